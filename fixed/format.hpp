/// \file
/// `{}` for std::format, if the library has it, and for fmt, if fmt is included before this header.
///
/// The format specification is `[[fill]align][width]`. `align` is `<`, `>` (the default) or `^`,
/// and `fill` is one char. The output is the exact value, as to_chars() writes it, padded to the
/// width.
///
/// To add the fmt formatter after fixed/fixed.hpp was included, include fmt and then this header
/// again; hence no #pragma once.
#ifndef FIXED_FORMAT_HPP
#define FIXED_FORMAT_HPP

#include <algorithm>
#include <array>
#include <cstddef>
#include <version>

#include "fixed/detail/decimal.hpp"
#include "fixed/detail/throw.hpp"
#include "fixed/number.hpp"

#if defined(__cpp_lib_format)
#include <format>
#endif

namespace fixproof::detail {

/// The common part of both formatters; Error is the library's format_error.
template <class Raw, int FractionBits, policy P, class Error>
class text_formatter {
 public:
  template <class Context>
  constexpr auto parse(Context& context) {
    auto it = context.begin();
    const auto end = context.end();
    if (it != end && it + 1 != end && is_align(it[1]) && *it != '{' && *it != '}') {
      fill_ = *it++;
    }
    if (it != end && is_align(*it)) align_ = *it++;
    for (; it != end && *it >= '0' && *it <= '9'; ++it) {
      width_ = width_ * 10 + static_cast<std::size_t>(*it - '0');
      if (width_ > max_width) {
        throw_error<Error>("the width of a fixed-point number is too large");
      }
    }
    if (it != end && *it != '}') {
      throw_error<Error>("the format of a fixed-point number is [[fill]align][width]");
    }
    return it;
  }

  template <class Context>
  auto format(number<Raw, FractionBits, P> value, Context& context) const {
    std::array<char, max_decimal_chars<Raw, FractionBits>> text{};
    const char* last = write_decimal<FractionBits>(text.data(), value.raw());
    const auto length = static_cast<std::size_t>(last - text.data());
    const std::size_t padding = width_ > length ? width_ - length : 0;
    const std::size_t before = align_ == '<' ? 0 : align_ == '^' ? padding / 2 : padding;
    auto out = std::fill_n(context.out(), before, fill_);
    out = std::copy(static_cast<const char*>(text.data()), last, out);
    return std::fill_n(out, padding - before, fill_);
  }

 private:
  static constexpr std::size_t max_width = 1'000'000;

  static constexpr bool is_align(char c) noexcept { return c == '<' || c == '>' || c == '^'; }

  char fill_ = ' ';
  char align_ = '>';
  std::size_t width_ = 0;
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
