// Tests the cases next to poles, zeros, and ends of domains and ranges: they hold words that are
// known from mathematics, and level 1 finds a party that is wrong at one of these words alone.
#include "verify/cases/edges.hpp"

#include <cmath>

#include "support/usage_error.hpp"
#include "tests/support/test.hpp"
#include "tests/verify/engine/saboteur.hpp"
#include "verify/cases/plan.hpp"
#include "verify/cases/streams.hpp"

namespace fixproof {
namespace edges_test {

using cases::Operation;
using cases::Stream;
using Words = std::vector<std::uint32_t>;

cases::Variant in_format(Operation operation, std::string_view format) {
  return {.operation = operation,
          .build = {.target = cases::Target::standard},
          .format = cases::format_named(format)};
}

std::set<Words> edges(Operation operation, std::string_view format) {
  const auto words = cases::edge_words(operation, cases::format_named(format));
  const std::size_t each = cases::words_in(operation);
  std::set<Words> all;
  for (std::size_t i = 0; i < words.size(); i += each) {
    const auto one = words.subspan(i, each);
    EXPECT_TRUE(all.insert({one.begin(), one.end()}).second) << "a case occurs twice";
  }
  return all;
}

/// The operands within two words of `words`, in a signed format of 32 bits.
void expect_around(const std::set<Words>& found, std::int64_t word) {
  for (std::int64_t near = word - 2; near <= word + 2; ++near) {
    if (near < INT32_MIN || near > INT32_MAX) continue;
    EXPECT_TRUE(found.contains({static_cast<std::uint32_t>(near)})) << near;
  }
}

TEST(Edges, HoldTheWordsNextToThePolesOfTangents) {
  // The first 32 bits of pi are c90fdaa2; the next are 2168...
  expect_around(edges(Operation::tan, "q2_30"), 0x6487ed51);
  expect_around(edges(Operation::tan, "q2_30"), -0x6487ed51);
  EXPECT_TRUE(edges(Operation::tan, "u1_31").contains({0xc90fdaa2}));
  EXPECT_TRUE(edges(Operation::tan, "u1_31").contains({0xc90fdaa3}));
}

TEST(Edges, HoldTheFirstAndLastQuarterTurns) {
  const auto degrees = edges(Operation::tan_of_degrees, "q16_16");
  const auto turns = edges(Operation::sin_of_turns, "q16_16");
  const auto radians = edges(Operation::cos, "q16_16");
  // The last multiples below 32768: of 90 it is 364, of 1/4 it is 131071, of pi/2 20860.
  for (std::int64_t i = 0; i < 64; ++i) {
    for (const std::int64_t multiple : {i, 364 - i, -i, i - 364}) {
      expect_around(degrees, multiple * 90 * 65536);
    }
    for (const std::int64_t multiple : {i, 131071 - i, -i, i - 131072}) {
      expect_around(turns, multiple * 65536 / 4);
    }
    for (const std::int64_t multiple : {i, 20860 - i, -i, i - 20860}) {
      expect_around(radians, std::llround(static_cast<long double>(multiple) *
                                          1.57079632679489661923L * 65536.0L));
    }
  }
}

TEST(Edges, HoldTheEndsOfDomains) {
  for (const std::int64_t one : {-(std::int64_t{1} << 30), std::int64_t{1} << 30}) {
    expect_around(edges(Operation::asin, "q2_30"), one);
    expect_around(edges(Operation::acos, "q2_30"), one);
  }
  expect_around(edges(Operation::log1p, "q16_16"), -65536);
  expect_around(edges(Operation::log, "q16_16"), 0);
  expect_around(edges(Operation::log, "q16_16"), 65536);  // its zero
}

TEST(Edges, ExistForEveryFunctionInEveryFormat) {
  for (const cases::OperationRow& row : cases::operations) {
    for (const cases::Format& format : cases::named_formats()) {
      cases::Variant v = in_format(row.operation, name_of(format));
      const bool has = row.kind == cases::Kind::function && row.words_in <= 2;
      std::array<std::uint32_t, 48> room{};
      const auto one = std::span(room).first(cases::words_in(v));
      if (!has || format.word_bits > 32) {
        EXPECT_THROW(cases::make_cases(Stream::edges, v, 1, 0, one), std::invalid_argument);
        continue;
      }
      const auto size = cases::size_of(Stream::edges, v);
      ASSERT_TRUE(size);
      EXPECT_EQ(edges(row.operation, name_of(format)).size(), *size);
      EXPECT_GE(*size, 5U) << row.name << ' ' << name_of(format);
      EXPECT_LT(*size, 30'000U) << row.name << ' ' << name_of(format);
      const cases::Plan plan(1, 1, {{v, {"a", "b"}}});
      EXPECT_EQ(plan.jobs().back().stream, Stream::edges);
      EXPECT_EQ(plan.jobs().back().cases, *size);
    }
  }
}

/// Whether level 1 finds a party that gives the other end of the range for these operands alone.
bool is_found(Operation operation, std::string_view format, const Words& operands) {
  const cases::Variant v = in_format(operation, format);
  int spoilt = 0;
  const auto liar = test::saboteur([&](std::span<const std::uint32_t> in,
                                       std::span<std::uint32_t> out, parties::Ending& /*ending*/) {
    if (!std::ranges::equal(in, operands)) return;
    ++spoilt;
    // A result that wraps: the highest word and one more is the lowest word, and the reverse.
    const std::uint32_t lowest = v.format.is_signed ? std::uint32_t{1} << 31U : 0;
    EXPECT_TRUE(out[0] == lowest || out[0] == lowest - 1) << "the result does not saturate";
    out[0] = out[0] == lowest ? lowest - 1 : lowest;
  });
  const bool found = test::judge(liar, v).mismatches() > 0;
  EXPECT_EQ(found, spoilt > 0);
  return found;
}

// Each word is the first whose result is out of range, by a computation with 200 bits.
TEST(Edges, FindAWrapAtOneWord) {
  // pi/2 is 1686629713.07 units of 2^-30, and 3373259426.13 of 2^-31.
  EXPECT_TRUE(is_found(Operation::tan, "q2_30", {0x6487ed51}));
  EXPECT_TRUE(is_found(Operation::tan, "q2_30", {0x9b7812af}));
  EXPECT_TRUE(is_found(Operation::tan, "u1_31", {0xc90fdaa2}));
  // The result is half a unit below 2^15 at these many units of 2^-16.
  EXPECT_TRUE(is_found(Operation::exp, "q16_16", {681'392}));                     // 681391.40
  EXPECT_TRUE(is_found(Operation::sinh, "q16_16", {726'818}));                    // 726817.50
  EXPECT_TRUE(is_found(Operation::tan_of_degrees, "q16_16", {5'898'126}));        // 5898125.41
  EXPECT_TRUE(is_found(Operation::pow, "q16_16", {11'863'284, 2 * 65'536}));      // 11863283.20
  EXPECT_TRUE(is_found(Operation::hypot, "q16_16", {1U << 30U, 1'859'775'393}));  // 1859775392.80
  EXPECT_TRUE(is_found(Operation::hypot, "q16_16", {1'859'775'393, 1U << 30U}));
  // 2^7 is one unit more than the highest word.
  EXPECT_TRUE(is_found(Operation::exp2, "q8_24", {7U << 24U}));
}

}  // namespace edges_test
}  // namespace fixproof
