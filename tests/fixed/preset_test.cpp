/// Tests the FIXED.ASM presets against hand-computed results of the routines.
#include "fixed/fixed.hpp"
#include "tests/support/test.hpp"

namespace {

using namespace fixed;

/// A number from its two's complement word.
template <class Number>
constexpr Number word(std::uint32_t bits) {
  return Number::from_raw(static_cast<typename Number::raw_type>(bits));
}

struct product {
  std::uint32_t a, b;
  /// floor(ab + 1/2); floor(ab); round half away from zero; truncation.
  std::uint32_t i386_on, i386_off, i8088_on, i8088_off;
};

constexpr product products[] = {
    // 1.5 * 2.5 = 3.75 is exact under every preset
    {0x00018000, 0x00028000, 0x0003c000, 0x0003c000, 0x0003c000, 0x0003c000},
    // 0.5 ulp and -0.5 ulp
    {0x00000001, 0x00008000, 0x00000001, 0x00000000, 0x00000001, 0x00000000},
    {0xffffffff, 0x00008000, 0x00000000, 0xffffffff, 0xffffffff, 0x00000000},
    // 1.5 ulp and -1.5 ulp
    {0x00000003, 0x00008000, 0x00000002, 0x00000001, 0x00000002, 0x00000001},
    {0xfffffffd, 0x00008000, 0xffffffff, 0xfffffffe, 0xfffffffe, 0xffffffff},
    // just below and just above -0.5 ulp
    {0xffffffff, 0x00007fff, 0x00000000, 0xffffffff, 0x00000000, 0x00000000},
    {0xffffffff, 0x00008001, 0xffffffff, 0xffffffff, 0xffffffff, 0x00000000},
    // 256.0 * 256.0 = 65536.0 wraps to 0; 256.0 * 128.0 = 32768.0 wraps to -32768.0
    {0x01000000, 0x01000000, 0x00000000, 0x00000000, 0x00000000, 0x00000000},
    {0x01000000, 0x00800000, 0x80000000, 0x80000000, 0x80000000, 0x80000000},
    // -32768.0 squared is 2^30, which wraps to 0; -32768.0 * -2^-16 = 0.5
    {0x80000000, 0x80000000, 0x00000000, 0x00000000, 0x00000000, 0x00000000},
    {0x80000000, 0xffffffff, 0x00008000, 0x00008000, 0x00008000, 0x00008000},
};

template <class On, class Off>
void expect_product(const product& p, std::uint32_t on, std::uint32_t off) {
  EXPECT_EQ(word<On>(p.a) * word<On>(p.b), word<On>(on)) << std::hex << p.a << ' ' << p.b;
  EXPECT_EQ(word<Off>(p.a) * word<Off>(p.b), word<Off>(off)) << std::hex << p.a << ' ' << p.b;
}

TEST(Presets, Products) {
  for (const product& p : products) {
    expect_product<q16_16_i386, q16_16_i386_unrounded>(p, p.i386_on, p.i386_off);
    expect_product<q16_16_i386_mul_rounded, q16_16_i386_div_rounded>(p, p.i386_on, p.i386_off);
    expect_product<q16_16_i8088, q16_16_i8088_unrounded>(p, p.i8088_on, p.i8088_off);
    expect_product<q16_16_i8088_mul_rounded, q16_16_i8088_div_rounded>(p, p.i8088_on, p.i8088_off);
  }
}

using answer = std::optional<std::uint32_t>;
constexpr answer DE = std::nullopt;

struct quotient {
  std::uint32_t n, d;
  answer i386_on, i386_off, i8088_on, i8088_off;
};

constexpr quotient quotients[] = {
    {0x00010000, 0x00020000, 0x00008000, 0x00008000, 0x00008000, 0x00008000},
    // 1.0 / 3.0 = 21845.33 ulp; 2.0 / 3.0 = 43690.67 ulp
    {0x00010000, 0x00030000, 0x00005555, 0x00005555, 0x00005555, 0x00005555},
    {0x00020000, 0x00030000, 0x0000aaab, 0x0000aaaa, 0x0000aaab, 0x0000aaaa},
    {0xfffe0000, 0x00030000, 0xffff5555, 0xffff5556, 0xffff5555, 0xffff5556},
    {0x00020000, 0xfffd0000, 0xffff5555, 0xffff5556, 0xffff5555, 0xffff5556},
    {0xfffe0000, 0xfffd0000, 0x0000aaab, 0x0000aaaa, 0x0000aaab, 0x0000aaaa},
    // 0.5 ulp and -0.5 ulp: away from zero or truncated
    {0x00000001, 0x00020000, 0x00000001, 0x00000000, 0x00000001, 0x00000000},
    {0xffffffff, 0x00020000, 0xffffffff, 0x00000000, 0xffffffff, 0x00000000},
    // 3.0 / 1.5 = 2.0; the 8088 divides by 1
    {0x00030000, 0x00018000, 0x00020000, 0x00020000, 0x00030000, 0x00030000},
    {0x00030000, 0xfffe8000, 0xfffe0000, 0xfffe0000, 0xfffd0000, 0xfffd0000},
    // 0.5 / 0.5: the 8088 cannot divide by less than 1.0
    {0x00008000, 0x00008000, 0x00010000, 0x00010000, DE, DE},
    {0x00008000, 0xffff8000, 0xffff0000, 0xffff0000, DE, DE},
    {0x00000001, 0x0000ffff, 0x00000001, 0x00000001, DE, DE},
    // zero divisors
    {0x00010000, 0x00000000, DE, DE, DE, DE},
    {0x00000000, 0x00000000, DE, DE, DE, DE},
    // 8001h / 1 = 80010000h ulp, unsigned
    {0x00008001, 0x00000001, 0x80010000, DE, DE, DE},
    {0x00008001, 0xffffffff, 0x7fff0000, DE, DE, DE},
    // ffffh / 1 is the last quotient that fits 32 bits; 10000h / 1 is the first that does not
    {0x0000ffff, 0x00000001, 0xffff0000, DE, DE, DE},
    {0x00010000, 0x00000001, DE, DE, DE, DE},
    // 2ffffh / 3 = 4294945450.67 ulp, unsigned
    {0x0002ffff, 0x00000003, 0xffffaaab, DE, DE, DE},
    {0x80000000, 0x80000000, 0x00010000, 0x00010000, 0x00010000, 0x00010000},
    {0x80000000, 0x00010000, 0x80000000, 0x80000000, 0x80000000, 0x80000000},
    {0x80000000, 0xffff0000, 0x80000000, DE, 0x80000000, 0x80000000},
    // 1.0 / -32768.0 = -2 ulp
    {0x00010000, 0x80000000, 0xfffffffe, 0xfffffffe, 0xfffffffe, 0xfffffffe},
    // 1.75 / 2.99 = 38357.12 ulp; the 8088 divides by 2 and gets 57344 ulp
    {0x0001c000, 0x0002fd71, 0x000095d5, 0x000095d5, 0x0000e000, 0x0000e000},
};

template <class On, class Off>
void expect_quotient(const quotient& q, answer on, answer off) {
  const auto check = [&q]<class Number>(Number, answer expected) {
    const auto n = word<Number>(q.n);
    const auto d = word<Number>(q.d);
    const auto tried = try_divide(n, d);
    ASSERT_EQ(tried.has_value(), expected.has_value()) << std::hex << q.n << " / " << q.d;
    if (expected) {
      EXPECT_EQ(*tried, word<Number>(*expected)) << std::hex << q.n << " / " << q.d;
      EXPECT_EQ(n / d, word<Number>(*expected)) << std::hex << q.n << " / " << q.d;
    } else {
      EXPECT_THROW(static_cast<void>(n / d), divide_error) << std::hex << q.n << " / " << q.d;
    }
  };
  check(On(), on);
  check(Off(), off);
}

TEST(Presets, Quotients) {
  for (const quotient& q : quotients) {
    expect_quotient<q16_16_i386, q16_16_i386_unrounded>(q, q.i386_on, q.i386_off);
    expect_quotient<q16_16_i386_div_rounded, q16_16_i386_mul_rounded>(q, q.i386_on, q.i386_off);
    expect_quotient<q16_16_i8088, q16_16_i8088_unrounded>(q, q.i8088_on, q.i8088_off);
    expect_quotient<q16_16_i8088_div_rounded, q16_16_i8088_mul_rounded>(q, q.i8088_on, q.i8088_off);
  }
}

/// The same rules with 8 bits in place of 16 and 16 in place of 32.
constexpr product half_products[] = {
    {0x0180, 0x0280, 0x03c0, 0x03c0, 0x03c0, 0x03c0},
    {0x0001, 0x0080, 0x0001, 0x0000, 0x0001, 0x0000},
    {0xffff, 0x0080, 0x0000, 0xffff, 0xffff, 0x0000},
    {0xfffd, 0x0080, 0xffff, 0xfffe, 0xfffe, 0xffff},
    {0x1000, 0x1000, 0x0000, 0x0000, 0x0000, 0x0000},
    {0x8000, 0xffff, 0x0080, 0x0080, 0x0080, 0x0080},
};

constexpr quotient half_quotients[] = {
    {0x0200, 0x0300, 0x00ab, 0x00aa, 0x00ab, 0x00aa},
    {0xfe00, 0x0300, 0xff55, 0xff56, 0xff55, 0xff56},
    {0x0001, 0x0200, 0x0001, 0x0000, 0x0001, 0x0000},
    {0xffff, 0x0200, 0xffff, 0x0000, 0xffff, 0x0000},
    {0x0300, 0x0180, 0x0200, 0x0200, 0x0300, 0x0300},
    {0x0080, 0x0080, 0x0100, 0x0100, DE, DE},
    {0x0081, 0x0001, 0x8100, DE, DE, DE},
    {0x0081, 0xffff, 0x7f00, DE, DE, DE},
    {0x00ff, 0x0001, 0xff00, DE, DE, DE},
    {0x0100, 0x0001, DE, DE, DE, DE},
    {0x8000, 0xff00, 0x8000, DE, 0x8000, 0x8000},
    {0x0100, 0x0000, DE, DE, DE, DE},
};

TEST(Presets, HalfWidth) {
  for (const product& p : half_products) {
    expect_product<q8_8_i386, q8_8_i386_unrounded>(p, p.i386_on, p.i386_off);
    expect_product<q8_8_i386_mul_rounded, q8_8_i386_div_rounded>(p, p.i386_on, p.i386_off);
    expect_product<q8_8_i8088, q8_8_i8088_unrounded>(p, p.i8088_on, p.i8088_off);
    expect_product<q8_8_i8088_mul_rounded, q8_8_i8088_div_rounded>(p, p.i8088_on, p.i8088_off);
  }
  for (const quotient& q : half_quotients) {
    expect_quotient<q8_8_i386, q8_8_i386_unrounded>(q, q.i386_on, q.i386_off);
    expect_quotient<q8_8_i386_div_rounded, q8_8_i386_mul_rounded>(q, q.i386_on, q.i386_off);
    expect_quotient<q8_8_i8088, q8_8_i8088_unrounded>(q, q.i8088_on, q.i8088_off);
    expect_quotient<q8_8_i8088_div_rounded, q8_8_i8088_mul_rounded>(q, q.i8088_on, q.i8088_off);
  }
}

}  // namespace
