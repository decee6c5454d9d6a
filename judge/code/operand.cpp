#include "judge/code/operand.hpp"

#include <charconv>
#include <string_view>

namespace fixproof::judge {

namespace {

/// Reads 0x1f, +0x1f or -0x1f.
std::optional<std::uint32_t> number_in(std::string_view text) {
  const bool negative = text.starts_with('-');
  if (negative || text.starts_with('+')) text.remove_prefix(1);
  if (!text.starts_with("0x")) return std::nullopt;
  std::uint32_t value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data() + 2, end, value, 16);
  if (error != std::errc() || stop != end) return std::nullopt;
  return negative ? 0 - value : value;
}

/// Parses the text between brackets: registers and numbers with signs between them.
bool read_address(std::string_view text, Operand& operand) {
  // ndisasm writes the width of a fixed address that a ModR/M byte asks for.
  for (const auto& [word, bits] : {std::pair<std::string_view, int>{"word ", 16},
                                   std::pair<std::string_view, int>{"dword ", 32}}) {
    if (!text.starts_with(word)) continue;
    text.remove_prefix(word.size());
    operand.address_bits = bits;
  }
  while (!text.empty()) {
    const std::size_t next = text.find_first_of("+-", 1);
    std::string_view part = text.substr(0, next);
    text = next == std::string_view::npos ? "" : text.substr(next);
    if (const auto value = number_in(part)) {
      operand.value += *value;
      continue;
    }
    if (part.starts_with('+')) part.remove_prefix(1);
    const auto reg = register_named(part);
    if (!reg) return false;
    operand.bases.push_back(*reg);
  }
  return true;
}

std::optional<Operand> operand_in(std::string_view text) {
  Operand operand;
  for (const auto& [word, bits] : {std::pair<std::string_view, int>{"byte ", 8},
                                   {"word ", 16},
                                   {"dword ", 32},
                                   {"short ", 0},
                                   {"near ", 0}}) {
    if (!text.starts_with(word)) continue;
    text.remove_prefix(word.size());
    operand.bits = bits;
  }
  if (text.starts_with('[') && text.ends_with(']')) {
    operand.kind = Operand::Kind::memory;
    if (!read_address(text.substr(1, text.size() - 2), operand)) return std::nullopt;
    return operand;
  }
  if (const auto reg = register_named(text)) {
    operand.kind = Operand::Kind::reg;
    operand.reg = *reg;
    return operand;
  }
  if (const auto value = number_in(text)) {
    operand.value = *value;
    return operand;
  }
  // ndisasm writes a shift by one without 0x.
  if (text != "1") return std::nullopt;
  operand.value = 1;
  return operand;
}

}  // namespace

std::optional<std::vector<Operand>> operands_of(const Line& line) {
  std::vector<Operand> operands;
  const std::size_t space = line.text.find(' ');
  if (space == std::string::npos) return operands;
  for (std::string_view rest = std::string_view(line.text).substr(space + 1); !rest.empty();) {
    const std::size_t comma = rest.find(',');
    const auto operand = operand_in(rest.substr(0, comma));
    if (!operand) return std::nullopt;
    operands.push_back(*operand);
    rest = comma == std::string_view::npos ? "" : rest.substr(comma + 1);
  }
  return operands;
}

}  // namespace fixproof::judge
