#include "app/cli/judge_options.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/cli/arguments.hpp"
#include "app/cli/case_options.hpp"
#include "app/cli/option_names.hpp"
#include "app/cli/port_option.hpp"
#include "support/usage_error.hpp"

namespace fixproof::cli {

namespace {

/// Refuses options other than `effective` beside one that needs no others.
void expect_only(const CLI::App& command, const std::string& mode,
                 const std::vector<std::string>& effective) {
  if (command.count(mode) == 0) return;
  for (const CLI::Option* option : command.get_options()) {
    const std::string name = option->get_name();
    if (option->count() == 0 || name == mode ||
        std::ranges::find(effective, name) != effective.end())
      continue;
    throw support::UsageError(fmt::format("{} has no effect with {}; leave it out", name, mode));
  }
}

}  // namespace

void expect_effects(const CLI::App& command) {
  if (command.count("--run") > 0 && command.count("file") > 0) {
    throw support::UsageError("--run and a file both name what to judge; leave one out");
  }
  expect_only(command, "--run",
              {"--as", "--format", "--to", "--terms", "--rounding", "--within", "--overflow",
               "--no-result", "--rule", "--level", "--seed", "--shard", "--cases", "--show",
               "--json", "--processes", "--timeout"});
  if (command.count("--run") > 0) return;
  if (command.count("--timeout") > 0 && command.count("--prove") == 0) {
    throw support::UsageError("--timeout requires --prove or --run");
  }
  if (command.count("file") == 0) {
    throw support::UsageError(
        "what is judged? Name the file of a routine, or a program: --run './mine'");
  }
  expect_only(command, "--list", {"file", "--at", "--symbol", "--bits"});
  expect_only(
      command, "--trace",
      {"file", "--at", "--symbol", "--bits", "--as", "--frame", "--format", "--to", "--terms"});
  expect_only(command, "--against-listing",
              {"file", "--at", "--target", "--round", "--mul-round", "--div-round", "--as-printed",
               "--chapter", "--repaired", "--json"});
}

void RunOptions::add_to(CLI::App& command) {
  CLI::Option* const runs =
      command
          .add_option("--run", program,
                      "judge a program: a command of the shell that reads the cases of gen and "
                      "writes a result per line")
          ->check(not_empty());
  command
      .add_option("--processes", processes,
                  "number of processes of the program; by default one, or one for each "
                  "processor if it would take over 2 seconds")
      ->transform(whole_number(1, 1024))
      ->needs(runs);
}

void JudgeOptions::add_to(CLI::App& command) {
  command
      .add_option("file", file,
                  "the file with the routine: C or C++ source ($CC, $CXX), an ELF object, program, "
                  "firmware or shared library, a .COM, MZ .EXE, NASM source or flat binary; "
                  "FILE:FUNCTION is FILE with --symbol FUNCTION; required unless --run is given")
      ->check(not_empty());
  command
      .add_option(
          "--as", operation,
          "what the routine computes: mul, div, sqrt, add, sub, muldiv, cos_sin, transform, a "
          "function of docs/functions.md, or ? to find out; required unless --list or "
          "--against-listing is given")
      ->check(not_empty());
  command
      .add_option(
          "--frame", frame,
          "calling convention: c, c-far, pascal, pascal-far, stdcall, of 64-bit code sysv (as c) "
          "or ms, types of C such as 'long, long -> long', or registers such as 'eax, ebx -> eax' "
          "or 'dx:ax, cx:bx -> dx:ax keeps si'")
      ->check(not_empty())
      ->capture_default_str();
  command
      .add_option("--at", at,
                  "where the routine is: OFFSET, OFFSET..END or, in hex, SEGMENT:OFFSET")
      ->check(not_empty());
  command.add_option("--symbol", symbol, "the name of the routine in an ELF file or NASM source")
      ->check(not_empty());
  command
      .add_option(
          "--bits", bits,
          "width of the code, 16, 32 or 64; by default that of an ELF file, what BITS says for "
          "NASM source, else 16")
      ->check(one_of({"16", "32", "64"}));
  command
      .add_option(
          "--format", format,
          "format of the words: qW_F signed or uW_F unsigned, with W bits before the point and F "
          "after it, 2 to 64 in all")
      ->capture_default_str();
  command.add_option("--to", to, "format of the results; by default --format")->check(not_empty());
  command.add_option("--terms", terms, "number of products of dot")
      ->transform(whole_number(1, cases::max_terms))
      ->capture_default_str();
  command
      .add_option("--rounding", rounding,
                  "expected rounding: half-up, half-away, half-even, floor, ceiling, toward-zero, "
                  "faithful, or best, the default, for the one that fits best")
      ->check(not_empty());
  command
      .add_option("--overflow", overflow,
                  "expected result of an overflow: wrap, saturate, symmetric, maximum, minimum, de "
                  "or any")
      ->check(not_empty())
      ->capture_default_str();
  command
      .add_option("--no-result", no_result,
                  "expected result where there is none, as in a division by 0: de, any, or another "
                  "value of --divide-by-zero, --negative-root, --outside-domain or --not-finite "
                  "of check")
      ->check(not_empty())
      ->capture_default_str();
  add_port_option(command, rule, {"--rounding", "--overflow", "--no-result"});
  command
      .add_option("--within", within,
                  "the largest error of a routine that is right, in ulps (2) or of the exact "
                  "result (0.5%)")
      ->check(not_empty())
      ->excludes(command.get_option("--rounding"))
      ->excludes(command.get_option("--rule"));
  add_case_options(command, cases);
  command.add_option("--show", shown, "number of wrong results to show")
      ->transform(whole_number(0, 1'000'000))
      ->capture_default_str();
  CLI::Option* const proves = command.add_flag(
      "--prove", prove, "also prove the routine for all operands, or find a case that fails");
  solver.add_to(command);
  command.get_option("--solver")->needs(proves);
  command.get_option("--timeout")
      ->default_str("")
      ->description(
          "seconds: of --prove the limit per question, by default 30; of --run the longest time "
          "in which a program neither reads nor writes, by default 60");
  command.add_flag(
      "--clocks", clocks,
      "also count the clocks of calls on an 8088, 286, 386 and 486, by Intel's tables, "
      "and the bytes of code that they fetch and of data that they read and write");
  command.add_flag("--list", list,
                   "only disassemble the routine, to NASM source of the same bytes");
  command
      .add_option(
          "--trace", trace,
          "only run one case step by step; write its operands as gen does, such as '00018000 "
          "00020000'")
      ->check(not_empty());
  listing.add_to(command);
  command.get_option("--round")->transform(CLI::Validator(
      [](const std::string& text) {
        const bool is_known = text == "on" || text == "off";
        return is_known ? "" : text + " not in {on,off}; did you mean --rounding?";
      },
      ""));
  run.add_to(command);
  put_under(command, "What is judged",
            {"--as", "--run", "--symbol", "--at", "--bits", "--frame", "--processes", "--timeout"});
  put_under(command, "Formats", {"--format", "--to", "--terms"});
  put_under(command, "What is right",
            {"--rounding", "--within", "--overflow", "--no-result", "--rule"});
  put_under(command, "Cases", {"--level", "--seed", "--shard", "--cases", "--show"});
  put_under(command, "More about a routine",
            {"--prove", "--solver", "--clocks", "--list", "--trace"});
  put_under(command, "Is it a listing of FIXED.ASM",
            {"--against-listing", "--target", "--round", "--mul-round", "--div-round",
             "--as-printed", "--chapter", "--repaired"});
  command.footer(
      R"(Start with the line that fits. docs/judge.md shows what each prints:
  fixproof judge fixed.c:fix_mul --as mul        a function in C or C++
  fixproof judge libmine.so:fix_mul --as mul     a function of a library, an object or a program
  fixproof judge firmware.elf:fix_mul --as mul   firmware for ARM, RISC-V and others
  fixproof judge old.com --at 1a0h --as '?' --frame 'dx:ax, cx:bx -> dx:ax'
                                                 a routine of a DOS program, whatever it computes
  fixproof judge --run './mine' --as mul         a program in any language, or a simulation
For a function in Python see docs/python.md, for Verilog and VHDL docs/hardware.md, for results in
a file `fixproof check --help`.

The verdict begins with the rules. Without --rounding, these are the rounding that fits best; name
the one that you intend, so that others are wrong.
  AGREES     no result is wrong
  WRONG      some are; the smallest case follows, and what all of them have in common
  BROKEN     the code faults, ends or hangs, for the case that is named
  UNSTEADY   the result differs from call to call; STATEFUL: it depends on earlier calls

A routine runs on every case of `fixproof gen`, in a process of its own that can open no file and
start no program. It runs on this processor, or on Unicorn if the processor cannot run it. An ELF
file may have code for i386, x86-64, ARM and Thumb, AArch64, RISC-V of 32 and 64 bits, MIPS of 32
bits, the 68000, PowerPC, s390x, SPARC V8 or, if the build has simavr, AVR. C and C++ are compiled
with -O2, or as $CFLAGS or $CXXFLAGS say.

--frame says where the operands and the result are. Types of C are passed as a C compiler does:
'long, long -> long', or 'int32_t*, int32_t*, int32_t*, 1 ->' for pointers to both operands and the
result, and a count that is always 1. Else name the registers in the order of the operands, a pair
with its upper half first, a pointer in brackets. In the stack conventions, the routine must
preserve (E)BP, (E)SI and (E)DI, and also EBX in 32-bit code; in 64-bit code RBX, RBP and R12 to
R15, and for ms RSI and RDI too. After registers, `keeps` names those that it must preserve. It must
always leave the direction flag clear, the x87 stack empty, and DS, SS and the x87's control word as
they were.
  mul, div, add, sub  two numbers          -> a number
  sqrt                a number             -> a number
  muldiv              a, b, c              -> a * b / c
  dot                 all first factors, then the second ones; mul_add and lerp take three numbers
  cos_sin             tenths of a degree (16 bits) -> cosine and sine, or pointers to them
  transform           pointers to 12, 3 and 3 numbers: matrix, vector, result

A program of --run reads the lines of `fixproof gen` on standard input, such as 00018000 ffff0000
for 1.5 and -1.0, and writes a line for each: 8 lower-case hex digits, or DE for a divide error.
Lines that start with # are skipped. --as then takes every operation of `fixproof check`.

Exit status: 0 if all results are right and there is no defect, 1 if there is one, 2 for bad usage
or input, 130 if interrupted.

More examples:
  CC='arm-none-eabi-gcc -mcpu=cortex-m4' fixproof judge fixed.c:fix_mul --as mul
  fixproof judge firmware.elf:FT_MulFix --as mul --frame 'long, long -> long'
  fixproof judge firmware.elf:arm_sqrt_q31 --as sqrt --format q1_31 --frame 'int32_t, int32_t* ->' --within 2
  fixproof judge fixmul.asm --as mul --frame 'eax, ebx -> eax' --bits 32
  fixproof judge game.exe --as mul --at 0:1f40 --frame c-far
  fixproof judge mine.o --symbol my_mul --as mul --overflow wrap --prove
  fixproof judge doom.o --symbol FixedDiv --as div --rule doom
  fixproof judge fixed.o --symbol fix_div --as div --rounding toward-zero
  fixproof judge --run 'python3 mine.py' --as div --rounding floor --no-result de
  fixproof judge --run 'vvp -n bench' --as mul --cases 20000
  fixproof judge demo1.exe --against-listing all --mul-round on --div-round off)");
}

}  // namespace fixproof::cli
