// Tests the cases of remainders, of mul_div and of hypot of three numbers: they are what their
// streams say, in every format, and a party that is wrong only there is found.
#include <boost/multiprecision/cpp_int.hpp>

#include "support/usage_error.hpp"
#include "tests/support/test.hpp"
#include "tests/verify/engine/saboteur.hpp"
#include "verify/cases/plan.hpp"
#include "verify/cases/streams.hpp"

namespace fixproof {
namespace function_cases_test {

using Integer = boost::multiprecision::cpp_int;
using cases::Operation;
using cases::Stream;

cases::Variant in_format(Operation operation, const cases::Format& format) {
  return {.operation = operation, .build = {.target = cases::Target::standard}, .format = format};
}

/// The operands of a stream's first cases, in units.
std::vector<std::vector<Integer>> made(Stream stream, Operation operation,
                                       const cases::Format& format) {
  constexpr std::size_t sample = 1000;
  const cases::Variant v = in_format(operation, format);
  const std::size_t size = cases::words_in(v);
  const std::size_t each = cases::words_per_number(format);
  std::vector<std::uint32_t> words(sample * size);
  cases::make_cases(stream, v, 7, 0, words);
  std::vector<std::vector<Integer>> all(sample);
  const Integer modulus = Integer(1) << format.word_bits;
  for (std::size_t i = 0; i < words.size(); i += each) {
    Integer value = words[i];
    if (each == 2) value += Integer(words[i + 1]) << 32U;
    EXPECT_LT(value, modulus);
    if (format.is_signed && value >= modulus / 2) value -= modulus;
    all[i / size].push_back(value);
  }
  return all;
}

template <class Holds>
std::size_t count(const std::vector<std::vector<Integer>>& cases, const Holds& holds) {
  return static_cast<std::size_t>(std::ranges::count_if(cases, holds));
}

/// Twice the distance of n / d from the nearest multiple of one half that is not whole, times d.
Integer from_tie(const Integer& n, const Integer& d) { return abs(2 * (abs(n) % abs(d)) - abs(d)); }

TEST(FunctionCases, HalfMultiplesAreExactTiesAndNextToThem) {
  for (const cases::Format& format : cases::named_formats()) {
    const auto all = made(Stream::half_multiples, Operation::fmod, format);
    ASSERT_EQ(count(all, [](const auto& c) { return c[1] == 0; }), 0U);
    const auto exact = count(all, [](const auto& c) { return c[0] % c[1] == 0; });
    const auto ties = count(all, [](const auto& c) { return from_tie(c[0], c[1]) == 0; });
    const auto near = count(all, [](const auto& c) { return from_tie(c[0], c[1]) <= 3; });
    EXPECT_GT(exact, all.size() / 8) << name_of(format);
    EXPECT_GT(ties, all.size() / 20) << name_of(format);
    EXPECT_GT(near, all.size() / 3) << name_of(format);
    // Ties are rounded to even quotients, so both kinds must occur.
    const auto odd = [](const auto& c) {
      return from_tie(c[0], c[1]) == 0 && abs(c[0]) / abs(c[1]) % 2 != 0;
    };
    EXPECT_GT(count(all, odd), ties / 5) << name_of(format);
    EXPECT_LT(count(all, odd), ties * 4 / 5) << name_of(format);
  }
}

TEST(FunctionCases, RatioTiesAreTies) {
  for (const cases::Format& format : cases::named_formats()) {
    for (const auto& c : made(Stream::ratio_ties, Operation::mul_div, format)) {
      ASSERT_NE(c[2], 0);
      ASSERT_EQ(from_tie(c[0] * c[1], c[2]), 0)
          << name_of(format) << ' ' << c[0] << ' ' << c[1] << ' ' << c[2];
    }
    const auto near = made(Stream::near_ratio_ties, Operation::mul_div, format);
    for (const auto& c : near) {
      ASSERT_NE(c[2], 0);
      ASSERT_EQ(from_tie(c[0] * c[1], c[2]), 1)
          << name_of(format) << ' ' << c[0] << ' ' << c[1] << ' ' << c[2];
    }
    const auto above =
        count(near, [](const auto& c) { return 2 * (abs(c[0] * c[1]) % abs(c[2])) > abs(c[2]); });
    EXPECT_GT(above, near.size() / 4) << name_of(format);
    EXPECT_LT(above, near.size() * 3 / 4) << name_of(format);
  }
}

TEST(FunctionCases, LargeRatiosStandOnBothSidesOfTheLimit) {
  for (const cases::Format& format : cases::named_formats()) {
    const Integer limit = Integer(1) << cases::magnitude_bits(format);
    const auto all = made(Stream::large_ratios, Operation::mul_div, format);
    const auto near = [&](const auto& c, const Integer& side) {
      if (c[2] == 0) return false;
      const Integer quotient = abs(c[0] * c[1]) / abs(c[2]);
      return abs(quotient - limit) <= limit / 16 && (quotient < limit) == (side < limit);
    };
    EXPECT_GT(count(all, [&](const auto& c) { return near(c, limit - 1); }), all.size() / 20)
        << name_of(format);
    EXPECT_GT(count(all, [&](const auto& c) { return near(c, limit); }), all.size() / 20)
        << name_of(format);
  }
}

/// The sum of squares minus the square of its root, rounded down.
std::pair<Integer, Integer> root_and_rest(const std::vector<Integer>& c) {
  const Integer sum = c[0] * c[0] + c[1] * c[1] + c[2] * c[2];
  const Integer root = sqrt(sum);
  return {root, sum - root * root};
}

TEST(FunctionCases, LengthsAreWholeOrNearestToHalfway) {
  for (const cases::Format& format : cases::named_formats()) {
    if (format.word_bits > 32) continue;
    const auto lengths = made(Stream::whole_lengths, Operation::hypot3, format);
    const auto whole = count(lengths, [](const auto& c) { return root_and_rest(c).second == 0; });
    EXPECT_GT(whole, lengths.size() / 3) << name_of(format);
    EXPECT_LT(whole, lengths.size() * 9 / 10) << name_of(format);
    const Integer limit = Integer(1) << cases::magnitude_bits(format);
    const auto beyond = count(lengths, [&](const auto& c) {
      const auto root = root_and_rest(c).first;
      return root >= limit && root < limit + limit / 4;
    });
    EXPECT_GT(beyond, lengths.size() / 50) << name_of(format);

    const auto ties = made(Stream::near_length_ties, Operation::hypot3, format);
    std::size_t above = 0;
    for (const auto& c : ties) {
      // (r + 1/2)^2 is r^2 + r + 1/4.
      const auto [root, rest] = root_and_rest(c);
      if (root < 2) continue;  // the sums next to halfway are squares
      ASSERT_TRUE(rest == root || rest == root + 1)
          << name_of(format) << ' ' << c[0] << ' ' << c[1] << ' ' << c[2];
      if (rest > root) ++above;
    }
    EXPECT_GT(above, ties.size() / 5) << name_of(format);
    EXPECT_LT(above, ties.size() * 4 / 5) << name_of(format);
  }
}

TEST(FunctionCases, EveryTripleOfBytesComesOnce) {
  const cases::Variant v = in_format(Operation::mul_div, cases::format_named("q4_4"));
  ASSERT_EQ(cases::size_of(Stream::every, v), 1U << 24U);
  std::array<std::uint32_t, 6> words{};
  cases::make_cases(Stream::every, v, 1, 0x1234ff, words);
  EXPECT_EQ(words, (std::array<std::uint32_t, 6>{0x12, 0x34, 0xff, 0x12, 0x35, 0x00}));
}

TEST(FunctionCases, FormatsWithoutTheFunctionAreRefused) {
  const auto refused = [](Operation operation, const char* format) {
    EXPECT_THROW(cases::check_format(operation, cases::format_named(format)), support::UsageError);
  };
  refused(Operation::remainder, "u8_8");
  refused(Operation::hypot3, "d32_4");
  EXPECT_NO_THROW(cases::check_format(Operation::fmod, cases::format_named("u32_32")));
  EXPECT_NO_THROW(cases::check_format(Operation::mul_div, cases::format_named("q32_32")));
  EXPECT_NO_THROW(cases::check_format(Operation::hypot3, cases::format_named("q32_32")));
}

/// Whether level 1 finds a party whose answers `answer` makes from the operands and the right word.
template <class Answer>
bool is_found_with(Operation operation, const Answer& answer) {
  const auto liar = test::saboteur([&](std::span<const std::uint32_t> in,
                                       std::span<std::uint32_t> out, parties::Ending& ending) {
    const auto value = [&](std::size_t i) {
      return i < in.size() ? std::int64_t{static_cast<std::int32_t>(in[i])} : 0;
    };
    if (ending == parties::Ending::value) {
      out[0] = answer(value(0), value(1), value(2), out[0]);
    }
  });
  return test::judge(liar, in_format(operation, cases::q16_16)).mismatches() > 0;
}

/// Whether level 1 finds a party that is wrong in the last bit wherever `spoils` says so.
template <class Spoils>
bool is_found(Operation operation, const Spoils& spoils) {
  return is_found_with(operation, [&](auto x, auto y, auto z, std::uint32_t right) {
    return spoils(x, y, z) ? right ^ 1U : right;
  });
}

// These parties are wrong in so few cases that random operands do not find them.
TEST(FunctionCases, FindDefectsThatAreRare) {
  EXPECT_TRUE(is_found(Operation::remainder, [](auto x, auto y, auto) {
    return y != 0 && y % 2 == 0 && std::abs(y) > 1'000'000 && std::abs(x % y) == std::abs(y / 2) &&
           x / y % 2 != 0;
  }));
  EXPECT_TRUE(is_found(Operation::fmod, [](auto x, auto y, auto) {
    return x == std::numeric_limits<std::int32_t>::min() && y == -1;
  }));
  EXPECT_TRUE(is_found(Operation::fmod, [](auto x, auto y, auto) {
    return y != 0 && std::abs(y) > 100'000 && std::abs(x) > 3 * std::abs(y) && x % y == 0;
  }));
  EXPECT_TRUE(is_found(Operation::mul_div, [](auto x, auto y, auto z) {
    return z != 0 && std::abs(z) > 1'000'000 && 2 * std::abs(x * y % z) == std::abs(z);
  }));
  EXPECT_TRUE(is_found(Operation::mul_div, [](auto x, auto y, auto z) {
    return z != 0 && std::abs(z) > 1'000'000 && 2 * std::abs(x * y % z) == std::abs(z) + 1;
  }));
  EXPECT_TRUE(is_found(Operation::mul_div, [](auto x, auto y, auto z) {
    return z != 0 && z != 1 && x * y / z == std::int64_t{1} << 31 && y != z;
  }));
  EXPECT_TRUE(is_found(Operation::hypot3, [](auto x, auto y, auto z) {
    const auto sum = static_cast<std::uint64_t>(x * x) + static_cast<std::uint64_t>(y * y) +
                     static_cast<std::uint64_t>(z * z);
    const auto root = static_cast<std::uint64_t>(std::sqrt(static_cast<long double>(sum)));
    return root > 100'000'000 && root < (1U << 31U) && sum == root * root + root;
  }));
}

/// n / d, half up. @pre d is not 0
std::int64_t half_up(std::int64_t n, std::int64_t d) {
  if (d < 0) {
    n = -n;
    d = -d;
  }
  const std::int64_t rest = (n % d + d) % d;
  return (n - rest) / d + (rest >= d - rest ? 1 : 0);
}

/// The product of two words, by their halves. `carry` is 1, or 0 to lose the carry of the low word.
std::int64_t product_by_halves(std::int64_t x, std::int64_t y, std::uint64_t carry) {
  const auto a = static_cast<std::uint64_t>(std::abs(x));
  const auto b = static_cast<std::uint64_t>(std::abs(y));
  const std::uint64_t middle = (a >> 16U) * (b & 0xFFFFU) + (a & 0xFFFFU) * (b >> 16U);
  const std::uint64_t low = (a & 0xFFFFU) * (b & 0xFFFFU) + (middle << 16U & 0xFFFFFFFFU);
  const std::uint64_t high = (a >> 16U) * (b >> 16U) + (middle >> 16U) + carry * (low >> 32U);
  const auto product = static_cast<std::int64_t>(high << 32U | (low & 0xFFFFFFFFU));
  return (x < 0) != (y < 0) ? -product : product;
}

/// The remainder of the nearest quotient. `is_odd` says whether a tie goes from the truncated
/// quotient to the next one. @pre y is not 0
template <class IsOdd>
std::uint32_t remainder_of(std::int64_t x, std::int64_t y, const IsOdd& is_odd) {
  const std::int64_t truncated = x % y;
  const std::int64_t missing = std::abs(y) - std::abs(truncated);
  const std::int64_t quotient = x / y;
  const bool is_next = std::abs(truncated) > missing ||
                       (std::abs(truncated) == missing && is_odd(quotient, (x < 0) != (y < 0)));
  return static_cast<std::uint32_t>(!is_next ? truncated : x < 0 ? missing : -missing);
}

/// The length. `is_next` takes the root, rounded down, and what is left, and says whether the next
/// integer is nearer.
template <class IsNext>
std::uint32_t length_of(std::int64_t x, std::int64_t y, std::int64_t z, const IsNext& is_next) {
  const auto [root, rest] = root_and_rest({Integer(x), Integer(y), Integer(z)});
  const Integer nearest = is_next(root, rest) ? root + 1 : root;
  const Integer highest = std::numeric_limits<std::int32_t>::max();
  return static_cast<std::uint32_t>(nearest < highest ? nearest : highest);
}

// The algorithms without their defects are right, so only the defects are found.
TEST(FunctionCases, FindASubtlyWrongAlgorithm) {
  const auto odd = [](std::int64_t quotient, bool /*negative*/) { return quotient % 2 != 0; };
  // Ties of negative odd quotients stay at the odd one.
  const auto odd_if_positive = [](std::int64_t quotient, bool negative) {
    return quotient % 2 != 0 && !negative;
  };
  const auto remainder_by = [](const auto& is_odd) {
    return is_found_with(Operation::remainder, [&](auto x, auto y, auto, std::uint32_t right) {
      return y == 0 ? right : remainder_of(x, y, is_odd);
    });
  };
  EXPECT_FALSE(remainder_by(odd));
  EXPECT_TRUE(remainder_by(odd_if_positive));

  const auto quotient_with = [](std::uint64_t carry) {
    return is_found_with(Operation::mul_div, [&](auto x, auto y, auto z, std::uint32_t right) {
      return z == 0 ? right
                    : static_cast<std::uint32_t>(half_up(product_by_halves(x, y, carry), z));
    });
  };
  EXPECT_FALSE(quotient_with(1));
  EXPECT_TRUE(quotient_with(0));

  const auto length_by = [](const auto& is_next) {
    return is_found_with(Operation::hypot3, [&](auto x, auto y, auto z, std::uint32_t) {
      return length_of(x, y, z, is_next);
    });
  };
  EXPECT_FALSE(length_by([](const auto& root, const auto& rest) { return rest > root; }));
  EXPECT_TRUE(length_by([](const auto& root, const auto& rest) { return rest >= root; }));
}

TEST(FunctionCases, ASoundPartyIsNotFound) {
  for (const Operation operation :
       {Operation::fmod, Operation::remainder, Operation::mul_div, Operation::hypot3}) {
    EXPECT_FALSE(is_found(operation, [](auto, auto, auto) { return false; }));
  }
}

}  // namespace function_cases_test
}  // namespace fixproof
