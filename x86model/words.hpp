/// @file
/// Numbers as the domain of alu.hpp: with them its instructions are the interpreter and the
/// compiled run. symbolic/open.hpp is the domain of the proofs.
#pragma once

#include <cstdint>

#include "x86model/flags.hpp"
#include "x86model/inline.hpp"

namespace x86model {

/// `bits` ones, 0 < bits <= 32.
X86MODEL_INLINE std::uint32_t mask(int bits) {
  return static_cast<std::uint32_t>((std::uint64_t{1} << bits) - 1);
}
X86MODEL_INLINE std::int64_t as_signed(std::uint64_t value, int bits) {
  return static_cast<std::int64_t>(value << (64 - bits)) >> (64 - bits);
}

/// A value is at most 32 bits wide and zero-extended. A wide value has at most 64 bits: a dividend,
/// or a product or an extension, which is extended to 64 bits in the same way.
struct Words {
  using Value = std::uint32_t;
  using Wide = std::uint64_t;
  using Truth = bool;
  using Flags = x86model::Flags;
  static constexpr int widest = 32;  ///< the bits of a Value

  X86MODEL_INLINE Truth truth(bool value) const { return value; }
  X86MODEL_INLINE Value constant(std::uint32_t value, int /*bits*/) const { return value; }

  X86MODEL_INLINE Value sum(Value a, Value b, Truth carry, int bits) const {
    return static_cast<Value>(wide_sum(a, b, carry)) & mask(bits);
  }
  X86MODEL_INLINE Truth carry_of(Value a, Value b, Truth carry, int bits) const {
    return bit(wide_sum(a, b, carry), bits);
  }
  X86MODEL_INLINE Value difference(Value a, Value b, Truth borrow, int bits) const {
    return static_cast<Value>(wide_difference(a, b, borrow)) & mask(bits);
  }
  X86MODEL_INLINE Truth borrow_of(Value a, Value b, Truth borrow, int bits) const {
    return bit(wide_difference(a, b, borrow), bits);
  }
  X86MODEL_INLINE Value bit_and(Value a, Value b) const { return a & b; }
  X86MODEL_INLINE Value bit_xor(Value a, Value b) const { return a ^ b; }

  /// `width` bits from bit `low` upwards.
  X86MODEL_INLINE Value extract(Wide a, int low, int width) const {
    return static_cast<Value>(a >> low) & mask(width);
  }
  /// `high` above the `low_bits` bits of `low`; 32 bits together at most.
  X86MODEL_INLINE Value concat(Value high, Value low, int low_bits) const {
    return high << low_bits | low;
  }
  X86MODEL_INLINE Wide join(Value high, Value low, int low_bits) const {
    return Wide{high} << low_bits | low;
  }
  X86MODEL_INLINE Wide sign_extend(Value a, int bits, int /*wanted*/) const {
    return static_cast<Wide>(as_signed(a, bits));
  }
  X86MODEL_INLINE Wide zero_extend(Value a, int /*bits*/, int /*wanted*/) const { return a; }
  X86MODEL_INLINE Wide unsigned_product(Value a, Value b, int /*bits*/) const {
    return Wide{a} * b;
  }
  X86MODEL_INLINE Wide signed_product(Value a, Value b, int bits) const {
    return static_cast<Wide>(as_signed(a, bits) * as_signed(b, bits));
  }

  // Quotients are computed only if the divide does not fault.
  X86MODEL_INLINE Value unsigned_quotient(Wide n, Value d, int /*bits*/) const {
    return static_cast<Value>(n / d);
  }
  X86MODEL_INLINE Value unsigned_remainder(Wide n, Value d, int /*bits*/) const {
    return static_cast<Value>(n % d);
  }
  X86MODEL_INLINE Value signed_quotient(Wide n, Value d, int bits) const {
    return static_cast<Value>(as_signed(n, 2 * bits) / as_signed(d, bits)) & mask(bits);
  }
  X86MODEL_INLINE Value signed_remainder(Wide n, Value d, int bits) const {
    return static_cast<Value>(as_signed(n, 2 * bits) % as_signed(d, bits)) & mask(bits);
  }
  /// Whether the divisor is zero or the truncated quotient outside the signed range.
  X86MODEL_INLINE Truth signed_quotient_overflows(Wide n, Value d, int bits) const {
    const std::int64_t dividend = as_signed(n, 2 * bits);
    const std::int64_t divisor = as_signed(d, bits);
    if (divisor == 0) return true;
    // -2^63 / -1 is the only quotient that does not fit in 64 bits.
    if (divisor == -1 && dividend == INT64_MIN) return true;
    const std::int64_t quotient = dividend / divisor;
    const std::int64_t limit = std::int64_t{1} << (bits - 1);
    return quotient < -limit || quotient >= limit;
  }

  X86MODEL_INLINE Truth bit(Wide a, int position) const { return (a >> position & 1U) != 0; }
  X86MODEL_INLINE Truth equal(Wide a, Wide b) const { return a == b; }
  X86MODEL_INLINE Truth below(Value a, Value b) const { return a < b; }
  X86MODEL_INLINE Truth negation(Truth a) const { return !a; }
  X86MODEL_INLINE Truth differ(Truth a, Truth b) const { return a != b; }
  X86MODEL_INLINE Truth either(Truth a, Truth b) const { return a || b; }

  /// The flags of a result; see alu::result().
  X86MODEL_INLINE Flags flags(Truth carry, Truth parity, Truth auxiliary, Truth zero, Truth sign,
                              Truth overflow, std::uint16_t undefined) const {
    const int all = when(carry, CF) | when(parity, PF) | when(auxiliary, AF) | when(zero, ZF) |
                    when(sign, SF) | when(overflow, OF);
    return {static_cast<std::uint16_t>(all & ~undefined), undefined};
  }
  X86MODEL_INLINE Flags undefined_flags() const { return all_undefined; }
  /// Of the low 8 bits. The constant has a bit for each of the 16 values of their folded halves.
  X86MODEL_INLINE Truth has_even_parity(Value a) const {
    return bit(0x9669U, static_cast<int>((a ^ a >> 4U) & 0xFU));
  }
  /// AF: a carry or borrow out of the low four bits of a sum or difference of `a` and `b`.
  X86MODEL_INLINE Truth half_carry(Value a, Value b, Value result) const {
    return bit(a ^ b ^ result, 4);
  }

 private:
  X86MODEL_INLINE static Wide wide_sum(Value a, Value b, Truth carry) {
    return Wide{a} + b + (carry ? 1U : 0U);
  }
  X86MODEL_INLINE static Wide wide_difference(Value a, Value b, Truth borrow) {
    return Wide{a} - b - (borrow ? 1U : 0U);
  }
  X86MODEL_INLINE static std::uint16_t when(bool set, Flag flag) {
    return static_cast<std::uint16_t>(set ? flag : 0);
  }
};

}  // namespace x86model
