// The instructions of PTX, for the output of ptx_to_cpp.
#pragma once

#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace ptx {

/// A trap instruction.
struct trapped {};

using bytes = unsigned char*;

/// An operand as another type: its bits, or those of the type that it has.
template <class To, class From>
To as(From x) {
  if constexpr (std::is_floating_point_v<To> != std::is_floating_point_v<From>) {
    return std::bit_cast<To>(x);
  } else {
    return static_cast<To>(x);
  }
}
template <class Register, class Value>
void set(Register& to, Value x) {
  to = as<Register>(x);
}
inline std::uint64_t address_of(const void* place) {
  return reinterpret_cast<std::uintptr_t>(place);
}

template <class Type>
Type load(std::uint64_t address) {
  if (address < 4096) throw address;  // what nvcc makes of the address of a variable of the host
  Type x;
  std::memcpy(&x, reinterpret_cast<const void*>(address), sizeof x);
  return x;
}
template <class Type>
void store(std::uint64_t address, Type x) {
  if (address < 4096) throw address;
  std::memcpy(reinterpret_cast<void*>(address), &x, sizeof x);
}

template <class Type>
using unsigned_of = std::make_unsigned_t<Type>;
template <class Type>
inline constexpr int bits = 8 * static_cast<int>(sizeof(Type));
template <class Type>
using twice = std::conditional_t<std::is_signed_v<Type>, __int128, unsigned __int128>;

template <class Type>
Type op_add(Type a, Type b) {
  return static_cast<Type>(static_cast<unsigned_of<Type>>(a) + static_cast<unsigned_of<Type>>(b));
}
template <class Type>
Type op_addc(Type a, Type b, unsigned& carry) {
  const auto sum = static_cast<unsigned __int128>(static_cast<unsigned_of<Type>>(a)) +
                   static_cast<unsigned_of<Type>>(b) + carry;
  carry = static_cast<unsigned>(sum >> bits<Type> & 1);
  return static_cast<Type>(sum);
}
template <class Type>
Type op_add(Type a, Type b, unsigned& carry) {
  carry = 0;
  return op_addc(a, b, carry);
}
template <class Type>
Type op_sub(Type a, Type b) {
  return static_cast<Type>(static_cast<unsigned_of<Type>>(a) - static_cast<unsigned_of<Type>>(b));
}
// After a subtraction, the carry says that nothing was borrowed, as NVIDIA's own division shows: it
// adds the carry of a subtraction.
template <class Type>
Type op_subc(Type a, Type b, unsigned& carry) {
  return op_addc(a, static_cast<Type>(~b), carry);
}
template <class Type>
Type op_sub(Type a, Type b, unsigned& carry) {
  carry = 1;
  return op_subc(a, b, carry);
}
template <class Type>
Type op_neg(Type a) {
  return op_sub(Type{0}, a);
}
template <class Type>
Type op_abs(Type a) {
  return a < 0 ? op_neg(a) : a;
}
template <class Type>
Type op_mul_lo(Type a, Type b) {
  return static_cast<Type>(twice<Type>{a} * b);
}
template <class Type>
Type op_mul_hi(Type a, Type b) {
  return static_cast<Type>(twice<Type>{a} * b >> bits<Type>);
}
template <class Type>
auto op_mul_wide(Type a, Type b) {
  return static_cast<std::conditional_t<std::is_signed_v<Type>, std::int64_t, std::uint64_t>>(
      twice<Type>{a} * b);
}
inline double op_mul(double a, double b) { return a * b; }
template <class Type, class... Carry>
Type op_mad_lo(Type a, Type b, Type c, Carry&... carry) {
  return op_add(op_mul_lo(a, b), c, carry...);
}
template <class Type, class... Carry>
Type op_mad_hi(Type a, Type b, Type c, Carry&... carry) {
  return op_add(op_mul_hi(a, b), c, carry...);
}
template <class Type>
Type op_madc_lo(Type a, Type b, Type c, unsigned& carry) {
  return op_addc(op_mul_lo(a, b), c, carry);
}
template <class Type>
Type op_madc_hi(Type a, Type b, Type c, unsigned& carry) {
  return op_addc(op_mul_hi(a, b), c, carry);
}

// A division by zero has some value, and no error.
template <class Type>
Type op_div(Type a, Type b) {
  return b == 0 ? static_cast<Type>(-1) : static_cast<Type>(twice<Type>{a} / b);
}
template <class Type>
Type op_rem(Type a, Type b) {
  return b == 0 ? a : static_cast<Type>(twice<Type>{a} % b);
}
/// The last bit is the GPU's own. The division of 128 bits, which asks, allows for more than that.
inline float op_rcp_approx(float x) {
  const float near = 1 / x;
  return double{near} * x < 1 ? std::nextafter(near, 2.0F) : near;
}

template <class Type>
Type op_and(Type a, Type b) {
  return static_cast<Type>(a & b);
}
template <class Type>
Type op_or(Type a, Type b) {
  return static_cast<Type>(a | b);
}
template <class Type>
Type op_xor(Type a, Type b) {
  return static_cast<Type>(a ^ b);
}
template <class Type>
Type op_not(Type a) {
  return static_cast<Type>(~a);
}
inline bool op_not(bool a) { return !a; }

// A shift by more than the width gives zero or the sign.
template <class Type>
Type op_shl(Type a, std::uint32_t places) {
  return places < bits<Type> ? static_cast<Type>(a << places) : Type{0};
}
template <class Type>
Type op_shr(Type a, std::uint32_t places) {
  return static_cast<Type>(a >> (places < bits<Type> - 1 ? places : bits<Type> - 1) >>
                           (places < bits<Type> ? 0 : 1));
}
inline std::uint32_t op_shf_l_wrap(std::uint32_t low, std::uint32_t high, std::uint32_t places) {
  return static_cast<std::uint32_t>((std::uint64_t{high} << 32 | low) << (places & 31) >> 32);
}
inline std::uint32_t op_shf_r_wrap(std::uint32_t low, std::uint32_t high, std::uint32_t places) {
  return static_cast<std::uint32_t>((std::uint64_t{high} << 32 | low) >> (places & 31));
}
template <class Type>
Type op_min(Type a, Type b) {
  return b < a ? b : a;
}
template <class Type>
Type op_max(Type a, Type b) {
  return a < b ? b : a;
}
template <class Type>
std::uint32_t op_clz(Type x) {
  return static_cast<std::uint32_t>(std::countl_zero(x));
}
template <class Type>
std::uint32_t op_popc(Type x) {
  return static_cast<std::uint32_t>(std::popcount(x));
}
template <class Type>
Type op_bfi(Type field, Type into, std::uint32_t place, std::uint32_t length) {
  for (std::uint32_t i = place; i < place + length && i < bits<Type>; ++i) {
    const Type bit = Type{1} << i;
    into = field >> (i - place) & 1 ? into | bit : into & ~bit;
  }
  return into;
}
template <class Type>
Type op_bfe(Type x, std::uint32_t place, std::uint32_t length) {
  const std::uint32_t unused = bits<Type> - length;
  if (length == 0) return 0;
  if (length >= bits<Type>) return op_shr(x, place);
  // A field that ends above the integer is filled with its sign.
  if (place + length > bits<Type>) return op_shr(x, place);
  return static_cast<Type>(op_shr(op_shl(x, unused - place), unused));
}
inline std::uint32_t op_prmt(std::uint32_t a, std::uint32_t b, std::uint32_t order) {
  const std::uint64_t all = std::uint64_t{b} << 32 | a;
  std::uint32_t result = 0;
  for (unsigned i = 0; i < 4; ++i) {
    const unsigned choice = order >> 4 * i & 15;
    auto byte = static_cast<std::uint8_t>(all >> 8 * (choice & 7));
    if (choice & 8) byte = byte & 0x80 ? 0xff : 0;  // only its sign
    result |= std::uint32_t{byte} << 8 * i;
  }
  return result;
}

}  // namespace ptx
