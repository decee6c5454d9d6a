// Tests the C++ inner loops against their definitions, pixel by pixel in 64 bits.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "tests/support/test.hpp"
#include "xsharp/raster/depth_row.hpp"
#include "xsharp/raster/parabola.hpp"
#include "xsharp/raster/span_loops.hpp"

namespace {

using namespace xsharp;
using Bytes = std::vector<std::uint8_t>;

/// Bits `low` to `low + bits - 1` of the value after `i` steps.
std::uint64_t after(std::uint64_t start, std::uint64_t step, std::size_t i, unsigned low,
                    unsigned bits) {
  return (start + i * step) >> low & ((std::uint64_t{1} << bits) - 1);
}

std::size_t length() { return *rc::gen::inRange<std::size_t>(0, longest_span + 1); }

RC_GTEST_PROP(SurfaceLoops, Gouraud, (std::uint16_t start, std::uint16_t step)) {
  Bytes out(length());
  PlainLoops().gouraud(out, start, step);
  for (std::size_t i = 0; i < out.size(); ++i) RC_ASSERT(out[i] == after(start, step, i, 8, 8));
}

RC_GTEST_PROP(SurfaceLoops, GouraudWide, (std::uint32_t start, std::uint32_t step)) {
  Bytes out(length());
  PlainLoops().gouraud_wide(out, start, step);
  for (std::size_t i = 0; i < out.size(); ++i) RC_ASSERT(out[i] == after(start, step, i, 16, 8));
}

RC_GTEST_PROP(SurfaceLoops, DepthWritesWhatIsGreater, (std::uint32_t start, std::uint32_t step)) {
  const std::size_t count = length();
  std::vector<std::int16_t> buffer(count);
  for (auto& depth : buffer) depth = *rc::gen::arbitrary<std::int16_t>();
  for (const bool reversed : {false, true}) {
    const auto before = buffer;
    Bytes out(count, 1);
    if (reversed) {
      depth_row(out, buffer, Bytes(count, 2), {start, step}, true);
    } else {
      PlainLoops().depth(out, buffer, 2, start, step);
      Bytes by_row(count, 1);
      auto again = before;
      depth_row(by_row, again, Bytes(count, 2), {start, step}, false);
      RC_ASSERT(by_row == out);
      RC_ASSERT(again == buffer);
    }
    for (std::size_t i = 0; i < count; ++i) {
      const auto depth = static_cast<std::int16_t>(after(start, step, i, 8, 16));
      const bool nearer = reversed ? depth < before[i] : depth > before[i];
      RC_ASSERT(out[i] == (nearer ? 2 : 1));
      RC_ASSERT(buffer[i] == (nearer ? depth : before[i]));
    }
  }
}

RC_GTEST_PROP(SurfaceLoops, Texture,
              (std::uint32_t u, std::uint32_t du, std::uint32_t v, std::uint32_t dv)) {
  Bytes bitmap(bitmap_texels);
  for (std::size_t i = 0; i < bitmap.size(); ++i) {
    bitmap[i] = static_cast<std::uint8_t>(i * 31 ^ i >> 8U);
  }
  Bytes out(length());
  PlainLoops().texture(out, bitmap, u, du, v, dv);
  for (std::size_t i = 0; i < out.size(); ++i) {
    RC_ASSERT(out[i] == bitmap[after(v, dv, i, 8, 8) * 256 + after(u, du, i, 8, 8)]);
  }
}

// Pixel i has i steps and i (i - 1) / 2 second steps.
RC_GTEST_PROP(SurfaceLoops, Quadratic,
              (std::uint32_t start, std::uint32_t step, std::uint32_t second)) {
  Bytes out(length());
  quadratic(out, {start, step, second});
  for (std::size_t i = 0; i < out.size(); ++i) {
    const auto word = static_cast<std::uint32_t>(start + i * step + i * (i - 1) / 2 * second);
    RC_ASSERT(out[i] == word >> 24U);
  }
}

// 10 + x^2 / 2 is 10, 12 and 18 at x = 0, 2 and 4.
TEST(SurfaceLoops, AParabolaGoesThroughItsThreeValues) {
  using N = fixproof::q16_16_i386;
  const Parabola p = parabola_through(N(10), N(12), N(18), 4);
  EXPECT_EQ(p.start, 10U << 24U);
  EXPECT_EQ(p.step, 1U << 23U);
  EXPECT_EQ(p.second, 1U << 24U);
  Bytes out(5);
  quadratic(out, p);
  EXPECT_EQ(out, (Bytes{10, 10, 12, 14, 18}));
  Bytes one(1);
  quadratic(one, parabola_through(N(10), N(10), N(10), 0));
  EXPECT_EQ(one[0], 10);
}

}  // namespace
