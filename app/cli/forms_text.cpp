#include "app/cli/forms_text.hpp"

#include <fmt/format.h>

#include <array>
#include <string_view>

#include "x86model/clock_rows.hpp"
#include "x86model/encoding.hpp"
#include "x86model/execute.hpp"
#include "x86model/flags.hpp"
#include "x86model/forms.hpp"
#include "x86model/text.hpp"

namespace fixproof::cli {

namespace {

namespace x86 = x86model;

int width_of(x86::Size size) {
  return size == x86::Size::byte ? 8 : size == x86::Size::word ? 16 : 32;
}

/// `add r16, m16`
std::string operands_text(const x86::Instruction& i) {
  std::string text(name_of(i.mnemonic));
  const char* between = " ";
  for (const x86::Operand& o : i.operands) {
    switch (o.kind) {
      case x86::Operand::Kind::none:
        return text;
      case x86::Operand::Kind::reg:
        text += fmt::format("{}r{}", between, width_of(o.size));
        break;
      case x86::Operand::Kind::memory:
        text += fmt::format("{}m{}", between, width_of(o.size));
        break;
      case x86::Operand::Kind::immediate:
        text += fmt::format("{}{}", between, x86::shape_of(i).back() == '1' ? "1" : "imm");
        break;
      case x86::Operand::Kind::label:
        text += fmt::format("{}label", between);
        break;
    }
    between = ", ";
  }
  return text;
}

/// `81 /2 iw`, in the notation of Intel's manuals.
std::string encoding_text(const x86::EncodingRow& row, const x86::Instruction& i) {
  const x86::Size size = i.operands[0].size;
  const unsigned width = has_bytes(row.operands) && size != x86::Size::byte ? 1 : 0;
  std::string text = fmt::format("{}{:02X}", row.follows_0f ? "0F " : "", row.opcode + width);
  const char* const whole = size == x86::Size::dword  ? " id"
                            : size == x86::Size::word ? " iw"
                                                      : " ib";
  switch (row.operands) {
    case x86::Encoded::nothing:
    case x86::Encoded::a_offset:
    case x86::Encoded::offset_a:
      break;
    case x86::Encoded::rm_r:
    case x86::Encoded::r_rm:
      text += " /r";
      break;
    case x86::Encoded::rm_r_count:
      text += " /r ib";
      break;
    case x86::Encoded::rm:
    case x86::Encoded::rm_of_words:
    case x86::Encoded::rm_1:
      text += fmt::format(" /{}", row.digit);
      break;
    case x86::Encoded::rm_count:
    case x86::Encoded::rm_imm8:
      text += fmt::format(" /{} ib", row.digit);
      break;
    case x86::Encoded::rm_imm:
      text += fmt::format(" /{}{}", row.digit, whole);
      break;
    case x86::Encoded::a_imm:
      text += whole;
      break;
    case x86::Encoded::r:
      text += "+r";
      break;
    case x86::Encoded::rel8:
      text += " cb";
      break;
    case x86::Encoded::rel16:
      text += " cw";
      break;
  }
  return text;
}

/// Whether some instruction of this form has the encoding: those of the accumulator, of small
/// immediates and of memory at a fixed address, too.
bool encodes(const x86::EncodingRow& row, x86::Instruction i) {
  for (x86::Operand& o : i.operands) {
    if (o.kind == x86::Operand::Kind::reg) o.reg = x86::Register::ax;
    if (o.kind == x86::Operand::Kind::memory) o.addressing = x86::Addressing::direct;
    if (o.kind == x86::Operand::Kind::immediate && x86::shape_of(i).back() != '1') {
      o = {.kind = x86::Operand::Kind::immediate, .value = 2};
    }
  }
  if (x86::fits(row.operands, i)) return true;
  // A jump is short unless the listing calls it near.
  i.operands[0].size = x86::Size::word;
  return i.operands[0].kind == x86::Operand::Kind::label && x86::fits(row.operands, i);
}

std::string flags_text(std::uint16_t flags) {
  constexpr std::array<std::pair<x86::Flag, char>, 6> letters{{{x86::OF, 'O'},
                                                               {x86::SF, 'S'},
                                                               {x86::ZF, 'Z'},
                                                               {x86::AF, 'A'},
                                                               {x86::PF, 'P'},
                                                               {x86::CF, 'C'}}};
  std::string text;
  for (const auto& [flag, letter] : letters) {
    if ((flags & flag) != 0) text += letter;
  }
  return text;
}

std::string range_text(const x86::figures::Cell& cell) {
  if (cell.max == 0) return "";
  std::string text =
      cell.min == cell.max ? fmt::format("{}", cell.min) : fmt::format("{}-{}", cell.min, cell.max);
  if (cell.per_count > 0) text += cell.per_count == 1 ? "+n" : fmt::format("+{}n", cell.per_count);
  return text;
}

std::string transfer_text(x86::Cpu cpu, std::string_view name, const std::string& shape) {
  const auto* taken = x86::figures::transfer_of(name, shape, true);
  if (taken == nullptr) return "";
  const std::string text = fmt::format("{}{}", x86::figures::column(cpu, *taken),
                                       cpu == x86::Cpu::i286 || cpu == x86::Cpu::i386 ? "+m" : "");
  const auto* passed = x86::figures::transfer_of(name, shape, false);
  if (passed == nullptr) return text;
  return fmt::format("{}, {}", text, x86::figures::column(cpu, *passed));
}

std::string form_clocks(x86::Cpu cpu, const x86::Instruction& i) {
  const std::string shape = x86::shape_of(i);
  if (x86::is_control_flow(i.mnemonic)) {
    const bool is_conditional = x86::detail::condition_of(i.mnemonic).has_value();
    return transfer_text(cpu, is_conditional ? "jcc" : name_of(i.mnemonic), shape);
  }
  // A word takes DWORD forms only since the 386.
  bool has_dwords = false;
  for (const x86::Operand& o : i.operands) has_dwords |= o.size == x86::Size::dword;
  if (has_dwords && cpu < x86::Cpu::i386) return "";
  if (x86::detail::is_multiply(i.mnemonic) || x86::detail::is_divide(i.mnemonic)) return "*";
  const char size = "?bwd"[static_cast<std::size_t>(i.operands[0].size)];
  const auto* row = x86::figures::row_of(x86::figures::rows_of(name_of(i.mnemonic)), shape,
                                         size == '?' ? 'w' : size);
  if (row == nullptr) return "";
  x86::figures::Cell cell = x86::figures::column(cpu, *row);
  if (cpu != x86::Cpu::i8088 || cell.max == 0) return range_text(cell);
  const bool is_of_bytes = size == 'b' || i.mnemonic == x86::Mnemonic::stosb;
  const std::uint32_t transfers = is_of_bytes ? 0 : 4 * row->words;
  cell.min += transfers;
  cell.max += transfers;
  return range_text(cell) + (shape.find('m') == std::string::npos ? "" : "+EA");
}

}  // namespace

std::string forms_text() {
  std::string text =
      "| form | encodings | reads | sets | undefined | 8088 | 286 | 386 | 486 |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";
  for (const x86::Instruction& i : x86::form_examples()) {
    std::string encodings;
    for (const x86::EncodingRow& row : x86::encodings_of(i.mnemonic)) {
      if (!encodes(row, i)) continue;
      encodings += fmt::format("{}`{}`", encodings.empty() ? "" : ", ", encoding_text(row, i));
    }
    const x86::FlagUse use = x86::flag_use(i);
    text +=
        fmt::format("| `{}` | {} | {} | {} | {} |", operands_text(i), encodings,
                    flags_text(use.reads), flags_text(use.sets), flags_text(use.leaves_undefined));
    for (int cpu = 0; cpu < x86::cpu_count; ++cpu) {
      text += fmt::format(" {} |", form_clocks(static_cast<x86::Cpu>(cpu), i));
    }
    text += '\n';
  }
  return text;
}

}  // namespace fixproof::cli
