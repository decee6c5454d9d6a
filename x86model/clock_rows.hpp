/// @file
/// The clocks of instructions and transfers, one row for each form: those of the listings, and
/// those that only other people's code has.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "x86model/clocks.hpp"

// The forms of the listings are from Intel's manuals:
//   8088  iAPX 86,88 User's Manual (210200), table 2-21
//   286   80286 Programmer's Reference Manual, appendix B
//   386   80386 Programmer's Reference Manual (1986), chapter 17
//   486   i486 Microprocessor Programmer's Reference Manual (1990), chapter 26 and appendix E
// and the processor's data sheet, where a manual is known to be wrong or omits a form.
//
// The forms that only other code has: one reader wrote Intel's figures from memory. A second
// gathered published copies before seeing them, and compared row by row:
//   all   HelpPC 2.10 (D. Jurgens, 1991)
//   8088  M. Abrash, Zen of Assembly Language (1989), appendix A
//   286   the figures of Intel's manual in IBMulator's decoder/cycles.cpp
//   386   80386 Programmer's Reference Manual (1986), chapter 17; MAME's i386/cycles.h
//   486   MAME
// and more copies where these were too few or differed: Microsoft's Assembly Language Help
// (ALANG.HLP, all four), 86Box's codegen_timing_486.c, Tsugaru's i486runinstruction.h, M. Abrash,
// Graphics Programming Black Book.
// Every figure is in two of them. A range has all figures where they differ and none is an evident
// misprint. LOOP on a 486 is 7 taken, 6 not; MAME and 86Box have 6 for both. On a 386, MOVS, SCAS
// and STOS have one clock more in MAME alone, POPF on a 486 has 5 in 86Box alone, and HelpPC has
// the figures of POPA for PUSHA on a 286 and a 386: these do not count.

namespace x86model::figures {

/// Clocks or their bounds, and what each bit of a shift count adds. A maximum of 0: there is none.
struct Cell {
  std::uint32_t min = 0;
  std::uint32_t max = 0;
  std::uint32_t per_count = 0;
  constexpr Cell() = default;
  constexpr Cell(std::uint32_t n) : min(n), max(n) {}  // NOLINT(google-explicit-constructor)
  constexpr Cell(std::uint32_t low, std::uint32_t high, std::uint32_t each = 0)
      : min(low), max(high), per_count(each) {}
};
inline constexpr Cell no_figure{};
constexpr Cell counted(std::uint32_t n, std::uint32_t each) { return {n, n, each}; }

/// One form, or several with the same figures. The 8088 adds its address calculation and 4 clocks
/// for each of `words` that go over the bus.
struct Row {
  std::string_view names;  ///< between blanks
  std::string_view shape;
  std::string_view sizes;  ///< of the operand: b, w, d
  Cell i8088;
  std::uint32_t words;
  Cell i286;
  Cell i386;
  Cell i486;
};

inline constexpr std::string_view arithmetic = " add adc sub sbb and or xor ";
inline constexpr std::string_view add_or_and = " add adc and ";
inline constexpr std::string_view subtract_or_xor = " sub sbb or xor ";
inline constexpr std::string_view shifts = " shl shr sar rol ror ";
inline constexpr std::string_view by_carry = " rcl rcr ";
inline constexpr std::string_view all_sizes = "bwd";

inline constexpr std::array rows{
    // names, shape, sizes, 8088, words, 286, 386, 486
    // The forms of the listings.
    Row{" mov ", "rr", all_sizes, 2, 0, 2, 2, 1},
    Row{" mov ", "rm", all_sizes, 8, 1, 5, 4, 1},
    Row{" mov ", "mr", all_sizes, 9, 1, 3, 2, 1},
    Row{" push ", "r", all_sizes, 11, 1, 3, 2, 1},
    Row{" push ", "m", all_sizes, 16, 2, 5, 5, 4},
    // The 486 manual says 4; its data sheet says 1 for the short form, which applies here.
    Row{" pop ", "r", all_sizes, 8, 1, 5, 4, {1, 4}},
    Row{arithmetic, "rr", all_sizes, 3, 0, 2, 2, 1},
    Row{arithmetic, "ri", all_sizes, 4, 0, 3, 2, 1},
    Row{add_or_and, "rm", all_sizes, 9, 1, 7, 6, 2},
    // The 386 manual says 7 to a register and 6 to memory, the reverse of ADD and AND. Tables that
    // do not follow it say 6 and 7 for all.
    Row{subtract_or_xor, "rm", all_sizes, 9, 1, 7, {6, 7}, 2},
    Row{" cmp ", "rr", all_sizes, 3, 0, 2, 2, 1},
    Row{" cmp ", "ri", all_sizes, 4, 0, 3, 2, 1},
    // CMP takes a clock less than ADD on a 286.
    Row{" cmp ", "rm", all_sizes, 9, 1, 6, 6, 2},
    Row{" neg not ", "r", all_sizes, 3, 0, 2, 2, 1},
    Row{" neg not ", "m", all_sizes, 16, 2, 7, 6, 3},
    Row{" inc dec ", "r", "wd", 2, 0, 2, 2, 1},
    Row{shifts, "r1", all_sizes, 2, 0, 2, 3, 3},
    Row{shifts, "ri", all_sizes, no_figure, 0, counted(5, 1), 3, 2},
    Row{" shld shrd ", "rri", "wd", no_figure, 0, no_figure, 3, 2},
    Row{" stosb stosw ", "", all_sizes, 11, 1, 3, 4, 5},
    // Other forms.
    Row{" mov ", "ri", all_sizes, 4, 0, 2, 2, 1},
    Row{" mov ", "mi", all_sizes, 10, 1, 3, 2, 1},
    Row{" mov ", "sr", all_sizes, 2, 0, 2, 2, 3},
    Row{" mov ", "rs", all_sizes, 2, 0, 2, 2, 3},
    Row{" mov ", "sm", all_sizes, 8, 1, 5, 5, {3, 9}},
    Row{" mov ", "ms", all_sizes, 9, 1, 3, 2, 3},
    Row{add_or_and, "mr", all_sizes, 16, 2, 7, 7, 3},
    // 6 in the 386 manual, 7 in tables that do not follow it.
    Row{subtract_or_xor, "mr", all_sizes, 16, 2, 7, {6, 7}, 3},
    Row{arithmetic, "mi", all_sizes, 17, 2, 7, 7, 3},
    Row{" cmp ", "mr", all_sizes, 9, 1, 7, 5, 2},
    Row{" cmp ", "mi", all_sizes, 10, 1, 6, 5, 2},
    Row{" test ", "rr", all_sizes, 3, 0, 2, 2, 1},
    Row{" test ", "mr", all_sizes, 9, 1, 6, 5, 2},
    Row{" test ", "ri", all_sizes, 5, 0, 3, 2, 1},
    Row{" test ", "mi", all_sizes, 11, 1, 6, 5, 2},
    Row{" inc dec ", "r", "b", 3, 0, 2, 2, 1},
    Row{" inc dec ", "m", all_sizes, 15, 2, 7, 6, 3},
    Row{shifts, "m1", all_sizes, 15, 2, 7, 7, 4},
    Row{shifts, "rc", all_sizes, counted(8, 4), 0, counted(5, 1), 3, 3},
    Row{shifts, "mc", all_sizes, counted(20, 4), 2, counted(8, 1), 7, 4},
    Row{shifts, "mi", all_sizes, no_figure, 0, counted(8, 1), 7, 4},
    Row{by_carry, "r1", all_sizes, 2, 0, 2, 9, 3},
    Row{by_carry, "m1", all_sizes, 15, 2, 7, 10, 4},
    Row{by_carry, "rc", all_sizes, counted(8, 4), 0, counted(5, 1), 9, {8, 30}},
    Row{" shld shrd ", "rrc", "wd", no_figure, 0, no_figure, 3, 3},
    Row{" push ", "i", all_sizes, no_figure, 0, 3, 2, 1},
    Row{" push ", "s", all_sizes, 10, 1, 3, 2, 3},
    Row{" pop ", "s", all_sizes, 8, 1, 5, 7, 3},
    Row{" pop ", "m", all_sizes, 17, 2, 5, 5, 6},
    Row{" lea ", "rm", "wd", 2, 0, 3, 2, 1},
    Row{" les lds ", "rm", "w", 16, 2, 7, 7, 6},
    Row{" xchg ", "rr", all_sizes, 4, 0, 3, 3, 3},
    Row{" xchg ", "rm", all_sizes, 17, 2, 5, 5, 5},
    Row{" xchg ", "mr", all_sizes, 17, 2, 5, 5, 5},
    Row{" movzx movsx ", "rr", "wd", no_figure, 0, no_figure, 3, 3},
    Row{" movzx movsx ", "rm", "wd", no_figure, 0, no_figure, 6, 3},
    Row{" nop ", "", all_sizes, 3, 0, 3, 3, 1},
    Row{" cwd ", "", all_sizes, 5, 0, 2, 2, 3},
    Row{" cdq ", "", all_sizes, no_figure, 0, no_figure, 2, 3},
    Row{" cbw ", "", all_sizes, 2, 0, 2, 3, 3},
    Row{" cwde ", "", all_sizes, no_figure, 0, no_figure, 3, 3},
    Row{" clc stc cmc cld std ", "", all_sizes, 2, 0, 2, 2, 2},
    Row{" lahf ", "", all_sizes, 4, 0, 2, 2, 3},
    Row{" sahf ", "", all_sizes, 4, 0, 2, 3, 2},
    Row{" leave ", "", all_sizes, no_figure, 0, 5, 4, 5},
    Row{" lodsb ", "", all_sizes, 12, 0, 5, 5, 5},
    Row{" lodsw ", "", all_sizes, 12, 1, 5, 5, 5},
    Row{" movsb ", "", all_sizes, 18, 0, 5, 7, 7},
    Row{" movsw ", "", all_sizes, 18, 2, 5, 7, 7},
    Row{" cmpsb ", "", all_sizes, 22, 0, 8, 10, 8},
    Row{" cmpsw ", "", all_sizes, 22, 2, 8, 10, 8},
    Row{" scasb ", "", all_sizes, 15, 0, 7, 7, 6},
    Row{" scasw ", "", all_sizes, 15, 1, 7, 7, 6},
    Row{" lodsd ", "", all_sizes, no_figure, 0, no_figure, 5, 5},
    Row{" stosd ", "", all_sizes, no_figure, 0, no_figure, 4, 5},
    Row{" movsd ", "", all_sizes, no_figure, 0, no_figure, 7, 7},
    Row{" cmpsd ", "", all_sizes, no_figure, 0, no_figure, 10, 8},
    Row{" scasd ", "", all_sizes, no_figure, 0, no_figure, 7, 6},
    Row{" xlat ", "", all_sizes, 11, 0, 5, 5, 4},
    Row{" pushf pushfd ", "", all_sizes, 10, 1, 3, 4, 4},
    Row{" popf popfd ", "", all_sizes, 8, 1, 5, 5, 9},
    Row{" pusha pushad ", "", all_sizes, no_figure, 0, 17, 18, 11},
    Row{" popa popad ", "", all_sizes, no_figure, 0, 19, 24, 9},
    Row{" aam ", "", all_sizes, 83, 0, 16, 17, 15},
    Row{" aad ", "", all_sizes, 60, 0, 14, 19, 14},
    // On a 486, HelpPC and MAME have 3 for a register and 4 for memory, 86Box 3 for both, and
    // Tsugaru
    // 4 for both if the condition holds, else 3.
    Row{" setcc ", "r", "b", no_figure, 0, no_figure, 4, {3, 4}},
    Row{" setcc ", "m", all_sizes, no_figure, 0, no_figure, 5, {3, 4}},
    Row{" mul ", "r", "b", {70, 77}, 0, 13, {9, 14}, {13, 18}},
    Row{" mul ", "m", "b", {76, 83}, 0, 16, {12, 17}, {13, 18}},
    Row{" mul ", "m", "w", {124, 139}, 1, 24, {12, 25}, {13, 26}},
    Row{" imul ", "r", "b", {80, 98}, 0, 13, {9, 14}, {13, 18}},
    Row{" imul ", "m", "b", {86, 104}, 0, 16, {12, 17}, {13, 18}},
    Row{" imul ", "r", "w", {128, 154}, 0, 21, {9, 22}, {13, 26}},
    Row{" imul ", "m", "w", {134, 160}, 1, 24, {12, 25}, {13, 26}},
    Row{" imul ", "rr", "w", no_figure, 0, no_figure, {9, 22}, {13, 26}},
    Row{" imul ", "rr", "d", no_figure, 0, no_figure, {9, 38}, {13, 42}},
    Row{" imul ", "rm", "w", no_figure, 0, no_figure, {12, 25}, {13, 26}},
    Row{" imul ", "rm", "d", no_figure, 0, no_figure, {12, 41}, {13, 42}},
    Row{" imul ", "rri", "w", no_figure, 0, 21, {9, 22}, {13, 26}},
    Row{" imul ", "rri", "d", no_figure, 0, no_figure, {9, 38}, {13, 42}},
    Row{" imul ", "rmi", "w", no_figure, 0, 24, {12, 25}, {13, 26}},
    Row{" imul ", "rmi", "d", no_figure, 0, no_figure, {12, 41}, {13, 42}},
    // A byte as the immediate operand: the 386 stops at its highest bit.
    Row{" imul ", "rrb", "w", no_figure, 0, 21, {9, 14}, {13, 26}},
    Row{" imul ", "rrb", "d", no_figure, 0, no_figure, {9, 14}, {13, 42}},
    Row{" imul ", "rmb", "w", no_figure, 0, 24, {12, 17}, {13, 26}},
    Row{" imul ", "rmb", "d", no_figure, 0, no_figure, {12, 17}, {13, 42}},
    Row{" div ", "r", "b", {80, 90}, 0, 14, 14, 16},
    Row{" div ", "m", "b", {86, 96}, 0, 17, 17, 16},
    Row{" div ", "m", "w", {150, 168}, 1, 25, 25, 24},
    Row{" div ", "m", "d", no_figure, 0, no_figure, 41, 40},
    Row{" idiv ", "r", "b", {101, 112}, 0, 17, 19, 19},
    Row{" idiv ", "m", "b", {107, 118}, 0, 20, 22, 20},
    Row{" idiv ", "r", "w", {165, 184}, 0, 25, 27, 27},
    Row{" idiv ", "m", "w", {171, 190}, 1, 28, 30, 28},
};

/// The clocks of transfers of control. `next` counts the next instruction's length, too.
struct Transfer {
  std::string_view names;
  std::string_view shape;
  std::uint32_t i8088;
  std::uint32_t i286;
  std::uint32_t i386;
  std::uint32_t i486;
};
inline constexpr std::array transfers{
    Transfer{" jcc ", "i", 16, 7, 7, 3},     Transfer{" jmp ", "i", 15, 7, 7, 3},
    Transfer{" jmp ", "r", 11, 7, 7, 5},     Transfer{" call ", "i", 23, 7, 7, 3},
    Transfer{" loop ", "i", 17, 8, 11, 7},   Transfer{" loope ", "i", 18, 8, 11, 9},
    Transfer{" loopne ", "i", 19, 8, 11, 9}, Transfer{" jcxz jecxz ", "i", 18, 8, 9, 8},
    Transfer{" ret ", "", 20, 11, 10, 5},    Transfer{" ret ", "i", 24, 11, 10, 5},
    Transfer{" retf ", "", 34, 15, 18, 13},  Transfer{" retf ", "i", 33, 15, 18, 14},
};
/// The same if the jump is not taken. A LOOP takes the same time on a 386.
inline constexpr std::array not_taken{
    Transfer{" jcc ", "i", 4, 3, 3, 1},        Transfer{" loop ", "i", 5, 4, 11, 6},
    Transfer{" loope ", "i", 6, 4, 11, 6},     Transfer{" loopne ", "i", 5, 4, 11, 6},
    Transfer{" jcxz jecxz ", "i", 6, 4, 5, 5},
};

/// The rows of an instruction.
std::vector<const Row*> rows_of(std::string_view mnemonic);

/// The one of these rows for a form. @param size b, w or d  @return null if there is none
const Row* row_of(std::span<const Row* const> candidates, std::string_view shape, char size);

/// The row of a transfer; `jcc` is any jump by a condition. @return null if there is none
const Transfer* transfer_of(std::string_view mnemonic, std::string_view shape, bool taken);

/// The figure of a row for a processor.
template <class T>
constexpr auto column(Cpu cpu, const T& row) {
  switch (cpu) {
    case Cpu::i8088:
      return row.i8088;
    case Cpu::i286:
      return row.i286;
    case Cpu::i386:
      return row.i386;
    case Cpu::i486:
      break;
  }
  return row.i486;
}

}  // namespace x86model::figures
