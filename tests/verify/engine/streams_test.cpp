// Tests that streams are pure functions and contain the cases that they promise.
#include "verify/cases/streams.hpp"

#include "tests/support/test.hpp"
#include "verify/cases/plan.hpp"
#include "verify/parties/party.hpp"

namespace fixproof {
namespace streams_test {

constexpr std::size_t sample = 4096;
constexpr std::uint64_t seed = 7;

std::int64_t value_of(std::uint32_t word, int bits) {
  return static_cast<std::int32_t>(word << (32 - bits)) >> (32 - bits);
}

using Case = std::vector<std::int64_t>;

std::vector<Case> cases_of(cases::Stream stream, const cases::Variant& variant,
                           std::size_t count = sample) {
  const std::size_t arity = cases::words_in(variant.operation);
  std::vector<std::uint32_t> words(count * arity);
  cases::make_cases(stream, variant, seed, 0, words);
  std::vector<Case> cases(count);
  for (std::size_t i = 0; i < words.size(); ++i) {
    cases[i / arity].push_back(value_of(words[i], cases::operand_bits(variant)));
  }
  return cases;
}

template <class Holds>
std::size_t count(const std::vector<Case>& cases, Holds holds) {
  return static_cast<std::size_t>(std::count_if(cases.begin(), cases.end(), holds));
}

/// Every stream of every operation, at each width that the operation has.
struct Use {
  cases::Stream stream;
  cases::Variant variant;
};
std::vector<Use> all_uses() {
  std::vector<Use> uses;
  for (const cases::Variant& listed : cases::all_variants()) {
    for (const cases::Format& format : {cases::q16_16, cases::q8_8}) {
      cases::Variant v = listed;
      v.format = format;
      const cases::Plan plan(1, 1, {{v, {"a", "b"}}});
      for (const cases::Job& job : plan.jobs()) uses.push_back({job.stream, v});
    }
  }
  return uses;
}

TEST(Streams, AreTheSameMadeInAnyOrderAndAnyPieces) {
  for (const auto& [stream, variant] : all_uses()) {
    const std::size_t arity = cases::words_in(variant.operation);
    std::vector<std::uint32_t> whole(100 * arity);
    cases::make_cases(stream, variant, seed, 5000, whole);
    std::vector<std::uint32_t> again(whole.size());
    for (const std::size_t i : {99U, 0U, 50U, 1U, 98U}) {
      const auto one = std::span(again).subspan(i * arity, arity);
      cases::make_cases(stream, variant, seed, 5000 + i, one);
      EXPECT_TRUE(std::equal(one.begin(), one.end(),
                             whole.begin() + static_cast<std::ptrdiff_t>(i * arity)))
          << cases::name_of(stream) << " case " << i;
    }
  }
}

TEST(Streams, FillOnlyTheBitsOfAnOperand) {
  for (const auto& [stream, variant] : all_uses()) {
    std::vector<std::uint32_t> words(1000 * cases::words_in(variant.operation));
    cases::make_cases(stream, variant, seed, 0, words);
    const int bits = cases::operand_bits(variant);
    const auto beyond = [&](std::uint32_t word) { return bits < 32 && word >> bits != 0; };
    EXPECT_TRUE(std::none_of(words.begin(), words.end(), beyond)) << cases::name_of(stream);
  }
}

TEST(Streams, DifferBySeedAndAreNotOneCaseOverAndOver) {
  for (const auto& [stream, variant] : all_uses()) {
    if (cases::size_of(stream, variant)) continue;
    const std::size_t arity = cases::words_in(variant.operation);
    std::vector<std::uint32_t> one(sample * arity);
    std::vector<std::uint32_t> other(one.size());
    cases::make_cases(stream, variant, 1, 0, one);
    cases::make_cases(stream, variant, 2, 0, other);
    EXPECT_NE(one, other) << cases::name_of(stream);
    const auto cases = cases_of(stream, variant);
    const std::set<Case> distinct(cases.begin(), cases.end());
    EXPECT_GT(distinct.size(), variant.format == cases::q16_16 ? sample / 4 : sample / 16)
        << cases::name_of(stream);
  }
}

TEST(Streams, RefuseOperationsTheyAreNotFor) {
  std::array<std::uint32_t, 2> words{};
  EXPECT_THROW(cases::make_cases(cases::Stream::quotient_ties, {.operation = cases::Operation::mul},
                                 1, 0, words),
               std::invalid_argument);
  EXPECT_THROW(cases::make_cases(cases::Stream::product_ties, {.operation = cases::Operation::div},
                                 1, 0, words),
               std::invalid_argument);
  EXPECT_THROW(cases::size_of(cases::Stream::lattice, {.operation = cases::Operation::concat}),
               std::invalid_argument);
  EXPECT_THROW(cases::size_of(cases::Stream::every, {.operation = cases::Operation::mul}),
               std::invalid_argument);
}

TEST(Lattice, HoldsTheBoundariesInBothSigns) {
  for (const int bits : {32, 16}) {
    const auto values = cases::boundary_lattice(bits);
    const std::set<std::uint32_t> set(values.begin(), values.end());
    EXPECT_EQ(set.size(), values.size());
    EXPECT_TRUE(std::is_sorted(values.begin(), values.end()));
    const std::uint32_t mask = ~0U >> (32 - bits);
    for (const std::uint64_t all : values) {
      const auto value = static_cast<std::uint32_t>(all);
      EXPECT_EQ(value & mask, value);
      EXPECT_TRUE(set.count(-value & mask)) << "no opposite of " << value;
    }
    for (int bit = 0; bit < bits; ++bit) {
      for (const std::uint32_t beside : {~0U, 0U, 1U}) {
        EXPECT_TRUE(set.count(((1U << bit) + beside) & mask)) << bit;
        EXPECT_TRUE(set.count((0U - (1U << bit) - beside) & mask)) << bit;
      }
    }
    for (const std::uint32_t value :
         {0U, 1U, 2U, 3U, 0x55555555U, 0xaaaaaaaaU, 0x33333333U, 0x0f0f0f0fU}) {
      EXPECT_TRUE(set.count(value & mask)) << value;
    }
  }
  const auto values = cases::boundary_lattice(32);
  for (const std::uint32_t value : {0x7fffU, 0x8000U, 0x8001U, 0xffffU, 0x10000U, 0x10001U,
                                    0x7fffffffU, 0x80000000U, 0x80000001U, 0xffffffffU}) {
    EXPECT_TRUE(std::binary_search(values.begin(), values.end(), value)) << std::hex << value;
  }
}

TEST(Lattice, StreamHoldsAllOrderedPairs) {
  const cases::Variant mul{.operation = cases::Operation::mul};
  const auto values = cases::boundary_lattice(32);
  const auto size = cases::size_of(cases::Stream::lattice, mul);
  ASSERT_EQ(size, values.size() * values.size());
  const auto cases = cases_of(cases::Stream::lattice, mul, *size);
  EXPECT_EQ(std::set<Case>(cases.begin(), cases.end()).size(), *size);
}

TEST(Streams, EveryHalfWidthPairAndEveryAngleComesOnce) {
  const cases::Variant half{.operation = cases::Operation::mul, .format = cases::q8_8};
  ASSERT_EQ(cases::size_of(cases::Stream::every, half), 1ULL << 32U);
  std::array<std::uint32_t, 4> words{};
  cases::make_cases(cases::Stream::every, half, seed, 0x12345678U, words);
  EXPECT_EQ(words, (std::array<std::uint32_t, 4>{0x1234, 0x5678, 0x1234, 0x5679}));
  cases::make_cases(cases::Stream::every, half, seed, 0xfffffffeU, words);
  EXPECT_EQ(words, (std::array<std::uint32_t, 4>{0xffff, 0xfffe, 0xffff, 0xffff}));

  const cases::Variant cossin{.operation = cases::Operation::cossin};
  ASSERT_EQ(cases::size_of(cases::Stream::every, cossin), 65536U);
  const auto angles = cases_of(cases::Stream::every, cossin, 65536);
  EXPECT_EQ(std::set<Case>(angles.begin(), angles.end()).size(), 65536U);

  const cases::Variant sqrt{.operation = cases::Operation::sqrt,
                            .build = {.target = cases::Target::standard}};
  ASSERT_EQ(cases::size_of(cases::Stream::every, sqrt), 1ULL << 32U);
  cases::make_cases(cases::Stream::every, sqrt, seed, 0xfffffffcU, words);
  EXPECT_EQ(words.back(), 0xffffffffU);
}

/// Constructed cases of mul and div at full and half width. The parameter is F, the number of
/// fraction bits.
class Constructed : public testing::TestWithParam<int> {
 protected:
  static std::vector<Case> made(cases::Operation operation, cases::Stream stream) {
    return cases_of(stream, {.operation = operation, .format = {2 * GetParam(), GetParam()}});
  }
  static std::int64_t one() { return std::int64_t{1} << GetParam(); }
  static std::int64_t limit() { return std::int64_t{1} << (2 * GetParam() - 1); }
  /// Twice the remainder of |n| 2^F divided by |d|.
  static std::int64_t twice_remainder(const Case& c) {
    return 2 * (std::abs(c[0]) * one() % std::abs(c[1]));
  }
};
INSTANTIATE_TEST_SUITE_P(Widths, Constructed, testing::Values(16, 8));

TEST_P(Constructed, ProductTiesAreTies) {
  const auto cases = made(cases::Operation::mul, cases::Stream::product_ties);
  const auto tie = [&](const Case& c) { return (c[0] * c[1] & (one() - 1)) == one() / 2; };
  EXPECT_EQ(count(cases, tie), sample);
  const std::size_t negative = count(cases, [](const Case& c) { return c[0] * c[1] < 0; });
  EXPECT_GT(negative, sample / 3);
  EXPECT_LT(negative, sample * 2 / 3);
}

TEST_P(Constructed, NearProductTiesLieOneBeside) {
  const auto cases = made(cases::Operation::mul, cases::Stream::near_product_ties);
  for (const std::int64_t off : {-1, 1}) {
    const auto near =
        count(cases, [&](const Case& c) { return (c[0] * c[1] & (one() - 1)) == one() / 2 + off; });
    EXPECT_GT(near, sample / 3) << off;
  }
  EXPECT_EQ(
      count(cases,
            [&](const Case& c) { return std::abs((c[0] * c[1] & (one() - 1)) - one() / 2) == 1; }),
      sample);
}

TEST_P(Constructed, QuotientTiesAreTies) {
  const auto cases = made(cases::Operation::div, cases::Stream::quotient_ties);
  EXPECT_EQ(count(cases, [&](const Case& c) { return twice_remainder(c) == std::abs(c[1]); }),
            sample);
  // None of them faults on the 386, and both signs occur.
  EXPECT_EQ(
      count(cases, [&](const Case& c) { return std::abs(c[1]) <= std::abs(c[0]) >> GetParam(); }),
      0U);
  EXPECT_GT(count(cases, [](const Case& c) { return (c[0] < 0) != (c[1] < 0); }), sample / 3);
}

TEST_P(Constructed, NearQuotientTiesLieOneBeside) {
  const auto cases = made(cases::Operation::div, cases::Stream::near_quotient_ties);
  EXPECT_EQ(
      count(cases,
            [&](const Case& c) { return std::abs(twice_remainder(c) - std::abs(c[1])) == 1; }),
      sample);
  EXPECT_EQ(
      count(cases, [&](const Case& c) { return std::abs(c[1]) <= std::abs(c[0]) >> GetParam(); }),
      0U);
  EXPECT_GT(count(cases, [&](const Case& c) { return twice_remainder(c) < std::abs(c[1]); }),
            sample / 3);
}

TEST_P(Constructed, WholeDivisorTiesAreTiesOfThe8088) {
  const auto cases = made(cases::Operation::div, cases::Stream::whole_divisor_ties);
  const auto whole = [&](const Case& c) { return std::abs(c[1]) >> GetParam(); };
  const auto beside = [&](const Case& c) { return 2 * (std::abs(c[0]) % whole(c)) - whole(c); };
  EXPECT_EQ(count(cases, [&](const Case& c) { return whole(c) == 0; }), 0U);
  EXPECT_GT(count(cases, [&](const Case& c) { return beside(c) == 0; }), sample / 10);
  EXPECT_GT(count(cases, [&](const Case& c) { return beside(c) == -1 || beside(c) == -2; }),
            sample / 5);
  EXPECT_GT(count(cases, [&](const Case& c) { return beside(c) == 1 || beside(c) == 2; }),
            sample / 5);
}

TEST_P(Constructed, LargeQuotientsStandOnBothSidesOfBothLimits) {
  const auto cases = made(cases::Operation::div, cases::Stream::large_quotients);
  for (const std::int64_t edge : {limit(), 2 * limit()}) {
    const auto side = [&](auto compare) {
      return count(cases, [&](const Case& c) {
        const std::int64_t quotient = std::abs(c[0]) * one() / std::abs(c[1]);
        return std::abs(quotient - edge) <= 4 * one() && compare(quotient, edge);
      });
    };
    EXPECT_GT(side(std::less<>()), sample / 50) << edge;
    EXPECT_GT(side(std::greater_equal<>()), sample / 50) << edge;
  }
}

TEST_P(Constructed, SmallDivisorsAreBelowOne) {
  const auto cases = made(cases::Operation::div, cases::Stream::small_divisors);
  EXPECT_EQ(count(cases, [&](const Case& c) { return std::abs(c[1]) < one(); }), sample);
  EXPECT_GT(count(cases, [](const Case& c) { return c[1] == 0; }), 0U);
}

TEST_P(Constructed, FaultEdgeLiesOnBothSidesOfBothRules) {
  const auto cases = made(cases::Operation::div, cases::Stream::fault_edge);
  for (const std::int64_t off : {-1, 0, 1}) {
    EXPECT_GT(count(cases,
                    [&](const Case& c) {
                      return std::abs(c[1]) == (std::abs(c[0]) >> GetParam()) + off && c[0] != 0;
                    }),
              sample / 20)
        << off;
    EXPECT_GT(count(cases, [&](const Case& c) { return std::abs(c[1]) == one() + off; }),
              sample / 20)
        << off;
  }
}

TEST(Streams, RotationsAreOrthonormal) {
  const cases::Variant xform{.operation = cases::Operation::xformvec};
  for (const Case& c : cases_of(cases::Stream::rotations, xform)) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        double dot = 0;
        for (std::size_t k = 0; k < 3; ++k) {
          dot += static_cast<double>(c[4 * i + k]) * static_cast<double>(c[4 * j + k]);
        }
        EXPECT_NEAR(dot / 65536 / 65536, i == j ? 1 : 0, 1e-4);
      }
    }
  }
}

TEST(Streams, AxesHoldTheIdentityAndItsNegative) {
  for (const cases::Operation operation : {cases::Operation::xformvec, cases::Operation::concat}) {
    const auto cases = cases_of(cases::Stream::axes, {.operation = operation});
    for (const std::int64_t sign : {1, -1}) {
      EXPECT_GT(count(cases,
                      [&](const Case& c) {
                        for (std::size_t i = 0; i < 3; ++i) {
                          for (std::size_t k = 0; k < 3; ++k) {
                            if (c[4 * i + k] != (i == k ? sign * 65536 : 0)) return false;
                          }
                        }
                        return true;
                      }),
                0U);
    }
  }
}

TEST(Streams, TransformTiesMakeEveryProductATie) {
  for (const cases::Operation operation : {cases::Operation::xformvec, cases::Operation::concat}) {
    const std::size_t columns = operation == cases::Operation::concat ? 4 : 1;
    for (const Case& c : cases_of(cases::Stream::transform_ties, {.operation = operation})) {
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
          for (std::size_t column = 0; column < columns; ++column) {
            ASSERT_EQ(c[4 * i + k] * c[12 + columns * k + column] & 0xffff, 0x8000);
          }
        }
      }
    }
  }
}

TEST(Streams, QuarterTurnsAreBesideMultiplesOfHalfPi) {
  for (const int bits : {16, 8}) {
    const auto cases =
        cases_of(cases::Stream::quarter_turns, {.operation = cases::Operation::sin,
                                                .build = {.target = cases::Target::standard},
                                                .format = {2 * bits, bits}});
    const double quarter = std::ldexp(std::acos(0.0), bits);
    std::set<double> seen;
    for (const Case& c : cases) {
      const auto angle = static_cast<double>(c[0]);
      const double turns = std::round(angle / quarter);
      ASSERT_LT(std::abs(angle - turns * quarter), 1.501) << c[0];
      seen.insert(turns);
    }
    EXPECT_GT(seen.size(), std::min<std::size_t>(sample / 2, 160)) << bits;
    EXPECT_GT(*seen.rbegin(), bits == 16 ? 20'000 : 80);
    EXPECT_LT(*seen.begin(), bits == 16 ? -20'000 : -80);
  }
}

TEST(Streams, HardAnglesAreNearHalfway) {
  const cases::Variant cosine{.operation = cases::Operation::cos,
                              .build = {.target = cases::Target::standard}};
  ASSERT_EQ(cases::size_of(cases::Stream::hard_angles, cosine), 124U);
  const auto cases = cases_of(cases::Stream::hard_angles, cosine, 124);
  const auto from_half = [](long double exact) {
    const long double units = exact * 65536;
    return std::abs(units - std::floor(units) - 0.5L);
  };
  std::set<std::int64_t> seen;
  for (const Case& c : cases) {
    const auto radians = static_cast<long double>(c[0]) / 65536;
    ASSERT_LT(std::min(from_half(std::sin(radians)), from_half(std::cos(radians))), 0x1p-27L);
    seen.insert(c[0]);
  }
  EXPECT_EQ(seen.size(), 124U);
}

// In every stream many fourth-column sums carry and many do not, so every stream distinguishes a
// ConcatXforms that keeps its carry from one that loses it.
TEST(Streams, SumsOfTransformsCarryAndDoNot) {
  for (const bool round : {true, false}) {
    const cases::Variant printed{.operation = cases::Operation::concat,
                                 .build = {.target = cases::Target::i8088, .mul_round = round}};
    cases::Variant repaired = printed;
    repaired.build.repaired = true;
    const cases::Plan plan(1, seed, {{printed, {"a", "b"}}});
    EXPECT_EQ(plan.jobs().size(), 6U);
    for (const cases::Job& job : plan.jobs()) {
      constexpr std::size_t rows = 3 * sample;
      std::vector<std::uint32_t> in(sample * cases::words_in(cases::Operation::concat));
      cases::make_cases(job.stream, printed, seed, 0, in);
      const auto answers = [&](const cases::Variant& v) {
        std::vector<std::uint32_t> out(sample * cases::words_out(cases::Operation::concat));
        std::vector<parties::Ending> endings(sample);
        parties::party_named("fast").answer(v, {in, out, endings});
        return out;
      };
      const auto lossy = answers(printed);
      const auto whole = answers(repaired);
      std::size_t carries = 0;
      for (std::size_t i = 0; i < whole.size(); ++i) carries += lossy[i] != whole[i] ? 1U : 0U;
      EXPECT_GT(carries, rows / 10) << cases::name_of(job.stream);
      EXPECT_LT(carries, rows * 9 / 10) << cases::name_of(job.stream);
    }
  }
}

TEST(Streams, RootTiesLieOnBothSidesOfHalfway) {
  const auto cases =
      cases_of(cases::Stream::root_ties,
               {.operation = cases::Operation::sqrt, .build = {.target = cases::Target::standard}});
  const auto fraction = [](const Case& c) {
    const double root = std::sqrt(static_cast<double>(c[0]) * 65536);
    return root - std::floor(root);
  };
  EXPECT_GT(count(cases,
                  [&](const Case& c) {
                    return c[0] > 6'553'600 && fraction(c) < 0.5 && fraction(c) > 0.4;
                  }),
            sample / 20);
  EXPECT_GT(count(cases,
                  [&](const Case& c) {
                    return c[0] > 6'553'600 && fraction(c) > 0.5 && fraction(c) < 0.6;
                  }),
            sample / 20);
}

}  // namespace streams_test
}  // namespace fixproof
