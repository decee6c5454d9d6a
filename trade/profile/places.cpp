#include "trade/profile/places.hpp"

#include <array>
#include <vector>

#include "x86model/routine.hpp"

namespace fixproof::trade {

namespace {

/// Maps an index into twelve row-major words: 0 for the matrix, 1 for the fourth column.
std::size_t of_transform(std::size_t index) { return index % 4 == 3 ? 1 : 0; }

}  // namespace

Names operand_names(cases::Operation operation) {
  static const std::array<std::vector<std::string_view>, x86model::routine_count> names{{
      {"first factor", "second factor"},
      {"dividend", "divisor"},
      {"angle"},
      {"matrix", "translation", "vector"},
      {"first matrix", "first translation", "second matrix", "second translation"},
  }};
  return names.at(static_cast<std::size_t>(operation));
}

Names result_names(cases::Operation operation) {
  static const std::array<std::vector<std::string_view>, x86model::routine_count> names{
      {{"product"}, {"quotient"}, {"cosine", "sine"}, {"vector"}, {"matrix", "translation"}}};
  return names.at(static_cast<std::size_t>(operation));
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
