// Remainders and the quotient of a product, in every format.
#include <array>

#include "oracle/fast.hpp"
#include "oracle/whole_function.hpp"
#include "verify/parties/formats.hpp"
#include "verify/parties/with_format.hpp"

namespace fixproof::parties {

namespace {

using cases::Operation;
using Operands = std::array<std::uint64_t, 3>;
using Result = std::optional<std::uint64_t>;

/// Calls one of the type's functions, which throws for a zero divisor.
template <class Call>
Result result_of(const Call& call) {
  try {
    return bits_of(call());
  } catch (const fixproof::divide_error&) {
    return std::nullopt;
  }
}

template <class Number>
void answer_reporting(const cases::Variant& v, const Cases& asked) {
  // Differs from the type's own policy only for a zero divisor, which it reports.
  constexpr fixproof::policy reporting{.fault = fixproof::divide_fault::zero_divisor};
  using Reporting = fixproof::with_policy<Number, reporting>;
  const auto each = [&](const auto& function) {
    each_case_in(v, asked, [&](const Operands& in) {
      return result_of([&] {
        return function(number_from<Reporting>(in[0]), number_from<Reporting>(in[1]),
                        number_from<Reporting>(in[2]));
      });
    });
  };
  switch (v.operation) {
    case Operation::fmod:
      return each([](Reporting x, Reporting y, Reporting /*z*/) { return fmod(x, y); });
    case Operation::mul_div:
      return each([](Reporting x, Reporting y, Reporting z) { return mul_div(x, y, z); });
    default:
      if constexpr (std::is_signed_v<typename Number::raw_type>) {
        return each([](Reporting x, Reporting y, Reporting /*z*/) { return remainder(x, y); });
      }
  }
}

}  // namespace

void answer_quotient_exactly(const cases::Variant& v, const Cases& asked) {
  const auto format = v.format.as<oracle::Format>();
  each_case_in(v, asked, [&](const Operands& in) -> Result {
    const auto x = oracle::ulps(in[0], format);
    const auto y = oracle::ulps(in[1], format);
    const auto result = v.operation == Operation::fmod ? oracle::truncated_remainder(x, y)
                        : v.operation == Operation::remainder
                            ? oracle::nearest_remainder(x, y)
                            : oracle::product_quotient(x, y, oracle::ulps(in[2], format),
                                                       oracle::Rounding::half_up);
    if (!result) return std::nullopt;
    return oracle::wrap(*result, format);
  });
}

void answer_quotient_fast(const cases::Variant& v, const Cases& asked) {
  const auto format = v.format.as<oracle::Format>();
  const auto each = [&](const auto& function) { each_case_in(v, asked, function); };
  switch (v.operation) {
    case Operation::fmod:
      return each([&](const Operands& in) -> Result {
        return oracle::fast::truncated_remainder(in[0], in[1], format);
      });
    case Operation::remainder:
      return each([&](const Operands& in) -> Result {
        return oracle::fast::nearest_remainder(in[0], in[1], format);
      });
    default:
      return each([&](const Operands& in) -> Result {
        return oracle::fast::product_quotient(in[0], in[1], in[2], oracle::Rounding::half_up,
                                              format);
      });
  }
}

void answer_quotient_by_type(const cases::Variant& v, const Cases& asked) {
  with_number_in(v.format, [&]<class Number>(std::type_identity<Number> /*type*/) {
    answer_reporting<Number>(v, asked);
  });
}

}  // namespace fixproof::parties
