#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <array>
#include <iostream>
#include <memory>
#include <vector>

#include "app/cli/arguments.hpp"
#include "app/cli/commands.hpp"
#include "app/cli/program.hpp"
#include "app/cli/trace_loop.hpp"
#include "app/cli/words.hpp"
#include "support/hex.hpp"
#include "support/usage_error.hpp"
#include "verify/parties/not_kept.hpp"
#include "verify/proof/kill.hpp"
#include "verify/singlestep/shown.hpp"
#include "x86model/call.hpp"
#include "x86model/forms.hpp"
#include "x86model/text.hpp"
#include "x86model/with_routine.hpp"

namespace fixproof::cli {

namespace {

namespace x86 = x86model;

struct TraceOptions {
  ProgramOptions program;
  std::vector<std::string> words;
  std::size_t mutant = 0;  ///< from 1; 0 if none
};

/// Formats the registers and memory words that differ, as in "  bp=0058 [0054]=0000".
template <class M>
std::string changes(const M& before, const M& after, x86::Size size) {
  std::string text;
  for (const x86::Register r : singlestep::shown_registers) {
    const std::uint32_t value = after.registers.read(r, size);
    if (value == before.registers.read(r, size)) continue;
    text += fmt::format("{}=", x86::name_of(r, size));
    support::append_hex(text, value, size == x86::Size::word ? 4 : 8);
    text += ' ';
  }
  std::uint32_t was = 0;
  std::uint32_t is = 0;
  for (std::uint32_t address = 0; after.memory.read(address, is); address += 2) {
    before.memory.read(address, was);
    if (is == was) continue;
    text += '[';
    support::append_hex(text, address, 4);
    text += "]=";
    support::append_hex(text, is, 4);
    text += ' ';
  }
  if (text.empty()) return text;
  text.pop_back();
  return "  " + text;
}

std::string_view reason(x86::Outcome outcome) {
  switch (outcome) {
    case x86::Outcome::divide_error:
      return "#DE: divide error";
    case x86::Outcome::undefined_flag:
      return "reads a flag that Intel leaves undefined";
    case x86::Outcome::step_limit:
      return "does not end";
    default:
      return "accesses memory outside its segment";
  }
}

std::string decimal(std::uint32_t word) {
  return fmt::format("{}", static_cast<double>(static_cast<std::int32_t>(word)) / 65536.0);
}

struct Traced {
  machine_code::ProgramKey key;
  x86::Program program;
  std::string mistake;  ///< the mutation; empty if none
  std::vector<std::uint32_t> in;
};

void print_end(std::size_t at, const x86::Instruction& instruction, const x86::Flags& flags,
               std::string_view why) {
  fmt::print(std::cout, "{:4}  {:<30}{}  {}\n", at, x86::text_of(instruction),
             singlestep::flag_columns(flags), why);
}

template <x86::Routine routine>
void trace(const Traced& traced) {
  const auto code = traced.program.instructions();
  x86::CallMachine<routine, 16> machine;
  // A mutation may show only if registers hold junk from a caller. Otherwise zeros are clearer.
  if (!traced.mistake.empty()) x86::fill_with_junk<routine>(machine, traced.in);
  x86::enter<routine>(machine, traced.in);
  const auto size = traced.key.target == x86::Target::i386 ? x86::Size::dword : x86::Size::word;

  fmt::print(std::cout, "   #  {:<30} CF PF AF ZF SF OF  changes\n", x86::name_of(routine));
  const auto entered = machine.registers;
  auto before = machine;
  // A mutant may use an instruction form that its processor has but no listing uses.
  const bool has_every_form = !traced.mistake.empty();
  bool stopped = false;
  const x86::Ending ending = x86::run(code, machine, [&](std::size_t at, const auto& after) {
    if (stopped) return;
    if (!has_every_form && !x86::is_modelled(code[at], traced.key.target)) {
      print_end(at, code[at], before.flags,
                "is not modelled: an 8088 does not have this instruction");
      stopped = true;
      return;
    }
    fmt::print(std::cout, "{:4}  {:<30}{}{}\n", at, x86::text_of(code[at]),
               singlestep::flag_columns(after.flags), changes(before, after, size));
    before = after;
  });
  if (stopped) return;
  if (ending.position >= code.size()) {
    fmt::print(std::cout, "{:4}  leaves the program\n", ending.position);
    return;
  }
  if (ending.outcome != x86::Outcome::returned) {
    print_end(ending.position, code[ending.position], machine.flags, reason(ending.outcome));
    return;
  }
  std::array<std::uint32_t, cases::max_words_out> out{};
  const auto given = std::span(out).first(static_cast<std::size_t>(x86::arity(routine).out));
  x86::leave<routine>(machine, given);
  fmt::print(std::cout, "{} instructions; result", ending.steps);
  for (const std::uint32_t word : given) fmt::print(std::cout, " {:08x} ({})", word, decimal(word));
  fmt::print(std::cout, "\n");
  const std::string lost = parties::not_kept<routine>(entered, machine, traced.in);
  if (!lost.empty()) fmt::print(std::cout, "does not preserve {}\n", lost);
}

int run(const TraceOptions& options) {
  if (const auto loop = options.program.choose_loop()) {
    if (options.mutant != 0)
      throw support::UsageError("--mutant is for routines; leave it out for an inner loop");
    trace_loop(*loop, options.words);
    return 0;
  }
  Traced traced;
  traced.key = options.program.choose();
  const machine_code::ProgramKey& key = traced.key;
  const cases::Variant operation{.operation = cases::operation_named(options.program.operation)};
  traced.in.resize(cases::words_in(operation));
  read_words(std::vector<std::string_view>(options.words.begin(), options.words.end()), operation,
             traced.in);
  traced.program = x86::assemble(x86::listing(key.routine, key.target), key.build);
  if (options.mutant != 0) {
    if (options.program.as_scanned)
      throw support::UsageError("--mutant excludes --as-scanned; leave one out");
    if (key.build.shl_as_printed)
      throw support::UsageError("--mutant excludes cossin --as-printed; leave one out");
    const cases::Variant v =
        options.program.variant.choose(cases::operation_named(options.program.operation));
    const x86::Mutant mutant = proof::mutant_of(v, options.mutant);
    fmt::print(std::cout, "mutant {}: {}\n", options.mutant, mutant.change);
    traced.program = mutant.program;
    traced.mistake = mutant.change;
  }
  x86::with_routine(key.routine, [&]<x86::Routine routine> { trace<routine>(traced); });
  return 0;
}

}  // namespace

void add_trace(CLI::App& app, int& status) {
  auto options = std::make_shared<TraceOptions>();
  CLI::App* command = app.add_subcommand(
      "trace", "show what each instruction of a routine or an inner loop changes");
  options->program.add_to(*command, true);
  command->add_option("words", options->words, "operands, as for eval");
  command
      ->add_option("--mutant", options->mutant,
                   "use this mutant of the routine; see fixproof mutate")
      ->transform(whole_number(1, 100'000));
  command->footer(
      R"(Flags are 0, 1, or ? where Intel leaves them undefined. [0054] is the word at that address.
With --mutant, registers start with random contents. The last line names the registers that a C
caller needs and the routine does not preserve.

An inner loop takes the number of pixels (1 to 320), its value and its step (EDX, EBP) in 24.8;
texture also takes a row and a row step. Pixels are drawn at address 2800. The
depth buffer is all 0, the colour is ff, and a texel is the sum of its row and column.

Examples:
  fixproof trace mul 1.5 -2.5
  fixproof trace mul 00018000 00028000
  fixproof trace div 00010000 00008000 --target i8088
  fixproof trace div 00018000 00028000 --target i8088 --round off --as-scanned
  fixproof trace gouraud-word 00000004 00002000 00000180 --loop dec-jnz)");
  command->callback([options, &status] { status = run(*options); });
}

}  // namespace fixproof::cli
