/// \file
/// Number operations over whole spans, vectorised and bit-identical to the scalar operations.
///
/// Not part of fixed/fixed.hpp, and not for -ffreestanding.
///
///     #include "batch/batch.hpp"
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
/// outputs and marks. Marks must not overlap any other span. No alignment is required.
///
/// **Vertices** are three numbers x, y, z, and points are two. Each is a std::array of numbers or a
/// struct that contains only them.
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

#include "batch/detail/element.hpp"
#include "batch/detail/inlining.hpp"
#include "batch/detail/portable.hpp"
#include "batch/detail/report.hpp"
#include "batch/detail/spans.hpp"
#include "batch/detail/targets.hpp"
#include "fixed/detail/wide_sum.hpp"
#include "fixed/math.hpp"
#include "fixed/number.hpp"

namespace fixproof::batch {

/// Options of a batch operation.
struct options {
  /// The path to use; path::portable replaces one that the processor lacks.
  path use = best();
  /// If not empty, entry i is set to whether element i has a fault, and nothing is thrown.
  std::span<bool> marks = {};
};

}  // namespace fixproof::batch

namespace fixproof::detail {

template <class... Ranges>
std::size_t batch_length(const batch::options& how, const Ranges&... ranges) noexcept {
  const std::size_t count = shortest(ranges...);
  return how.marks.empty() ? count : (std::min)(count, how.marks.size());
}

inline std::span<bool> batch_marks(const batch::options& how, std::size_t count) noexcept {
  return how.marks.empty() ? how.marks : how.marks.first(count);
}

/// The rows of a transform; the fourth column is the translation.
template <class N>
using transform_rows = std::array<std::array<N, 4>, 3>;

template <class N>
raw_transform<typename N::raw_type> raws_of(const transform_rows<N>& rows) noexcept {
  raw_transform<typename N::raw_type> raws;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 4; ++k) raws[i][k] = rows[i][k].raw();
  }
  return raws;
}

/// Runs a batch. Computes a few elements one by one. Computes more on the path of `how`, as far as
/// it goes, and the remaining ones with the number type.
/// \tparam few      up to this many elements are faster one by one
/// \tparam has      whether the loops cover the operation
/// \tparam O        the overflow rule of the operation
/// \tparam Fault    the divide errors of the operation
/// \param blocks    (loops, fault_recorder&) -> number of elements done
/// \param element   (index) -> outcome
/// \param store     (index, raw)
/// \param rest      (number of elements done, fault_recorder&), computes the others
/// \param operation the name in the text of an error
template <std::size_t few, bool has, overflow O, divide_fault Fault, class Blocks, class Element,
          class Store, class Rest>
FIXED_ALWAYS_INLINE batch::report run_batch(const char* operation, const batch::options& how,
                                            std::size_t count, const Blocks& blocks,
                                            const Element& element, const Store& store,
                                            const Rest& rest) {
  fault_recorder found(batch_marks(how, count));
  if (count <= few) {
    few_elements(0, count, found, element, store);
  } else {
    const std::size_t done =
        on_path<has>(how.use, [&](auto loops) { return blocks(loops, found); });
    if (done < count) rest(done, found);
  }
  return found.template finish<O, Fault>(operation);
}

/// The same, with a plain loop for the remaining elements.
template <std::size_t few, bool has, overflow O, divide_fault Fault = divide_fault::none,
          class Blocks, class Element, class Store>
FIXED_ALWAYS_INLINE batch::report run_batch(const char* operation, const batch::options& how,
                                            std::size_t count, const Blocks& blocks,
                                            const Element& element, const Store& store) {
  return run_batch<few, has, O, Fault>(operation, how, count, blocks, element, store,
                                       [&](std::size_t done, fault_recorder& found) {
                                         each_element(done, count, found, element, store);
                                       });
}

template <class N>
inline constexpr bool transform_never_throws = N::never_throws&& N::multiply_never_throws;

template <class N>
inline constexpr bool project_never_throws = N::divide_never_throws&& N::multiply_never_throws;

/// Refuses policies under which some overflows of a transform throw and others do not. A report
/// counts all of them together.
template <class N>
constexpr void check_transform() noexcept {
  static_assert(transform_never_throws<N> || (N::rules.range != overflow::saturate &&
                                              N::rules.product_range() != overflow::saturate),
                "fixproof::batch::transform cannot saturate sums and throw for products, or "
                "saturate products and throw for sums: give both one rule, policy::range");
}

/// The same for a projection.
template <class N>
constexpr void check_project() noexcept {
  static_assert(
      (N::rules.quotient_range() == overflow::trap) == (N::rules.product_range() == overflow::trap),
      "fixproof::batch::project throws for quotients and products alike: give both "
      "overflow::trap, or neither, in policy::quotients and policy::products");
}

/// Returns a function that stores a raw integer as element i of `to`.
template <class N>
auto store_at(N* to) noexcept {
  return [to](std::size_t i, typename N::raw_type raw) { to[i] = N::from_raw(raw); };
}

/// Returns the stored integers at index i of three arrays.
template <class N>
std::array<typename N::raw_type, 3> tuple_at(const std::array<const N*, 3>& from,
                                             std::size_t i) noexcept {
  return {from[0][i].raw(), from[1][i].raw(), from[2][i].raw()};
}

}  // namespace fixproof::detail

namespace fixproof::batch {

/// out[i] = a[i] * b[i].
template <detail::number_range A, detail::input_of<detail::element_t<A>> B,
          detail::output_of<detail::element_t<A>> Out>
FIXED_ALWAYS_INLINE report
multiply(const A& a, const B& b, Out&& out,
         const options& how = {}) noexcept(detail::element_t<A>::multiply_never_throws) {
  using N = detail::element_t<A>;
  const N* const x = std::data(a);
  const N* const y = std::data(b);
  N* const to = std::data(out);
  const std::size_t count = detail::batch_length(how, a, b, out);
  return detail::run_batch<4, detail::has_lanes<N>, N::rules.product_range()>(
      "multiply", how, count,
      [&](auto on, detail::fault_recorder& found) {
        return on.template multiply<N>(x, y, to, count, found);
      },
      [=](std::size_t i) { return detail::multiplied(x[i], y[i]); }, detail::store_at(to));
}

/// out[i] = mul_add(a[i], b[i], c[i]): the product and the sum, rounded once.
template <detail::number_range A, detail::input_of<detail::element_t<A>> B,
          detail::input_of<detail::element_t<A>> C, detail::output_of<detail::element_t<A>> Out>
FIXED_ALWAYS_INLINE report
mul_add(const A& a, const B& b, const C& c, Out&& out,
        const options& how = {}) noexcept(detail::element_t<A>::multiply_never_throws) {
  using N = detail::element_t<A>;
  const N* const x = std::data(a);
  const N* const y = std::data(b);
  const N* const z = std::data(c);
  N* const to = std::data(out);
  const std::size_t count = detail::batch_length(how, a, b, c, out);
  return detail::run_batch<4, detail::has_mul_add_lanes<N>, N::rules.product_range()>(
      "mul_add", how, count,
      [&](auto on, detail::fault_recorder& found) {
        return on.template mul_add<N>(x, y, z, to, count, found);
      },
      [=](std::size_t i) { return detail::multiplied_and_added(x[i], y[i], z[i]); },
      detail::store_at(to));
}

/// out[i] = n[i] / d[i]. Counts every element for which try_divide returns nothing, even if
/// operator/ returns a value for it.
template <detail::number_range Numerators, detail::input_of<detail::element_t<Numerators>> Divisors,
          detail::output_of<detail::element_t<Numerators>> Out>
FIXED_ALWAYS_INLINE report
divide(const Numerators& n, const Divisors& d, Out&& out,
       const options& how = {}) noexcept(detail::element_t<Numerators>::divide_never_throws) {
  using N = detail::element_t<Numerators>;
  constexpr policy P = N::rules;
  const N* const x = std::data(n);
  const N* const y = std::data(d);
  N* const to = std::data(out);
  const std::size_t count = detail::batch_length(how, n, d, out);
  const auto element = [=](std::size_t i) { return detail::divided(x[i], y[i]); };
  constexpr bool has_quotients = detail::has_quotient_lanes<N>;
  return detail::run_batch<4, has_quotients, P.quotient_range(), P.fault>(
      "divide", how, count,
      [&](auto on, detail::fault_recorder& found) {
        return on.template divide<N>(x, y, to, count, found);
      },
      element, detail::store_at(to),
      [&](std::size_t done, detail::fault_recorder& found) {
        if constexpr (N::divide_never_throws && has_quotients) {
          done = detail::divide_blocks(done, x, y, to, count, found, element);
        }
        detail::each_element(done, count, found, element, detail::store_at(to));
      });
}

/// out[i] = sqrt(x[i]). Counts negative operands under every policy.
template <detail::number_range X, detail::output_of<detail::element_t<X>> Out>
FIXED_ALWAYS_INLINE report
sqrt(const X& x, Out&& out, const options& how = {}) noexcept(detail::element_t<X>::never_throws) {
  using N = detail::element_t<X>;
  const N* const from = std::data(x);
  N* const to = std::data(out);
  const std::size_t count = detail::batch_length(how, x, out);
  return detail::run_batch<1, detail::has_root_lanes<N>, N::rules.range>(
      "sqrt", how, count,
      [&](auto on, detail::fault_recorder& found) {
        return on.template sqrt<typename N::raw_type, N::fraction_bits>(from, to, count, found);
      },
      [=](std::size_t i) { return detail::rooted(from[i]); }, detail::store_at(to));
}

/// fixproof::dot(a, b): the sum of a[i] * b[i], exact until it is rounded once. Only the final sum
/// can be out of range; the policy decides the result. Throws as fixproof::dot does.
template <detail::number_range A, detail::input_of<detail::element_t<A>> B>
FIXED_ALWAYS_INLINE detail::element_t<A> dot(const A& a, const B& b, path use = best()) noexcept(
    detail::element_t<A>::multiply_never_throws) {
  using N = detail::element_t<A>;
  if constexpr (!detail::has_lanes<N> ||
                !detail::has_wide_sum<typename N::raw_type, N::fraction_bits>) {
    return fixproof::dot(a, b);
  } else {
    constexpr std::size_t at_once = std::size_t{1} << 30;  // the capacity of loops::dot()
    constexpr std::size_t few = 8;                         // that are faster one by one
    const N* const x = std::data(a);
    const N* const y = std::data(b);
    const std::size_t count = detail::shortest(a, b);
    std::conditional_t<detail::rounds_modulo<N>, std::uint64_t, detail::wide_sum> sum{};
    for (std::size_t done = 0; done < count;) {
      const std::size_t end = done + (std::min)(count - done, at_once);
      if (count > few) {
        done += detail::on_path<true>(use, [&](auto on) {
          return on.template dot<typename N::raw_type>(x + done, y + done, end - done, sum);
        });
      }
      for (; done < end; ++done) {
        const std::int64_t product = std::int64_t{x[done].raw()} * y[done].raw();
        if constexpr (detail::rounds_modulo<N>) {
          sum += static_cast<std::uint64_t>(product);
        } else {
          sum.add(product);
        }
      }
    }
    if constexpr (detail::rounds_modulo<N>) {
      return detail::rounded_sum<N>(sum);
    } else {
      return detail::rounded_sum<N>(sum, count);
    }
  }
}

/// out[i] = in[i] transformed: each product is rounded, then row[0] x + row[1] y + row[2] z +
/// row[3] is summed from the left, as XformVec does. On AVX2 and AVX-512, eight megabytes or more
/// of 32-bit results bypass the caches.
template <class Raw, int F, policy P, detail::tuples_of<number<Raw, F, P>, 3> In,
          detail::output_tuples_of<number<Raw, F, P>, 3> Out>
FIXED_ALWAYS_INLINE report
transform(const detail::transform_rows<number<Raw, F, P>>& rows, const In& in, Out&& out,
          const options& how = {}) noexcept(detail::transform_never_throws<number<Raw, F, P>>) {
  using N = number<Raw, F, P>;
  detail::check_transform<N>();
  const detail::raw_transform<Raw> by = detail::raws_of<N>(rows);
  const void* const from = std::data(in);
  void* const to = std::data(out);
  const std::size_t count = detail::batch_length(how, in, out);
  return detail::run_batch<0, detail::has_lanes<N>, detail::sums_and_products<N>>(
      "transform", how, count,
      [&](auto on, detail::fault_recorder& found) {
        return on.template transform<N>(by, from, to, count, found);
      },
      [=](std::size_t i) {
        return detail::transformed_vertex<N>(by, detail::load_tuple<Raw, 3>(from, i));
      },
      [=](std::size_t i, const auto& v) { detail::store_tuple<Raw, 3>(to, i, v); });
}

/// The same, with each coordinate in its own span.
template <class Raw, int F, policy P, detail::input_of<number<Raw, F, P>> X,
          detail::input_of<number<Raw, F, P>> Y, detail::input_of<number<Raw, F, P>> Z,
          detail::output_of<number<Raw, F, P>> ToX, detail::output_of<number<Raw, F, P>> ToY,
          detail::output_of<number<Raw, F, P>> ToZ>
FIXED_ALWAYS_INLINE report
transform(const detail::transform_rows<number<Raw, F, P>>& rows, const X& x, const Y& y, const Z& z,
          ToX&& to_x, ToY&& to_y, ToZ&& to_z,
          const options& how = {}) noexcept(detail::transform_never_throws<number<Raw, F, P>>) {
  using N = number<Raw, F, P>;
  detail::check_transform<N>();
  const detail::raw_transform<Raw> by = detail::raws_of<N>(rows);
  const std::array<const N*, 3> from{std::data(x), std::data(y), std::data(z)};
  const std::array<N*, 3> to{std::data(to_x), std::data(to_y), std::data(to_z)};
  const std::size_t count = detail::batch_length(how, x, y, z, to_x, to_y, to_z);
  return detail::run_batch<0, detail::has_lanes<N>, detail::sums_and_products<N>>(
      "transform", how, count,
      [&](auto on, detail::fault_recorder& found) {
        return on.template transform<N>(by, std::array<const void*, 3>{from[0], from[1], from[2]},
                                        std::array<void*, 3>{to[0], to[1], to[2]}, count, found);
      },
      [=](std::size_t i) { return detail::transformed_vertex<N>(by, detail::tuple_at(from, i)); },
      [=](std::size_t i, const auto& v) {
        for (std::size_t k = 0; k < 3; ++k) to[k][i] = N::from_raw(v[k]);
      });
}

/// out[i] = the point x / z * constant, y / z * constant of the vertex in[i]. The policy rounds
/// both the quotient and the product. An element has a divide error if either quotient has one.
template <class Raw, int F, policy P, detail::tuples_of<number<Raw, F, P>, 3> In,
          detail::output_tuples_of<number<Raw, F, P>, 2> Out>
FIXED_ALWAYS_INLINE report
project(const In& in, number<Raw, F, P> constant, Out&& out,
        const options& how = {}) noexcept(detail::project_never_throws<number<Raw, F, P>>) {
  using N = number<Raw, F, P>;
  detail::check_project<N>();
  const void* const from = std::data(in);
  void* const to = std::data(out);
  const std::size_t count = detail::batch_length(how, in, out);
  return detail::run_batch<0, detail::has_quotient_lanes<N>, P.quotient_range(), P.fault>(
      "project", how, count,
      [&](auto on, detail::fault_recorder& found) {
        return on.template project<N>(constant.raw(), from, to, count, found);
      },
      [=](std::size_t i) {
        return detail::projected_point(constant, detail::load_tuple<Raw, 3>(from, i));
      },
      [=](std::size_t i, const auto& point) { detail::store_tuple<Raw, 2>(to, i, point); });
}

/// The same, with each coordinate in its own span.
template <class Raw, int F, policy P, detail::input_of<number<Raw, F, P>> X,
          detail::input_of<number<Raw, F, P>> Y, detail::input_of<number<Raw, F, P>> Z,
          detail::output_of<number<Raw, F, P>> ToX, detail::output_of<number<Raw, F, P>> ToY>
FIXED_ALWAYS_INLINE report
project(const X& x, const Y& y, const Z& z, number<Raw, F, P> constant, ToX&& to_x, ToY&& to_y,
        const options& how = {}) noexcept(detail::project_never_throws<number<Raw, F, P>>) {
  using N = number<Raw, F, P>;
  detail::check_project<N>();
  const std::array<const N*, 3> from{std::data(x), std::data(y), std::data(z)};
  const std::array<N*, 2> to{std::data(to_x), std::data(to_y)};
  const std::size_t count = detail::batch_length(how, x, y, z, to_x, to_y);
  return detail::run_batch<0, detail::has_quotient_lanes<N>, P.quotient_range(), P.fault>(
      "project", how, count,
      [&](auto on, detail::fault_recorder& found) {
        return on.template project<N>(constant.raw(),
                                      std::array<const void*, 3>{from[0], from[1], from[2]},
                                      std::array<void*, 2>{to[0], to[1]}, count, found);
      },
      [=](std::size_t i) { return detail::projected_point(constant, detail::tuple_at(from, i)); },
      [=](std::size_t i, const auto& point) {
        for (std::size_t k = 0; k < 2; ++k) to[k][i] = N::from_raw(point[k]);
      });
}

/// \cond
FIXED_REFUSED_RANGES(report, multiply)
FIXED_REFUSED_RANGES(report, mul_add)
FIXED_REFUSED_RANGES(report, divide)
FIXED_REFUSED_RANGES(report, sqrt)
FIXED_REFUSED_RANGES(detail::element_t<X>, dot)
FIXED_REFUSED_RANGES(report, transform)
FIXED_REFUSED_RANGES(report, project)
/// \endcond

}  // namespace fixproof::batch
