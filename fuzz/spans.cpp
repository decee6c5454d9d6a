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
#include <string_view>
#include <vector>

#include "batch/batch.hpp"
#include "batch/radian.hpp"
#include "fixed/fixed.hpp"
#include "fuzz/finding.hpp"
#include "fuzz/words.hpp"

using namespace fixproof;
using fixproof::batch::path;

namespace {

/// The spans that a function takes, and how many numbers make up one element of each.
struct Shape {
  std::string_view name;
  std::size_t inputs;
  std::size_t in_width;
  std::size_t outputs;
  std::size_t out_width;
};

enum class Call {
  multiply,
  mul_add,
  divide,
  sqrt,
  transform,
  transform_columns,
  project,
  project_columns,
  sin,
  cos,
  sin_cos,
  dot,
  fused_transform,
  fused_transform_columns
};

constexpr std::array<Shape, 14> shapes{{{"multiply", 2, 1, 1, 1},
                                        {"mul_add", 3, 1, 1, 1},
                                        {"divide", 2, 1, 1, 1},
                                        {"sqrt", 1, 1, 1, 1},
                                        {"transform", 1, 3, 1, 3},
                                        {"transform of columns", 3, 1, 3, 1},
                                        {"project", 1, 3, 1, 2},
                                        {"project of columns", 3, 1, 2, 1},
                                        {"sin", 1, 1, 1, 1},
                                        {"cos", 1, 1, 1, 1},
                                        {"sin_cos", 1, 1, 2, 1},
                                        {"dot", 2, 1, 0, 1},
                                        {"fused_transform", 1, 3, 1, 3},
                                        {"fused_transform of columns", 3, 1, 3, 1}}};

constexpr std::size_t most_spans = 3;
constexpr std::size_t buffer_size = 4096;

/// Numbers of the buffer.
struct Range {
  std::size_t first = 0;
  std::size_t last = 0;  ///< one past the end

  [[nodiscard]] bool meets(const Range& other) const {
    return first < other.last && other.first < last;
  }
};

struct Layout {
  Call call = Call::multiply;
  std::size_t count = 0;                     ///< elements that the function computes
  std::array<std::size_t, most_spans> in{};  ///< first numbers
  std::array<std::size_t, most_spans> out{};
  std::array<std::size_t, 2 * most_spans> surplus{};  ///< elements of each span beyond `count`
  bool marked = false;

  [[nodiscard]] const Shape& shape() const { return shapes[static_cast<std::size_t>(call)]; }
  [[nodiscard]] Range input(std::size_t i) const {
    return {in[i], in[i] + count * shape().in_width};
  }
  [[nodiscard]] Range output(std::size_t i) const {
    return {out[i], out[i] + count * shape().out_width};
  }
  /// As batch/batch.hpp permits it.
  [[nodiscard]] bool permitted() const {
    for (std::size_t o = 0; o < shape().outputs; ++o) {
      for (std::size_t i = 0; i < shape().inputs; ++i) {
        const bool same = in[i] == out[o] && shape().in_width == shape().out_width;
        if (!same && output(o).meets(input(i))) return false;
      }
      for (std::size_t other = 0; other < o; ++other) {
        if (output(o).meets(output(other))) return false;
      }
    }
    return true;
  }
  [[nodiscard]] bool writes(std::size_t number) const {
    for (std::size_t o = 0; o < shape().outputs; ++o) {
      if (output(o).meets({number, number + 1})) return true;
    }
    return false;
  }
  [[nodiscard]] std::string text() const {
    std::string said = fmt::format("{}, {} elements, marks {}", shape().name, count, marked);
    for (std::size_t i = 0; i < shape().inputs; ++i) said += fmt::format(", input {}", in[i]);
    for (std::size_t o = 0; o < shape().outputs; ++o) said += fmt::format(", output {}", out[o]);
    return said;
  }
};

/// Takes bytes of the input one by one; zeros once they are used up.
class Bytes {
 public:
  explicit Bytes(std::span<const std::uint8_t> bytes) : left_(bytes) {}
  std::size_t next() {
    if (left_.empty()) return 0;
    const std::uint8_t byte = left_.front();
    left_ = left_.subspan(1);
    return byte;
  }
  [[nodiscard]] std::span<const std::uint8_t> left() const { return left_; }

 private:
  std::span<const std::uint8_t> left_;
};

/// A place for a span of `size` numbers: often that of another span, or right behind it.
std::size_t place(Bytes& bytes, std::span<const Range> others, std::size_t size) {
  const std::size_t kind = bytes.next();
  const std::size_t at = bytes.next();
  std::size_t first = at * 7 + kind % 64;
  if (!others.empty() && kind >= 64) {
    const Range& other = others[at % others.size()];
    // The same place, right behind, or a few numbers away on either side.
    first = other.first;
    if (kind >= 128) first = other.last;
    if (kind >= 192) first = other.first + kind % 64 < 32 ? 0 : other.first + kind % 64 - 32;
  }
  return std::min(first, buffer_size - size);
}

Layout read_layout(Bytes& bytes) {
  Layout layout;
  layout.call = static_cast<Call>(bytes.next() % shapes.size());
  layout.marked = bytes.next() % 2 == 1;
  layout.count = bytes.next();
  for (std::size_t& one : layout.surplus) one = bytes.next() % 4;
  // One span ends the batch.
  const std::size_t spans = layout.shape().inputs + layout.shape().outputs;
  layout.surplus[bytes.next() % spans] = 0;
  std::vector<Range> taken;
  const auto add = [&](std::size_t width, std::size_t& first) {
    first = place(bytes, taken, (layout.count + 4) * width);
    taken.push_back({first, first + layout.count * width});
  };
  for (std::size_t i = 0; i < layout.shape().inputs; ++i)
    add(layout.shape().in_width, layout.in[i]);
  for (std::size_t o = 0; o < layout.shape().outputs; ++o) {
    add(layout.shape().out_width, layout.out[o]);
  }
  return layout;
}

template <class N>
using Rows = std::array<std::array<N, 4>, 3>;

/// What a call leaves, beside the buffer.
struct Ending {
  fixproof::batch::report report;
  std::vector<bool> marks;
  std::string thrown;
  std::int64_t sum = 0;  ///< of dot

  friend bool operator==(const Ending&, const Ending&) = default;
};

template <class N, std::size_t size>
std::span<std::array<N, size>> tuples(std::span<N> numbers) {
  // NOLINTNEXTLINE(*-reinterpret-cast): an array is its numbers, and the batch takes bytes
  return {reinterpret_cast<std::array<N, size>*>(numbers.data()), numbers.size() / size};
}

template <class N>
fixproof::batch::report call(const Layout& layout, std::span<N> buffer, const Rows<N>& rows,
                             const fixproof::batch::options& how, Ending& ending) {
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
      ending.sum = batch::dot(in(0), in(1), how.use).raw();
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
Ending run(const Layout& layout, std::span<N> buffer, const Rows<N>& rows, path use) {
  Ending ending;
  const std::size_t guarded = layout.count + 1;
  const auto marks = std::make_unique<bool[]>(guarded);  // NOLINT(*-avoid-c-arrays): for a span
  std::fill_n(marks.get(), guarded, true);
  fixproof::batch::options how{use, {}};
  if (layout.marked) how.marks = {marks.get(), layout.count};
  try {
    ending.report = call(layout, buffer, rows, how, ending);
  } catch (const std::exception& error) {
    if (!is_of_the_type(error)) {
      fuzz::report_finding(fmt::format("{}: thrown: {}", layout.text(), error.what()));
    }
    if (layout.marked && layout.count > 0 && layout.call != Call::dot) {
      fuzz::report_finding(fmt::format("{}: thrown in spite of marks", layout.text()));
    }
    ending.thrown = error.what();
  }
  ending.marks.assign(marks.get(), marks.get() + guarded);
  if (!ending.marks.back()) fuzz::report_finding(layout.text() + ": a mark behind the last");
  return ending;
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
        put(0, fixproof::cos(x(0)));
        put(1, fixproof::sin(x(0)));
        break;
      case Call::dot:  // writes no span
        break;
    }
  }
}

/// The same call with spans that are apart from each other.
template <class N>
Ending run_apart(const Layout& layout, std::span<const N> buffer, const Rows<N>& rows) {
  const Shape& shape = layout.shape();
  const std::size_t room = (layout.count + 4) * 3;
  std::vector<N> apart(2 * most_spans * room);
  Layout moved = layout;
  for (std::size_t i = 0; i < shape.inputs; ++i) {
    moved.in[i] = i * room;
    const Range from = layout.input(i);
    std::copy(buffer.begin() + static_cast<std::ptrdiff_t>(from.first),
              buffer.begin() + static_cast<std::ptrdiff_t>(from.last),
              apart.begin() + static_cast<std::ptrdiff_t>(moved.in[i]));
  }
  for (std::size_t o = 0; o < shape.outputs; ++o) moved.out[o] = (most_spans + o) * room;
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
bool marks_fit(const Ending& ending) {
  const auto& report = ending.report;
  const auto end = ending.marks.end() - 1;  // behind the last element: a guard
  const auto first = std::find(ending.marks.begin(), end, true);
  const auto count = static_cast<std::size_t>(std::count(first, end, true));
  const std::size_t at = first == end ? fixproof::batch::report::nowhere
                                      : static_cast<std::size_t>(first - ending.marks.begin());
  return count == report.divide_errors + report.overflows + report.domain_errors &&
         at == report.first;
}

bool has_marks(Call call) {
  return call != Call::sin && call != Call::cos && call != Call::sin_cos && call != Call::dot;
}

template <class N>
void check(const Layout& layout, std::span<const std::uint32_t> words) {
  std::vector<N> before(buffer_size);
  for (std::size_t i = 0; i < buffer_size; ++i) before[i] = number_of<N>(words, i);
  Rows<N> rows;
  for (std::size_t i = 0; i < 12; ++i) rows[i / 4][i % 4] = number_of<N>(words, buffer_size - i);
  const bool permitted = layout.permitted();
  std::vector<N> want = before;
  Ending ending;
  if (permitted) {
    write_expected<N>(layout, before, rows, want);
    ending = run_apart<N>(layout, before, rows);
    if constexpr (N::never_throws) {
      if (layout.call == Call::dot) {
        ending.sum = fixproof::dot(std::span(before).subspan(layout.in[0], layout.count),
                                   std::span(before).subspan(layout.in[1], layout.count))
                         .raw();
      }
    }
  }
  for (const path use : {path::portable, path::neon, path::avx2, path::avx512}) {
    if (!fixproof::batch::has(use)) continue;
    std::vector<N> buffer = before;
    const Ending got = run<N>(layout, buffer, rows, use);
    const auto where = [&] {
      return fmt::format("path {}, {} fraction bits, {}", static_cast<int>(use), N::fraction_bits,
                         layout.text());
    };
    for (std::size_t i = 0; i < buffer_size; ++i) {
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
    if (permitted && got != ending) {
      fuzz::report_finding(
          fmt::format("{}: another report, mark, sum or exception than on copies: "
                      "'{}', not '{}'",
                      where(), got.thrown, ending.thrown));
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes bytes({data, size});
  const std::size_t type = bytes.next();
  const Layout layout = read_layout(bytes);
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
