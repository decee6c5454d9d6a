#include "oracle/fast.hpp"
#include "oracle/format.hpp"
#include "verify/parties/formats.hpp"

namespace fixproof::parties {

namespace {

using cases::Operation;
using oracle::Integer;
using oracle::LongWord;
using oracle::Rounding;
using Result = std::optional<LongWord>;

/// The value of the double nearest to an integer, ties to even. It has 53 bits.
Integer nearest_double(const Integer& value) {
  constexpr unsigned precision = 53;
  const Integer magnitude = abs(value);
  if (magnitude < Integer(1) << precision) return value;
  const unsigned dropped = msb(magnitude) + 1 - precision;
  return oracle::rounded(value, Integer(1) << dropped, Rounding::half_even) << dropped;
}

template <class Int>
void answer_in(const cases::Variant& v, const Cases& asked) {
  const auto format = v.format.as<oracle::Format>();
  each_number(v, asked, [&](LongWord a, LongWord b) -> Result {
    switch (v.operation) {
      case Operation::add:
        return oracle::wrap<Int>(oracle::ulps<Int>(a, format) + oracle::ulps<Int>(b, format),
                                 format);
      case Operation::sub:
        return oracle::wrap<Int>(oracle::ulps<Int>(a, format) - oracle::ulps<Int>(b, format),
                                 format);
      case Operation::mul:
        return oracle::wrap<Int>(oracle::exact_product<Int>(a, b, Rounding::half_up, format),
                                 format);
      case Operation::div: {
        const auto quotient = oracle::exact_quotient<Int>(a, b, Rounding::half_up, format);
        if (!quotient) return std::nullopt;
        return oracle::wrap<Int>(*quotient, format);
      }
      case Operation::sqrt:
        return oracle::wrap<Int>(oracle::exact_root<Int>(a, Rounding::half_up, format).value_or(0),
                                 format);
      case Operation::binary64:
        return oracle::wrap(nearest_double(oracle::ulps(a, format)), format);
      default:
        return a;  // decimal text is exact, so the way there and back is the identity
    }
  });
}

}  // namespace

void answer_exactly(const cases::Variant& v, const Cases& asked) {
  if (v.from) return answer_mixed_exactly(v, asked);
  if (cases::is_function(v.operation)) return answer_function_exactly(v, asked);
  if (cases::is_quotient_function(v.operation)) return answer_quotient_exactly(v, asked);
  return v.format.word_bits <= 32 ? answer_in<oracle::Wide>(v, asked)
                                  : answer_in<Integer>(v, asked);
}

void answer_fast(const cases::Variant& v, const Cases& asked) {
  if (cases::is_function(v.operation)) return answer_function_fast(v, asked);
  if (cases::is_quotient_function(v.operation)) return answer_quotient_fast(v, asked);
  const auto format = v.format.as<oracle::Format>();
  const std::uint64_t ones = cases::all_ones(v.format);
  const auto each = [&](const auto& answer) { each_number(v, asked, answer); };
  switch (v.operation) {
    case Operation::add:
      return each([&](LongWord a, LongWord b) -> Result { return (a + b) & ones; });
    case Operation::sub:
      return each([&](LongWord a, LongWord b) -> Result { return (a - b) & ones; });
    case Operation::mul:
      return each([&](LongWord a, LongWord b) -> Result {
        return oracle::fast::mul(a, b, Rounding::half_up, format);
      });
    case Operation::div:
      return each([&](LongWord a, LongWord b) -> Result {
        return oracle::fast::quotient(a, b, Rounding::half_up, format);
      });
    case Operation::sqrt: {
      LongWord guess = 0;
      return each([&](LongWord a, LongWord /*b*/) -> Result {
        return oracle::fast::sqrt(a, format, guess).value_or(0);
      });
    }
    default:
      // A double holds every word of 32 bits.
      return each([](LongWord a, LongWord /*b*/) -> Result { return a; });
  }
}

}  // namespace fixproof::parties
