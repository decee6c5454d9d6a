#include "x86model/parse.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <string>
#include <vector>

#include "x86model/execute.hpp"
#include "x86model/text.hpp"

namespace x86model {

namespace {

constexpr std::string_view name_characters = "abcdefghijklmnopqrstuvwxyz0123456789";
constexpr std::string_view label_characters =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_.";

/// Quotes input text in a message: shortened, on one line, and printable.
std::string quoted(std::string_view text) {
  constexpr std::size_t longest = 40;
  std::string result = "'";
  for (const char c : text.substr(0, longest)) result += c >= ' ' && c <= '~' ? c : '?';
  return result + (text.size() > longest ? "...'" : "'");
}

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

std::string_view first_word(std::string_view line) {
  return line.substr(0, line.find_first_of(" \t"));
}

bool is_prefix(std::string_view name) {
  constexpr std::array<std::string_view, 6> all{"rep", "repe", "repz", "repne", "repnz", "lock"};
  return std::find(all.begin(), all.end(), name) != all.end();
}

std::vector<std::string_view> split_operands(std::string_view text) {
  std::vector<std::string_view> parts;
  if (text.empty()) return parts;
  for (;;) {
    const auto comma = text.find(',');
    parts.push_back(trimmed(text.substr(0, comma)));
    if (comma == std::string_view::npos) return parts;
    text.remove_prefix(comma + 1);
  }
}

std::optional<Operand> register_named(std::string_view name) {
  for (std::size_t i = 0; i < register_count; ++i) {
    for (const Size size : {Size::byte, Size::word, Size::dword}) {
      const auto r = static_cast<Register>(i);
      if (name_of(r, size) == name)
        return Operand{.kind = Operand::Kind::reg, .size = size, .reg = r};
    }
  }
  return std::nullopt;
}

/// Registers and size words that no routine uses as operands.
bool is_unmodelled_name(std::string_view name) {
  constexpr std::array<std::string_view, 6> known{"cs", "ds", "es", "ss", "fs", "gs"};
  const bool memory = name.back() == ']' && name.find('[') != std::string_view::npos;
  return memory || std::find(known.begin(), known.end(), name) != known.end();
}

/// A number with an optional minus sign, at most 32 bits wide.
std::optional<std::int64_t> number(std::string_view text) {
  const bool negative = text.starts_with('-');
  if (negative) text.remove_prefix(1);
  const bool hex = text.starts_with("0x");
  if (hex) text.remove_prefix(2);
  std::uint32_t magnitude = 0;
  const char* end = text.data() + text.size();
  const auto [read, error] = std::from_chars(text.data(), end, magnitude, hex ? 16 : 10);
  if (error != std::errc{} || read != end) return std::nullopt;
  return negative ? -std::int64_t{magnitude} : std::int64_t{magnitude};
}

/// Whether `value` can be encoded: as a shift count in 8 bits, otherwise in the size of the first
/// operand, signed or unsigned.
bool fits(std::int64_t value, bool is_count, Size size) {
  if (is_count) return value >= 0 && value <= 0xFF;
  const int bits = size == Size::dword ? 32 : size == Size::byte ? 8 : 16;
  return value >= -(std::int64_t{1} << (bits - 1)) && value < (std::int64_t{1} << bits);
}

}  // namespace

std::optional<Instruction> parse(std::string_view line) {
  line = trimmed(line);
  bool has_prefix = false;
  std::string_view name = first_word(line);
  // What follows a prefix is an instruction, not an operand.
  for (; is_prefix(name) && name != line; name = first_word(line)) {
    has_prefix = true;
    line = trimmed(line.substr(name.size()));
  }
  if (name.empty()) throw ParseError("no instruction");
  if (name.find_first_not_of(name_characters) != std::string_view::npos) {
    throw ParseError(quoted(name) + " is not a mnemonic");
  }
  const auto operands = split_operands(trimmed(line.substr(name.size())));
  const auto mnemonic = mnemonic_named(name);
  const bool jump = mnemonic && is_control_flow(*mnemonic) && *mnemonic != Mnemonic::ret;
  const bool shift =
      mnemonic && (detail::is_shift(*mnemonic) || detail::is_double_shift(*mnemonic));
  if (operands.size() > 3) throw ParseError("more than three operands");

  Instruction instruction;
  bool known = mnemonic.has_value();
  if (known) instruction.mnemonic = *mnemonic;
  for (std::size_t i = 0; i < operands.size(); ++i) {
    const std::string_view text = operands[i];
    if (text.empty()) throw ParseError("an operand is missing");
    Operand& operand = instruction.operands.at(i);
    if (const auto reg = register_named(text)) {
      operand = *reg;
    } else if (const auto value = number(text)) {
      if (!fits(*value, shift, instruction.operands[0].size)) {
        throw ParseError(quoted(text) + " does not fit the operand");
      }
      operand = {.kind = jump ? Operand::Kind::label : Operand::Kind::immediate,
                 .value = static_cast<std::int32_t>(static_cast<std::uint32_t>(*value))};
    } else if (jump && text.find_first_not_of(label_characters) == std::string_view::npos) {
      operand = {.kind = Operand::Kind::label};
    } else if (is_unmodelled_name(text)) {
      known = false;
    } else {
      throw ParseError(quoted(text) + " is not an operand");
    }
  }
  if (!known || has_prefix) return std::nullopt;
  return instruction;
}

}  // namespace x86model
