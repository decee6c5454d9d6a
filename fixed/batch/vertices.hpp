/// @file
/// Transforms and projections of vertices: a part of fixed/batch/batch.hpp, which documents them.
#pragma once

#include <array>
#include <cstddef>

#include "fixed/batch/detail/element.hpp"
#include "fixed/batch/detail/report.hpp"
#include "fixed/batch/detail/run.hpp"
#include "fixed/batch/detail/spans.hpp"
#include "fixed/batch/detail/targets.hpp"
#include "fixed/batch/detail/transforms.hpp"
#include "fixed/detail/inlining.hpp"
#include "fixed/number.hpp"

namespace fixproof::detail {

/// Computes vertices or points one by one.
/// @param element (index) -> outcome
template <class Number, std::size_t size, class To, class Element>
FIXED_ALWAYS_INLINE void each_tuple(std::size_t i, std::size_t count, fault_recorder& found,
                                    const To& to, const Element& element) noexcept {
  for (; i < count; ++i) {
    const auto one = element(i);
    store_tuple<Number, size>(to, i, one.raw);
    found.note(one.what, i);
  }
}

/// Transforms vertices in one array, a pointer, or in three, an array of pointers.
/// @tparam Transform rounded_products or rounded_sums
template <template <class> class Transform, class Number, class From, class To>
FIXED_ALWAYS_INLINE batch::report transform_all(
    const transform_rows<Number>& rows, const From& from, const To& to, std::size_t count,
    const batch::options& how) noexcept(Transform<Number>::never_throws) {
  // One vertex is faster without a call.
  if (count == 1) {
    const auto one = transformed(Transform<Number>{rows}, load_tuple<Number, 3>(from, 0));
    if (one.what == fault::none) {
      store_tuple<Number, 3>(to, 0, one.raw);
      return clean_report(how, 1);
    }
  }
  return run_recorded<1, has_lanes<Number>, Transform<Number>::range, divide_fault::none>(
      Transform<Number>::name, how, 0, count,
      [&](auto on, const recording& start) {
        return on.template transform<Transform>(rows, from, to, count, start.found);
      },
      [&](std::size_t done, fault_recorder& found) {
        apart([&, done, count] {
          each_tuple<Number, 3>(done, count, found, to,
                                [&, by = Transform<Number>{rows}](std::size_t i) {
                                  return transformed(by, load_tuple<Number, 3>(from, i));
                                });
        });
      });
}

template <class Number>
inline constexpr bool project_never_throws =
    Number::divide_never_throws&& Number::multiply_never_throws;

/// Projects vertices, as transform_all() transforms them.
template <class Number, class From, class To>
FIXED_ALWAYS_INLINE batch::report project_all(
    const From& from, Number constant, const To& to, std::size_t count,
    const batch::options& how) noexcept(project_never_throws<Number>) {
  constexpr policy Rules = Number::rules;
  static_assert(
      (Rules.quotient_range() == overflow::trap) == (Rules.product_range() == overflow::trap),
      "fixproof::batch::project throws for quotients and products alike: give both "
      "overflow::trap, or neither, in policy::quotients and policy::products");
  return run_recorded<0, has_quotient_lanes<Number>, Rules.quotient_range(), Rules.fault>(
      "project", how, 0, count,
      [&](auto on, const recording& start) {
        return on.project(constant, from, to, count, start.found);
      },
      [&](std::size_t done, fault_recorder& found) {
        each_tuple<Number, 2>(done, count, found, to, [&](std::size_t i) {
          return projected_point(constant, load_tuple<Number, 3>(from, i));
        });
      });
}

}  // namespace fixproof::detail

/// What the refusal of a transform says.
// NOLINTNEXTLINE(cppcoreguidelines-macro-usage): an attribute needs a literal
#define FIXED_TRANSFORM_TAKES                                                                   \
  "rows are std::array<std::array<N, 4>, 3>, and a vertex has 3 numbers N; results come last, " \
  "neither const nor temporary; options may follow"

namespace fixproof::batch {

/// out[i] = in[i] transformed: each product is rounded, then row[0] x + row[1] y + row[2] z +
/// row[3] is summed from the left, as XformVec does. On AVX2 and AVX-512, eight megabytes or more
/// of 32-bit results bypass the caches.
template <class Number, detail::tuples_of<Number, 3> In, detail::output_tuples_of<Number, 3> Out>
FIXED_ALWAYS_INLINE report
transform(const detail::transform_rows<Number>& rows, const In& in, Out&& out,
          const options& how = {}) noexcept(detail::rounded_products<Number>::never_throws) {
  return detail::transform_all<detail::rounded_products>(
      rows, static_cast<const void*>(std::data(in)), static_cast<void*>(std::data(out)),
      detail::batch_length(how, in, out), how);
}

/// The same, with each coordinate in its own span.
template <class Number, detail::input_of<Number> Xs, detail::input_of<Number> Ys,
          detail::input_of<Number> Zs, detail::output_of<Number> ToX, detail::output_of<Number> ToY,
          detail::output_of<Number> ToZ>
FIXED_ALWAYS_INLINE report
transform(const detail::transform_rows<Number>& rows, const Xs& x, const Ys& y, const Zs& z,
          ToX&& to_x, ToY&& to_y, ToZ&& to_z,
          const options& how = {}) noexcept(detail::rounded_products<Number>::never_throws) {
  return detail::transform_all<detail::rounded_products>(
      rows, std::array<const Number*, 3>{std::data(x), std::data(y), std::data(z)},
      std::array<Number*, 3>{std::data(to_x), std::data(to_y), std::data(to_z)},
      detail::batch_length(how, x, y, z, to_x, to_y, to_z), how);
}

/// out[i] = in[i] transformed: each row[0] x + row[1] y + row[2] z + row[3] is exact until it is
/// rounded once, as by fixproof::accumulator. Only that result can be out of range; the policy
/// handles it as for products. More exact than transform() and faster, but not what XformVec does.
/// Large results bypass the caches, as there.
template <class Number, detail::tuples_of<Number, 3> In, detail::output_tuples_of<Number, 3> Out>
FIXED_ALWAYS_INLINE report
fused_transform(const detail::transform_rows<Number>& rows, const In& in, Out&& out,
                const options& how = {}) noexcept(detail::rounded_sums<Number>::never_throws) {
  return detail::transform_all<detail::rounded_sums>(rows, static_cast<const void*>(std::data(in)),
                                                     static_cast<void*>(std::data(out)),
                                                     detail::batch_length(how, in, out), how);
}

/// The same, with each coordinate in its own span.
template <class Number, detail::input_of<Number> Xs, detail::input_of<Number> Ys,
          detail::input_of<Number> Zs, detail::output_of<Number> ToX, detail::output_of<Number> ToY,
          detail::output_of<Number> ToZ>
FIXED_ALWAYS_INLINE report
fused_transform(const detail::transform_rows<Number>& rows, const Xs& x, const Ys& y, const Zs& z,
                ToX&& to_x, ToY&& to_y, ToZ&& to_z,
                const options& how = {}) noexcept(detail::rounded_sums<Number>::never_throws) {
  return detail::transform_all<detail::rounded_sums>(
      rows, std::array<const Number*, 3>{std::data(x), std::data(y), std::data(z)},
      std::array<Number*, 3>{std::data(to_x), std::data(to_y), std::data(to_z)},
      detail::batch_length(how, x, y, z, to_x, to_y, to_z), how);
}

/// out[i] = the point x / z * constant, y / z * constant of the vertex in[i]. The policy rounds
/// both the quotient and the product. An element has a divide error if either quotient has one.
template <class Number, detail::tuples_of<Number, 3> In, detail::output_tuples_of<Number, 2> Out>
FIXED_ALWAYS_INLINE report
project(const In& in, Number constant, Out&& out,
        const options& how = {}) noexcept(detail::project_never_throws<Number>) {
  return detail::project_all(static_cast<const void*>(std::data(in)), constant,
                             static_cast<void*>(std::data(out)), detail::batch_length(how, in, out),
                             how);
}

/// The same, with each coordinate in its own span.
template <class Number, detail::input_of<Number> Xs, detail::input_of<Number> Ys,
          detail::input_of<Number> Zs, detail::output_of<Number> ToX, detail::output_of<Number> ToY>
FIXED_ALWAYS_INLINE report
project(const Xs& x, const Ys& y, const Zs& z, Number constant, ToX&& to_x, ToY&& to_y,
        const options& how = {}) noexcept(detail::project_never_throws<Number>) {
  return detail::project_all(std::array<const Number*, 3>{std::data(x), std::data(y), std::data(z)},
                             constant, std::array<Number*, 2>{std::data(to_x), std::data(to_y)},
                             detail::batch_length(how, x, y, z, to_x, to_y), how);
}

/// @cond
template <detail::sized Rows, detail::sized Xs, class... Type>
report transform(const Rows&, const Xs&, const Type&...) FIXED_INSTEAD(FIXED_TRANSFORM_TAKES);
template <detail::sized Rows, detail::sized Xs, class... Type>
report fused_transform(const Rows&, const Xs&, const Type&...) FIXED_INSTEAD(FIXED_TRANSFORM_TAKES);
FIXED_REFUSED_BATCH(report, project,
                    "a vertex has 3 numbers N, a point has 2, and the constant is an N; points "
                    "come last, neither const nor temporary; options may follow")
/// @endcond

}  // namespace fixproof::batch
