// Tests that the model and the host processor agree with the committed cases.
#include <fmt/format.h>

#include "tests/support/test.hpp"
#include "tests/verify/vectors/cases.hpp"
#include "tests/verify/vectors/processor.hpp"

namespace {

using vectors::Json;

TEST(Vectors, TheModelAgreesWithEveryCommittedCase) {
  for (const auto& file : vectors::committed) {
    const std::string path = vectors::path_of(file);
    const auto run =
        command::fixproof(fmt::format("step --cpu {} --singlestep {}", file.cpu, path));
    EXPECT_EQ(run.status, 0);
    EXPECT_EQ(run.out, fmt::format("{}: {}\n", path, file.summary));
    EXPECT_EQ(run.err, "");
  }
}

TEST(Vectors, SeveralFilesAreJudgedOneAfterTheOther) {
  const std::string first = vectors::path_of(vectors::committed[1]);
  const std::string second = vectors::path_of(vectors::committed[2]);
  const auto run = command::fixproof(fmt::format("step --singlestep {} {}", first, second));
  EXPECT_EQ(
      run.out,
      fmt::format("{}: {}\n{}: {}\ntotal: 91 cases, 85 run, 85 equal, 0 differing; 6 "
                  "skipped: 1 prefix in no listing, 5 form in no listing\n",
                  first, vectors::committed[1].summary, second, vectors::committed[2].summary));
  EXPECT_EQ(run.status, 0);
}

using Code = std::vector<std::uint8_t>;

/// Translates 16-bit code to 64-bit code: the operand-size prefix 66h selects the opposite size
/// there, and INC and DEC of a register need a ModR/M byte.
Code host_code(Code code) {
  const auto opcode = std::find_if(code.begin(), code.end(),
                                   [](std::uint8_t byte) { return (byte & 0xE7U) != 0x26U; });
  const auto at = opcode - code.begin();
  if (*opcode == 0x66) {
    code.erase(opcode);
  } else {
    code.insert(opcode, 0x66);
  }
  const auto first =
      std::find_if(code.begin() + at, code.end(), [](std::uint8_t byte) { return byte != 0x66; });
  if (*first >= 0x40 && *first < 0x50) {
    const auto modrm = static_cast<std::uint8_t>(0xC0U | (*first & 0xFU));
    *first = 0xFF;
    code.insert(first + 1, modrm);
  }
  return code;
}

constexpr std::array<std::string_view, 8> general{"ax", "cx", "dx", "bx", "sp", "bp", "si", "di"};

std::uint32_t initial_value(const Json& c, std::string_view name, std::string_view cpu) {
  return c["initial"]["regs"][vectors::name_in_set(name, cpu)].get<std::uint32_t>();
}

std::uint32_t final_value(const Json& c, std::string_view name, std::string_view cpu) {
  return vectors::final_value(c, vectors::name_in_set(name, cpu));
}

std::uint32_t word_at(const Json& state, std::uint32_t address) {
  const std::map<std::uint32_t, std::uint32_t> ram = state["ram"];
  return ram.at(address) | ram.at(address + 1) << 8U;
}

/// A divide error is interrupt 0: the stack holds FLAGS, CS and IP. The 8088 pushes the address of
/// the next instruction, the 386 that of the divide.
void expect_interrupt(const Json& c, std::string_view cpu, std::uint32_t next) {
  const auto sp = initial_value(c, "sp", cpu);
  const auto stack = initial_value(c, "ss", cpu) * 16 + sp;
  const std::uint32_t halt = cpu == "386" ? 1 : 0;
  EXPECT_EQ(final_value(c, "sp", cpu), sp - 6);
  EXPECT_EQ(final_value(c, "ip", cpu), word_at(c["initial"], 0) + halt);
  EXPECT_EQ(final_value(c, "cs", cpu), word_at(c["initial"], 2));
  EXPECT_EQ(final_value(c, "flags", cpu), initial_value(c, "flags", cpu));
  EXPECT_EQ(c["final"]["ram"].size(), 6U);
  EXPECT_EQ(word_at(c["final"], stack - 2), initial_value(c, "flags", cpu) & 0xFFFFU);
  EXPECT_EQ(word_at(c["final"], stack - 4), initial_value(c, "cs", cpu));
  EXPECT_EQ(word_at(c["final"], stack - 6), cpu == "386" ? initial_value(c, "ip", cpu) : next);
}

/// Cases with memory, stack or jump instructions cannot run as 64-bit code.
bool is_bound_to_memory(const Json& c) {
  const auto name = c["name"].get<std::string>();
  return name == "mov ax, [ds:bx]" || name == "push ax" || name == "jmp short +5";
}

TEST(Vectors, TheProcessorSaysTheSameAgain) {
  if (!vectors::has_processor()) GTEST_SKIP() << "needs an x86-64 processor";
  int executed = 0;
  for (const auto& file : vectors::committed) {
    const bool i386 = file.cpu == "386";
    for (const Json& c : vectors::load(file)) {
      if (is_bound_to_memory(c)) continue;
      SCOPED_TRACE(fmt::format("{} case {}", file.name, c["idx"].dump()));
      Code code = c["bytes"];
      if (i386) {
        ASSERT_EQ(code.back(), 0xF4) << "the 386 sets end every case with HLT";
        code.pop_back();
      }
      const auto address = initial_value(c, "cs", file.cpu) * 16 + initial_value(c, "ip", file.cpu);
      const std::map<std::uint32_t, std::uint8_t> ram = c["initial"]["ram"];
      for (std::uint32_t i = 0; i < code.size(); ++i) EXPECT_EQ(ram.at(address + i), code[i]);

      vectors::Registers registers{.flags = initial_value(c, "flags", file.cpu)};
      for (std::size_t i = 0; i < general.size(); ++i) {
        registers.general.at(i) = initial_value(c, general.at(i), file.cpu);
      }
      ++executed;
      const auto next = initial_value(c, "ip", file.cpu) + static_cast<std::uint32_t>(code.size());
      const bool fault = !vectors::execute(host_code(code), registers);
      ASSERT_EQ(fault, vectors::is_fault(c));
      for (std::size_t i = 0; i < general.size(); ++i) {
        if (fault && general.at(i) == "sp") continue;
        EXPECT_EQ(registers.general.at(i), final_value(c, general.at(i), file.cpu))
            << general.at(i);
      }
      for (const auto* segment : {"ss", "ds", "es"}) {
        EXPECT_EQ(final_value(c, segment, file.cpu), initial_value(c, segment, file.cpu));
      }
      if (fault) {
        expect_interrupt(c, file.cpu, next);
        continue;
      }
      EXPECT_EQ(final_value(c, "ip", file.cpu), next + (i386 ? 1 : 0));
      EXPECT_EQ(final_value(c, "cs", file.cpu), initial_value(c, "cs", file.cpu));
      EXPECT_TRUE(c["final"]["ram"].empty());
      const std::uint32_t defined = ~std::uint32_t{vectors::undefined_flags(c)};
      EXPECT_EQ(registers.flags & defined, final_value(c, "flags", file.cpu) & defined);
    }
  }
  EXPECT_EQ(executed, 58 + 68 + 23 - 2 * 3);
}

/// Tests execute() itself with results worked out by hand.
TEST(Vectors, TheProcessorIsAskedRight) {
  if (!vectors::has_processor()) GTEST_SKIP() << "needs an x86-64 processor";
  vectors::Registers r{.general = {0xFFFF, 1, 2, 3, 4, 5, 6, 7}, .flags = 0xF402};
  EXPECT_TRUE(vectors::execute(Code{0x01, 0xC8}, r)) << "add eax, ecx";
  EXPECT_EQ(r, (vectors::Registers{.general = {0x10000, 1, 2, 3, 4, 5, 6, 7}, .flags = 0xF416}));
  EXPECT_TRUE(vectors::execute(Code{0x66, 0x11, 0xDC}, r)) << "adc sp, bx";
  EXPECT_EQ(r, (vectors::Registers{.general = {0x10000, 1, 2, 3, 7, 5, 6, 7}, .flags = 0xF402}));
  const auto before = r;
  r.general[1] = 0;
  EXPECT_FALSE(vectors::execute(Code{0xF7, 0xF1}, r)) << "div ecx";
  r.general[1] = 1;
  EXPECT_EQ(r, before);
}

}  // namespace
