#include "measure/trade/profile/places.hpp"

#include <array>
#include <vector>

#include "x86model/routine.hpp"

namespace fixproof::trade {

namespace {

/// Maps an index into twelve row-major words: 0 for the matrix, 1 for the fourth column.
std::size_t of_transform(std::size_t index) { return index % 4 == 3 ? 1 : 0; }

struct CallNames {
  std::vector<std::string_view> operands;
  std::vector<std::string_view> results;
};

const CallNames& names_of(cases::Operation routine) {
  // In the order of cases::Operation, which begins with the five routines.
  static const std::array<CallNames, x86model::routine_count> names{
      {{{"first factor", "second factor"}, {"product"}},
       {{"dividend", "divisor"}, {"quotient"}},
       {{"angle"}, {"cosine", "sine"}},
       {{"matrix", "translation", "vector"}, {"vector"}},
       {{"first matrix", "first translation", "second matrix", "second translation"},
        {"matrix", "translation"}}}};
  return names.at(static_cast<std::size_t>(routine));
}

}  // namespace

std::span<const std::string_view> operand_names(cases::Operation routine) {
  return names_of(routine).operands;
}

std::span<const std::string_view> result_names(cases::Operation routine) {
  return names_of(routine).results;
}

std::size_t operand_place(cases::Operation operation, std::size_t index) {
  if (operation == cases::Operation::xformvec) return index < 12 ? of_transform(index) : 2;
  if (operation == cases::Operation::concat) return of_transform(index) + (index < 12 ? 0U : 2U);
  return index;
}

std::size_t result_place(cases::Operation operation, std::size_t index) {
  if (operation == cases::Operation::xformvec) return 0;
  if (operation == cases::Operation::concat) return of_transform(index);
  return index;
}

}  // namespace fixproof::trade
