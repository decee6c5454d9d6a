/// @file
/// Number operations over whole spans, vectorised and bit-identical to the scalar operations.
///
/// Not part of fixed/fixed.hpp, and not for -ffreestanding.
///
///     #include "fixed/batch/batch.hpp"
///
///     std::vector<fixproof::q16_16> a, b, quotients;                // of equal length
///     const auto report = fixproof::batch::divide(a, b, quotients);
///     if (!report.clean()) std::cout << report.divide_errors << " zero divisors\n";
///
/// **Results** are those of the number type under its policy, element by element. If elements have
/// an error that the number type throws, the batch still completes: those elements get the result
/// of overflow::wrap and divide_fault::none and are counted. Then the first error is thrown, with
/// its index in the text. With `options::marks`, the batch marks these elements and does not throw.
///
/// **Reports** count every element that has a fault; see batch::report.
///
/// **Spans** are vectors, arrays, std::span and anything else with std::data and std::size. The
/// shortest argument, marks included, sets the length of the batch; nothing beyond it is read or
/// written. An output may be the same span as an input. Any other overlap with an input or output
/// leaves the results, report and marks unspecified, but the batch writes nothing outside the
/// outputs and marks. Marks must not overlap any other span, nor an output the rows of a transform.
/// No alignment is required.
///
/// **Vertices** are three numbers x, y, z, and points are two. Each is a std::array of numbers or a
/// struct that contains only them. A class with constructors must have its first as `x` or `[0]`.
///
/// **Formats**: all of 8 to 64 bits, under every policy. Vector registers compute signed formats of
/// 16 and 32 bits, with the exceptions that docs/batch.md lists. All others take the plain loop.
///
/// **Paths**: AVX2 and AVX-512 code is always compiled in, and the processor is queried once. NEON
/// is used if the program is compiled for it. Otherwise a plain loop runs. All paths give the same
/// results and reports. Under -ffast-math and similar flags, where doubles are not exact, divide,
/// sqrt and project use the plain loop. Compile all files of a program that include this header for
/// the same processor (-m, -march), because the linker keeps only one copy of each function.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include "fixed/batch/detail/element.hpp"
#include "fixed/batch/detail/portable.hpp"
#include "fixed/batch/detail/report.hpp"
#include "fixed/batch/detail/run.hpp"
#include "fixed/batch/detail/spans.hpp"
#include "fixed/batch/detail/targets.hpp"
#include "fixed/batch/vertices.hpp"
#include "fixed/detail/inlining.hpp"
#include "fixed/detail/wide_sum.hpp"
#include "fixed/math.hpp"
#include "fixed/number.hpp"

namespace fixproof::detail {

/// The dot product of at least one number, on a path.
template <class Number>
FIXED_ALWAYS_INLINE Number dot_in_blocks(const Number* x, const Number* y, std::size_t count,
                                         batch::path use) {
  return on_path<true>(
      use,
      [=](auto on) FIXED_INLINE {
        if constexpr (rounds_modulo<Number>) {
          return rounded_sum<Number>(on.template dot<std::uint64_t>(x, y, count));
        } else {
          return rounded_sum<Number>(on.template dot<wide_sum>(x, y, count), [count] {
            raise<overflow_error>("overflow", "dot", term_count{count});
          });
        }
      },
      [=] {
        return apart([=] { return fixproof::dot(std::span(x, count), std::span(y, count)); });
      });
}

/// The same in functions of their own, so that short spans need no stack. The first takes the
/// fastest path.
template <class Number>
FIXED_NOINLINE Number long_dot(const Number* x, const Number* y, std::size_t count) {
  return dot_in_blocks(x, y, count, batch::path::fastest);
}
template <class Number>
FIXED_NOINLINE Number long_dot(const Number* x, const Number* y, std::size_t count,
                               batch::path use) {
  return dot_in_blocks(x, y, count, use);
}

}  // namespace fixproof::detail

namespace fixproof::batch {

/// out[i] = a[i] * b[i].
template <detail::number_range First, detail::input_of<detail::element_t<First>> Second,
          detail::output_of<detail::element_t<First>> Out>
FIXED_ALWAYS_INLINE report
multiply(const First& a, const Second& b, Out&& out,
         const options& how = {}) noexcept(detail::element_t<First>::multiply_never_throws) {
  using Number = detail::element_t<First>;
  const std::size_t count = detail::batch_length(how, a, b, out);
  return detail::run_products<detail::has_lanes<Number>>(
      "multiply", how, count,
      [](auto on, auto... args) FIXED_INLINE {
        return on.template run<typename decltype(on)::template products<Number>>(args...);
      },
      [](std::size_t i, const Number* p, const Number* q) {
        return detail::multiplied(p[i], q[i]);
      },
      detail::start_of(out), detail::start_of(a), detail::start_of(b));
}

/// out[i] = mul_add(a[i], b[i], c[i]): the product and the sum, rounded once.
template <detail::number_range First, detail::input_of<detail::element_t<First>> Second,
          detail::input_of<detail::element_t<First>> Third,
          detail::output_of<detail::element_t<First>> Out>
FIXED_ALWAYS_INLINE report
mul_add(const First& a, const Second& b, const Third& c, Out&& out,
        const options& how = {}) noexcept(detail::element_t<First>::multiply_never_throws) {
  using Number = detail::element_t<First>;
  const std::size_t count = detail::batch_length(how, a, b, c, out);
  return detail::run_products<detail::has_mul_add_lanes<Number>>(
      "mul_add", how, count,
      [](auto on, auto... args) FIXED_INLINE {
        return on.template run<typename decltype(on)::template mul_adds<Number>>(args...);
      },
      [](std::size_t i, const Number* x, const Number* y, const Number* z) {
        return detail::multiplied_and_added(x[i], y[i], z[i]);
      },
      detail::start_of(out), detail::start_of(a), detail::start_of(b), detail::start_of(c));
}

/// out[i] = n[i] / d[i]. Counts every element for which try_divide returns nothing, even if
/// operator/ returns a value for it.
template <detail::number_range Numerators, detail::input_of<detail::element_t<Numerators>> Divisors,
          detail::output_of<detail::element_t<Numerators>> Out>
FIXED_ALWAYS_INLINE report
divide(const Numerators& n, const Divisors& d, Out&& out,
       const options& how = {}) noexcept(detail::element_t<Numerators>::divide_never_throws) {
  using Number = detail::element_t<Numerators>;
  constexpr policy Rules = Number::rules;
  const std::size_t count = detail::batch_length(how, n, d, out);
  return detail::run_batch<1, detail::has_quotient_lanes<Number>, Rules.quotient_range(),
                           Rules.fault>(
      "divide", how, count,
      [](auto on, auto... args) FIXED_INLINE {
        return on.template run<typename decltype(on)::template quotients<Number>>(args...);
      },
      detail::quotient_element{}, detail::start_of(out), detail::start_of(n), detail::start_of(d));
}

/// out[i] = sqrt(x[i]). Counts negative operands under every policy.
template <detail::number_range Xs, detail::output_of<detail::element_t<Xs>> Out>
FIXED_ALWAYS_INLINE report sqrt(const Xs& x, Out&& out, const options& how = {}) noexcept(
    detail::element_t<Xs>::never_throws) {
  using Number = detail::element_t<Xs>;
  const std::size_t count = detail::batch_length(how, x, out);
  // Under flags that promise AVX-512, the conversion that clang++ chooses for a single root waits
  // for the root before it.
  constexpr std::size_t few = detail::sure_of_masks && detail::loops_in_vectors ? 0 : 1;
  return detail::run_batch<few, detail::has_root_lanes<Number>, Number::rules.range>(
      "sqrt", how, count,
      [](auto on, auto... args) FIXED_INLINE {
        return on.template run<typename decltype(on)::template roots<typename Number::raw_type,
                                                                     Number::fraction_bits>>(
            args...);
      },
      [](std::size_t i, const Number* from) { return detail::rooted(from[i]); },
      detail::start_of(out), detail::start_of(x));
}

/// fixproof::dot(a, b): the sum of a[i] * b[i], exact until it is rounded once. Only the final sum
/// can be out of range; the policy decides the result. Throws as fixproof::dot does.
template <detail::number_range First, detail::input_of<detail::element_t<First>> Second>
[[nodiscard]] FIXED_ALWAYS_INLINE detail::element_t<First> dot(
    const First& a, const Second& b,
    path use = path::fastest) noexcept(detail::element_t<First>::multiply_never_throws) {
  using Number = detail::element_t<First>;
  if constexpr (!detail::has_lanes<Number> ||
                !detail::has_wide_sum<typename Number::raw_type, Number::fraction_bits>) {
    return fixproof::dot(a, b);
  } else {
    const Number* const x = std::data(a);
    const Number* const y = std::data(b);
    const std::size_t count = detail::shortest(a, b);
    // That are faster one by one.
    constexpr std::size_t few = detail::sure_of_masks ? 1 : 8;
    if (count <= few) return fixproof::dot(std::span(x, count), std::span(y, count));
    if constexpr (detail::sure_of_masks) {
      return detail::dot_in_blocks(x, y, count, use);
    } else {
      return use == path::fastest ? detail::long_dot(x, y, count)
                                  : detail::long_dot(x, y, count, use);
    }
  }
}

/// @cond
FIXED_REFUSED_RANGES(report, multiply, "options")
FIXED_REFUSED_RANGES(report, mul_add, "options")
FIXED_REFUSED_RANGES(report, divide, "options")
FIXED_REFUSED_RANGES(report, sqrt, "options")
FIXED_REFUSED_RANGES(detail::element_t<Xs>, dot, "a path")
/// @endcond

}  // namespace fixproof::batch
