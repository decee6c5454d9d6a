// Compares `fixproof eval` on whole streams of cases with slow, simple arithmetic.
#include <fmt/format.h>

#include "tests/app/cli/draw.hpp"
#include "tests/app/cli/semantics.hpp"
#include "tests/support/command.hpp"
#include "tests/support/test.hpp"

namespace {

using RoutineForm = std::tuple<const char*, const char*, const char*, const char*>;

class EvalReference : public testing::TestWithParam<RoutineForm> {};

TEST_P(EvalReference, SixHundredThousandLinesAgree) {
  const auto& [operation, target, round, party] = GetParam();
  const bool is_mul = std::string_view(operation) == "mul";
  const bool is_386 = std::string_view(target) == "i386";
  const bool rounds = std::string_view(round) == "on";
  command::Random random(20260614);
  std::string lines;
  std::string expected;
  for (int i = 0; i < 600'000; ++i) {
    const std::uint32_t a = command::draw_word(random, 32);
    const std::uint32_t b = command::draw_word(random, 32);
    fmt::format_to(std::back_inserter(lines), "{:08x} {:08x}\n", a, b);
    const auto answer =
        is_mul ? semantics::mul(a, b, is_386, rounds) : semantics::div(a, b, is_386, rounds);
    expected += answer ? fmt::format("{:08x}\n", *answer) : "DE\n";
  }
  const std::string answers = command::output_of(
      fmt::format("eval {} --target {} --round {} --by {}", operation, target, round, party),
      lines);
  if (answers == expected) return;
  const auto asked = command::split(lines, '\n');
  const auto wanted = command::split(expected, '\n');
  const auto given = command::split(answers, '\n');
  ASSERT_EQ(given.size(), wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) ASSERT_EQ(given[i], wanted[i]) << asked[i];
}

INSTANTIATE_TEST_SUITE_P(
    Routines, EvalReference,
    testing::Combine(testing::Values("mul", "div"), testing::Values("i386", "i8088"),
                     testing::Values("on", "off"), testing::Values("model", "type")),
    [](const auto& test) {
      return fmt::format("{}_{}_{}_{}", std::get<0>(test.param), std::get<1>(test.param),
                         std::get<2>(test.param), std::get<3>(test.param));
    });

std::uint32_t nearest(long double value) {
  return static_cast<std::uint32_t>(static_cast<std::int32_t>(std::lroundl(value * 65536)));
}

TEST(EvalReference, CosSinOfEveryAngle) {
  std::string lines;
  std::string expected;
  for (int angle = -32768; angle < 32768; ++angle) {
    fmt::format_to(std::back_inserter(lines), "{:04x}\n", static_cast<std::uint16_t>(angle));
    // Reduces the angle in whole tenths of a degree, which is exact.
    const long double radians = angle % 3600 * std::numbers::pi_v<long double> / 1800;
    fmt::format_to(std::back_inserter(expected), "{:08x} {:08x}\n", nearest(std::cos(radians)),
                   nearest(std::sin(radians)));
  }
  for (const char* options : {"--target i386", "--target i8088", "--by type", "--by oracle"}) {
    EXPECT_TRUE(command::output_of(fmt::format("eval cossin {}", options), lines) == expected)
        << options;
  }
}

}  // namespace
