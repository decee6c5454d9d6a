// The type in the formats that fixed/formats.hpp names.
#include <array>
#include <system_error>
#include <type_traits>

#include "fixed/fixed.hpp"
#include "fixed/formats.hpp"
#include "parties/formats.hpp"

namespace fixproof::parties {

namespace {

template <class... Numbers>
struct List {};

// In the order of cases::named_formats().
using Named =
    List<q8_0, q4_4, q1_7, u4_4, u0_8, q12_4, q8_8, q4_12, q2_14, q1_15, u8_8, u1_15, u0_16, q32_0,
         q26_6, q24_8, q20_12, q16_16, q8_24, q4_28, q2_30, q1_31, u24_8, u16_16, u8_24, u1_31,
         u0_32, q48_16, q40_24, q32_32, q16_48, q2_62, q1_63, u48_16, u32_32, u0_64>;

template <class Number>
constexpr cases::Format format_of() {
  using Raw = typename Number::raw_type;
  return {.word_bits = static_cast<int>(8 * sizeof(Raw)),
          .fraction_bits = Number::fraction_bits,
          .is_signed = std::is_signed_v<Raw>};
}

/// Calls call(std::type_identity<N>()) for the type of a format; false if there is none.
template <class Call, class... Numbers>
bool with_number_in(const cases::Format& format, const Call& call, List<Numbers...> /*numbers*/) {
  return ((format_of<Numbers>() == format && (call(std::type_identity<Numbers>()), true)) || ...);
}

using Result = std::optional<std::uint64_t>;

template <class Number>
Number number_of(std::uint64_t word) {
  return Number::from_raw(static_cast<typename Number::raw_type>(word));
}

template <class Number>
std::uint64_t word_of(Number x) {
  return static_cast<std::make_unsigned_t<typename Number::raw_type>>(x.raw());
}

template <class Number>
Result through_text(Number x) {
  std::array<char, fixproof::max_chars<Number>> text{};
  const auto written = fixproof::to_chars(text.data(), text.data() + text.size(), x);
  Number back;
  const auto read = fixproof::from_chars(text.data(), written.ptr, back);
  if (read.ec != std::errc{} || read.ptr != written.ptr) return std::nullopt;
  return word_of(back);
}

template <class Number>
void answer(const cases::Variant& v, const Batch& batch) {
  const auto each = [&](const auto& one) {
    each_number(v, batch, [&](std::uint64_t a, std::uint64_t b) -> Result {
      return one(number_of<Number>(a), number_of<Number>(b));
    });
  };
  switch (v.operation) {
    case cases::Operation::add:
      return each([](Number a, Number b) -> Result { return word_of<Number>(a + b); });
    case cases::Operation::sub:
      return each([](Number a, Number b) -> Result { return word_of<Number>(a - b); });
    case cases::Operation::mul:
      return each([](Number a, Number b) -> Result { return word_of<Number>(a * b); });
    case cases::Operation::div:
      return each([](Number a, Number b) -> Result {
        const auto quotient = fixproof::try_divide(a, b);
        if (!quotient) return std::nullopt;
        return word_of<Number>(*quotient);
      });
    case cases::Operation::sqrt:
      return each([](Number a, Number /*b*/) -> Result { return word_of(fixproof::sqrt(a)); });
    case cases::Operation::binary64:
      return each(
          [](Number a, Number /*b*/) -> Result { return word_of(Number(static_cast<double>(a))); });
    default:
      return each([](Number a, Number /*b*/) { return through_text(a); });
  }
}

}  // namespace

bool is_named(const cases::Format& format) {
  return with_number_in(
      format, [](auto /*type*/) {}, Named());
}

void answer_by_type(const cases::Variant& v, const Batch& batch) {
  with_number_in(
      v.format,
      [&]<class Number>(std::type_identity<Number> /*type*/) { answer<Number>(v, batch); },
      Named());
}

}  // namespace fixproof::parties
