// The production type, under the policy that must be bit-identical to the variant.
#include <span>

#include "fixed/fixed.hpp"
#include "verify/parties/formats.hpp"
#include "verify/parties/parties.hpp"
#include "verify/parties/with_number.hpp"
#include "xsharp/arithmetic.hpp"

namespace fixproof::parties {

namespace {

/// Answers one case with numbers of one type; false if the case has no value.
template <class Number, cases::Operation operation>
// One branch for each operation.  NOLINTNEXTLINE(readability-function-cognitive-complexity)
bool one_case(const cases::Variant& v, std::span<const std::uint32_t> in,
              std::span<std::uint32_t> out) {
  const auto operand = [&](std::size_t i) { return number_of<Number>(in[i]); };
  if constexpr (operation == cases::Operation::mul) {
    out[0] = word_of(operand(0) * operand(1));
  } else if constexpr (operation == cases::Operation::div) {
    const auto quotient = fixproof::try_divide(operand(0), operand(1));
    if (!quotient) return false;
    out[0] = word_of(*quotient);
  } else if constexpr (operation == cases::Operation::cossin) {
    const auto angle = static_cast<std::int16_t>(static_cast<std::uint16_t>(in[0]));
    const auto [sin, cos] = fixproof::sin_cos_of_tenths<Number>(angle);
    out[0] = word_of(cos);
    out[1] = word_of(sin);
  } else if constexpr (operation == cases::Operation::xformvec) {
    for (std::size_t row = 0; row < 3; ++row) {
      Number sum = operand(4 * row + 3);
      for (std::size_t k = 0; k < 3; ++k) sum += operand(4 * row + k) * operand(12 + k);
      out[row] = word_of(sum);
    }
  } else if constexpr (operation == cases::Operation::concat) {
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t column = 0; column < 4; ++column) {
        Number sum;
        for (std::size_t k = 0; k < 3; ++k) {
          sum += operand(4 * row + k) * operand(12 + 4 * k + column);
        }
        const Number moved = column == 3 || v.build.chapter_52 ? operand(4 * row + 3) : Number();
        const bool in_parts = column == 3 && cases::loses_carry(v);
        out[4 * row + column] = word_of(in_parts ? xsharp::sum_in_parts(sum, moved) : sum + moved);
      }
    }
  }
  return true;
}

template <class Number, cases::Operation operation>
void each_case(const cases::Variant& v, const Cases& asked) {
  constexpr std::size_t in = cases::words_in(operation);
  constexpr std::size_t out = cases::words_out(operation);
  for (std::size_t i = 0; i < asked.endings.size(); ++i) {
    const bool valued = one_case<Number, operation>(v, asked.in.subspan(i * in, in),
                                                    asked.out.subspan(i * out, out));
    asked.endings[i] = valued ? Ending::value : Ending::divide_error;
  }
}

template <class Number>
void each_case(const cases::Variant& v, const Cases& asked) {
  using enum cases::Operation;
  switch (v.operation) {
    case mul:
      return each_case<Number, mul>(v, asked);
    case div:
      return each_case<Number, div>(v, asked);
    case cossin:
      return each_case<Number, cossin>(v, asked);
    case xformvec:
      return each_case<Number, xformvec>(v, asked);
    case concat:
      return each_case<Number, concat>(v, asked);
    default:  // not a routine
      return;
  }
}

class Type final : public Party {
 public:
  [[nodiscard]] std::string_view name() const override { return "type"; }
  [[nodiscard]] std::string identity() const override { return fixed_version(); }
  [[nodiscard]] bool answers(const cases::Variant& v) const override {
    if (!cases::has_routine_format(v)) {
      return exists_in_format(v) && is_of_type(v) && is_standard(v);
    }
    return v.operation != cases::Operation::cossin || v.format == cases::q16_16;
  }
  void fill(const cases::Variant& v, const Cases& asked) const override {
    if (!is_of_build(v)) return answer_by_type(v, asked);
    with_number(
        v, [&]<class Number>(std::type_identity<Number> /*type*/) { each_case<Number>(v, asked); });
  }
};

}  // namespace

std::unique_ptr<Party> make_type() { return std::make_unique<Type>(); }

}  // namespace fixproof::parties
