// Tests that the model is minimal: routines and loops execute every form of instruction, and
// leaving out any form gives results that the oracle rejects. For the loops, tests/verify/loops
// tests the latter.
#include "tests/support/test.hpp"
#include "tests/x86model/cases.hpp"
#include "verify/parties/party.hpp"
#include "x86model/call_loop.hpp"
#include "x86model/notation.hpp"
#include "x86model/text.hpp"

namespace {

using namespace x86model;

/// The operand's kind and size, and the details that the interpreter distinguishes: how a constant
/// depends on the width, and the addressing. A shift by one is a form of its own.
std::string form_of(const Operand& o, bool is_count) {
  const auto bits = [&] { return o.size == Size::byte ? "8" : o.size == Size::word ? "16" : "32"; };
  switch (o.kind) {
    case Operand::Kind::reg:
      return std::string(" r") + bits();
    case Operand::Kind::memory:
      if (o.addressing == Addressing::index_twice) return std::string(" index*2 m") + bits();
      if (o.addressing == Addressing::index) return std::string(" index m") + bits();
      if (o.addressing == Addressing::direct) return std::string(" direct m") + bits();
      return std::string(o.segment == SegmentOverride::cs ? " cs m" : " m") + bits();
    case Operand::Kind::label:
      return " label";
    case Operand::Kind::immediate:
      break;
    case Operand::Kind::none:
      return "";
  }
  switch (o.scaling) {
    case Scaling::bytes:
      return " bytes";
    case Scaling::half_unit:
      return " half_unit";
    case Scaling::word_bits:
      return " word_bits";
    case Scaling::literal:
      break;
  }
  return is_count && o.value == 1 ? " 1" : " imm";
}

/// For example `mov r16 m16` or `shr r32 1`.
std::string form_of(const Instruction& i) {
  std::string form(name_of(i.mnemonic));
  for (const Operand& o : i.operands) form += form_of(o, detail::is_shift(i.mnemonic));
  return form;
}

std::vector<std::uint32_t> all_cases(Routine routine) {
  if (routine != Routine::cossin) return test::cases(routine);
  std::vector<std::uint32_t> angles(0x10000);
  for (std::uint32_t i = 0; i < angles.size(); ++i) angles[i] = i;
  return angles;
}

struct Expected {
  std::vector<std::uint32_t> out;
  std::vector<fixproof::parties::Ending> endings;
};

template <Routine routine, Target target>
Expected oracle_of(const Build& build, std::span<const std::uint32_t> words) {
  const fixproof::cases::Variant variant{
      .operation = static_cast<fixproof::cases::Operation>(routine),
      .build = {.target = target == Target::i386 ? fixproof::cases::Target::i386
                                                 : fixproof::cases::Target::i8088,
                .mul_round = build.mul_rounding,
                .div_round = build.div_rounding,
                .chapter_52 = build.chapter_52,
                .repaired = build.repaired && routine == Routine::concat}};
  const std::size_t cases = words.size() / static_cast<std::size_t>(arity(routine).in);
  Expected expected{
      std::vector<std::uint32_t>(cases * static_cast<std::size_t>(arity(routine).out)),
      std::vector<fixproof::parties::Ending>(cases)};
  fixproof::parties::party_named("oracle").answer(variant, {words, expected.out, expected.endings});
  return expected;
}

/// The first case in which `program` breaks its contract; nothing if there is none. The contract is
/// the oracle's results or divide error, and BP, SI, DI and SP preserved for a C caller.
template <Routine routine>
std::optional<std::size_t> first_broken(const Program& program,
                                        std::span<const std::uint32_t> words,
                                        const Expected& expected) {
  constexpr auto in = static_cast<std::size_t>(arity(routine).in);
  constexpr auto out = static_cast<std::size_t>(arity(routine).out);
  CallMachine<routine, 16> ready;
  // Registers hold arbitrary values on entry, so that a routine must clear what it needs to be 0.
  for (std::size_t r = 0; r < register_count; ++r) {
    ready.registers.write(static_cast<Register>(r), Size::dword,
                          0x89ABCDEF * static_cast<std::uint32_t>(r + 1));
  }
  for (std::size_t i = 0; i < expected.endings.size(); ++i) {
    auto m = ready;
    enter<routine>(m, words.subspan(i * in, in));
    const auto before = m.registers;
    const Outcome outcome = run(program.instructions(), m).outcome;
    const bool faults = expected.endings[i] == fixproof::parties::Ending::divide_error;
    if (outcome != (faults ? Outcome::divide_error : Outcome::returned)) return i;
    if (faults) continue;
    for (const Register r : {Register::bp, Register::si, Register::di}) {
      if (m.registers.read(r, Size::word) != before.read(r, Size::word)) return i;
    }
    if (m.registers.read(Register::sp, Size::word) != before.read(Register::sp, Size::word) + 2) {
      return i;
    }
    std::array<std::uint32_t, out> results{};
    leave<routine>(m, results);
    const auto wanted = std::span(expected.out).subspan(i * out, out);
    if (!std::equal(results.begin(), results.end(), wanted.begin())) return i;
  }
  return std::nullopt;
}

/// Replaces an instruction by a no-op. Replaces RET by an end of the run: without RET, XformVec
/// would run into the FixedMul behind it, which returns.
void leave_out(Instruction& instruction) {
  using namespace notation;
  constexpr auto nowhere = static_cast<std::int32_t>(Program{}.code.size());
  const bool ends = instruction.mnemonic == Mnemonic::ret;
  instruction = ends ? jmp("") : mov(ax, ax);
  if (ends) instruction.operands[0].value = nowhere;
}

Program without(const Program& program, const std::string& form) {
  Program rest = program;
  for (std::size_t at = 0; at < rest.size; ++at) {
    if (form_of(rest.code.at(at)) == form) leave_out(rest.code.at(at));
  }
  return rest;
}

/// Calls `visit.operator()<routine, target>(build, program, words)` for every program.
template <class Visit>
void each_program(Visit visit) {
  test::each_routine([&]<Routine routine, Target target>() {
    const auto words = all_cases(routine);
    for (const Build& build : test::builds) {
      if (!test::is_for(build, target)) continue;
      const Program program = assemble(listing(routine, target), build);
      visit.template operator()<routine, target>(build, program, words);
    }
  });
}

std::string with_target(Target target, const std::string& form) {
  return (target == Target::i386 ? "386 " : "8088 ") + form;
}

struct Executed {
  std::set<std::string> forms;
  std::set<Mnemonic> mnemonics;
  std::set<Operand::Kind> kinds;
  std::set<Size> sizes;
  std::set<Scaling> scalings;
  std::set<Symbol> symbols;
  std::set<Register> registers;
  std::set<Addressing> addressings;
  std::set<SegmentOverride> segments;

  void note(Target target, const Instruction& i) {
    forms.insert(with_target(target, form_of(i)));
    mnemonics.insert(i.mnemonic);
    for (const Operand& o : i.operands) {
      kinds.insert(o.kind);
      sizes.insert(o.size);
      scalings.insert(o.scaling);
      symbols.insert(o.symbol);
      segments.insert(o.segment);
      if (o.kind == Operand::Kind::memory) addressings.insert(o.addressing);
      if (o.kind == Operand::Kind::reg) registers.insert(o.reg);
    }
  }
};

/// Notes the instructions of two pixels of a loop. A depth test draws one of them.
void note_executed(const LoopForm& form, Executed& executed) {
  std::vector<std::uint8_t> memory(0x1000);
  // Nearer than every pixel but the first.
  memory.at(0x501) = 0x7F;
  LoopMachine m{.registers = {}, .memory = ByteMemory(memory, memory, memory)};
  const auto code = code_of(form);
  m.registers.write(Register::bx, Size::dword, 0x01000000);
  const LoopCall call{.pixels = 2, .value = 0x101, .step = 1};
  const auto ending = call_loop(form, code, m, call, [&](std::size_t at, const auto&) {
    executed.note(form.target, code.at(at));
  });
  EXPECT_EQ(ending.outcome, Outcome::returned);
}

TEST(Minimal, EveryFormIsExecuted) {
  Executed executed;
  std::set<std::string> listed;
  const auto list = [&](Target target, const Listing& rows) {
    // An 8088 does not have the SHL BX,2 of the printed CosSin, so no program here contains it.
    bool left_out = false;
    for (std::size_t i = 0; i < rows.size; ++i) {
      const Instruction& row = rows.rows.at(i);
      if (row.condition == Condition::shl_as_printed) left_out = true;
      if (row.directive == Directive::else_ || row.directive == Directive::endif) left_out = false;
      if (!left_out && row.directive == Directive::none)
        listed.insert(with_target(target, form_of(row)));
    }
  };
  test::each_routine(
      [&]<Routine routine, Target target>() { list(target, listing(routine, target)); });
  for (const LoopForm& form : all_loop_forms()) {
    list(form.target, listing(form));
    note_executed(form, executed);
  }
  each_program([&]<Routine routine, Target target>(const Build&, const Program& program,
                                                   std::span<const std::uint32_t> words) {
    constexpr auto in = static_cast<std::size_t>(arity(routine).in);
    std::array<std::uint32_t, static_cast<std::size_t>(arity(routine).out)> out{};
    std::vector<bool> reached(program.size);
    for (std::size_t i = 0; i + in <= words.size(); i += in) {
      call<routine, 16>(program.instructions(), words.subspan(i, in), out,
                        [&](std::size_t at, const auto&) { reached[at] = true; });
    }
    for (std::size_t at = 0; at < program.size; ++at) {
      if (reached[at]) executed.note(target, program.code.at(at));
    }
  });
  EXPECT_EQ(executed.forms, listed);
  EXPECT_EQ(executed.mnemonics.size(), mnemonic_count);
  EXPECT_EQ(executed.registers.size(), register_count);
  // Everything that instruction.hpp names: none, reg, memory, immediate, label; none, byte, word,
  // dword; literal, bytes, half_unit, word_bits; none, cos_table, inc_j, texture, screen, z_buff;
  // the four ways to form an address.
  EXPECT_EQ(executed.kinds.size(), 5U);
  EXPECT_EQ(executed.sizes.size(), 4U);
  EXPECT_EQ(executed.scalings.size(), 4U);
  EXPECT_EQ(executed.symbols.size(), 6U);
  EXPECT_EQ(executed.addressings.size(), 4U);
  EXPECT_EQ(executed.segments.size(), 2U);
}

TEST(Minimal, TheProgramsAreWhole) {
  each_program([]<Routine routine, Target target>(const Build& build, const Program& program,
                                                  std::span<const std::uint32_t> words) {
    const auto expected = oracle_of<routine, target>(build, words);
    EXPECT_EQ(first_broken<routine>(program, words, expected), std::nullopt) << name_of(routine);
  });
}

TEST(Minimal, NoFormCanBeLeftOut) {
  std::size_t tried = 0;
  each_program([&]<Routine routine, Target target>(const Build& build, const Program& program,
                                                   std::span<const std::uint32_t> words) {
    const auto expected = oracle_of<routine, target>(build, words);
    std::set<std::string> forms;
    for (const Instruction& i : program.instructions()) forms.insert(form_of(i));
    for (const std::string& form : forms) {
      ++tried;
      EXPECT_TRUE(first_broken<routine>(without(program, form), words, expected))
          << with_target(target, std::string(name_of(routine))) << ": " << form;
    }
  });
  EXPECT_GT(tried, 500U);
}

TEST(Minimal, NoInstructionCanBeLeftOut) {
  std::size_t tried = 0;
  each_program([&]<Routine routine, Target target>(const Build& build, const Program& program,
                                                   std::span<const std::uint32_t> words) {
    const auto expected = oracle_of<routine, target>(build, words);
    for (std::size_t at = 0; at < program.size; ++at) {
      ++tried;
      Program rest = program;
      leave_out(rest.code.at(at));
      EXPECT_TRUE(first_broken<routine>(rest, words, expected))
          << with_target(target, std::string(name_of(routine))) << ' ' << at << ' '
          << text_of(program.code.at(at));
    }
  });
  EXPECT_GT(tried, 4000U);
}

}  // namespace
