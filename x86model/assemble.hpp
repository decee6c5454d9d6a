/// @file
/// Listings and their assembly, which resolves conditional rows and labels.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <stdexcept>
#include <string_view>

#include "x86model/instruction.hpp"

namespace x86model {

/// The rows of one routine as printed: instructions, labels and conditional assembly.
struct Listing {
  std::array<Instruction, 640> rows{};
  std::size_t size = 0;

  constexpr Listing() = default;
  constexpr Listing(std::initializer_list<Instruction> more) { *this += more; }

  constexpr Listing& operator+=(std::initializer_list<Instruction> more) {
    for (const Instruction& row : more) rows.at(size++) = row;
    return *this;
  }
  constexpr Listing& operator+=(const Listing& more) {
    for (std::size_t i = 0; i < more.size; ++i) rows.at(size++) = more.rows.at(i);
    return *this;
  }
};

/// The processor that a listing is for.
enum class Target : std::uint8_t { i386, i8088 };

/// The switches of the conditional assembly. Each states what the code does.
struct Build {
  bool mul_rounding = true;
  bool div_rounding = true;
  /// The routine of chapter 52: always rounded; the divide ends in MOV and SHR. ConcatXforms is C
  /// in that chapter; here it is the later assembly changed to give the C result, with the
  /// translation added in all four columns. 386 only.
  bool chapter_52 = false;
  /// The 8088 divide with its last ADC after the endif, as in a scan of chapter 54. Without
  /// rounding, that ADC adds a carry that DIV leaves undefined. The author's file has the ADC
  /// before the endif, so this serves only as an example of a detected undefined flag.
  bool endif_as_scanned = false;
  /// The 8088 ConcatXforms with the carry that the listing loses. 8088 only.
  bool repaired = false;
  /// The 8088 CosSin with SHL BX,2 as printed, which the 8088 cannot execute; otherwise two shifts
  /// by one. 8088 only.
  bool shl_as_printed = false;

  friend constexpr bool operator==(const Build&, const Build&) = default;
};

/// An assembled routine: every row is an instruction and every label operand a position.
struct Program {
  std::array<Instruction, 600> code{};
  std::size_t size = 0;

  [[nodiscard]] constexpr std::span<const Instruction> instructions() const {
    return std::span(code).first(size);
  }
};

namespace detail {

constexpr bool holds(Condition condition, const Build& build) {
  switch (condition) {
    case Condition::mul_rounding:
      return build.mul_rounding;
    case Condition::div_rounding:
      return build.div_rounding;
    case Condition::chapter_52:
      return build.chapter_52;
    case Condition::endif_as_scanned:
      return build.endif_as_scanned;
    case Condition::repaired:
      return build.repaired;
    case Condition::shl_as_printed:
      return build.shl_as_printed;
    case Condition::none:
      break;
  }
  throw std::logic_error("a conditional row without a condition");
}

constexpr std::size_t position_of(std::string_view label, const Program& program) {
  for (std::size_t i = 0; i < program.size; ++i) {
    const char* here = program.code.at(i).label;
    if (here != nullptr && label == here) return i;
  }
  throw std::logic_error("a jump to a label that does not exist");
}

}  // namespace detail

/// Assembles a listing under one setting of its switches.
///
/// @throws std::logic_error if the listing is malformed; in a constant expression this is a compile
/// error
constexpr Program assemble(const Listing& listing, const Build& build) {
  Program program;
  std::array<bool, 4> kept{true};
  std::size_t depth = 0;
  const char* label = nullptr;
  bool is_procedure = false;
  for (std::size_t i = 0; i < listing.size; ++i) {
    const Instruction& row = listing.rows.at(i);
    switch (row.directive) {
      case Directive::if_:
        kept.at(depth + 1) = kept.at(depth) && detail::holds(row.condition, build);
        ++depth;
        break;
      case Directive::else_:
        kept.at(depth) = kept.at(depth - 1) && !kept.at(depth);
        break;
      case Directive::endif:
        --depth;
        break;
      case Directive::procedure:
      case Directive::label:
        if (!kept.at(depth)) break;
        if (label != nullptr) throw std::logic_error("two labels at one instruction");
        label = row.label;
        is_procedure = row.is_procedure;
        break;
      case Directive::none:
        if (!kept.at(depth)) break;
        Instruction& placed = program.code.at(program.size++);
        placed = row;
        placed.label = label;
        placed.is_procedure = is_procedure;
        label = nullptr;
        is_procedure = false;
        break;
    }
  }
  if (depth != 0) throw std::logic_error("an if without its endif");
  if (label != nullptr) throw std::logic_error("a label after the last instruction");
  for (std::size_t i = 0; i < program.size; ++i) {
    for (Operand& operand : program.code.at(i).operands) {
      if (operand.kind == Operand::Kind::label) {
        operand.value = static_cast<std::int32_t>(detail::position_of(operand.name, program));
      }
    }
  }
  return program;
}

}  // namespace x86model
