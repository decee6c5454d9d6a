// Target `spans`: a batch function on spans of one buffer, at any offsets and lengths, on every
// path of this processor. A permitted layout must give what a loop over the number type gives on
// copies, with the report, marks and exception of the portable path there. Under any other overlap
// the results are unspecified, but nothing outside the outputs may change.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "fixed/batch/batch.hpp"
#include "fixed/batch/radian.hpp"
#include "fixed/fixed.hpp"
#include "fuzz/finding.hpp"
#include "fuzz/span_layout.hpp"
#include "fuzz/words.hpp"

using namespace fixproof;
using fixproof::batch::path;
using fuzz::Bytes;
using fuzz::Call;
using fuzz::Layout;
using fuzz::Range;
using fuzz::Shape;

namespace {

template <class N>
using Rows = std::array<std::array<N, 4>, 3>;

/// What a call leaves, beside the buffer.
struct CallResult {
  fixproof::batch::report report;
  std::vector<bool> marks;
  std::string thrown;
  std::int64_t sum = 0;  ///< of dot

  friend bool operator==(const CallResult&, const CallResult&) = default;
};

template <class N, std::size_t size>
std::span<std::array<N, size>> tuples(std::span<N> numbers) {
  // NOLINTNEXTLINE(*-reinterpret-cast): an array is its numbers, and the batch takes bytes
  return {reinterpret_cast<std::array<N, size>*>(numbers.data()), numbers.size() / size};
}

template <class N>
fixproof::batch::report call(const Layout& layout, std::span<N> buffer, const Rows<N>& rows,
                             const fixproof::batch::options& how, CallResult& result) {
  const Shape& shape = layout.shape();
  const auto in = [&](std::size_t i) {
    return buffer.subspan(layout.in[i], (layout.count + layout.surplus[i]) * shape.in_width);
  };
  const auto out = [&](std::size_t o) {
    return buffer.subspan(layout.out[o],
                          (layout.count + layout.surplus[shape.inputs + o]) * shape.out_width);
  };
  namespace batch = fixproof::batch;
  switch (layout.call) {
    case Call::multiply:
      return batch::multiply(in(0), in(1), out(0), how);
    case Call::mul_add:
      return batch::mul_add(in(0), in(1), in(2), out(0), how);
    case Call::divide:
      return batch::divide(in(0), in(1), out(0), how);
    case Call::sqrt:
      return batch::sqrt(in(0), out(0), how);
    case Call::transform:
      return batch::transform(rows, tuples<N, 3>(in(0)), tuples<N, 3>(out(0)), how);
    case Call::transform_columns:
      return batch::transform(rows, in(0), in(1), in(2), out(0), out(1), out(2), how);
    case Call::fused_transform:
      return batch::fused_transform(rows, tuples<N, 3>(in(0)), tuples<N, 3>(out(0)), how);
    case Call::fused_transform_columns:
      return batch::fused_transform(rows, in(0), in(1), in(2), out(0), out(1), out(2), how);
    case Call::project:
      return batch::project(tuples<N, 3>(in(0)), rows[0][3], tuples<N, 2>(out(0)), how);
    case Call::project_columns:
      return batch::project(in(0), in(1), in(2), rows[0][3], out(0), out(1), how);
    case Call::sin:
      batch::sin(in(0), out(0), how.use);
      break;
    case Call::cos:
      batch::cos(in(0), out(0), how.use);
      break;
    case Call::sin_cos:
      batch::sin_cos(in(0), out(0), out(1), how.use);
      break;
    case Call::dot:
      result.sum = batch::dot(in(0), in(1), how.use).raw();
      break;
  }
  return {};
}

/// Whether a policy can throw it.
bool is_of_the_type(const std::exception& error) {
  return dynamic_cast<const fixproof::divide_error*>(&error) != nullptr ||
         dynamic_cast<const fixproof::overflow_error*>(&error) != nullptr ||
         dynamic_cast<const fixproof::domain_error*>(&error) != nullptr;
}

template <class N>
CallResult run(const Layout& layout, std::span<N> buffer, const Rows<N>& rows, path use) {
  CallResult result;
  const std::size_t guarded = layout.count + 1;
  const auto marks = std::make_unique<bool[]>(guarded);  // NOLINT(*-avoid-c-arrays): for a span
  std::fill_n(marks.get(), guarded, true);
  fixproof::batch::options how{use, {}};
  if (layout.marked) how.marks = {marks.get(), layout.count};
  try {
    result.report = call(layout, buffer, rows, how, result);
  } catch (const std::exception& error) {
    if (!is_of_the_type(error)) {
      fuzz::report_finding(fmt::format("{}: thrown: {}", layout.text(), error.what()));
    }
    if (layout.marked && layout.count > 0 && layout.call != Call::dot) {
      fuzz::report_finding(fmt::format("{}: thrown in spite of marks", layout.text()));
    }
    result.thrown = error.what();
  }
  result.marks.assign(marks.get(), marks.get() + guarded);
  if (!result.marks.back()) fuzz::report_finding(layout.text() + ": a mark behind the last");
  return result;
}

/// Throws nothing, and gives what a batch writes for an element with an error.
constexpr fixproof::policy quiet(fixproof::policy p) {
  if (p.range == fixproof::overflow::trap) p.range = fixproof::overflow::wrap;
  p.fault = fixproof::divide_fault::none;
  return p;
}

/// Writes what the functions give, element by element, from a copy of the inputs.
template <class N>
void write_expected(const Layout& layout, std::span<const N> from, const Rows<N>& rows,
                    std::span<N> to) {
  using Q = fixproof::number<typename N::raw_type, N::fraction_bits, quiet(N::rules)>;
  const Shape& shape = layout.shape();
  const auto quiet_of = [](N x) { return Q::from_raw(x.raw()); };
  for (std::size_t i = 0; i < layout.count; ++i) {
    // The three numbers of a vertex lie side by side; in columns, each coordinate has its own span.
    const auto x = [&](std::size_t k) {
      return quiet_of(shape.in_width == 1 ? from[layout.in[k] + i]
                                          : from[layout.in[0] + 3 * i + k]);
    };
    const auto put = [&](std::size_t k, Q value) {
      const std::size_t at =
          shape.out_width == 1 ? layout.out[k] + i : layout.out[0] + shape.out_width * i + k;
      to[at] = N::from_raw(value.raw());
    };
    const auto row = [&](std::size_t r, std::size_t c) { return quiet_of(rows[r][c]); };
    switch (layout.call) {
      case Call::multiply:
        put(0, x(0) * x(1));
        break;
      case Call::mul_add:
        put(0, fixproof::mul_add(x(0), x(1), x(2)));
        break;
      case Call::divide:
        put(0, x(0) / x(1));
        break;
      case Call::sqrt:
        put(0, fixproof::sqrt(x(0)));
        break;
      case Call::transform:
      case Call::transform_columns:
        for (std::size_t r = 0; r < 3; ++r) {
          put(r, row(r, 0) * x(0) + row(r, 1) * x(1) + row(r, 2) * x(2) + row(r, 3));
        }
        break;
      case Call::fused_transform:
      case Call::fused_transform_columns:
        for (std::size_t r = 0; r < 3; ++r) {
          fixproof::accumulator<Q> sum;
          sum.add(row(r, 3));
          for (std::size_t k = 0; k < 3; ++k) sum.add_product(row(r, k), x(k));
          put(r, sum.result());
        }
        break;
      case Call::project:
      case Call::project_columns:
        for (std::size_t k = 0; k < 2; ++k) put(k, x(k) / x(2) * row(0, 3));
        break;
      case Call::sin:
        put(0, fixproof::sin(x(0)));
        break;
      case Call::cos:
        put(0, fixproof::cos(x(0)));
        break;
      case Call::sin_cos:
        put(0, fixproof::sin(x(0)));
        put(1, fixproof::cos(x(0)));
        break;
      case Call::dot:  // writes no span
        break;
    }
  }
}

/// The same call with spans that are apart from each other.
template <class N>
CallResult run_apart(const Layout& layout, std::span<const N> buffer, const Rows<N>& rows) {
  const Shape& shape = layout.shape();
  const std::size_t room = (layout.count + 4) * 3;
  std::vector<N> apart(2 * fuzz::most_spans * room);
  Layout moved = layout;
  for (std::size_t i = 0; i < shape.inputs; ++i) {
    moved.in[i] = i * room;
    const Range from = layout.input(i);
    std::copy(buffer.begin() + static_cast<std::ptrdiff_t>(from.first),
              buffer.begin() + static_cast<std::ptrdiff_t>(from.last),
              apart.begin() + static_cast<std::ptrdiff_t>(moved.in[i]));
  }
  for (std::size_t o = 0; o < shape.outputs; ++o) moved.out[o] = (fuzz::most_spans + o) * room;
  return run<N>(moved, apart, rows, path::portable);
}

/// Any word, often a small number or one of those of the input.
template <class N>
N number_of(std::span<const std::uint32_t> words, std::size_t i) {
  constexpr std::uint32_t odd = 0x9E3779B9U;
  std::uint32_t word = words[i % words.size()];
  const std::size_t round = i / words.size();
  if (round % 2 == 1) word = (word + static_cast<std::uint32_t>(i)) * odd;
  const auto raw = static_cast<std::int32_t>(word) >> (round % 3 == 2 ? i % 20 : 0);
  return N::from_raw(static_cast<typename N::raw_type>(raw));
}

/// An element counts once in a report, and its mark says so.
bool marks_fit(const CallResult& result) {
  const auto& report = result.report;
  const auto end = result.marks.end() - 1;  // behind the last element: a guard
  const auto first = std::find(result.marks.begin(), end, true);
  const auto count = static_cast<std::size_t>(std::count(first, end, true));
  const std::size_t at = first == end ? fixproof::batch::report::nowhere
                                      : static_cast<std::size_t>(first - result.marks.begin());
  return count == report.divide_errors + report.overflows + report.domain_errors &&
         at == report.first;
}

bool has_marks(Call call) {
  return call != Call::sin && call != Call::cos && call != Call::sin_cos && call != Call::dot;
}

template <class N>
void check(const Layout& layout, std::span<const std::uint32_t> words) {
  std::vector<N> before(fuzz::buffer_size);
  for (std::size_t i = 0; i < fuzz::buffer_size; ++i) before[i] = number_of<N>(words, i);
  Rows<N> rows;
  for (std::size_t i = 0; i < 12; ++i)
    rows[i / 4][i % 4] = number_of<N>(words, fuzz::buffer_size - i);
  const bool permitted = layout.permitted();
  std::vector<N> want = before;
  CallResult expected;
  if (permitted) {
    write_expected<N>(layout, before, rows, want);
    expected = run_apart<N>(layout, before, rows);
    if constexpr (N::never_throws) {
      if (layout.call == Call::dot) {
        expected.sum = fixproof::dot(std::span(before).subspan(layout.in[0], layout.count),
                                     std::span(before).subspan(layout.in[1], layout.count))
                           .raw();
      }
    }
  }
  for (const path use : {path::portable, path::neon, path::avx2, path::avx512}) {
    if (!fixproof::batch::has(use)) continue;
    std::vector<N> buffer = before;
    const CallResult got = run<N>(layout, buffer, rows, use);
    const auto where = [&] {
      return fmt::format("path {}, {} fraction bits, {}", static_cast<int>(use), N::fraction_bits,
                         layout.text());
    };
    for (std::size_t i = 0; i < fuzz::buffer_size; ++i) {
      const bool free = !permitted && layout.writes(i);
      if (!free && buffer[i].raw() != want[i].raw()) {
        fuzz::report_finding(fmt::format("{}: number {} is {:x}, must be {:x}", where(), i,
                                         buffer[i].raw(), want[i].raw()));
      }
    }
    if (permitted && layout.marked && layout.count > 0 && has_marks(layout.call) &&
        !marks_fit(got)) {
      fuzz::report_finding(where() + ": the marks are not those that the report counts");
    }
    if (permitted && got != expected) {
      fuzz::report_finding(
          fmt::format("{}: another report, mark, sum or exception than on copies: "
                      "'{}', not '{}'",
                      where(), got.thrown, expected.thrown));
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes bytes({data, size});
  const std::size_t type = bytes.next();
  const Layout layout = fuzz::read_layout(bytes);
  constexpr std::size_t most_words = 256;
  std::vector<std::uint32_t> words(
      std::clamp<std::size_t>(bytes.left().size() / fuzz::bytes_of_word, 1, most_words));
  fuzz::read_words(bytes.left(), words);
  switch (type % 4) {
    case 0:
      check<fixproof::q16_16>(layout, words);
      break;
    case 1:
      check<fixproof::q16_16_trapping>(layout, words);
      break;
    case 2:
      check<fixproof::q16_16_saturating>(layout, words);
      break;
    default:
      check<fixproof::q8_8>(layout, words);
      break;
  }
  return 0;
}
