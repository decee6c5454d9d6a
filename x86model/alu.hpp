/// @file
/// Results and flags of the arithmetic instructions, from Intel's Software Developer's Manual
/// (volume 2) for the 386. The 8088 agrees on every form that an 8088 listing uses.
///
/// Operands are `bits` wide (at most 32) and zero-extended. Flags that the manual leaves undefined
/// are marked so. The caller preserves flags that an instruction does not change.
#pragma once

#include <bit>
#include <cstdint>
#include <optional>

#include "x86model/flags.hpp"
#include "x86model/inline.hpp"

namespace x86model::alu {

struct Result {
  std::uint32_t value = 0;
  Flags flags;
};

X86MODEL_INLINE std::uint32_t mask(int bits) {
  return static_cast<std::uint32_t>((std::uint64_t{1} << bits) - 1);
}
X86MODEL_INLINE bool sign(std::uint32_t value, int bits) {
  return ((value >> (bits - 1)) & 1U) != 0;
}
X86MODEL_INLINE std::int64_t as_signed(std::uint64_t value, int bits) {
  return static_cast<std::int64_t>(value << (64 - bits)) >> (64 - bits);
}

/// `flag` if `set`, else 0: for building a flags word.
X86MODEL_INLINE std::uint16_t when(bool set, Flag flag) {
  return static_cast<std::uint16_t>(set ? flag : 0);
}

/// SF, ZF and PF, which depend only on the result. PF depends on its low 8 bits.
X86MODEL_INLINE std::uint16_t result_flags(std::uint32_t value, int bits) {
  // First, because zero is rare. Otherwise g++ branches on the sign, which is as good as random.
  if (value == 0) return ZF | PF;
  return static_cast<std::uint16_t>(when(sign(value, bits), SF) |
                                    when((std::popcount(value & 0xFFU) & 1) == 0, PF));
}

X86MODEL_INLINE Result add(std::uint32_t a, std::uint32_t b, bool carry, int bits) {
  const std::uint64_t sum = std::uint64_t{a} + b + (carry ? 1U : 0U);
  const auto value = static_cast<std::uint32_t>(sum) & mask(bits);
  const auto flags = static_cast<std::uint16_t>(
      result_flags(value, bits) | when(((sum >> bits) & 1U) != 0, CF) |
      when(((a ^ b ^ value) & 0x10U) != 0, AF) | when(sign((a ^ value) & (b ^ value), bits), OF));
  return {value, {flags, 0}};
}

X86MODEL_INLINE Result sub(std::uint32_t a, std::uint32_t b, bool borrow, int bits) {
  const std::uint64_t difference = std::uint64_t{a} - b - (borrow ? 1U : 0U);
  const auto value = static_cast<std::uint32_t>(difference) & mask(bits);
  const auto flags = static_cast<std::uint16_t>(
      result_flags(value, bits) | when(((difference >> bits) & 1U) != 0, CF) |
      when(((a ^ b ^ value) & 0x10U) != 0, AF) | when(sign((a ^ b) & (a ^ value), bits), OF));
  return {value, {flags, 0}};
}

/// AND and XOR: CF and OF cleared, AF undefined.
X86MODEL_INLINE Result logic(std::uint32_t value, int bits) {
  return {value, {result_flags(value, bits), AF}};
}

/// Flags of a shift by `count` > 0: AF is undefined; OF is defined only for a shift by one.
X86MODEL_INLINE Flags shift_flags(std::uint32_t value, int bits, int count, bool carry,
                                  bool overflow) {
  const auto flags = static_cast<std::uint16_t>(result_flags(value, bits) | when(carry, CF) |
                                                when(count == 1 && overflow, OF));
  return {flags, static_cast<std::uint16_t>(AF | when(count != 1, OF))};
}

/// SHL, 0 < count < 32. CF is undefined if count >= bits.
X86MODEL_INLINE Result shl(std::uint32_t a, int count, int bits) {
  const std::uint64_t wide = std::uint64_t{a} << count;
  const auto value = static_cast<std::uint32_t>(wide) & mask(bits);
  const bool carry = count < bits && ((wide >> bits) & 1U) != 0;
  Flags flags = shift_flags(value, bits, count, carry, sign(value, bits) != carry);
  flags.undefined |= when(count >= bits, CF);
  return {value, flags};
}

/// SHR, 0 < count < 32. CF is undefined if count >= bits.
X86MODEL_INLINE Result shr(std::uint32_t a, int count, int bits) {
  const std::uint32_t value = a >> count;
  const bool carry = count < bits && ((a >> (count - 1)) & 1U) != 0;
  Flags flags = shift_flags(value, bits, count, carry, sign(a, bits));
  flags.undefined |= when(count >= bits, CF);
  return {value, flags};
}

/// SAR, 0 < count < 32. If count >= bits, CF is the sign.
X86MODEL_INLINE Result sar(std::uint32_t a, int count, int bits) {
  const std::int64_t wide = as_signed(a, bits);
  const auto value = static_cast<std::uint32_t>(wide >> count) & mask(bits);
  const bool carry = ((wide >> (count - 1)) & 1) != 0;
  return {value, shift_flags(value, bits, count, carry, false)};
}

/// ROL, 0 < count < 32. Sets only CF and OF; the caller preserves the other flags.
X86MODEL_INLINE Result rol(std::uint32_t a, int count, int bits) {
  const int turn = count % bits;
  const auto value =
      static_cast<std::uint32_t>((std::uint64_t{a} << turn) | (std::uint64_t{a} >> (bits - turn))) &
      mask(bits);
  const bool carry = (value & 1U) != 0;
  const auto flags = static_cast<std::uint16_t>(when(carry, CF) |
                                                when(count == 1 && sign(value, bits) != carry, OF));
  return {value, {flags, when(count != 1, OF)}};
}

/// SHLD, 0 < count < bits: shifts `a` left and fills from the top of `fill`.
X86MODEL_INLINE Result shld(std::uint32_t a, std::uint32_t fill, int count, int bits) {
  const std::uint64_t wide = (std::uint64_t{a} << bits | fill) << count;
  const auto value = static_cast<std::uint32_t>(wide >> bits) & mask(bits);
  const bool carry = ((a >> (bits - count)) & 1U) != 0;
  return {value, shift_flags(value, bits, count, carry, sign(a ^ value, bits))};
}

/// SHRD, 0 < count < bits: shifts `a` right and fills from the bottom of `fill`.
X86MODEL_INLINE Result shrd(std::uint32_t a, std::uint32_t fill, int count, int bits) {
  const std::uint64_t wide = (std::uint64_t{fill} << bits | a) >> count;
  const auto value = static_cast<std::uint32_t>(wide) & mask(bits);
  const bool carry = ((a >> (count - 1)) & 1U) != 0;
  return {value, shift_flags(value, bits, count, carry, sign(a ^ value, bits))};
}

struct Product {
  std::uint32_t low = 0;
  std::uint32_t high = 0;
  Flags flags;
};

/// The result of MUL and IMUL: CF and OF tell whether the high half is significant; other flags are
/// undefined.
X86MODEL_INLINE Product product(std::uint64_t wide, bool high_matters, int bits) {
  return {static_cast<std::uint32_t>(wide) & mask(bits),
          static_cast<std::uint32_t>(wide >> bits) & mask(bits),
          {static_cast<std::uint16_t>(when(high_matters, CF) | when(high_matters, OF)),
           SF | ZF | AF | PF}};
}

X86MODEL_INLINE Product mul(std::uint32_t a, std::uint32_t b, int bits) {
  const std::uint64_t wide = std::uint64_t{a} * b;
  return product(wide, (wide >> bits) != 0, bits);
}

X86MODEL_INLINE Product imul(std::uint32_t a, std::uint32_t b, int bits) {
  const std::int64_t wide = as_signed(a, bits) * as_signed(b, bits);
  const auto raw = static_cast<std::uint64_t>(wide);
  return product(raw, as_signed(raw, bits) != wide, bits);
}

struct Quotient {
  std::uint32_t quotient;
  std::uint32_t remainder;
};

/// DIV of high:low. Returns nothing (#DE) if the divisor is zero or the quotient does not fit.
/// Leaves all six flags undefined.
X86MODEL_INLINE std::optional<Quotient> div(std::uint32_t high, std::uint32_t low,
                                            std::uint32_t divisor, int bits) {
  // The quotient fits if and only if the high half is below the divisor.
  if (high >= divisor) return std::nullopt;
  const std::uint64_t dividend = (std::uint64_t{high} << bits) | low;
  return Quotient{static_cast<std::uint32_t>(dividend / divisor),
                  static_cast<std::uint32_t>(dividend % divisor)};
}

/// IDIV of high:low, truncating; the remainder has the sign of the dividend. Returns nothing (#DE)
/// if the divisor is zero or the quotient is outside the signed range.
X86MODEL_INLINE std::optional<Quotient> idiv(std::uint32_t high, std::uint32_t low,
                                             std::uint32_t divisor, int bits) {
  const std::int64_t d = as_signed(divisor, bits);
  const std::int64_t n = as_signed((std::uint64_t{high} << bits) | low, 2 * bits);
  if (d == 0) return std::nullopt;
  // -2^63 / -1 is the only quotient that does not fit in 64 bits.
  if (d == -1 && n == INT64_MIN) return std::nullopt;
  const std::int64_t q = n / d;
  const std::int64_t limit = std::int64_t{1} << (bits - 1);
  if (q < -limit || q >= limit) return std::nullopt;
  return Quotient{static_cast<std::uint32_t>(q) & mask(bits),
                  static_cast<std::uint32_t>(n % d) & mask(bits)};
}

}  // namespace x86model::alu
