#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/arguments.hpp"
#include "app/cli/commands.hpp"
#include "app/cli/lines.hpp"
#include "app/cli/options.hpp"
#include "app/cli/singlestep.hpp"
#include "support/error_text.hpp"
#include "support/hex.hpp"
#include "support/plain_text.hpp"
#include "support/usage_error.hpp"
#include "verify/singlestep/shown.hpp"
#include "verify/singlestep/step_clocks.hpp"
#include "verify/singlestep/step_machine.hpp"
#include "x86model/forms.hpp"
#include "x86model/parse.hpp"
#include "x86model/run.hpp"
#include "x86model/text.hpp"

namespace fixproof::cli {

namespace {

namespace x86 = x86model;

struct State {
  singlestep::StepMachine machine;
  std::array<bool, singlestep::shown_registers.size()>
      wide{};                     ///< whether given as eax=…, with 8 digits
  std::uint32_t other_flags = 0;  ///< bits of fl other than the six arithmetic flags
};

/// The space-separated NAME=DIGITS fields of a line, by name.
using Fields = std::map<std::string_view, std::string_view>;

Fields split_fields(std::string_view text) {
  Fields fields;
  while (true) {
    text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
    if (text.empty()) return fields;
    const std::string_view field = text.substr(0, text.find(' '));
    text.remove_prefix(field.size());
    const auto equals = field.find('=');
    if (equals == std::string_view::npos) {
      throw support::UsageError(
          fmt::format("{} is not a register as NAME=DIGITS", support::quoted(field)));
    }
    const std::string_view name = field.substr(0, equals);
    if (!fields.emplace(name, field.substr(equals + 1)).second) {
      throw support::UsageError(
          fmt::format("{} is given twice; remove one", support::quoted(name)));
    }
  }
}

/// Removes a field and returns its digits, or nothing if the line does not have it.
std::optional<std::string_view> take(Fields& fields, std::string_view name) {
  const auto node = fields.extract(name);
  if (node.empty()) return std::nullopt;
  return node.mapped();
}

State parse_state(std::string_view text, x86::Target cpu) {
  State state;
  Fields fields = split_fields(text);
  for (std::size_t i = 0; i < singlestep::shown_registers.size(); ++i) {
    const std::string_view narrow = x86::name_of(singlestep::shown_registers[i], x86::Size::word);
    const std::string_view wide = x86::name_of(singlestep::shown_registers[i], x86::Size::dword);
    auto digits = take(fields, narrow);
    if (cpu == x86::Target::i386 && fields.contains(wide)) {
      if (digits) {
        throw support::UsageError(
            fmt::format("both {} and {} are given; remove one", narrow, wide));
      }
      digits = take(fields, wide);
      state.wide[i] = true;
    }
    if (!digits)
      throw support::UsageError(fmt::format("{} is missing: give all eight registers", narrow));
    state.machine.registers.write(singlestep::shown_registers[i], x86::Size::dword,
                                  support::parse_hex(*digits, state.wide[i] ? 8 : 4));
  }
  const auto fl = take(fields, "fl");
  if (!fl) throw support::UsageError("fl is missing: give the flags as fl=DIGITS");
  const std::uint32_t value = support::parse_hex(*fl, 4);
  state.machine.flags = {static_cast<std::uint16_t>(value & x86::arithmetic_flags), 0};
  state.other_flags = value & ~std::uint32_t{x86::arithmetic_flags};
  if (!fields.empty()) {
    throw support::UsageError(fmt::format("{} is not a register of this processor",
                                          support::quoted(fields.begin()->first)));
  }
  return state;
}

void append_state(std::string& output, const State& state) {
  for (std::size_t i = 0; i < singlestep::shown_registers.size(); ++i) {
    const std::uint32_t value =
        state.machine.registers.read(singlestep::shown_registers[i], x86::Size::dword);
    // Show an upper half that the instruction has set even if the input did not give it.
    const bool wide = state.wide[i] || value > 0xFFFF;
    output +=
        x86::name_of(singlestep::shown_registers[i], wide ? x86::Size::dword : x86::Size::word);
    output += '=';
    support::append_hex(output, value, wide ? 8 : 4);
    output += ' ';
  }
  output += "fl=";
  support::append_hex(output, state.other_flags | state.machine.flags.value, 4);
  output += " undef=";
  bool any = false;
  for (const auto& [flag, name] : singlestep::shown_flags) {
    if ((state.machine.flags.undefined & flag) == 0) continue;
    if (any) output += ',';
    output += name;
    any = true;
  }
  if (!any) output += '-';
}

void append_clocks(std::string& output, const std::optional<x86::Range>& clocks) {
  output += " clocks=";
  if (!clocks) {
    output += '-';
  } else if (clocks->min == clocks->max) {
    output += fmt::format("{}", clocks->min);
  } else {
    output += fmt::format("{}-{}", clocks->min, clocks->max);
  }
}

/// The instructions that the model cannot run.
struct Unmodelled {
  std::uint64_t lines = 0;
  std::vector<std::string> first;  ///< the first different ones

  void add(std::string_view instruction) {
    constexpr std::size_t most = 3;
    ++lines;
    const std::size_t end = instruction.find_last_not_of(" \t");
    const std::string text = support::printable(instruction.substr(0, end + 1));
    if (first.size() < most && std::ranges::find(first, text) == first.end()) first.push_back(text);
  }
};

/// Answers one line.
/// @param timed the processor whose clocks the answer includes, if any
/// @param unmodelled gets the instruction if the model cannot run it
void answer(std::string_view line, x86::Target cpu, std::optional<x86::Cpu> timed,
            std::string& output, Unmodelled& unmodelled) {
  const auto bar = line.find('|');
  if (bar == std::string_view::npos)
    throw support::UsageError("the '|' between instruction and registers is missing");
  std::optional<x86::Instruction> instruction;
  try {
    instruction = x86::parse(line.substr(0, bar));
  } catch (const x86::ParseError& error) {
    throw support::UsageError(error.what());
  }
  State state = parse_state(line.substr(bar + 1), cpu);
  const auto without_answer = [&] {
    output += "unmodelled";
    unmodelled.add(line.substr(0, bar));
  };
  if (!instruction || !x86::is_modelled(*instruction, cpu)) return without_answer();
  const x86::Mnemonic op = instruction->mnemonic;
  // CALL and RET need code and a stack. Jumps are not taken; only LOOP changes a register.
  if (op == x86::Mnemonic::call || op == x86::Mnemonic::ret) return without_answer();
  std::optional<x86::Range> clocks;
  if (timed) clocks = singlestep::step_clocks(*timed, *instruction, state.machine);
  if (op == x86::Mnemonic::loop) x86::count_down(state.machine);
  if (!x86::is_control_flow(op)) {
    const x86::Outcome outcome = x86::execute_any(*instruction, state.machine);
    if (outcome == x86::Outcome::divide_error) {
      output += "DE";
      return;
    }
    if (outcome != x86::Outcome::proceeds) return without_answer();
  }
  append_state(output, state);
  if (timed) append_clocks(output, clocks);
}

int run(x86::Target cpu, std::optional<x86::Cpu> timed) {
  Unmodelled unmodelled;
  answer_lines(std::cin, std::cout, [&](std::string_view line, std::string& output) {
    answer(line, cpu, timed, output, unmodelled);
  });
  if (unmodelled.lines > 0) {
    support::write_error(fmt::format(
        "fixproof step: {} line{} unmodelled, such as {}; the model has what FIXED.ASM and the "
        "inner "
        "loops use, on registers: fixproof list forms\n",
        unmodelled.lines, unmodelled.lines > 1 ? "s" : "", fmt::join(unmodelled.first, "; ")));
  }
  return 0;
}

}  // namespace

void add_step(CLI::App& app, int& status) {
  static const std::map<std::string, x86::Cpu> processors{{"8086", x86::Cpu::i8088},
                                                          {"8088", x86::Cpu::i8088},
                                                          {"286", x86::Cpu::i286},
                                                          {"386", x86::Cpu::i386}};
  auto cpu = std::make_shared<std::string>("386");
  auto timed = std::make_shared<std::string>();
  auto files = std::make_shared<std::vector<std::string>>();
  auto result = std::make_shared<ResultFile>();
  CLI::App* command = app.add_subcommand(
      "step", "execute one instruction per line, or judge the model by captured states");
  command
      ->add_option("--cpu", *cpu,
                   "processor: 8088 (also as 8086) or 386; with --singlestep also 286")
      ->check(one_of(names_of(processors)))
      ->capture_default_str();
  CLI::Option* clocks =
      command
          ->add_option("--clocks", *timed,
                       "append the clocks of the instruction on an 8088, 286, 386 or 486")
          ->check(one_of(names_of(cpu_names)));
  CLI::Option* captured =
      command
          ->add_option(
              "--singlestep", *files,
              "judge the cases of these files, JSON or MOO, plain or gzip, instead of lines")
          ->check(not_empty())
          ->excludes(clocks);
  result->add_to(*command);
  command->get_option("--json")->needs(captured);
  command->footer(
      R"(A line is an instruction and all registers. The answer is the state after it, then the flags that
it leaves undefined. DE is a divide error. `unmodelled` means that no routine uses the
instruction or that it reads memory. With --cpu 386 a register may be given with 8 digits, as in
eax=; it is then printed with 8. Jumps are not taken; LOOP decrements its counter.

--clocks appends clocks=N to every state, clocks=MIN-MAX if Intel's tables give a range, and
clocks=- if that processor does not have the instruction. A jump has the clocks of a jump not
taken, except JMP, whose time depends on its target.

Example:
  echo 'adc bx, dx | ax=0000 bx=ffff cx=0000 dx=0000 si=0000 di=0000 bp=0000 sp=fffe fl=0001' |
    fixproof step --cpu 8088

--singlestep reads the captured states of SingleStepTests, JSON or MOO: the 8088, 8086, 80286 and
80386 sets in real mode. A case has registers and memory before and after one instruction. A case
runs if some listing uses its instruction, addressing mode and prefix; the others are skipped and
counted by reason. Everything is compared except undefined flags: registers, the instruction
pointer, each byte of memory, and after a divide error the pushed FLAGS, CS and return address.
For each file the command prints the first 20 cases that differ and one line of counts. Exit
status: 0 no case differs, 1 a case differs, 2 a file is damaged or no case can be run.

Examples:
  fixproof step --cpu 8086 --singlestep 8086/v1_binary/*.MOO.gz
  fixproof step --cpu 286 --singlestep 80286/v1_real_mode/F7.6.MOO.gz)");
  command->callback([cpu, timed, files, result, &status] {
    const x86::Cpu processor = processors.at(*cpu);
    if (!files->empty()) {
      status = judge_files(*files, processor, *result);
      return;
    }
    if (processor == x86::Cpu::i286) {
      throw support::UsageError("--cpu 286 needs --singlestep; lines run on an 8088 or a 386");
    }
    const auto target = processor == x86::Cpu::i8088 ? x86::Target::i8088 : x86::Target::i386;
    std::optional<x86::Cpu> timed_cpu;
    if (!timed->empty()) timed_cpu = cpu_names.at(*timed);
    status = run(target, timed_cpu);
  });
}

}  // namespace fixproof::cli
