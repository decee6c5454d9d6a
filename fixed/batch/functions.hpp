/// @file
/// Elementary functions of many numbers, bit-identical to the scalar functions and several times as
/// fast with AVX2 or AVX-512. NEON registers compute them, too. Not part of fixed/batch/batch.hpp.
///
///     std::vector<fixproof::q16_16> x(1000), powers(1000);
///     fixproof::batch::exp(x, powers);  // powers[i] = exp(x[i])
///
/// Results out of range and outside the domain are those of the scalar functions. Under
/// overflow::trap a batch throws what the scalar function throws. The elements before the one that
/// throws are written, and those after it are unspecified. Under every other policy nothing throws.
///
/// Spans and paths are those of fixed/batch/batch.hpp: the shortest span sets the length, and the
/// result may be an operand. Vector registers compute signed formats of 16 and 32 bits; all others
/// take the plain loop, and so does every format under -ffast-math.
#pragma once

#include <array>  // std::data, std::size
#include <cstddef>

#include "fixed/batch/detail/function_targets.hpp"
#include "fixed/batch/detail/spans.hpp"
#include "fixed/batch/radian.hpp"

namespace fixproof::detail {

/// out[i] = Function::scalar(from[i]...) for i below `count`.
template <class Function, class Number, class... Operands>
void each_result(batch::path use, Number* out, std::size_t count,
                 const Operands*... from) noexcept(Number::never_throws) {
  std::size_t i = on_function_path<has_function_lanes<Number>>(
      use, [&](auto on) { return on.template each<Function>(out, count, from...); });
  for (; i < count; ++i) out[i] = Function::scalar(from[i]...);
}

/// The same for ranges. The shortest one sets the number of results.
template <class Function, class Out, class... Operands>
void each_of(batch::path use, Out& out,
             const Operands&... from) noexcept(element_t<Out>::never_throws) {
  each_result<Function>(use, std::data(out), shortest(out, from...), std::data(from)...);
}

}  // namespace fixproof::detail

namespace fixproof::batch {

/// out[i] = fixproof::exp2(x[i]).
template <detail::number_range Xs, detail::output_of<detail::element_t<Xs>> Out>
void exp2(const Xs& x, Out&& out,
          path use = path::fastest) noexcept(detail::element_t<Xs>::never_throws) {
  detail::each_of<detail::of_exp2>(use, out, x);
}

/// out[i] = fixproof::exp(x[i]).
template <detail::number_range Xs, detail::output_of<detail::element_t<Xs>> Out>
void exp(const Xs& x, Out&& out,
         path use = path::fastest) noexcept(detail::element_t<Xs>::never_throws) {
  detail::each_of<detail::of_exp>(use, out, x);
}

/// out[i] = fixproof::expm1(x[i]).
template <detail::number_range Xs, detail::output_of<detail::element_t<Xs>> Out>
void expm1(const Xs& x, Out&& out,
           path use = path::fastest) noexcept(detail::element_t<Xs>::never_throws) {
  detail::each_of<detail::of_expm1>(use, out, x);
}

/// out[i] = fixproof::log(x[i]).
template <detail::number_range Xs, detail::output_of<detail::element_t<Xs>> Out>
void log(const Xs& x, Out&& out,
         path use = path::fastest) noexcept(detail::element_t<Xs>::never_throws) {
  detail::each_of<detail::of_log>(use, out, x);
}

/// out[i] = fixproof::log1p(x[i]).
template <detail::number_range Xs, detail::output_of<detail::element_t<Xs>> Out>
void log1p(const Xs& x, Out&& out,
           path use = path::fastest) noexcept(detail::element_t<Xs>::never_throws) {
  detail::each_of<detail::of_log1p>(use, out, x);
}

/// out[i] = fixproof::log2(x[i]).
template <detail::number_range Xs, detail::output_of<detail::element_t<Xs>> Out>
void log2(const Xs& x, Out&& out,
          path use = path::fastest) noexcept(detail::element_t<Xs>::never_throws) {
  detail::each_of<detail::of_log2>(use, out, x);
}

/// out[i] = fixproof::log10(x[i]).
template <detail::number_range Xs, detail::output_of<detail::element_t<Xs>> Out>
void log10(const Xs& x, Out&& out,
           path use = path::fastest) noexcept(detail::element_t<Xs>::never_throws) {
  detail::each_of<detail::of_log10>(use, out, x);
}

/// out[i] = fixproof::sinh(x[i]).
template <detail::number_range Xs, detail::output_of<detail::element_t<Xs>> Out>
void sinh(const Xs& x, Out&& out,
          path use = path::fastest) noexcept(detail::element_t<Xs>::never_throws) {
  detail::each_of<detail::of_sinh>(use, out, x);
}

/// out[i] = fixproof::cosh(x[i]).
template <detail::number_range Xs, detail::output_of<detail::element_t<Xs>> Out>
void cosh(const Xs& x, Out&& out,
          path use = path::fastest) noexcept(detail::element_t<Xs>::never_throws) {
  detail::each_of<detail::of_cosh>(use, out, x);
}

/// out[i] = fixproof::tanh(x[i]).
template <detail::number_range Xs, detail::output_of<detail::element_t<Xs>> Out>
void tanh(const Xs& x, Out&& out,
          path use = path::fastest) noexcept(detail::element_t<Xs>::never_throws) {
  detail::each_of<detail::of_tanh>(use, out, x);
}

/// out[i] = fixproof::sin_of_degrees(x[i]).
template <detail::number_range Xs, detail::output_of<detail::element_t<Xs>> Out>
void sin_of_degrees(const Xs& x, Out&& out,
                    path use = path::fastest) noexcept(detail::element_t<Xs>::never_throws) {
  detail::each_of<detail::of_sin_of_degrees>(use, out, x);
}

/// out[i] = fixproof::cos_of_degrees(x[i]).
template <detail::number_range Xs, detail::output_of<detail::element_t<Xs>> Out>
void cos_of_degrees(const Xs& x, Out&& out,
                    path use = path::fastest) noexcept(detail::element_t<Xs>::never_throws) {
  detail::each_of<detail::of_cos_of_degrees>(use, out, x);
}

/// out[i] = fixproof::tan_of_degrees(x[i]).
template <detail::number_range Xs, detail::output_of<detail::element_t<Xs>> Out>
void tan_of_degrees(const Xs& x, Out&& out,
                    path use = path::fastest) noexcept(detail::element_t<Xs>::never_throws) {
  detail::each_of<detail::of_tan_of_degrees>(use, out, x);
}

/// out[i] = fixproof::sin_of_turns(x[i]).
template <detail::number_range Xs, detail::output_of<detail::element_t<Xs>> Out>
void sin_of_turns(const Xs& x, Out&& out,
                  path use = path::fastest) noexcept(detail::element_t<Xs>::never_throws) {
  detail::each_of<detail::of_sin_of_turns>(use, out, x);
}

/// out[i] = fixproof::cos_of_turns(x[i]).
template <detail::number_range Xs, detail::output_of<detail::element_t<Xs>> Out>
void cos_of_turns(const Xs& x, Out&& out,
                  path use = path::fastest) noexcept(detail::element_t<Xs>::never_throws) {
  detail::each_of<detail::of_cos_of_turns>(use, out, x);
}

/// out[i] = fixproof::tan_of_turns(x[i]).
template <detail::number_range Xs, detail::output_of<detail::element_t<Xs>> Out>
void tan_of_turns(const Xs& x, Out&& out,
                  path use = path::fastest) noexcept(detail::element_t<Xs>::never_throws) {
  detail::each_of<detail::of_tan_of_turns>(use, out, x);
}

/// out[i] = fixproof::sin(x[i]) of radians. fixed/batch/radian.hpp has that of 16.16 and 8.8.
template <detail::number_range Xs, detail::output_of<detail::element_t<Xs>> Out>
requires(!detail::has_radians_of<detail::element_t<Xs>>) void sin(
    const Xs& x, Out&& out,
    path use = path::fastest) noexcept(detail::element_t<Xs>::never_throws) {
  detail::each_of<detail::of_sin>(use, out, x);
}

/// out[i] = fixproof::cos(x[i]) of radians. fixed/batch/radian.hpp has that of 16.16 and 8.8.
template <detail::number_range Xs, detail::output_of<detail::element_t<Xs>> Out>
requires(!detail::has_radians_of<detail::element_t<Xs>>) void cos(
    const Xs& x, Out&& out,
    path use = path::fastest) noexcept(detail::element_t<Xs>::never_throws) {
  detail::each_of<detail::of_cos>(use, out, x);
}

/// out[i] = fixproof::tan(x[i]).
template <detail::number_range Xs, detail::output_of<detail::element_t<Xs>> Out>
void tan(const Xs& x, Out&& out,
         path use = path::fastest) noexcept(detail::element_t<Xs>::never_throws) {
  detail::each_of<detail::of_tan>(use, out, x);
}

/// out[i] = fixproof::atan(x[i]).
template <detail::number_range Xs, detail::output_of<detail::element_t<Xs>> Out>
void atan(const Xs& x, Out&& out,
          path use = path::fastest) noexcept(detail::element_t<Xs>::never_throws) {
  detail::each_of<detail::of_atan>(use, out, x);
}

/// out[i] = fixproof::asin(x[i]).
template <detail::number_range Xs, detail::output_of<detail::element_t<Xs>> Out>
void asin(const Xs& x, Out&& out,
          path use = path::fastest) noexcept(detail::element_t<Xs>::never_throws) {
  detail::each_of<detail::of_asin>(use, out, x);
}

/// out[i] = fixproof::acos(x[i]).
template <detail::number_range Xs, detail::output_of<detail::element_t<Xs>> Out>
void acos(const Xs& x, Out&& out,
          path use = path::fastest) noexcept(detail::element_t<Xs>::never_throws) {
  detail::each_of<detail::of_acos>(use, out, x);
}

/// out[i] = fixproof::cbrt(x[i]).
template <detail::number_range Xs, detail::output_of<detail::element_t<Xs>> Out>
void cbrt(const Xs& x, Out&& out,
          path use = path::fastest) noexcept(detail::element_t<Xs>::never_throws) {
  detail::each_of<detail::of_cbrt>(use, out, x);
}

/// out[i] = fixproof::rsqrt(x[i]).
template <detail::number_range Xs, detail::output_of<detail::element_t<Xs>> Out>
void rsqrt(const Xs& x, Out&& out,
           path use = path::fastest) noexcept(detail::element_t<Xs>::never_throws) {
  detail::each_of<detail::of_rsqrt>(use, out, x);
}

/// out[i] = fixproof::reciprocal(x[i]).
template <detail::number_range Xs, detail::output_of<detail::element_t<Xs>> Out>
void reciprocal(const Xs& x, Out&& out,
                path use = path::fastest) noexcept(detail::element_t<Xs>::never_throws) {
  detail::each_of<detail::of_reciprocal>(use, out, x);
}

/// out[i] = fixproof::atan2(y[i], x[i]).
template <detail::number_range First, detail::input_of<detail::element_t<First>> Second,
          detail::output_of<detail::element_t<First>> Out>
void atan2(const First& y, const Second& x, Out&& out,
           path use = path::fastest) noexcept(detail::element_t<First>::never_throws) {
  detail::each_of<detail::of_atan2>(use, out, y, x);
}

/// out[i] = fixproof::hypot(x[i], y[i]).
template <detail::number_range First, detail::input_of<detail::element_t<First>> Second,
          detail::output_of<detail::element_t<First>> Out>
void hypot(const First& x, const Second& y, Out&& out,
           path use = path::fastest) noexcept(detail::element_t<First>::never_throws) {
  detail::each_of<detail::of_hypot>(use, out, x, y);
}

/// out[i] = fixproof::pow(x[i], y[i]).
template <detail::number_range First, detail::input_of<detail::element_t<First>> Second,
          detail::output_of<detail::element_t<First>> Out>
void pow(const First& x, const Second& y, Out&& out,
         path use = path::fastest) noexcept(detail::element_t<First>::never_throws) {
  detail::each_of<detail::of_pow>(use, out, x, y);
}

/// @cond
FIXED_REFUSED_RANGES(void, exp2, "a path")
FIXED_REFUSED_RANGES(void, exp, "a path")
FIXED_REFUSED_RANGES(void, expm1, "a path")
FIXED_REFUSED_RANGES(void, log, "a path")
FIXED_REFUSED_RANGES(void, log1p, "a path")
FIXED_REFUSED_RANGES(void, log2, "a path")
FIXED_REFUSED_RANGES(void, log10, "a path")
FIXED_REFUSED_RANGES(void, sinh, "a path")
FIXED_REFUSED_RANGES(void, cosh, "a path")
FIXED_REFUSED_RANGES(void, tanh, "a path")
FIXED_REFUSED_RANGES(void, sin_of_degrees, "a path")
FIXED_REFUSED_RANGES(void, cos_of_degrees, "a path")
FIXED_REFUSED_RANGES(void, tan_of_degrees, "a path")
FIXED_REFUSED_RANGES(void, sin_of_turns, "a path")
FIXED_REFUSED_RANGES(void, cos_of_turns, "a path")
FIXED_REFUSED_RANGES(void, tan_of_turns, "a path")
FIXED_REFUSED_RANGES(void, tan, "a path")
FIXED_REFUSED_RANGES(void, atan, "a path")
FIXED_REFUSED_RANGES(void, asin, "a path")
FIXED_REFUSED_RANGES(void, acos, "a path")
FIXED_REFUSED_RANGES(void, cbrt, "a path")
FIXED_REFUSED_RANGES(void, rsqrt, "a path")
FIXED_REFUSED_RANGES(void, reciprocal, "a path")
FIXED_REFUSED_RANGES(void, atan2, "a path")
FIXED_REFUSED_RANGES(void, hypot, "a path")
FIXED_REFUSED_RANGES(void, pow, "a path")
/// @endcond

}  // namespace fixproof::batch
