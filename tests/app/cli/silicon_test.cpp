// Tests the definitions of bitwise.hpp against the host processor. Current processors still execute
// these instructions as the 386 does.
#include <csignal>

#include "tests/app/cli/draw.hpp"
#include "tests/support/bitwise.hpp"
#include "tests/support/test.hpp"
#include "verify/parties/answer.hpp"

namespace {

#if defined(__x86_64__)

using bitwise::Answer;
using bitwise::Operands;

/// Flags in the form of EAX: AH is the low byte of FLAGS, and AL is 1 if OF is set.
std::uint32_t packed(std::uint16_t flags) {
  return (flags & 0xFFU) << 8U | ((flags & bitwise::OF) != 0 ? 1U : 0U);
}
std::uint16_t unpacked(std::uint32_t eax) {
  const std::uint32_t low = eax >> 8U & (bitwise::all_six & 0xFFU);
  return static_cast<std::uint16_t>(low | ((eax & 1U) != 0 ? bitwise::OF : 0U));
}

/// MUL or IMUL. They define only CF and OF.
template <class Word>
Answer multiplied(std::string_view name, const Operands& o) {
  auto low = static_cast<Word>(o.first);
  auto high = Word{0};
  const auto factor = static_cast<Word>(o.second);
  bool carry = false;
  bool overflow = false;
  if (name == "mul") {
    asm("mul %[factor]; setc %[carry]; seto %[overflow]"
        : "+a"(low), "=d"(high), [carry] "=q"(carry), [overflow] "=q"(overflow)
        : [factor] "r"(factor)
        : "cc");
  } else {
    asm("imul %[factor]; setc %[carry]; seto %[overflow]"
        : "+a"(low), "=d"(high), [carry] "=q"(carry), [overflow] "=q"(overflow)
        : [factor] "r"(factor)
        : "cc");
  }
  const auto flags =
      static_cast<std::uint16_t>((carry ? bitwise::CF : 0) | (overflow ? bitwise::OF : 0));
  return {.value = low, .high = high, .flags = flags};
}

/// DIV or IDIV. The asm is volatile because a fault counts even if the result is unused.
template <class Word>
Answer divided(std::string_view name, const Operands& o) {
  auto low = static_cast<Word>(o.first);
  auto high = static_cast<Word>(o.high);
  const auto divisor = static_cast<Word>(o.second);
  if (name == "div") {
    asm volatile("div %[divisor]" : "+a"(low), "+d"(high) : [divisor] "r"(divisor) : "cc");
  } else {
    asm volatile("idiv %[divisor]" : "+a"(low), "+d"(high) : [divisor] "r"(divisor) : "cc");
  }
  return {.value = low, .high = high};
}

// Adding 127 to AL overflows exactly where AL is 1; SAHF sets the other five and leaves OF.
// NOLINTNEXTLINE(cppcoreguidelines-macro-usage): the text of an asm has to be a literal
#define WITH_FLAGS(instruction)                                 \
  asm("addb $127, %%al; sahf; " instruction "; lahf; seto %%al" \
      : "+a"(flags), [first] "+r"(first)                        \
      : [second] "r"(second), [count] "c"(count)                \
      : "cc")

/// Runs one instruction on the host, on operands as wide as Word. It must not fault.
template <class Word>
Answer on_silicon(std::string_view name, const Operands& o) {
  if (name == "mul" || name == "imul") return multiplied<Word>(name, o);
  if (name == "div" || name == "idiv") return divided<Word>(name, o);
  auto first = static_cast<Word>(o.first);
  const auto second = static_cast<Word>(o.second);
  const auto count = static_cast<std::uint8_t>(o.count);
  std::uint32_t flags = packed(o.flags);
  if (name == "mov") WITH_FLAGS("mov %[second], %[first]");
  if (name == "add") WITH_FLAGS("add %[second], %[first]");
  if (name == "adc") WITH_FLAGS("adc %[second], %[first]");
  if (name == "sub") WITH_FLAGS("sub %[second], %[first]");
  if (name == "sbb") WITH_FLAGS("sbb %[second], %[first]");
  if (name == "cmp") WITH_FLAGS("cmp %[second], %[first]");
  if (name == "and") WITH_FLAGS("and %[second], %[first]");
  if (name == "xor") WITH_FLAGS("xor %[second], %[first]");
  if (name == "neg") WITH_FLAGS("neg %[first]");
  if (name == "inc") WITH_FLAGS("inc %[first]");
  if (name == "dec") WITH_FLAGS("dec %[first]");
  if (name == "shl") WITH_FLAGS("shl %[count], %[first]");
  if (name == "shr") WITH_FLAGS("shr %[count], %[first]");
  if (name == "sar") WITH_FLAGS("sar %[count], %[first]");
  if (name == "rol") WITH_FLAGS("rol %[count], %[first]");
  if (name == "shld") WITH_FLAGS("shld %[count], %[second], %[first]");
  if (name == "shrd") WITH_FLAGS("shrd %[count], %[second], %[first]");
  return {.value = first, .flags = unpacked(flags)};
}
#undef WITH_FLAGS

class Silicon : public testing::TestWithParam<const char*> {
 protected:
  template <class Word>
  static void expect_agreement() {
    constexpr int bits = 8 * sizeof(Word);
    const std::string_view name = GetParam();
    command::Random random(386);
    int faults = 0;
    constexpr int cases = 100'000;
    for (int i = 0; i < cases; ++i) {
      const Operands o{.first = command::draw_word(random, bits),
                       .second = command::draw_word(random, bits),
                       .count = static_cast<int>(random() % 40),
                       .high = command::draw_word(random, bits),
                       .flags = static_cast<std::uint16_t>(random() & bitwise::all_six)};
      // SHLD and SHRD of a word by more than 16 are undefined.
      if (bits == 16 && name.starts_with("sh") && name.size() == 4 && o.count % 32 > 16) continue;
      const Answer expected = bitwise::execute(name, o, bits);
      if (expected.fault) {
        ++faults;
        continue;
      }
      const Answer answer = on_silicon<Word>(name, o);
      const auto context = [&] {
        return testing::Message() << std::hex << name << ' ' << o.first << ' ' << o.second
                                  << " high " << o.high << " flags " << o.flags << " count "
                                  << std::dec << o.count << ", " << bits << " bits";
      };
      ASSERT_EQ(answer.value, expected.value) << context();
      ASSERT_EQ(answer.high, expected.high) << context();
      ASSERT_EQ(answer.flags & ~expected.undefined, expected.flags) << context();
    }
    EXPECT_LT(faults, cases * 3 / 4);
  }
};

TEST_P(Silicon, AgreesInWords) { expect_agreement<std::uint16_t>(); }
TEST_P(Silicon, AgreesInDoublewords) { expect_agreement<std::uint32_t>(); }

INSTANTIATE_TEST_SUITE_P(Instruction, Silicon,
                         testing::Values("mov", "add", "adc", "sub", "sbb", "cmp", "and", "xor",
                                         "neg", "inc", "dec", "shl", "shr", "sar", "rol", "shld",
                                         "shrd", "mul", "imul", "div", "idiv"),
                         [](const auto& test) { return test.param; });

/// Raises a divide error with the system's default action, which removes any other handler.
template <class Word>
void divide_by_default(std::string_view name, const Operands& o) {
  (void)std::signal(SIGFPE, SIG_DFL);
  on_silicon<Word>(name, o);
}

TEST(SiliconDeathTest, FaultsWhereTheDefinitionFaults) {
  const auto expect_edge = [](std::string_view name, Operands fits, Operands faults) {
    EXPECT_FALSE(bitwise::execute(name, fits, 32).fault);
    on_silicon<std::uint32_t>(name, fits);
    EXPECT_TRUE(bitwise::execute(name, faults, 32).fault);
    EXPECT_EXIT(divide_by_default<std::uint32_t>(name, faults), testing::KilledBySignal(SIGFPE),
                "");
  };
  // Largest quotients and one beyond: 2^32 - 1 and 2^32; 2^31 - 1 and 2^31; -2^31 and -2^31 - 1.
  // Then zero divisors.
  expect_edge("div", {.first = 0xFFFFFFFF, .second = 2, .high = 1}, {.second = 2, .high = 2});
  expect_edge("idiv", {.first = 0xFFFFFFFF, .second = 2}, {.second = 2, .high = 1});
  expect_edge("idiv", {.second = 0xFFFFFFFE, .high = 1},
              {.first = 2, .second = 0xFFFFFFFE, .high = 1});
  expect_edge("div", {.second = 1}, {.second = 0});
  expect_edge("idiv", {.second = 1}, {.second = 0});
}

#else

TEST(Silicon, AgreesWithTheDefinitions) {
  GTEST_SKIP() << "needs an x86-64 processor, to be asked itself";
}

#endif

}  // namespace
