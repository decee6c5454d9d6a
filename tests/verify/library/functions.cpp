// Functions for `fixproof verify --against ./libjudged.so:NAME`: right ones, wrong ones and ones
// that fault.
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>

namespace {

// Division by zero must reach the processor, which a compiler may assume it never does.
template <class Int>
Int divided(Int a, Int b) {
  volatile Int divisor = b;
  return a / divisor;
}

}  // namespace

extern "C" {

std::int32_t mul(std::int32_t a, std::int32_t b) {
  return static_cast<std::int32_t>((std::int64_t{a} * b + 0x8000) >> 16);
}

std::int32_t mul_floor(std::int32_t a, std::int32_t b) {
  return static_cast<std::int32_t>((std::int64_t{a} * b) >> 16);
}

/// Ends the program.
std::int32_t mul_exits(std::int32_t /*a*/, std::int32_t /*b*/) { std::exit(0); }

/// Wrong for one pair of 2^64.
std::int32_t mul_but_one(std::int32_t a, std::int32_t b) {
  return mul(a, b) + (a == 0x10000 && b == 0x10000 ? 1 : 0);
}

void muls(const std::int32_t* a, const std::int32_t* b, std::int32_t* results, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) results[i] = mul(a[i], b[i]);
}

std::int16_t mul_8_8(std::int16_t a, std::int16_t b) {
  return static_cast<std::int16_t>((std::int32_t{a} * b + 0x80) >> 8);
}

std::int32_t mul_8_8_to_24_8(std::int16_t a, std::int16_t b) {
  return (std::int32_t{a} * b + 0x80) >> 8;
}

void muls_16_16_to_8_8(const std::int32_t* a, const std::int32_t* b, std::int16_t* results,
                       std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    results[i] = static_cast<std::int16_t>((std::int64_t{a[i]} * b[i] + 0x800000) >> 24);
  }
}

std::uint8_t add_u8_0(std::uint8_t a, std::uint8_t b) { return static_cast<std::uint8_t>(a + b); }

std::int64_t sub_32_32(std::int64_t a, std::int64_t b) {
  return static_cast<std::int64_t>(static_cast<std::uint64_t>(a) - static_cast<std::uint64_t>(b));
}

/// Half up is the floor of n / d + 1/2.
std::int32_t quotient(std::int32_t a, std::int32_t b) {
  const std::int64_t n = std::int64_t{a} * 0x20000 + b;
  const std::int64_t d = std::int64_t{b} * 2;
  const std::int64_t truncated = divided(n, d);
  const bool is_above = n % d != 0 && (n < 0) != (d < 0);
  return static_cast<std::int32_t>(truncated - (is_above ? 1 : 0));
}

void quotients(const std::int32_t* a, const std::int32_t* b, std::int32_t* results,
               std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) results[i] = quotient(a[i], b[i]);
}

void transform(const std::int32_t* matrix, const std::int32_t* vector, std::int32_t* result) {
  for (std::size_t row = 0; row < 3; ++row) {
    auto sum = static_cast<std::uint32_t>(matrix[4 * row + 3]);
    for (std::size_t k = 0; k < 3; ++k) {
      sum += static_cast<std::uint32_t>(mul(matrix[4 * row + k], vector[k]));
    }
    result[row] = static_cast<std::int32_t>(sum);
  }
}

std::int32_t mul_at_null(std::int32_t a, std::int32_t b) {
  if (a != 0x10000 || b != 0x10000) return mul(a, b);
  const volatile std::int32_t* volatile nothing = nullptr;
  return *nothing;
}

/// Calls itself until the stack is used up.
std::int32_t mul_in_circles(std::int32_t a, std::int32_t b) {
  std::array<volatile char, 4096> frame{};
  const volatile bool goes_on = true;
  frame[0] = static_cast<char>(a);
  return (goes_on ? mul_in_circles(b, a) : 0) + frame[0];
}

std::int32_t mul_throws(std::int32_t /*a*/, std::int32_t /*b*/) {
  throw std::runtime_error("no product today");
}

/// Wrong wherever the right word is another one, for operands and results of every width: callers
/// of C take the low bits, and pass operands that nobody reads.
std::uint64_t wrong() { return 0x5bd1e9955bd1e995; }

void cossin_wrong(std::int16_t /*angle*/, std::int32_t* cos, std::int32_t* sin) {
  *cos = *sin = 0x5bd1e995;
}

void transform_wrong(const std::int32_t* /*matrix*/, const std::int32_t* /*operand*/,
                     std::int32_t* result) {
  result[0] = 0x5bd1e995;
}

/// Wrong in every thousandth call.
std::int32_t mul_at_times(std::int32_t a, std::int32_t b) {
  static std::atomic<unsigned> calls = 0;
  return mul(a, b) + (++calls % 1000 == 0 ? 1 : 0);
}

/// Right in the first call of the program.
std::int32_t mul_at_first(std::int32_t a, std::int32_t b) {
  static std::atomic<bool> was_called = false;
  return mul(a, b) + (was_called.exchange(true) ? 1 : 0);
}

/// Wrong only where it follows another element.
void muls_but_first(const std::int32_t* a, const std::int32_t* b, std::int32_t* results,
                    std::size_t count) {
  muls(a, b, results, count);
  for (std::size_t i = 1; i < count; ++i) ++results[i];
}

}  // extern "C"
