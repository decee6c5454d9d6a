/// @file
/// What the target `spans` calls, and where in one buffer the spans of the call are.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fixproof::fuzz {

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

inline constexpr std::array<Shape, 14> shapes{{{"multiply", 2, 1, 1, 1},
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

inline constexpr std::size_t most_spans = 3;
inline constexpr std::size_t buffer_size = 4096;

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
  /// As fixed/batch/batch.hpp permits it.
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
inline std::size_t place(Bytes& bytes, std::span<const Range> others, std::size_t size) {
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

inline Layout read_layout(Bytes& bytes) {
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
  for (std::size_t i = 0; i < layout.shape().inputs; ++i) {
    add(layout.shape().in_width, layout.in[i]);
  }
  for (std::size_t o = 0; o < layout.shape().outputs; ++o) {
    add(layout.shape().out_width, layout.out[o]);
  }
  return layout;
}

}  // namespace fixproof::fuzz
