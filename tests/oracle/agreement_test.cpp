#include "oracle/exact.hpp"
#include "oracle/fast.hpp"
#include "oracle/format.hpp"
#include "tests/oracle/rules.hpp"
#include "tests/support/test.hpp"
#include "verify/parties/answer.hpp"

namespace oracle {
namespace {

static_assert(fast::mul(0xffff8000, 1, Rounding::half_up, 16) == 0);
static_assert(fast::div(0x8001, 0xffffffff, DivideRule::i386_rounded, 16) == 0x7fff0000);
static_assert(fast::exact_root(0x20000, Rounding::half_up, 16) == 0x16a0a);

/// Whether both formulations agree on every operation on a pair; names the first difference.
testing::AssertionResult agree(Word a, Word b, int fraction_bits) {
  const auto differ = [&](const char* what, std::size_t rule) {
    return testing::AssertionFailure() << what << " of " << std::hex << a << ", " << b << std::dec
                                       << ", rule " << rule << ", fraction bits " << fraction_bits;
  };
  if (add(a, b, fraction_bits) !=
      fast::wrap(static_cast<LongWord>(fast::exact_sum(a, b, fraction_bits)), fraction_bits)) {
    return differ("sum", 0);
  }
  if (sub(a, b, fraction_bits) !=
      fast::wrap(static_cast<LongWord>(fast::exact_difference(a, b, fraction_bits)),
                 fraction_bits)) {
    return differ("difference", 0);
  }
  for (std::size_t i = 0; i < test::kRoundings.size(); ++i) {
    const Rounding rule = test::kRoundings[i];
    const Integer product = exact_product(a, b, rule, fraction_bits);
    if (product != Integer(exact_product<Wide>(a, b, rule, fraction_bits))) {
      return differ("product in Wide", i);
    }
    if (product != fast::exact_product(a, b, rule, fraction_bits).value())
      return differ("product", i);
    if (mul(a, b, rule, fraction_bits) != fast::mul(a, b, rule, fraction_bits)) {
      return differ("mul", i);
    }
    const auto exact = exact_quotient(a, b, rule, fraction_bits);
    const auto wide = exact_quotient<Wide>(a, b, rule, fraction_bits);
    if (exact.has_value() != wide.has_value() || (exact && *exact != Integer(*wide))) {
      return differ("exact quotient in Wide", i);
    }
    const auto quick = fast::exact_quotient(a, b, rule, fraction_bits);
    if (exact.has_value() != quick.has_value() || (exact && *exact != quick->value())) {
      return differ("exact quotient", i);
    }
    if (quotient(a, b, rule, fraction_bits) != fast::quotient(a, b, rule, fraction_bits)) {
      return differ("quotient", i);
    }
  }
  for (std::size_t i = 0; i < test::kDivideRules.size(); ++i) {
    const DivideRule rule = test::kDivideRules[i];
    if (div(a, b, rule, fraction_bits) != fast::div(a, b, rule, fraction_bits)) {
      return differ("div", i);
    }
  }
  return testing::AssertionSuccess();
}

/// Zero, the powers of two and 1.5 times them, each with its neighbours and its negative.
std::vector<Word> boundary_words(int fraction_bits) {
  const Word mask = ~Word{0} >> (32 - 2 * fraction_bits);
  std::vector<Word> words;
  for (int bit = 0; bit < 2 * fraction_bits; ++bit) {
    const Word power = Word{1} << bit;
    for (const Word centre : {power, power + power / 2}) {
      for (const Word word : {centre - 1, centre, centre + 1}) {
        words.push_back(word & mask);
        words.push_back((~word + 1) & mask);
      }
    }
  }
  std::sort(words.begin(), words.end());
  words.erase(std::unique(words.begin(), words.end()), words.end());
  return words;
}

/// Words of every magnitude and either sign: a uniform word shifted down by a uniform count.
class Words {
 public:
  Word operator()() {
    const auto bits = static_cast<Word>(generator_());
    const Word magnitude = bits >> (generator_() % 32);
    return generator_() % 2 == 0 ? magnitude : ~magnitude + 1;
  }

 private:
  // A fixed seed, so that failures are reproducible.
  std::mt19937_64 generator_{20260101};  // NOLINT(cert-msc32-c, cert-msc51-cpp)
};

class OracleFastByFormat : public testing::TestWithParam<int> {};

TEST_P(OracleFastByFormat, AgreesOnTheBoundaryLattice) {
  const std::vector<Word> words = boundary_words(GetParam());
  for (const Word a : words) {
    for (const Word b : words) ASSERT_TRUE(agree(a, b, GetParam()));
  }
}

TEST_P(OracleFastByFormat, AgreesOnRandomPairs) {
  Words words;
  for (int i = 0; i < 20000; ++i) ASSERT_TRUE(agree(words(), words(), GetParam()));
}

TEST_P(OracleFastByFormat, AgreesOnRandomTransforms) {
  Words words;
  std::array<Word, 12> first{};
  std::array<Word, 12> second{};
  std::array<Word, 3> vector{};
  for (int i = 0; i < 1000; ++i) {
    std::generate(first.begin(), first.end(), std::ref(words));
    std::generate(second.begin(), second.end(), std::ref(words));
    std::generate(vector.begin(), vector.end(), std::ref(words));
    for (const Rounding rule : test::kRoundings) {
      ASSERT_EQ(fast::xform_vec(first, vector, rule, GetParam()),
                xform_vec(first, vector, rule, GetParam()));
      for (const auto translation :
           {TranslationRule::fourth, TranslationRule::every, TranslationRule::fourth_in_parts}) {
        ASSERT_EQ(fast::concat(first, second, rule, translation, GetParam()),
                  concat(first, second, rule, translation, GetParam()));
      }
    }
  }
}

TEST_P(OracleFastByFormat, AgreesOnRoots) {
  Words words;
  const auto expect_equal = [](Word word) {
    ASSERT_EQ(fast::exact_root(word, Rounding::half_up, GetParam()), sqrt(word, GetParam()))
        << word;
    for (const Rounding rule : test::kRoundings) {
      const auto exact = exact_root(word, rule, GetParam());
      const auto wide = exact_root<Wide>(word, rule, GetParam());
      const auto quick = fast::exact_root(word, rule, GetParam());
      ASSERT_EQ(exact.has_value(), wide.has_value()) << word;
      ASSERT_EQ(exact.has_value(), quick.has_value()) << word;
      if (exact) {
        ASSERT_EQ(*exact, Integer(*wide)) << word;
        ASSERT_EQ(*exact, *quick) << word;
      }
    }
  };
  for (const Word word : boundary_words(GetParam())) expect_equal(word);
  for (int i = 0; i < 20000; ++i) expect_equal(words());
}

INSTANTIATE_TEST_SUITE_P(Formats, OracleFastByFormat, testing::Values(2, 3, 5, 8, 15, 16),
                         testing::PrintToStringParamName());

TEST(OracleFast, AgreesOnEveryPairOfFourFractionBits) {
  for (Word a = 0; a < 256; ++a) {
    for (Word b = 0; b < 256; ++b) ASSERT_TRUE(agree(a, b, 4));
  }
}

TEST(OracleFast, FormatsOutsideTheRangeAreRefused) {
  for (const int fraction_bits : {-1, 1, 17}) {
    EXPECT_THROW((void)fast::mul(1, 1, Rounding::floor, fraction_bits), std::invalid_argument);
    EXPECT_THROW((void)fast::exact_root(1, Rounding::floor, fraction_bits), std::invalid_argument);
    EXPECT_THROW((void)fast::wrap(LongWord{1}, fraction_bits), std::invalid_argument);
    for (const DivideRule rule : test::kDivideRules) {
      EXPECT_THROW((void)fast::div(1, 1, rule, fraction_bits), std::invalid_argument);
    }
  }
}

}  // namespace
}  // namespace oracle
