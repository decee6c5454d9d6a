/// @file
/// Recorded numbers in the standard library: text, formatters, limits, hashes and common types.
#pragma once

#include <bit>
#include <charconv>
#include <cstddef>
#include <functional>
#include <istream>
#include <limits>
#include <numbers>
#include <ostream>
#include <string>
#include <type_traits>

#include "fixed/bytes.hpp"
#include "fixed/fixed.hpp"
#include "fixed/record/number.hpp"

namespace fixproof {

/// @name Text
/// \{

/// As that of plain numbers. Reading is recorded, and writing is not.
template <class Number>
constexpr std::to_chars_result to_chars(char* first, char* last,
                                        recorded_number<Number> x) noexcept {
  return fixproof::to_chars(first, last, x.value_);
}
template <class Number>
constexpr std::from_chars_result from_chars(const char* first, const char* last,
                                            recorded_number<Number>& x,
                                            record::place from = FIXPROOF_HERE) noexcept {
  const std::from_chars_result read = fixproof::from_chars(first, last, x.value_);
  if (read.ec == std::errc{} && !std::is_constant_evaluated()) {
    record::detail::note_input<record::kind::from_text, Number>(from, x.value_);
  }
  return read;
}
template <class Number>
std::string to_string(recorded_number<Number> x) {
  return fixproof::to_string(x.value_);
}
template <class Traits, class Number>
std::basic_ostream<char, Traits>& operator<<(std::basic_ostream<char, Traits>& out,
                                             recorded_number<Number> x) {
  return out << x.value_;
}
template <class Traits, class Number>
std::basic_istream<char, Traits>& operator>>(std::basic_istream<char, Traits>& in,
                                             recorded_number<Number>& x) {
  in >> x.value_;
  if (in) record::detail::note_input<record::kind::from_text, Number>(record::nowhere, x.value_);
  return in;
}
/// \}

/// Returns the bytes of the plain number.
template <std::endian Order, class Number>
[[nodiscard]] constexpr auto to_bytes(recorded_number<Number> x) noexcept {
  return fixproof::to_bytes<Order>(x.value_);
}

}  // namespace fixproof

/// The limits of the plain number, as recorded numbers.
template <class Number>
class std::numeric_limits<fixproof::recorded_number<Number>> : public std::numeric_limits<Number> {
  using plain = std::numeric_limits<Number>;
  using recorded = fixproof::recorded_number<Number>;

 public:
  /// @name As those of the plain number
  /// \{

  /// Members as the standard names them.
  static constexpr recorded(min)() noexcept { return (plain::min)(); }
  static constexpr recorded(max)() noexcept { return (plain::max)(); }
  static constexpr recorded lowest() noexcept { return plain::lowest(); }
  static constexpr recorded epsilon() noexcept { return plain::epsilon(); }
  static constexpr recorded round_error() noexcept { return plain::round_error(); }
  static constexpr recorded denorm_min() noexcept { return plain::denorm_min(); }
  static constexpr recorded infinity() noexcept { return plain::infinity(); }
  static constexpr recorded quiet_NaN() noexcept { return plain::quiet_NaN(); }
  static constexpr recorded signaling_NaN() noexcept { return plain::signaling_NaN(); }
  /// \}
};

/// The hash of the plain number.
template <class Number>
struct std::hash<fixproof::recorded_number<Number>> {
  /// Returns the hash of the plain number.
  std::size_t operator()(fixproof::recorded_number<Number> x) const noexcept {
    return std::hash<Number>{}(x.plain());
  }
};

/// The common type with an integer, as for the plain number.
template <class Number, fixproof::detail::integer Int>
struct std::common_type<fixproof::recorded_number<Number>, Int> {
  /// The recorded number.
  using type = fixproof::recorded_number<Number>;
};
/// The same with the integer first.
template <fixproof::detail::integer Int, class Number>
struct std::common_type<Int, fixproof::recorded_number<Number>> {
  /// The recorded number.
  using type = fixproof::recorded_number<Number>;
};

/// @cond
// NOLINTNEXTLINE(cppcoreguidelines-macro-usage): defines a constant
#define FIXPROOF_RECORDED_CONSTANT(name)             \
  template <class Number>                            \
  inline constexpr fixproof::recorded_number<Number> \
      std::numbers::name<fixproof::recorded_number<Number>> = std::numbers::name<Number>;
FIXPROOF_RECORDED_CONSTANT(pi_v)
FIXPROOF_RECORDED_CONSTANT(e_v)
FIXPROOF_RECORDED_CONSTANT(ln2_v)
FIXPROOF_RECORDED_CONSTANT(ln10_v)
FIXPROOF_RECORDED_CONSTANT(log2e_v)
FIXPROOF_RECORDED_CONSTANT(log10e_v)
FIXPROOF_RECORDED_CONSTANT(sqrt2_v)
FIXPROOF_RECORDED_CONSTANT(sqrt3_v)
FIXPROOF_RECORDED_CONSTANT(inv_pi_v)
FIXPROOF_RECORDED_CONSTANT(inv_sqrtpi_v)
FIXPROOF_RECORDED_CONSTANT(inv_sqrt3_v)
FIXPROOF_RECORDED_CONSTANT(phi_v)
FIXPROOF_RECORDED_CONSTANT(egamma_v)
#undef FIXPROOF_RECORDED_CONSTANT
/// @endcond

#if defined(__cpp_lib_format)
#include <format>
template <class Number>
struct std::formatter<fixproof::recorded_number<Number>, char> : std::formatter<Number, char> {
  /// Formats the plain number.
  template <class Context>
  auto format(fixproof::recorded_number<Number> x, Context& context) const {
    return std::formatter<Number, char>::format(x.plain(), context);
  }
};
#endif
