// Level 1 must kill every policy that differs from a preset in one rule, unless it is equivalent.
#include "fixed/fixed.hpp"
#include "tests/support/test.hpp"
#include "verify/proof/kill.hpp"

namespace {

using namespace fixproof;
using fixproof::divide_fault;
using fixproof::divisor_width;
using fixproof::overflow;
using fixproof::policy;
using fixproof::rounding;

template <policy rules>
class Ruled final : public parties::Party {
 public:
  [[nodiscard]] std::string_view name() const override { return "ruled"; }
  [[nodiscard]] std::string identity() const override { return "a test"; }
  [[nodiscard]] bool answers(const cases::Variant& /*variant*/) const override { return true; }
  void fill(const cases::Variant& v, const parties::Cases& asked) const override {
    for (std::size_t i = 0; i < asked.endings.size(); ++i) {
      asked.endings[i] = one(v, asked.in.subspan(2 * i, 2), asked.out[i]);
    }
  }

 private:
  static parties::Ending one(const cases::Variant& v, std::span<const std::uint32_t> in,
                             std::uint32_t& out) {
    using Number = fixproof::number<std::int32_t, 16, rules>;
    const auto a = Number::from_raw(static_cast<std::int32_t>(in[0]));
    const auto b = Number::from_raw(static_cast<std::int32_t>(in[1]));
    try {
      if (v.operation == cases::Operation::mul) {
        out = static_cast<std::uint32_t>((a * b).raw());
        return parties::Ending::value;
      }
      const auto quotient = fixproof::try_divide(a, b);
      if (!quotient) return parties::Ending::divide_error;
      out = static_cast<std::uint32_t>(quotient->raw());
      return parties::Ending::value;
    } catch (const fixproof::overflow_error&) {
      return parties::Ending::broken;
    }
  }
};

class Trials {
 public:
  explicit Trials(cases::Variant v) : v_(v) {}

  template <policy wrong>
  void try_out(const std::string& rule, bool is_right) {
    if (is_right) return;
    ++tried;
    if (!proof::cases_to_kill(v_, Ruled<wrong>(), 54)) survivors.push_back(rule);
  }

  template <policy right>
  void round_otherwise() {
    constexpr auto with = [](rounding r) {
      policy p = right;
      p.multiply = r;
      p.divide = r;
      return p;
    };
    const rounding now = v_.operation == cases::Operation::mul ? right.multiply : right.divide;
    try_out<with(rounding::half_up)>("half_up", now == rounding::half_up);
    try_out<with(rounding::half_away)>("half_away", now == rounding::half_away);
    try_out<with(rounding::floor)>("floor", now == rounding::floor);
    try_out<with(rounding::truncate)>("truncate", now == rounding::truncate);
  }

  template <policy right>
  void overflow_otherwise() {
    constexpr auto with = [](overflow o) {
      policy p = right;
      p.range = o;
      return p;
    };
    try_out<with(overflow::wrap)>("wrap", right.range == overflow::wrap);
    try_out<with(overflow::saturate)>("saturate", right.range == overflow::saturate);
    try_out<with(overflow::trap)>("trap", right.range == overflow::trap);
  }

  template <policy right>
  void divide_otherwise() {
    constexpr auto with = [](divisor_width d, divide_fault f) {
      policy p = right;
      p.divisor = d;
      p.fault = f;
      return p;
    };
    constexpr bool whole = right.divisor == divisor_width::whole_part;
    constexpr auto other = whole ? divisor_width::full : divisor_width::whole_part;
    try_out<with(other, right.fault)>("divisor", false);
    using enum divide_fault;
    try_out<with(right.divisor, none)>("none", right.fault == none);
    try_out<with(right.divisor, zero_divisor)>("zero_divisor", right.fault == zero_divisor);
    try_out<with(right.divisor, unsigned_quotient)>("unsigned_quotient",
                                                    right.fault == unsigned_quotient);
    try_out<with(right.divisor, signed_quotient)>("signed_quotient",
                                                  right.fault == signed_quotient);
  }

  int tried = 0;
  std::vector<std::string> survivors;

 private:
  cases::Variant v_;
};

using Names = std::vector<std::string>;

/// @param same divide rules that are equivalent to those of the preset
template <policy right>
void expect_all_killed(cases::Target target, bool mul_round, bool div_round, const Names& same) {
  const auto variant = [&](cases::Operation o) {
    return cases::Variant{
        .operation = o,
        .build = {.target = target, .mul_round = mul_round, .div_round = div_round}};
  };
  Trials products(variant(cases::Operation::mul));
  products.round_otherwise<right>();
  products.overflow_otherwise<right>();
  EXPECT_EQ(products.tried, 5);
  EXPECT_EQ(products.survivors, Names{});
  EXPECT_FALSE(proof::cases_to_kill(variant(cases::Operation::mul), Ruled<right>(), 54));

  Trials quotients(variant(cases::Operation::div));
  quotients.round_otherwise<right>();
  quotients.overflow_otherwise<right>();
  quotients.divide_otherwise<right>();
  EXPECT_EQ(quotients.tried, 9);
  EXPECT_EQ(quotients.survivors, same);
  EXPECT_FALSE(proof::cases_to_kill(variant(cases::Operation::div), Ruled<right>(), 54));
}

namespace p = fixproof::policies;

// try_divide returns no value for a zero divisor under any policy.
TEST(PolicyMutation, Wrapping) {
  expect_all_killed<p::wrapping>(cases::Target::standard, true, true, {"zero_divisor"});
}

TEST(PolicyMutation, I386) {
  expect_all_killed<p::i386_rounded>(cases::Target::i386, true, true, {});
  expect_all_killed<p::i386_div_rounded>(cases::Target::i386, false, true, {});
}

// A value that would be out of range has already raised a fault.
TEST(PolicyMutation, I386WithIdiv) {
  const Names same{"saturate", "trap"};
  expect_all_killed<p::i386_mul_rounded>(cases::Target::i386, true, false, same);
  expect_all_killed<p::i386_unrounded>(cases::Target::i386, false, false, same);
}

// Dividing by a whole number gives magnitudes of at most 2^31 units, so only zero divisors fault.
// try_divide returns no value for them in any case.
TEST(PolicyMutation, I8088) {
  const Names same{"none", "unsigned_quotient"};
  expect_all_killed<p::i8088_rounded>(cases::Target::i8088, true, true, same);
  expect_all_killed<p::i8088_mul_rounded>(cases::Target::i8088, true, false, same);
  expect_all_killed<p::i8088_div_rounded>(cases::Target::i8088, false, true, same);
  expect_all_killed<p::i8088_unrounded>(cases::Target::i8088, false, false, same);
}

}  // namespace
