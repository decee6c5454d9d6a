// What desync shows of a record: every operand that the program passed, and the result.
#include "judge/desync/values.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "judge/desync/log_file.hpp"
#include "tests/fixed/record/sim.hpp"
#include "tests/support/scratch_folder.hpp"

namespace {

using namespace fixproof;
using recorder_test::real;

/// Records what `operations` does, in full, and returns it as text.
template <class Operations>
std::vector<std::string> shown(const Operations& operations) {
  const ScratchFolder folder;
  const std::string path = folder.path("x.log");
  {
    const record::log log(path, {.full = {.first = 0, .last = 0}});
    operations();
  }
  desync::LogFile log(path);
  std::vector<std::string> texts;
  for (const desync::Record& record : log.records(0)) {
    texts.push_back(text_of(desync::operation_of(record.words)));
  }
  return texts;
}

const real a(q16_16(3));
const real b(q16_16(2));
const std::string operands = " [q16_16]: 3 (00030000), 2 (00020000) -> ";

TEST(Values, OfTwoOperands) {
  const auto texts = shown([] {
    (void)add<real>(a, b);
    (void)subtract<real>(a, b);
    (void)multiply<real>(a, b);
    (void)divide<real>(a, b);
    (void)saturating_add(a, b);
    (void)fmod(a, b);
    (void)(a % b);
  });
  const std::vector<std::string> expected{
      "add<To>" + operands + "5 (00050000)",        "subtract<To>" + operands + "1 (00010000)",
      "multiply<To>" + operands + "6 (00060000)",   "divide<To>" + operands + "1.5 (00018000)",
      "saturating_add" + operands + "5 (00050000)", "fmod" + operands + "1 (00010000)",
      "a % b" + operands + "1 (00010000)"};
  EXPECT_EQ(texts, expected);
}

TEST(Values, OfOtherNumbersOfOperands) {
  const auto texts = shown([] {
    (void)real(0.5);
    (void)-a;
    (void)(a * -7);
    (void)(a << -1);
    (void)(a * (std::int64_t{1} << 40));
    (void)mul_add(a, b, a);
    (void)checked_add(a, (std::numeric_limits<real>::max)());
    (void)(recorded<q32_32>(q32_32(-3)) * -2);
  });
  const std::vector<std::string> expected{
      "conversion [q16_16] -> 0.5 (00008000)",
      "-a [q16_16]: 3 (00030000) -> -3 (fffd0000)",
      "a * integer [q16_16]: 3 (00030000), -7 -> -21 (ffeb0000)",
      "a << n [q16_16]: 3 (00030000), -1 -> 1.5 (00018000)",
      "a * integer [q16_16]: 3 (00030000), 1099511627776 -> 0 (00000000)",
      "mul_add [q16_16]: 3 (00030000), 2 (00020000), 3 (00030000) -> 9 (00090000)",
      "checked_add [q16_16]: 3 (00030000), 32767.99998474121 (7fffffff) -> nothing",
      "a * integer [q32_32]: -3 (fffffffd00000000), -2 -> 6 (0000000600000000)"};
  EXPECT_EQ(texts, expected);
}

}  // namespace
