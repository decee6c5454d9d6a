#include "tests/support/bitwise.hpp"

#include <array>
#include <stdexcept>
#include <string>

#include "verify/parties/answer.hpp"

namespace bitwise {

namespace {

bool bit(std::uint64_t value, int place) { return (value >> place & 1U) != 0; }

std::uint64_t with_bit(std::uint64_t value, int place, bool set) {
  const std::uint64_t one = std::uint64_t{1} << place;
  return set ? value | one : value & ~one;
}

void assign(std::uint16_t& flags, Flag flag, bool set) {
  flags = static_cast<std::uint16_t>(set ? flags | flag : flags & ~flag);
}

void look_at_result(Answer& answer, int bits) {
  bool zero = true;
  for (int i = 0; i < bits; ++i) zero = zero && !bit(answer.value, i);
  bool even = true;
  for (int i = 0; i < 8; ++i) even = even != bit(answer.value, i);
  assign(answer.flags, ZF, zero);
  assign(answer.flags, SF, bit(answer.value, bits - 1));
  assign(answer.flags, PF, even);
}

void leave_undefined(Answer& answer, std::uint16_t flags) {
  answer.undefined = flags;
  answer.flags = static_cast<std::uint16_t>(answer.flags & ~flags);
}

/// A row of full adders. A subtraction adds the complement and inverts every carry.
Answer add(std::uint32_t a, std::uint32_t b, bool carry, bool subtract, std::uint16_t flags,
           int bits) {
  Answer answer{.flags = flags};
  std::uint64_t sum = 0;
  carry = carry != subtract;
  for (int i = 0; i < bits; ++i) {
    const bool x = bit(a, i);
    const bool y = bit(b, i) != subtract;
    const bool into = carry;
    sum = with_bit(sum, i, (x != y) != into);
    carry = (x && y) || (x && into) || (y && into);
    if (i == 3) assign(answer.flags, AF, carry != subtract);
    if (i == bits - 1) assign(answer.flags, OF, carry != into);
  }
  assign(answer.flags, CF, carry != subtract);
  answer.value = static_cast<std::uint32_t>(sum);
  look_at_result(answer, bits);
  return answer;
}

Answer logic(std::uint32_t a, std::uint32_t b, bool exclusive, int bits) {
  Answer answer;
  std::uint64_t value = 0;
  for (int i = 0; i < bits; ++i) {
    value = with_bit(value, i, exclusive ? bit(a, i) != bit(b, i) : bit(a, i) && bit(b, i));
  }
  answer.value = static_cast<std::uint32_t>(value);
  look_at_result(answer, bits);
  leave_undefined(answer, AF);
  return answer;
}

Answer shift(std::string_view name, const Operands& o, int bits) {
  Answer answer{.value = o.first, .flags = o.flags};
  const int count = o.count % 32;
  if (count == 0) return answer;
  const bool left = name == "shl" || name == "rol" || name == "shld";
  std::uint64_t value = o.first;
  std::uint64_t fill = o.second;
  bool carry = false;
  bool sign_changed = false;
  for (int i = 0; i < count; ++i) {
    const bool sign = bit(value, bits - 1);
    carry = left ? sign : bit(value, 0);
    bool enters = false;
    if (name == "rol") enters = carry;
    if (name == "sar") enters = sign;
    if (name == "shld") enters = bit(fill, bits - 1);
    if (name == "shrd") enters = bit(fill, 0);
    fill = left ? fill << 1U : fill >> 1U;
    value = left ? with_bit(value << 1U, bits, false) : value >> 1U;
    value = with_bit(value, left ? 0 : bits - 1, enters);
    sign_changed = sign != bit(value, bits - 1);
  }
  answer.value = static_cast<std::uint32_t>(value);
  assign(answer.flags, CF, carry);
  // For a count of 1, OF reports a changed sign, except for SAR, which keeps the sign.
  assign(answer.flags, OF, sign_changed);
  std::uint16_t undefined = count == 1 ? 0 : OF;
  if (name != "rol") {
    look_at_result(answer, bits);
    undefined |= AF;
    if ((name == "shl" || name == "shr") && count >= bits) undefined |= CF;
  }
  leave_undefined(answer, undefined);
  return answer;
}

/// Shifts and adds. In a signed number the multiplier's top bit has negative weight.
Answer multiply(const Operands& o, bool is_signed, int bits) {
  std::uint64_t a = o.first;
  if (is_signed && bit(a, bits - 1)) a -= std::uint64_t{1} << bits;
  std::uint64_t product = 0;
  for (int i = 0; i < bits; ++i) {
    if (!bit(o.second, i)) continue;
    const bool subtract = is_signed && i == bits - 1;
    product = subtract ? product - (a << i) : product + (a << i);
  }
  Answer answer;
  bool matters = false;
  for (int i = 0; i < bits; ++i) {
    answer.value = static_cast<std::uint32_t>(with_bit(answer.value, i, bit(product, i)));
    answer.high = static_cast<std::uint32_t>(with_bit(answer.high, i, bit(product, bits + i)));
    // The high half is insignificant if it only repeats the sign bit or is zero.
    const bool expected = is_signed && bit(product, bits - 1);
    matters = matters || bit(product, bits + i) != expected;
  }
  assign(answer.flags, CF, matters);
  assign(answer.flags, OF, matters);
  leave_undefined(answer, SF | ZF | AF | PF);
  return answer;
}

/// Divides the magnitudes by binary long division and then applies the signs.
Answer divide(const Operands& o, bool is_signed, int bits) {
  std::uint64_t dividend = 0;
  for (int i = 0; i < bits; ++i) {
    dividend = with_bit(dividend, i, bit(o.first, i));
    dividend = with_bit(dividend, bits + i, bit(o.high, i));
  }
  std::uint64_t divisor = o.second;
  const bool dividend_negative = is_signed && bit(dividend, 2 * bits - 1);
  const bool divisor_negative = is_signed && bit(divisor, bits - 1);
  const auto negated = [](std::uint64_t value, int width) {
    value = ~value + 1;
    return width == 64 ? value : value % (std::uint64_t{1} << width);
  };
  if (dividend_negative) dividend = negated(dividend, 2 * bits);
  if (divisor_negative) divisor = negated(divisor, bits);

  Answer answer;
  answer.fault = true;
  if (divisor == 0) return answer;
  std::uint64_t quotient = 0;
  std::uint64_t remainder = 0;
  for (int i = 2 * bits - 1; i >= 0; --i) {
    remainder = remainder * 2 + (bit(dividend, i) ? 1 : 0);
    if (remainder < divisor) continue;
    remainder -= divisor;
    quotient = with_bit(quotient, i, true);
  }
  const bool negative = dividend_negative != divisor_negative;
  std::uint64_t largest = (std::uint64_t{1} << bits) - 1;
  if (is_signed) largest = largest / 2 + (negative ? 1 : 0);
  if (quotient > largest) return answer;
  answer.fault = false;
  answer.value = static_cast<std::uint32_t>(negative ? negated(quotient, bits) : quotient);
  answer.high =
      static_cast<std::uint32_t>(dividend_negative ? negated(remainder, bits) : remainder);
  leave_undefined(answer, all_six);
  return answer;
}

}  // namespace

Answer execute(std::string_view name, const Operands& o, int bits) {
  const bool carry = (o.flags & CF) != 0;
  if (name == "mov") return {.value = o.second, .flags = o.flags};
  if (name == "add") return add(o.first, o.second, false, false, o.flags, bits);
  if (name == "adc") return add(o.first, o.second, carry, false, o.flags, bits);
  if (name == "sub") return add(o.first, o.second, false, true, o.flags, bits);
  if (name == "sbb") return add(o.first, o.second, carry, true, o.flags, bits);
  if (name == "neg") return add(0, o.first, false, true, o.flags, bits);
  if (name == "and") return logic(o.first, o.second, false, bits);
  if (name == "xor") return logic(o.first, o.second, true, bits);
  if (name == "mul") return multiply(o, false, bits);
  if (name == "imul") return multiply(o, true, bits);
  if (name == "div") return divide(o, false, bits);
  if (name == "idiv") return divide(o, true, bits);
  if (name == "cmp") {
    Answer answer = add(o.first, o.second, false, true, o.flags, bits);
    answer.value = o.first;
    return answer;
  }
  if (name == "inc" || name == "dec") {
    Answer answer = add(o.first, 1, false, name == "dec", o.flags, bits);
    assign(answer.flags, CF, carry);
    return answer;
  }
  for (const std::string_view shifts : {"shl", "shr", "sar", "rol", "shld", "shrd"}) {
    if (name == shifts) return shift(name, o, bits);
  }
  throw std::invalid_argument(std::string(name));
}

}  // namespace bitwise
