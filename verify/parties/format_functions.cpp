// Functions of real numbers.
#include <algorithm>
#include <array>
#include <stdexcept>

#include "fixed/fixed.hpp"
#include "oracle/fast.hpp"
#include "oracle/function.hpp"
#include "oracle/function_names.hpp"
#include "oracle/whole_function.hpp"
#include "verify/parties/formats.hpp"
#include "verify/parties/with_format.hpp"

namespace fixproof::parties {

namespace {

using cases::Operation;
using oracle::Function;
using Operands = std::array<std::uint64_t, 3>;
using Result = std::optional<std::uint64_t>;

Function function_of(Operation operation) {
  return oracle::function_named(cases::name_of(operation)).value();
}

template <class Number>
Number computed(Operation operation, Number x, Number y, Number z) {
// NOLINTBEGIN(cppcoreguidelines-macro-usage): cases of a switch
#define OF_ONE(name)    \
  case Operation::name: \
    return name(x);
#define OF_TWO(name)    \
  case Operation::name: \
    return name(x, y);
  // NOLINTEND(cppcoreguidelines-macro-usage)
  switch (operation) {
    ORACLE_FUNCTIONS_OF_ONE(OF_ONE)
    ORACLE_FUNCTIONS_OF_TWO(OF_TWO)
    case Operation::hypot3:
      return hypot(x, y, z);
    default:
      throw std::invalid_argument("not a function");
  }
#undef OF_ONE
#undef OF_TWO
}

}  // namespace

oracle::Integer outside_domain(Operation operation, bool is_zero, const oracle::Format& results) {
  switch (operation) {
    case Operation::log2:
    case Operation::log:
    case Operation::log10:
    case Operation::log1p:
      return oracle::lowest(results);
    case Operation::rsqrt:
    case Operation::reciprocal:
    case Operation::tan_of_degrees:
    case Operation::tan_of_turns:
      return oracle::highest(results);
    case Operation::pow:
      return is_zero ? oracle::highest(results) : oracle::Integer(0);
    default:
      return 0;
  }
}

void answer_function_exactly(const cases::Variant& v, const Cases& asked) {
  const auto format = v.format.as<oracle::Format>();
  if (v.operation == Operation::hypot3) {
    return each_case_in(v, asked, [&](const Operands& in) -> Result {
      const auto ulps = [&](std::size_t i) { return oracle::ulps(in.at(i), format); };
      return oracle::saturate(oracle::nearest_length(ulps(0), ulps(1), ulps(2)), format);
    });
  }
  const Function function = function_of(v.operation);
  each_number(v, asked, [&](std::uint64_t a, std::uint64_t b) -> Result {
    const oracle::Integer x = oracle::ulps(a, format);
    const auto ulps = oracle::nearest(function, x, oracle::ulps(b, format), format.fraction_bits,
                                      oracle::Rounding::half_up);
    return oracle::saturate(ulps ? *ulps : outside_domain(v.operation, x == 0, format), format);
  });
}

void answer_function_fast(const cases::Variant& v, const Cases& asked) {
  const auto format = v.format.as<oracle::Format>();
  if (v.operation == Operation::hypot3) {
    const auto most = static_cast<std::uint64_t>(oracle::highest(format));
    return each_case_in(v, asked, [&](const Operands& in) -> Result {
      return std::min(oracle::fast::nearest_length(in[0], in[1], in[2], format), most);
    });
  }
  const auto lowest = static_cast<std::int64_t>(oracle::lowest(format));
  const auto highest = static_cast<std::int64_t>(oracle::highest(format));
  const Function function = function_of(v.operation);
  const std::uint64_t ones = cases::all_ones(v.format);
  const std::uint64_t sign = format.is_signed ? std::uint64_t{1} << (format.bits - 1) : 0;
  const auto ulps_of = [&](std::uint64_t word) {
    return static_cast<std::int64_t>((word ^ sign) - sign);
  };
  each_number(v, asked, [&](std::uint64_t a, std::uint64_t b) -> Result {
    const std::int64_t x = ulps_of(a);
    const auto ulps = oracle::fast::nearest(function, x, ulps_of(b), format.fraction_bits,
                                            oracle::Rounding::half_up);
    const std::int64_t result =
        ulps ? *ulps : static_cast<std::int64_t>(outside_domain(v.operation, x == 0, format));
    return static_cast<std::uint64_t>(std::clamp(result, lowest, highest)) & ones;
  });
}

void answer_function_by_type(const cases::Variant& v, const Cases& asked) {
  with_number_in(v.format, [&]<class Number>(std::type_identity<Number> /*type*/) {
    each_case_in(v, asked, [&](const Operands& in) -> Result {
      return bits_of(computed(v.operation, number_from<Number>(in[0]), number_from<Number>(in[1]),
                              number_from<Number>(in[2])));
    });
  });
}

}  // namespace fixproof::parties
