// The same operations for every translation unit; ANSWERS names the function of this one.
#include <span>
#include <string>

#include "fixed/batch/batch.hpp"
#include "fixed/batch/conversions.hpp"
#include "fixed/batch/radian.hpp"
#include "fixed/bytes.hpp"
#include "fixed/fixed.hpp"

std::string ANSWERS();

namespace {

using namespace fixproof;

template <class N>
void append(std::string& text, N n) {
  for (const std::byte byte : to_bytes<std::endian::little>(n)) {
    text.push_back(static_cast<char>(byte));
  }
}

template <class N>
void append_results(std::string& text, N a, N b) {
  append(text, a + b);
  append(text, a * b);
  append(text, a / b);
  append(text, a % b);
  append(text, sqrt(a));
  append(text, mul_div(a, b, a));
  append(text, mul_add(a, b, b));
  append(text, lerp(a, b, a));
  append(text, saturating_multiply(a, a));
  append(text, N(static_cast<double>(a) / 3));
  append(text, a * 3 - 1);
  append(text, (a << 1) + (b >> 2));
  accumulator<N> sum;
  sum.add_product(a, b).add(a);
  append(text, sum.result());
  text += a < b || a == 2 ? '<' : '>';
}

template <class N>
void append_functions(std::string& text, N a, N b) {
  append(text, exp(a));
  append(text, log10(b));
  append(text, tanh(a));
  append(text, tan(a));
  append(text, sin_of_degrees(b));
  append(text, atan2(a, b));
  append(text, acos(a));
  append(text, pow(b, a));
  append(text, rsqrt(b));
  append(text, reciprocal(a));
}

}  // namespace

std::string ANSWERS() {
  std::string text;
  for (int i = 1; i < 2000; ++i) {
    append_results(text, q16_16::from_raw(i * 77'777), q16_16::from_raw(5'000 - i * 13));
    append_results(text, u8_8(i % 200), u8_8::from_raw(static_cast<std::uint16_t>(i)));
    append_results(text, q2_30::from_raw(i * 333'333), q2_30::from_raw(-i * 77'777));
    append_results(text, q48_16::from_raw(i * 1'234'567'890'123), q48_16::from_raw(-i));
    append(text, sin(q16_16::from_raw(i * 99'991)));
    append(text, cos_of_tenths<q16_16>(i));
  }
  for (int i = 1; i < 100; ++i) {
    append_functions(text, q16_16::from_raw(i * 7'777 - 400'000), q16_16::from_raw(i * 99'991));
    append_functions(text, q2_30::from_raw(i * 9'999'999), q2_30::from_raw(i * 7'777'777));
  }
  std::array<q16_16, 512> x{};
  for (std::size_t i = 0; i < x.size(); ++i) {
    x.at(i) = q16_16::from_raw(static_cast<std::int32_t>(i * i * 997));
  }
  std::array<q16_16, 512> y{};
  for (const auto path : {batch::path::portable, batch::best()}) {
    static_cast<void>(batch::multiply(x, x, y, {.use = path}));
    for (const q16_16 n : y) append(text, n);
    static_cast<void>(batch::mul_add(x, x, x, y, {.use = path}));
    for (const q16_16 n : y) append(text, n);
    for (std::size_t i = 0; i < y.size(); ++i) {
      // A single number, by arithmetic that depends on the instructions that the flags allow.
      const std::array<double, 1> from{(static_cast<double>(i) - 255.5) / 131'072};
      static_cast<void>(batch::from_floats(from, std::span(&y.at(i), 1), {.use = path}));
      append(text, y.at(i));
    }
    batch::sin(x, y, path);
    for (const q16_16 n : y) append(text, n);
  }
  return text;
}
