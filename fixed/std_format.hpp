/// @file
/// `{}` for std::format, if the library has it, and for fmt, if fmt is included before this header.
///
/// The format specification is `[[fill]align][sign][#][0][width][.precision][type]`.
///
/// | part | meaning |
/// | --- | --- |
/// | `align` | `<`, `>` (the default) or `^`; `fill` is one char, a space by default |
/// | `sign` | what stands before a number that is not negative: `+`, a space, or `-` for nothing |
/// | `#` | adds `0x`, `0X` or `0b` to `x`, `X` and `b`, and a point to a decimal without one |
/// | `0` | pads with zeros after the sign; without effect beside `align` |
/// | no type | the exact value, as to_chars() writes it; with a precision, as `f` |
/// | `f` | `precision` digits after the point, 6 by default |
/// | `e` | scientific, with `precision` digits after the point, 6 by default: `-1.5e+00` |
/// | `x`, `X` | the exact value in hexadecimal, with a hexadecimal fraction: -1.5 is `-1.8` |
/// | `b` | the same in binary |
///
/// `f` and `e` round the exact value to nearest, ties to even; a negative number that rounds to
/// zero keeps its sign, as in printf. Types `x`, `X` and `b` take no precision. Width and precision
/// are at most 1,000,000. Any other specification throws the library's format_error.
///
/// To add the fmt formatter after fixed/fixed.hpp was included, include fmt and then this header
/// again; hence no #pragma once.
#ifndef FIXED_FORMAT_HPP
#define FIXED_FORMAT_HPP

#include <algorithm>
#include <cstddef>
#include <version>

#include "fixed/detail/number_text.hpp"
#include "fixed/detail/throw.hpp"
#include "fixed/number.hpp"

#if defined(__cpp_lib_format)
#include <format>
#endif

namespace fixproof::detail {

/// Reads a format specification.
template <class Error>
class format_reader {
 public:
  text_style style;
  char fill = ' ';
  char align = 0;
  bool pads_with_zeros = false;
  std::size_t width = 0;

  /// @return the end of the specification
  template <class Iterator>
  constexpr Iterator read(Iterator it, const Iterator end) {
    if (it != end && it + 1 != end && is_align(it[1]) && *it != '{' && *it != '}') fill = *it++;
    if (it != end && is_align(*it)) align = *it++;
    if (it != end && (*it == '+' || *it == '-' || *it == ' ')) style.plus = *it++;
    style.alternate = take(it, end, '#');
    pads_with_zeros = take(it, end, '0') && align == 0;
    width = read_size(it, end);
    const bool has_precision = take(it, end, '.');
    if (has_precision) {
      if (it == end || *it < '0' || *it > '9') fail();
      style.precision = read_size(it, end);
    }
    if (it != end && is_type(*it)) style.type = *it++;
    if (it != end && *it != '}') fail();
    if (has_precision) {
      if (style.type == 0) style.type = 'f';
      if (style.type != 'f' && style.type != 'e') {
        throw_error<Error>("types x, X and b of a fixed-point number take no precision");
      }
    }
    return it;
  }

 private:
  static constexpr std::size_t max_size = 1'000'000;

  static constexpr bool is_align(char c) noexcept { return c == '<' || c == '>' || c == '^'; }

  static constexpr bool is_type(char c) noexcept {
    return c == 'f' || c == 'e' || c == 'x' || c == 'X' || c == 'b';
  }

  template <class Iterator>
  static constexpr bool take(Iterator& it, const Iterator end, char c) {
    if (it == end || *it != c) return false;
    ++it;
    return true;
  }

  template <class Iterator>
  static constexpr std::size_t read_size(Iterator& it, const Iterator end) {
    std::size_t size = 0;
    for (; it != end && *it >= '0' && *it <= '9'; ++it) {
      size = size * 10 + static_cast<std::size_t>(*it - '0');
      if (size > max_size) {
        throw_error<Error>("the width or precision of a fixed-point number is above 1000000");
      }
    }
    return size;
  }

  [[noreturn]] static void fail() {
    throw_error<Error>(
        "the format of a fixed-point number is "
        "[[fill]align][sign][#][0][width][.precision][type], with type f, e, x, X or b");
  }
};

/// The common part of both formatters; Error is the library's format_error.
template <class Raw, int FractionBits, policy P, class Error>
class text_formatter {
 public:
  template <class Context>
  constexpr auto parse(Context& context) {
    return format_.read(context.begin(), context.end());
  }

  template <class Context>
  auto format(number<Raw, FractionBits, P> value, Context& context) const {
    const auto text = number_text::of<FractionBits>(value.raw(), format_.style);
    const std::size_t padding = format_.width - (std::min)(format_.width, text.size());
    const std::size_t zeros = format_.pads_with_zeros ? padding : 0;
    const std::size_t spaces = padding - zeros;
    const std::size_t before = format_.align == '<'   ? 0
                               : format_.align == '^' ? spaces / 2
                                                      : spaces;
    auto out = number_text::fill(context.out(), before, format_.fill);
    out = number_text::fill(text.write_head(out), zeros, '0');
    out = text.write_rest(number_text::copy(text.whole_begin(), text.whole_end(), out));
    return number_text::fill(out, spaces - before, format_.fill);
  }

 private:
  format_reader<Error> format_;
};

}  // namespace fixproof::detail

#if defined(__cpp_lib_format)
template <class Raw, int FractionBits, fixproof::policy P>
struct std::formatter<fixproof::number<Raw, FractionBits, P>, char>
    : fixproof::detail::text_formatter<Raw, FractionBits, P, std::format_error> {};
#endif

#endif

#if defined(FMT_VERSION) && !defined(FIXED_FMT_FORMATTER)
#define FIXED_FMT_FORMATTER
#if !defined(FMT_FORMAT_H_)
#include <fmt/format.h>  // <fmt/core.h> alone has no fmt::format_error
#endif
template <class Raw, int FractionBits, fixproof::policy P>
struct fmt::formatter<fixproof::number<Raw, FractionBits, P>, char>
    : fixproof::detail::text_formatter<Raw, FractionBits, P, fmt::format_error> {};
#endif
