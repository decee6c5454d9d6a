// Tests ALU results and flags against range definitions, exhaustively at 8 bits: CF means the
// unsigned result is out of range, OF the signed result, AF the low hex digit.
#include "x86model/alu.hpp"

#include <optional>

#include "tests/support/test.hpp"
#include "x86model/words.hpp"

namespace {

using namespace x86model;
using Result = alu::Result<Words>;

constexpr Words numbers;

int signed_value(std::uint32_t v) {
  return v < 128 ? static_cast<int>(v) : static_cast<int>(v) - 256;
}

bool even_parity(std::uint32_t v) {
  bool even = true;
  for (int i = 0; i < 8; ++i) even ^= ((v >> i) & 1U) != 0;
  return even;
}

std::uint16_t flags(bool cf, bool af, bool of, std::uint32_t result) {
  unsigned f = 0;
  if (cf) f |= 0x001;
  if (even_parity(result)) f |= 0x004;
  if (af) f |= 0x010;
  if (result == 0) f |= 0x040;
  if (result >= 128) f |= 0x080;
  if (of) f |= 0x800;
  return static_cast<std::uint16_t>(f);
}

bool outside_signed(int v) { return v < -128 || v > 127; }

TEST(Alu, AdditionByRanges) {
  for (std::uint32_t a = 0; a < 256; ++a) {
    for (std::uint32_t b = 0; b < 256; ++b) {
      for (const std::uint32_t carry : {0U, 1U}) {
        const Result r = alu::add(numbers, a, b, carry != 0, 8);
        const std::uint32_t sum = a + b + carry;
        ASSERT_EQ(r.value, sum % 256);
        const int s = signed_value(a) + signed_value(b) + static_cast<int>(carry);
        ASSERT_EQ(r.flags.value,
                  flags(sum > 255, a % 16 + b % 16 + carry > 15, outside_signed(s), sum % 256));
        ASSERT_EQ(r.flags.undefined, 0);
      }
    }
  }
}

TEST(Alu, SubtractionByRanges) {
  for (int a = 0; a < 256; ++a) {
    for (int b = 0; b < 256; ++b) {
      for (const int borrow : {0, 1}) {
        const auto ua = static_cast<std::uint32_t>(a);
        const auto ub = static_cast<std::uint32_t>(b);
        const Result r = alu::sub(numbers, ua, ub, borrow != 0, 8);
        const int difference = a - b - borrow;
        const auto value = static_cast<std::uint32_t>((difference + 512) % 256);
        ASSERT_EQ(r.value, value);
        const int s = signed_value(ua) - signed_value(ub) - borrow;
        ASSERT_EQ(r.flags.value,
                  flags(difference < 0, a % 16 - b % 16 - borrow < 0, outside_signed(s), value));
        ASSERT_EQ(r.flags.undefined, 0);
      }
    }
  }
}

TEST(Alu, LogicLeavesOnlyAuxiliaryCarryUndefined) {
  for (std::uint32_t v = 0; v < 256; ++v) {
    EXPECT_EQ(alu::logic(numbers, v, 8).flags.value, flags(false, false, false, v));
    EXPECT_EQ(alu::logic(numbers, v, 8).flags.undefined, AF);
  }
}

/// Shifts one bit at a time; CF is the last bit shifted out.
struct Shifted {
  std::uint32_t value;
  bool carry;
};
template <class Step>
Shifted bit_by_bit(std::uint32_t v, int count, Step step) {
  Shifted s{v, false};
  for (int i = 0; i < count; ++i) s = step(s);
  return s;
}

void expect_shift(const Result& r, const Shifted& s, int count, bool overflow, bool carry_defined) {
  ASSERT_EQ(r.value, s.value);
  const std::uint16_t undefined =
      static_cast<std::uint16_t>(AF | (count == 1 ? 0 : OF) | (carry_defined ? 0 : CF));
  ASSERT_EQ(r.flags.undefined, undefined);
  const std::uint16_t all = flags(s.carry, false, overflow, s.value);
  ASSERT_EQ(r.flags.value, all & static_cast<std::uint16_t>(~undefined));
}

TEST(Alu, ShiftsBitByBit) {
  for (std::uint32_t v = 0; v < 256; ++v) {
    for (int count = 1; count < 32; ++count) {
      const bool fits = count < 8;
      const Shifted left = bit_by_bit(v, count, [](Shifted s) {
        return Shifted{s.value * 2 % 256, s.value >= 128};
      });
      expect_shift(alu::shl(numbers, v, count, 8), left, count, (left.value >= 128) != left.carry,
                   fits);
      const Shifted right = bit_by_bit(v, count, [](Shifted s) {
        return Shifted{s.value / 2, s.value % 2 == 1};
      });
      expect_shift(alu::shr(numbers, v, count, 8), right, count, v >= 128, fits);
      const Shifted arithmetic = bit_by_bit(v, count, [](Shifted s) {
        return Shifted{s.value / 2 + (s.value >= 128 ? 128 : 0), s.value % 2 == 1};
      });
      expect_shift(alu::sar(numbers, v, count, 8), arithmetic, count, false, true);
    }
  }
}

TEST(Alu, RotationTouchesOnlyCarryAndOverflow) {
  for (std::uint32_t v = 0; v < 256; ++v) {
    for (int count = 1; count < 32; ++count) {
      const Shifted turned = bit_by_bit(v, count, [](Shifted s) {
        return Shifted{s.value * 2 % 256 + s.value / 128, s.value >= 128};
      });
      const Result r = alu::rol(numbers, v, count, 8);
      ASSERT_EQ(r.value, turned.value);
      ASSERT_EQ(r.flags.undefined, count == 1 ? 0 : OF);
      const bool overflow = count == 1 && (turned.value >= 128) != turned.carry;
      ASSERT_EQ(r.flags.value, (turned.carry ? CF : 0) | (overflow ? OF : 0));
    }
  }
}

TEST(Alu, DoubleShiftsBitByBit) {
  for (std::uint32_t v = 0; v < 256; ++v) {
    for (const std::uint32_t fill : {0x00U, 0xFFU, 0x55U, 0xAAU, 0x81U, 0x7EU, 0x01U, 0x80U}) {
      for (int count = 1; count < 8; ++count) {
        std::uint32_t rest = fill;
        const Shifted left = bit_by_bit(v, count, [&](Shifted s) {
          const Shifted next{s.value * 2 % 256 + rest / 128, s.value >= 128};
          rest = rest * 2 % 256;
          return next;
        });
        expect_shift(alu::shld(numbers, v, fill, count, 8), left, count,
                     (v >= 128) != (left.value >= 128), true);
        rest = fill;
        const Shifted right = bit_by_bit(v, count, [&](Shifted s) {
          const Shifted next{s.value / 2 + rest % 2 * 128, s.value % 2 == 1};
          rest /= 2;
          return next;
        });
        expect_shift(alu::shrd(numbers, v, fill, count, 8), right, count,
                     (v >= 128) != (right.value >= 128), true);
      }
    }
  }
}

TEST(Alu, ProductsSayWhetherTheHighHalfMatters) {
  for (std::uint32_t a = 0; a < 256; ++a) {
    for (std::uint32_t b = 0; b < 256; ++b) {
      const alu::Product<Words> u = alu::mul(numbers, a, b, 8);
      ASSERT_EQ(u.wide, a * b);
      ASSERT_EQ(u.flags.value, a * b > 255 ? CF | OF : 0);
      const alu::Product<Words> s = alu::imul(numbers, a, b, 8);
      const int product = signed_value(a) * signed_value(b);
      ASSERT_EQ(s.wide, static_cast<std::uint64_t>(product));
      ASSERT_EQ(s.flags.value, outside_signed(product) ? CF | OF : 0);
      ASSERT_EQ(s.flags.undefined, SF | ZF | AF | PF);
    }
  }
}

struct Quotient {
  std::uint32_t quotient;
  std::uint32_t remainder;
};
std::optional<Quotient> divide(std::uint32_t high, std::uint32_t low, std::uint32_t d, int bits) {
  if (alu::div_faults(numbers, high, d)) return std::nullopt;
  const std::uint64_t n = numbers.join(high, low, bits);
  return Quotient{numbers.unsigned_quotient(n, d, bits), numbers.unsigned_remainder(n, d, bits)};
}
std::optional<Quotient> divide_signed(std::uint32_t high, std::uint32_t low, std::uint32_t d,
                                      int bits) {
  const std::uint64_t n = numbers.join(high, low, bits);
  if (numbers.signed_quotient_overflows(n, d, bits)) return std::nullopt;
  return Quotient{numbers.signed_quotient(n, d, bits), numbers.signed_remainder(n, d, bits)};
}

TEST(Alu, QuotientsOrFaults) {
  for (std::uint32_t n = 0; n < 65536; n += 7) {
    for (std::uint32_t d = 0; d < 256; ++d) {
      const auto u = divide(n / 256, n % 256, d, 8);
      const bool fits = d != 0 && n / d < 256;
      ASSERT_EQ(u.has_value(), fits) << n << " / " << d;
      if (fits) {
        ASSERT_EQ(u->quotient * d + u->remainder, n);
        ASSERT_LT(u->remainder, d);
      }
      const int sn = n < 32768 ? static_cast<int>(n) : static_cast<int>(n) - 65536;
      const int sd = signed_value(d);
      const auto s = divide_signed(n / 256, n % 256, d, 8);
      const bool signed_fits = sd != 0 && !outside_signed(sn / sd);
      ASSERT_EQ(s.has_value(), signed_fits) << sn << " / " << sd;
      if (signed_fits) {
        ASSERT_EQ(signed_value(s->quotient) * sd + signed_value(s->remainder), sn);
        ASSERT_LT(std::abs(signed_value(s->remainder)), std::abs(sd));
        ASSERT_GE(signed_value(s->remainder) * sn, 0);
      }
    }
  }
}

TEST(Alu, TheWidestSignedDivideHasNoOverflow) {
  EXPECT_FALSE(divide_signed(0x80000000, 0, 0xFFFFFFFF, 32).has_value());
  EXPECT_FALSE(divide_signed(0xFFFFFFFF, 0x80000000, 0xFFFFFFFF, 32).has_value());
  const auto least = divide_signed(0xFFFFFFFF, 0x80000000, 1, 32);
  ASSERT_TRUE(least.has_value());
  EXPECT_EQ(least->quotient, 0x80000000U);
}

}  // namespace
