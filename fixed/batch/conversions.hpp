/// @file
/// Conversions of many numbers from and to float and double, bit-identical to the conversions of
/// one number. Not part of fixed/fixed.hpp.
///
///     std::vector<double> x(1000);
///     std::vector<fixproof::q16_16> numbers(1000);
///     fixproof::batch::from_floats(x, numbers);
///     fixproof::batch::to_floats(numbers, x);
///
/// Spans, paths, marks and reports are those of fixed/batch/batch.hpp. Unlike there, no two spans
/// may overlap.
#pragma once

#include <array>  // std::data, std::size
#include <cstddef>

#include "fixed/batch/batch.hpp"
#include "fixed/batch/detail/element.hpp"
#include "fixed/batch/detail/spans.hpp"
#include "fixed/batch/detail/targets.hpp"
#include "fixed/detail/floating.hpp"
#include "fixed/detail/inlining.hpp"
#include "fixed/math.hpp"

namespace fixproof::detail {

/// A range of float or double.
template <class Range>
concept float_range = sized<Range> && binary_float<element_t<Range>>;

/// A range of float or double that can be written.
template <class Range>
concept float_output = float_range<Range> && written<Range, element_t<Range>>;

}  // namespace fixproof::detail

namespace fixproof::batch {

/// out[i] = Number(x[i]), for float or double. Under every policy, NaN counts as a domain error.
/// Under overflow::saturate and overflow::trap, infinities and other values out of range count as
/// overflows.
template <detail::float_range Xs, detail::number_range Out>
requires detail::output_of<Out, detail::element_t<Out>> FIXED_ALWAYS_INLINE report
from_floats(const Xs& x, Out&& out, const options& how = {})
noexcept(detail::element_t<Out>::never_throws) {
  using Number = detail::element_t<Out>;
  using Float = detail::element_t<Xs>;
  const std::size_t count = detail::batch_length(how, x, out);
  constexpr std::size_t few = detail::sure_of_masks ? 0 : 1;
  return detail::run_batch<few, detail::has_float_lanes<Number>, Number::rules.range,
                           divide_fault::none, detail::all_blocks>(
      "from_floats", how, count,
      [](auto on, auto... args) FIXED_INLINE {
        return on.template run<typename decltype(on)::template from_floats<Number, Float>>(args...);
      },
      detail::from_float_element<Number>{}, detail::start_of(out), detail::start_of(x));
}

/// out[i] = the float or double nearest to x[i], with ties to even, in every rounding mode of the
/// processor.
template <detail::number_range Xs, detail::float_output Out>
FIXED_ALWAYS_INLINE void to_floats(const Xs& x, Out&& out, path use = path::fastest) noexcept {
  using Number = detail::element_t<Xs>;
  using Float = detail::element_t<Out>;
  detail::run_faultless<detail::has_float_lanes<Number>>(
      use, detail::shortest(x, out),
      [](auto on, auto... args) FIXED_INLINE {
        return on.template run<typename decltype(on)::template to_floats<Number, Float>>(args...);
      },
      [](std::size_t i, const Number* from) {
        return detail::outcome<Float>{static_cast<Float>(from[i])};
      },
      detail::start_of(out), detail::start_of(x));
}

/// @cond
FIXED_REFUSED_BATCH(report, from_floats,
                    "from_floats reads floats or doubles and writes numbers; options may follow")
FIXED_REFUSED_BATCH(void, to_floats,
                    "to_floats reads numbers and writes floats or doubles; a path may follow")
/// @endcond

}  // namespace fixproof::batch
