#include "app/web/edit.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <optional>

#include "app/input/number.hpp"
#include "x86model/clocks.hpp"
#include "x86model/execute.hpp"
#include "x86model/forms.hpp"
#include "x86model/loop.hpp"
#include "x86model/text.hpp"

namespace fixproof::web {

namespace {

namespace x86 = x86model;
using Operand = x86::Operand;

/// More instructions than any routine has.
constexpr std::size_t most_lines = 600;

std::string_view trimmed_line(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// Removes a part from the front of a text, and tells whether it was there.
bool skip(std::string_view& text, std::string_view part) {
  if (!text.starts_with(part)) return false;
  text = trimmed_line(text.substr(part.size()));
  return true;
}

std::optional<Operand> register_of(std::string_view name) {
  for (std::size_t i = 0; i < x86::register_count; ++i) {
    for (const x86::Size size : {x86::Size::byte, x86::Size::word, x86::Size::dword}) {
      const auto r = static_cast<x86::Register>(i);
      if (x86::name_of(r, size) == name)
        return Operand{.kind = Operand::Kind::reg, .size = size, .reg = r};
    }
  }
  return std::nullopt;
}

/// Returns a number of at most 32 bits, decimal or after `0x`, with an optional sign.
std::optional<std::int32_t> number_in(std::string_view text) {
  const bool negative = skip(text, "-");
  const int base = skip(text, "0x") ? 16 : 10;
  std::uint32_t magnitude = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, magnitude, base);
  if (error != std::errc() || stop != end) return std::nullopt;
  return static_cast<std::int32_t>(negative ? 0U - magnitude : magnitude);
}

bool is_base(const Operand& r) {
  using enum x86::Register;
  return r.size == x86::Size::word && (r.reg == bx || r.reg == bp || r.reg == si || r.reg == di);
}

/// Adds a part of an address between two signs. Returns whether it is one.
bool add_part(Operand& address, std::string_view part) {
  constexpr std::array<std::pair<std::string_view, x86::Symbol>, 5> symbols{
      {{"CosTable", x86::Symbol::cos_table},
       {"IncJ", x86::Symbol::inc_j},
       {"Texture", x86::Symbol::texture},
       {"Screen", x86::Symbol::screen},
       {"ZBuff", x86::Symbol::z_buff}}};
  for (const auto& [name, symbol] : symbols) {
    if (name != part) continue;
    const bool is_first = address.symbol == x86::Symbol::none;
    address.symbol = symbol;
    return is_first;
  }
  const bool twice = part.ends_with("*2");
  if (const auto reg = register_of(twice ? part.substr(0, part.size() - 2) : part)) {
    if (address.addressing != x86::Addressing::direct) return false;
    const bool is_index = reg->size == x86::Size::dword;
    if (!is_index && (twice || !is_base(*reg))) return false;
    address.reg = reg->reg;
    address.addressing = twice      ? x86::Addressing::index_twice
                         : is_index ? x86::Addressing::index
                                    : x86::Addressing::base;
    return true;
  }
  const auto value = number_in(part);
  const bool is_first = address.value == 0;
  address.value = value.value_or(0);
  return value && is_first;
}

/// Returns what is between brackets, without its size.
std::optional<Operand> address_of(std::string_view text) {
  Operand address{.kind = Operand::Kind::memory, .addressing = x86::Addressing::direct};
  skip(text, "nosplit ");
  if (skip(text, "cs:")) address.segment = x86::SegmentOverride::cs;
  while (!text.empty()) {
    const std::size_t end = text.find_first_of("+-", 1);
    std::string_view part = text.substr(0, end);
    skip(part, "+");
    if (!add_part(address, trimmed_line(part))) return std::nullopt;
    text = end == std::string_view::npos ? std::string_view() : text.substr(end);
  }
  return address;
}

std::optional<Operand> operand_in(std::string_view text, x86::Mnemonic mnemonic) {
  if (const auto reg = register_of(text)) return reg;
  if (x86::is_control_flow(mnemonic) && mnemonic != x86::Mnemonic::ret) {
    skip(text, ".");
    if (text.empty()) return std::nullopt;
    return Operand{.kind = Operand::Kind::label, .name = text.data()};
  }
  x86::Size size = x86::Size::none;
  if (skip(text, "byte ")) size = x86::Size::byte;
  if (skip(text, "word ")) size = x86::Size::word;
  if (skip(text, "dword ")) size = x86::Size::dword;
  if (text.starts_with('[') && text.ends_with(']')) {
    auto address = address_of(text.substr(1, text.size() - 2));
    if (address) address->size = size;
    return address;
  }
  const auto value = number_in(text);
  if (!value) return std::nullopt;
  // As the listings have it, so that both have the same text.
  return Operand{.kind = Operand::Kind::immediate,
                 .scaling = *value == 0x8000 ? x86::Scaling::half_unit : x86::Scaling::literal,
                 .value = *value};
}

/// An instruction, and the label that it jumps to.
struct Line {
  std::string error{};
  x86::Instruction instruction{};
  std::string_view to{};
};

Line line_of(std::string_view text) {
  Line line;
  const std::size_t space = text.find_first_of(" \t");
  const auto mnemonic = x86::mnemonic_named(text.substr(0, space));
  if (!mnemonic) {
    line.error = "the model has no such instruction";
    return line;
  }
  line.instruction.mnemonic = *mnemonic;
  std::string_view rest =
      space == std::string_view::npos ? std::string_view() : trimmed_line(text.substr(space));
  auto& operands = line.instruction.operands;
  for (std::size_t i = 0; !rest.empty(); ++i) {
    const std::size_t comma = rest.find(',');
    const std::string_view part = trimmed_line(rest.substr(0, comma));
    const auto operand = i < operands.size() ? operand_in(part, *mnemonic) : std::nullopt;
    if (!operand) {
      line.error = "'" + std::string(part) + "' is no operand";
      return line;
    }
    operands.at(i) = *operand;
    if (operand->kind == Operand::Kind::label) line.to = part.substr(part.starts_with('.') ? 1 : 0);
    rest =
        comma == std::string_view::npos ? std::string_view() : trimmed_line(rest.substr(comma + 1));
  }
  // A register says how wide the memory is.
  const auto* const reg = std::find_if(operands.begin(), operands.end(), [](const Operand& o) {
    return o.kind == Operand::Kind::reg;
  });
  for (Operand& o : operands) {
    if (o.kind == Operand::Kind::memory && o.size == x86::Size::none && reg != operands.end())
      o.size = reg->size;
  }
  return line;
}

/// Tells whether the processor has the instruction and a figure for its clocks.
bool runs_on(const x86::Instruction& instruction, x86::Target target) {
  const auto cpu = target == x86::Target::i386 ? x86::Cpu::i386 : x86::Cpu::i8088;
  return x86::is_modelled(instruction, target) &&
         x86::clocks(cpu, {.instruction = instruction, .next = &instruction}) &&
         x86::clocks(cpu, {.instruction = instruction, .taken = true, .next = &instruction});
}

/// Says why an instruction cannot run.
std::string lacks(const x86::Instruction& instruction) {
  return "no listing for this processor has '" + x86::form_text(instruction) +
         "', so the model lacks it";
}

std::string read_registers(Edit& edit, std::string_view text) {
  for (const std::string_view part : input::parts_of(text)) {
    const std::size_t equals = part.find('=');
    const auto reg = register_of(part.substr(0, equals));
    const auto value = equals == std::string_view::npos
                           ? std::nullopt
                           : number_in("0x" + std::string(part.substr(equals + 1)));
    if (!reg || !value || reg->reg == x86::Register::sp || reg->size == x86::Size::byte) {
      return "Registers: '" + std::string(part) +
             "' should be a register other than SP and hexadecimal digits, such as ax=1234.";
    }
    edit.registers.emplace_back(reg->reg, static_cast<std::uint32_t>(*value));
  }
  return {};
}

}  // namespace

Edit edit_of(std::string_view registers, std::span<const std::string_view> lines,
             x86::Target target) {
  Edit edit;
  edit.error = read_registers(edit, registers);
  if (!edit.error.empty()) return edit;
  if (lines.size() > most_lines) {
    edit.error = "The code has more than " + std::to_string(most_lines) + " lines.";
    return edit;
  }
  std::vector<std::string_view> targets;
  std::vector<std::size_t> places;  // of the labels, in the order of edit.names
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::string_view text = trimmed_line(lines[i]);
    const std::size_t colon = text.find(':');
    if (colon < text.find_first_of(" \t[")) {
      edit.names.emplace_back(text.substr(0, colon));
      places.push_back(edit.code.size());
      text = trimmed_line(text.substr(colon + 1));
    }
    if (text.empty()) continue;
    Line line = line_of(text);
    if (line.error.empty() && line.to.empty() && !runs_on(line.instruction, target))
      line.error = lacks(line.instruction);
    if (!line.error.empty()) {
      edit.error = "Line " + std::to_string(i + 1) + ": " + line.error + ".";
      return edit;
    }
    edit.code.push_back(line.instruction);
    targets.push_back(line.to);
  }
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (places[i] < edit.code.size()) edit.code[places[i]].label = edit.names[i].c_str();
  }
  for (std::size_t i = 0; i < edit.code.size(); ++i) {
    if (targets[i].empty()) continue;
    const auto found = std::find(edit.names.begin(), edit.names.end(), targets[i]);
    if (found == edit.names.end()) {
      edit.error = "There is no label " + std::string(targets[i]) + ".";
      return edit;
    }
    Operand& to = edit.code[i].operands[0];
    to.value =
        static_cast<std::int32_t>(places[static_cast<std::size_t>(found - edit.names.begin())]);
    to.name = found->c_str();
    if (!runs_on(edit.code[i], target)) {
      edit.error = "The jump to " + *found + ": " + lacks(edit.code[i]) + ".";
      return edit;
    }
  }
  return edit;
}

}  // namespace fixproof::web
