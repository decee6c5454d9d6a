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
/// are at most 1,000,000. Each may be the integer of another argument, as for double: `{}`, `{1}`
/// or, in fmt, `{name}`. Any other specification throws the library's format_error.
///
/// To add the fmt formatter after fixed/fixed.hpp was included, include fmt and then this header
/// again; hence no #pragma once.
#ifndef FIXED_FORMAT_HPP
#define FIXED_FORMAT_HPP

#include <cstddef>
#include <string_view>
#include <type_traits>
#include <version>

#include "fixed/detail/number_text.hpp"
#include "fixed/detail/throw.hpp"
#include "fixed/number.hpp"

#if defined(__cpp_lib_format)
#include <format>
#endif

namespace fixproof::detail {

/// The largest width and precision.
inline constexpr std::size_t max_format_size = 1'000'000;

/// A width or a precision: a number, or the argument that has it. Id is the library's type for the
/// index of an argument.
template <class Error, class Id>
class format_size {
 public:
  constexpr format_size() noexcept = default;
  constexpr explicit format_size(std::size_t value) noexcept : value_(value) {}

  /// Reads the argument between braces. `it` is after the first of them.
  /// @return the position after the last
  template <class Iterator, class Context>
  constexpr Iterator read_argument(Iterator it, const Iterator end, Context& context) {
    kind_ = kind::index;
    if (it != end && *it == '}') {
      index_ = context.next_arg_id();
      check_type(context);
    } else if (it != end && is_digit(*it)) {
      const bool is_zero = *it == '0';
      for (index_ = 0; it != end && is_digit(*it); ++it) {
        index_ = static_cast<Id>(index_ * 10 + static_cast<Id>(*it - '0'));
        if (index_ > static_cast<Id>(max_format_size) || (is_zero && index_ != 0)) fail();
      }
      context.check_arg_id(index_);
      check_type(context);
    } else {
      it = read_name(it, end, context);
    }
    if (it == end || *it != '}') fail();
    return ++it;
  }

  /// Returns the value, which may be in an argument.
  template <class Context>
  constexpr std::size_t in(Context& context) const {
    switch (kind_) {
      case kind::index:
        return visited(context.arg(index_));
      case kind::name:
        if constexpr (requires { context.arg(name_); }) return visited(context.arg(name_));
        break;
      default:
        break;
    }
    return value_;
  }

 private:
  enum class kind : unsigned char { value, index, name };

  /// Returns the integer of any argument.
  struct visitor {
    template <class Type>
    constexpr std::size_t operator()([[maybe_unused]] const Type& x) const {
      // The standard library has no integer of 128 bits.
      constexpr bool is_integer = requires { x % x; };
      if constexpr (is_integer && !std::is_same_v<Type, bool> && !std::is_same_v<Type, char>) {
        if (x < Type{0}) throw_error<Error>("the width or precision of a number is negative");
        if (x > Type{max_format_size}) {
          throw_error<Error>("the width or precision of a fixed-point number is above 1000000");
        }
        return static_cast<std::size_t>(x);
      } else {
        throw_error<Error>("the width or precision of a fixed-point number is no integer");
      }
    }
  };

  template <class Argument>
  static constexpr std::size_t visited(const Argument& argument) {
    if constexpr (requires { argument.visit(visitor{}); }) {
      return argument.visit(visitor{});
    } else {
      return visit_format_arg(visitor{}, argument);
    }
  }

  static constexpr bool is_digit(char c) noexcept { return c >= '0' && c <= '9'; }
  static constexpr bool is_letter(char c) noexcept {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
  }

  template <class Iterator, class Context>
  constexpr Iterator read_name(Iterator it, const Iterator end, Context& context) {
    const Iterator first = it;
    if (it == end || !is_letter(*it)) fail();
    while (it != end && (is_letter(*it) || is_digit(*it))) ++it;
    kind_ = kind::name;
    name_ = std::string_view(&*first, static_cast<std::size_t>(it - first));
    if constexpr (requires { context.check_arg_id(name_); }) {
      context.check_arg_id(name_);
    } else {
      fail();
    }
    return it;
  }

  /// Lets the compiler refuse an argument of another type, where the library can.
  template <class Context>
  constexpr void check_type(Context& context) const {
    if constexpr (requires { context.check_dynamic_spec_integral(index_); }) {
      context.check_dynamic_spec_integral(index_);
    } else if constexpr (requires { context.check_dynamic_spec(index_); }) {
      context.check_dynamic_spec(index_);
    }
  }

  [[noreturn]] static void fail() {
    throw_error<Error>(
        "between the braces of a width or precision is nothing, or the number or name of an "
        "argument");
  }

  kind kind_ = kind::value;
  std::size_t value_ = 0;
  Id index_ = 0;
  std::string_view name_;
};

/// Reads a format specification.
template <class Error, class Id>
class format_reader {
 public:
  using size = format_size<Error, Id>;

  text_style style;
  char fill = ' ';
  char align = 0;
  bool pads_with_zeros = false;
  size width;
  size precision{text_style{}.precision};

  /// @return the end of the specification
  template <class Context>
  constexpr auto read(Context& context) {
    auto it = context.begin();
    const auto end = context.end();
    if (it != end && it + 1 != end && is_align(it[1]) && *it != '{' && *it != '}') fill = *it++;
    if (it != end && is_align(*it)) align = *it++;
    if (it != end && (*it == '+' || *it == '-' || *it == ' ')) style.plus = *it++;
    style.alternate = take(it, end, '#');
    pads_with_zeros = take(it, end, '0') && align == 0;
    width = read_size(it, end, context);
    const bool has_precision = take(it, end, '.');
    if (has_precision) {
      if (it == end || ((*it < '0' || *it > '9') && *it != '{')) fail();
      precision = read_size(it, end, context);
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

  template <class Iterator, class Context>
  static constexpr size read_size(Iterator& it, const Iterator end, Context& context) {
    if (take(it, end, '{')) {
      size argument;
      it = argument.read_argument(it, end, context);
      return argument;
    }
    std::size_t value = 0;
    for (; it != end && *it >= '0' && *it <= '9'; ++it) {
      value = value * 10 + static_cast<std::size_t>(*it - '0');
      if (value > max_format_size) {
        throw_error<Error>("the width or precision of a fixed-point number is above 1000000");
      }
    }
    return size(value);
  }

  [[noreturn]] static void fail() {
    throw_error<Error>(
        "the format of a fixed-point number is "
        "[[fill]align][sign][#][0][width][.precision][type], with type f, e, x, X or b");
  }
};

/// The common part of both formatters; Error is the library's format_error, Id the type of the
/// index of an argument.
template <class Raw, int FractionBits, policy Rules, class Error, class Id>
class text_formatter {
 public:
  template <class Context>
  constexpr auto parse(Context& context) {
    return format_.read(context);
  }

  template <class Context>
  auto format(number<Raw, FractionBits, Rules> value, Context& context) const {
    text_style style = format_.style;
    style.precision = format_.precision.in(context);
    const std::size_t width = format_.width.in(context);
    const auto text = number_text::of<FractionBits>(value.raw(), style);
    const std::size_t padding = width > text.size() ? width - text.size() : 0;
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
  format_reader<Error, Id> format_;
};

}  // namespace fixproof::detail

#if defined(__cpp_lib_format)
template <class Raw, int FractionBits, fixproof::policy Rules>
struct std::formatter<fixproof::number<Raw, FractionBits, Rules>, char>
    : fixproof::detail::text_formatter<Raw, FractionBits, Rules, std::format_error, std::size_t> {};
#endif

#endif

#if defined(FMT_VERSION) && !defined(FIXED_FMT_FORMATTER)
#define FIXED_FMT_FORMATTER
#if !defined(FMT_FORMAT_H_)
#include <fmt/format.h>  // <fmt/core.h> alone has no fmt::format_error
#endif
template <class Raw, int FractionBits, fixproof::policy Rules>
struct fmt::formatter<fixproof::number<Raw, FractionBits, Rules>, char>
    : fixproof::detail::text_formatter<Raw, FractionBits, Rules, fmt::format_error, int> {};
#endif
