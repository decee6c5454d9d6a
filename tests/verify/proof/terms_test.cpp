// Tests that folding preserves meaning: constants and variables of the same values must agree.
#include "tests/support/test.hpp"
#include "x86model/alu.hpp"
#include "x86model/symbolic/domain.hpp"
#include "x86model/symbolic/evaluate.hpp"
#include "x86model/symbolic/smt.hpp"

namespace {

using namespace x86model::symbolic;

TEST(Terms, AreKeptOnce) {
  Terms t;
  const Term a = t.variable("a", 16);
  EXPECT_EQ(t.add(a, t.constant(3, 16)), t.add(t.constant(3, 16), a));
  EXPECT_EQ(t.add(t.add(a, t.constant(3, 16)), t.constant(65533, 16)), a);
  EXPECT_EQ(t.sub(a, a), t.constant(0, 16));
  EXPECT_EQ(t.concat(t.extract(a, 8, 8), t.extract(a, 0, 8)), a);
  EXPECT_EQ(t.extract(t.concat(a, t.constant(5, 16)), 16, 16), a);
  EXPECT_NE(t.variable("a", 16), t.variable("b", 16));
}

TEST(Terms, ExtensionsAndShiftsOfOneAreOne) {
  Terms t;
  const Term a = t.variable("a", 16);
  const auto half = [&](Term x) { return t.concat(t.constant(0, 1), t.extract(x, 1, 15)); };
  const auto twice = [&](Term x) { return t.concat(t.extract(x, 0, 15), t.constant(0, 1)); };
  EXPECT_EQ(half(half(a)), t.concat(t.constant(0, 2), t.extract(a, 2, 14)));
  EXPECT_EQ(twice(twice(a)), t.concat(t.extract(a, 0, 14), t.constant(0, 2)));
  Term left = a;
  for (int i = 0; i < 16; ++i) left = half(left);
  EXPECT_EQ(left, t.constant(0, 16));
  EXPECT_EQ(t.sign_extend(t.sign_extend(a, 24), 40), t.sign_extend(a, 40));
  EXPECT_EQ(t.sign_extend(t.zero_extend(a, 24), 40), t.zero_extend(a, 40));
  EXPECT_EQ(t.extract(t.sign_extend(a, 40), 0, 16), a);
  EXPECT_EQ(t.extract(t.sign_extend(a, 40), 8, 16), t.sign_extend(t.extract(a, 8, 8), 16));
  const Term sign = t.sign_extend(t.extract(a, 15, 1), 8);
  EXPECT_EQ(t.extract(t.sign_extend(t.extract(a, 15, 1), 40), 20, 8), sign);
}

TEST(Terms, AreWholeAgainAfterTheirBytes) {
  Terms t;
  const Term a = t.variable("a", 32);
  for (const Term whole : {a, t.zero_extend(a, 64), t.sign_extend(a, 64),
                           t.sign_extend(t.extract(a, 31, 1), 64), t.add(a, a)}) {
    Term bytes = t.extract(whole, 0, 8);
    for (int low = 8; low < t.width(whole); low += 8) {
      bytes = t.concat(t.extract(whole, low, 8), bytes);
    }
    EXPECT_EQ(bytes, whole);
  }
}

TEST(Terms, KnowWhatAChainOfConditionsSays) {
  Terms t;
  const Term x = t.variable("x", 0);
  const Term y = t.variable("y", 0);
  const Term both = t.both(x, y);
  EXPECT_EQ(t.both(both, x), both);
  EXPECT_EQ(t.both(both, t.negation(x)), t.truth(false));
  EXPECT_EQ(t.both(both, t.truth(true)), both);
}

TEST(Terms, FoldToWhatTheyMean) {
  std::mt19937_64 random(54);
  Terms t;
  const Term a = t.variable("a", 16);
  const Term b = t.variable("b", 16);
  Evaluation evaluation(t, concrete);
  for (int i = 0; i < 500; ++i) {
    const std::uint64_t x = random() & 0xFFFFU;
    const std::uint64_t y = i % 3 == 0 ? x : random() & 0xFFFFU;
    evaluation.set("a", x);
    evaluation.set("b", y);
    const Term p = t.constant(x, 16);
    const Term q = t.constant(y, 16);
    const int low = static_cast<int>(random() % 15);
    const auto same = [&](Term open, Term folded) {
      ASSERT_TRUE(t.is_constant(folded));
      EXPECT_EQ(evaluation(open), t.value(folded)) << x << ' ' << y;
    };
    same(t.add(a, b), t.add(p, q));
    same(t.sub(a, b), t.sub(p, q));
    same(t.sub(a, q), t.sub(p, q));
    same(t.bit_and(a, b), t.bit_and(p, q));
    same(t.bit_xor(a, b), t.bit_xor(p, q));
    same(t.concat(a, b), t.concat(p, q));
    same(t.extract(t.concat(a, b), low, 17), t.extract(t.concat(p, q), low, 17));
    same(t.sign_extend(a, 40), t.sign_extend(p, 40));
    same(t.sign_extend(t.concat(t.constant(x, 3), b), 40),
         t.sign_extend(t.concat(t.constant(x, 3), q), 40));
    const int bits = 1 + static_cast<int>(random() % 16);
    same(t.extract(t.sign_extend(a, 40), low, bits), t.extract(t.sign_extend(p, 40), low, bits));
    same(t.concat(t.extract(a, 8, 8), t.extract(b, 0, 8)),
         t.concat(t.extract(p, 8, 8), t.extract(q, 0, 8)));
    same(t.concat(t.sign_extend(a, 24), t.sign_extend(a, 20)),
         t.concat(t.sign_extend(p, 24), t.sign_extend(p, 20)));
    same(t.concat(t.constant(5, 3), t.concat(t.constant(1, 2), a)),
         t.concat(t.constant(5, 3), t.concat(t.constant(1, 2), p)));
    same(t.concat(t.concat(a, t.constant(1, 2)), t.constant(5, 3)),
         t.concat(t.concat(p, t.constant(1, 2)), t.constant(5, 3)));
    same(t.equal(a, b), t.equal(p, q));
    same(t.below(a, b), t.below(p, q));
    same(t.ite(t.below(a, b), a, b), t.ite(t.below(p, q), p, q));
  }
}

// Joining the words of ADD and ADC, or of NEG, NEG and SBB, gives one addition or subtraction with
// the same meaning as the two words.
TEST(Terms, JoinedWordsMeanTheWords) {
  Terms t;
  const Domain d = t;
  const Term none = t.truth(false);
  const Term zero = t.constant(0, 16);
  const Term a = t.variable("a", 32);
  const Term b = t.variable("b", 32);
  const auto low = [&](Term x) { return t.extract(x, 0, 16); };
  const auto high = [&](Term x) { return t.extract(x, 16, 16); };
  const auto sum = x86model::alu::add(d, low(a), low(b), none, 16);
  const auto upper = x86model::alu::add(d, high(a), high(b), *sum.flags.carry, 16);
  const Term joined = join(t, upper.value, sum.value);
  EXPECT_EQ(joined, t.add(a, b));

  const Term negated_high = x86model::alu::sub(d, zero, high(a), none, 16).value;
  const auto negated_low = x86model::alu::sub(d, zero, low(a), none, 16);
  const auto borrowed = x86model::alu::sub(d, negated_high, zero, *negated_low.flags.carry, 16);
  const Term opposite = join(t, borrowed.value, negated_low.value);
  EXPECT_EQ(opposite, t.sub(t.constant(0, 32), a));

  Evaluation evaluation(t, concrete);
  std::mt19937 random(8088);
  for (int i = 0; i < 1000; ++i) {
    evaluation.set("a", i % 4 == 0 ? random() & 0xFFFF0000U : random());
    evaluation.set("b", random());
    EXPECT_EQ(evaluation(joined), evaluation(t.concat(upper.value, sum.value)));
    EXPECT_EQ(evaluation(opposite), evaluation(t.concat(borrowed.value, negated_low.value)));
  }
  // Unrelated words are not joined.
  EXPECT_EQ(join(t, high(b), sum.value), t.concat(high(b), sum.value));
}

TEST(Terms, AreWrittenInOrder) {
  Terms t;
  const Term sum = t.add(t.variable("a", 16), t.constant(3, 16));
  const std::array roots{t.apply("umul16", {sum, sum}, 32)};
  EXPECT_EQ(declare_variables(t, roots), "(declare-const a (_ BitVec 16))\n");
  const std::string text = define(t, roots);
  EXPECT_LT(text.find("(bvadd a (_ bv3 16))"), text.find("umul16")) << text;
}

}  // namespace
