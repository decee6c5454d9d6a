// Exponentials and logarithms in formats of at most 32 bits.
#include <algorithm>

#include "fixed/exponential.hpp"
#include "oracle/exponential.hpp"
#include "oracle/format.hpp"
#include "parties/formats.hpp"
#include "parties/with_format.hpp"

namespace fixproof::parties {

namespace {

using cases::Operation;
using oracle::Exponential;
using Result = std::optional<std::uint64_t>;

Exponential function_of(Operation operation) {
  switch (operation) {
    case Operation::exp2:
      return Exponential::exp2;
    case Operation::exp:
      return Exponential::exp;
    case Operation::log2:
      return Exponential::log2;
    case Operation::log:
      return Exponential::log;
    default:
      return Exponential::log10;
  }
}

/// Answers each case by `nearest`, an oracle that returns ulps or nothing.
template <class Nearest>
void answer_by_oracle(const cases::Variant& v, const Batch& batch, const Nearest& nearest) {
  const oracle::Format format{v.format.word_bits, v.format.fraction_bits, v.format.is_signed};
  const Exponential function = function_of(v.operation);
  each_number(v, batch, [&](std::uint64_t word, std::uint64_t /*b*/) -> Result {
    const auto ulps = nearest(function, oracle::ulps(word, format), format.fraction_bits,
                              oracle::Rounding::half_up);
    return oracle::saturate(ulps ? oracle::Integer(*ulps) : oracle::lowest(format), format);
  });
}

template <class Number>
void answer_exponential(const cases::Variant& v, const Batch& batch) {
  const auto each = [&](const auto& function) {
    each_number(v, batch, [&](std::uint64_t word, std::uint64_t /*b*/) -> Result {
      return bits_of<Number>(function(number_from<Number>(word)));
    });
  };
  switch (v.operation) {
    case Operation::exp2:
      return each([](Number x) { return exp2(x); });
    case Operation::exp:
      return each([](Number x) { return exp(x); });
    case Operation::log2:
      return each([](Number x) { return log2(x); });
    case Operation::log:
      return each([](Number x) { return log(x); });
    default:
      return each([](Number x) { return log10(x); });
  }
}

}  // namespace

void answer_exponential_exactly(const cases::Variant& v, const Batch& batch) {
  answer_by_oracle(v, batch, oracle::nearest);
}

void answer_exponential_fast(const cases::Variant& v, const Batch& batch) {
  const oracle::Format format{v.format.word_bits, v.format.fraction_bits, v.format.is_signed};
  const auto lowest = static_cast<std::int64_t>(oracle::lowest(format));
  const auto highest = static_cast<std::int64_t>(oracle::highest(format));
  const Exponential function = function_of(v.operation);
  const std::uint64_t ones = cases::all_ones(v.format);
  const std::uint64_t sign = format.is_signed ? std::uint64_t{1} << (format.bits - 1) : 0;
  each_number(v, batch, [&](std::uint64_t word, std::uint64_t /*b*/) -> Result {
    const auto ulps = static_cast<std::int64_t>((word ^ sign) - sign);
    const auto result =
        oracle::fast::nearest(function, ulps, format.fraction_bits, oracle::Rounding::half_up);
    return static_cast<std::uint64_t>(std::clamp(result.value_or(lowest), lowest, highest)) & ones;
  });
}

void answer_exponential_by_type(const cases::Variant& v, const Batch& batch) {
  with_number_in(v.format, [&]<class Number>(std::type_identity<Number> /*type*/) {
    if constexpr (sizeof(typename Number::raw_type) <= sizeof(std::uint32_t)) {
      answer_exponential<Number>(v, batch);
    }
  });
}

}  // namespace fixproof::parties
