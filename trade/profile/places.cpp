#include "trade/profile/places.hpp"

#include <array>

namespace fixproof::trade {

namespace {

/// Maps an index into twelve row-major words: 0 for the matrix, 1 for the fourth column.
std::size_t of_transform(std::size_t index) { return index % 4 == 3 ? 1 : 0; }

}  // namespace

std::span<const std::string_view> operand_names(cases::Operation operation) {
  static constexpr std::array<std::string_view, 2> mul{"first factor", "second factor"};
  static constexpr std::array<std::string_view, 2> div{"dividend", "divisor"};
  static constexpr std::array<std::string_view, 1> cossin{"angle"};
  static constexpr std::array<std::string_view, 3> xformvec{"matrix", "translation", "vector"};
  static constexpr std::array<std::string_view, 4> concat{"first matrix", "first translation",
                                                          "second matrix", "second translation"};
  switch (operation) {
    case cases::Operation::mul:
      return mul;
    case cases::Operation::div:
      return div;
    case cases::Operation::cossin:
      return cossin;
    case cases::Operation::xformvec:
      return xformvec;
    default:
      return concat;
  }
}

std::span<const std::string_view> result_names(cases::Operation operation) {
  static constexpr std::array<std::string_view, 1> mul{"product"};
  static constexpr std::array<std::string_view, 1> div{"quotient"};
  static constexpr std::array<std::string_view, 2> cossin{"cosine", "sine"};
  static constexpr std::array<std::string_view, 1> xformvec{"vector"};
  static constexpr std::array<std::string_view, 2> concat{"matrix", "translation"};
  switch (operation) {
    case cases::Operation::mul:
      return mul;
    case cases::Operation::div:
      return div;
    case cases::Operation::cossin:
      return cossin;
    case cases::Operation::xformvec:
      return xformvec;
    default:
      return concat;
  }
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
