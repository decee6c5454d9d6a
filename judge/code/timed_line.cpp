#include "judge/code/timed_line.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "x86model/flags.hpp"

namespace fixproof::judge {

namespace {

using x86model::Register;
using x86model::Size;

bool is_one_of(std::string_view name, std::initializer_list<std::string_view> names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool is_prefix(std::uint8_t byte) {
  constexpr std::array<std::uint8_t, 11> all{0x26, 0x2E, 0x36, 0x3E, 0x64, 0x65,
                                             0x66, 0x67, 0xF0, 0xF2, 0xF3};
  return std::ranges::find(all, byte) != all.end();
}

/// Whether a ModR/M byte follows the opcode (80386 Programmer's Reference Manual, appendix A).
bool has_mod_rm(std::uint8_t opcode, bool is_long) {
  const auto within = [opcode](unsigned first, unsigned last) {
    return opcode >= first && opcode <= last;
  };
  if (is_long) {
    return !(within(0x80, 0x8F) || within(0xA0, 0xA2) || within(0xA8, 0xAA) || within(0xC8, 0xCF) ||
             within(0x05, 0x0B));
  }
  if (opcode < 0x40) return (opcode & 7U) < 4;
  return within(0x62, 0x63) || opcode == 0x69 || opcode == 0x6B || within(0x80, 0x8F) ||
         within(0xC0, 0xC1) || within(0xC4, 0xC7) || within(0xD0, 0xD3) || within(0xD8, 0xDF) ||
         within(0xF6, 0xF7) || within(0xFE, 0xFF);
}

/// The bytes of a displacement behind a ModR/M byte, and of the SIB byte before it.
struct Address {
  std::size_t sib = 0;
  std::size_t displacement = 0;
};

Address address_after(std::uint8_t mod_rm, std::uint8_t sib, bool wide) {
  const unsigned mod = mod_rm >> 6U;
  const unsigned rm = mod_rm & 7U;
  if (mod == 3) return {};
  if (!wide) {
    if (mod == 0) return {0, rm == 6 ? 2U : 0U};
    return {0, mod};
  }
  const bool has_sib = rm == 4;
  const bool no_base = mod == 0 && (rm == 5 || (has_sib && (sib & 7U) == 5));
  return {has_sib ? 1U : 0U, no_base || mod == 2 ? 4U : mod};
}

/// Counts prefixes and components in the bytes.
void count_parts(TimedLine& timed, std::span<const std::uint8_t> bytes, int code_bits) {
  const auto byte_at = [&](std::size_t i) { return i < bytes.size() ? bytes[i] : std::uint8_t{0}; };
  std::size_t at = 0;
  bool wide = code_bits == 32;
  for (; at < bytes.size() && is_prefix(bytes[at]); ++at) {
    if (bytes[at] == 0x67) wide = !wide;
    timed.has_repeat |= bytes[at] == 0xF2 || bytes[at] == 0xF3;
    timed.overrides_segment |=
        (bytes[at] & 0xE7U) == 0x26 || bytes[at] == 0x64 || bytes[at] == 0x65;
    timed.needs_386 |= bytes[at] >= 0x64 && bytes[at] <= 0x67;
  }
  timed.prefixes = static_cast<int>(at);
  timed.has_wide_addresses = wide;
  const bool is_long = byte_at(at) == 0x0F;
  if (is_long) ++at;
  timed.needs_386 |= is_long;  // the table has no 0F of a 286
  const std::uint8_t opcode = byte_at(at++);
  timed.opcode = opcode;
  timed.uses_accumulator =
      !is_long && ((opcode >= 0xA0 && opcode <= 0xA3) || (opcode < 0x40 && (opcode & 6U) == 4) ||
                   (opcode & 0xFEU) == 0xA8 || (opcode > 0x90 && opcode < 0x98));
  Address address;
  if (has_mod_rm(opcode, is_long)) {
    address = address_after(byte_at(at), byte_at(at + 1), wide);
    at += 1 + address.sib;
  }
  const std::size_t rest = bytes.size() - std::min(bytes.size(), at + address.displacement);
  timed.has_displacement = address.displacement > 0;
  timed.components =
      static_cast<int>(at + (address.displacement > 0 ? 1U : 0U) + (rest > 0 ? 1U : 0U));
}

std::vector<std::string> operands_in(const Line& line, const std::string& mnemonic) {
  std::vector<std::string> operands;
  const std::size_t start = line.text.find(mnemonic);
  std::string_view rest = std::string_view(line.text).substr(
      std::min(line.text.size(), (start == std::string::npos ? 0 : start) + mnemonic.size() + 1));
  while (!rest.empty()) {
    const std::size_t comma = std::min(rest.find(','), rest.size());
    operands.emplace_back(rest.substr(0, comma));
    rest.remove_prefix(std::min(comma + 1, rest.size()));
  }
  return operands;
}

/// Removes a segment override, which operands_of() does not take.
void remove_segment(std::string& operand) {
  constexpr std::array<std::string_view, 6> names{"cs:", "ds:", "es:", "ss:", "fs:", "gs:"};
  for (const std::string_view name : names) {
    if (const std::size_t at = operand.find(name); at != std::string::npos) {
      operand.erase(at, name.size());
      return;
    }
  }
}

unsigned bit_of(const RegisterName& name) {
  const auto number = static_cast<unsigned>(name.number);
  // AH to BH are numbered after AL to BL.
  return 1U << (name.size == Size::byte ? number % 4 : number);
}

bool is_shift(std::string_view m) {
  return is_one_of(m, {"shl", "shr", "sar", "rol", "ror", "rcl", "rcr", "shld", "shrd"});
}

/// Reads one operand into the shape and what depends on it.
void add_operand(TimedLine& timed, std::string text) {
  if (is_one_of(text, {"cs", "ds", "es", "ss", "fs", "gs"})) {
    timed.shape += 's';
    timed.needs_386 |= text == "fs" || text == "gs";
    return;
  }
  remove_segment(text);
  Line alone;
  alone.text.append("x ").append(text);
  const auto operands = operands_of(alone);
  if (!operands || operands->size() != 1) {
    timed.shape += '?';
    return;
  }
  const Operand& o = operands->front();
  const bool counts = is_shift(timed.mnemonic) && !timed.shape.empty();
  switch (o.kind) {
    case Operand::Kind::reg:
      if (counts && text == "cl") {
        timed.shape += 'c';
        return;
      }
      if (timed.shape.empty() || timed.mnemonic == "xchg") timed.writes |= bit_of(o.reg);
      timed.shape += 'r';
      if (timed.bits == 0) timed.bits = bits_of(o.reg);
      return;
    case Operand::Kind::memory:
      timed.shape += 'm';
      if (timed.bits == 0) timed.bits = o.bits;
      timed.bases = o.bases;
      return;
    case Operand::Kind::immediate: {
      const bool by_one = counts && (timed.opcode == 0xD0 || timed.opcode == 0xD1);
      const bool by_byte = timed.mnemonic == "imul" && timed.opcode == 0x6B;
      timed.shape += by_one ? '1' : by_byte ? 'b' : 'i';
      timed.immediate = o.value;
      return;
    }
  }
}

}  // namespace

bool is_conditional(const std::string& mnemonic) {
  return mnemonic.starts_with('j') && !is_one_of(mnemonic, {"jmp", "jcxz", "jecxz"});
}

bool may_pass(const std::string& mnemonic) {
  return is_conditional(mnemonic) || mnemonic.starts_with("loop") || mnemonic.ends_with("cxz");
}

bool is_taken(const TimedLine& line, const Registers& before) {
  const auto has = [&](unsigned flag) { return (before.flags & flag) != 0; };
  if (is_conditional(line.mnemonic)) {
    using enum x86model::Flag;
    const bool is_less = has(SF) != has(OF);
    // In the order of the opcodes. An odd opcode has the opposite condition.
    const std::array holds{has(OF), has(CF), has(ZF), has(CF) || has(ZF),
                           has(SF), has(PF), is_less, is_less || has(ZF)};
    return holds.at(line.opcode >> 1U & 7U) != ((line.opcode & 1U) != 0);
  }
  if (!may_pass(line.mnemonic)) return true;
  const RegisterName counter{Register::cx, line.has_wide_addresses ? Size::dword : Size::word};
  const std::uint32_t count = before.read(counter);
  if (line.mnemonic.ends_with("cxz")) return count == 0;
  if (count == 1) return false;
  if (line.mnemonic == "loope") return has(x86model::ZF);
  return line.mnemonic != "loopne" || !has(x86model::ZF);
}

TimedLine timed_line(const Line& line, std::span<const std::uint8_t> bytes, int code_bits) {
  TimedLine timed;
  timed.line = line;
  timed.mnemonic = mnemonic_of(line);
  count_parts(timed, bytes, code_bits);
  if (target_of(line) != no_target) {
    timed.shape += 'i';
    return timed;
  }
  for (const std::string& operand : operands_in(line, timed.mnemonic)) {
    add_operand(timed, operand);
  }
  if (timed.bits == 0 && timed.shape.starts_with("m")) timed.bits = code_bits;
  const std::string& m = timed.mnemonic;
  if (is_one_of(m, {"cmp", "test", "push", "mul", "div", "idiv"}) ||
      (m == "imul" && timed.shape.size() == 1)) {
    timed.writes = 0;
  }
  constexpr unsigned ax_and_dx = 1U << 0U | 1U << 2U;
  if (is_one_of(m, {"mul", "div", "idiv"}) || (m == "imul" && timed.shape.size() == 1)) {
    timed.writes = ax_and_dx;
  }
  if (is_one_of(m, {"cwd", "cdq"})) timed.writes = 1U << 2U;
  if (is_one_of(m, {"cbw", "cwde", "lahf", "lodsb", "lodsw", "lodsd", "xlatb", "aam", "aad"}))
    timed.writes |= 1U;
  // MOVSX has operands.
  const bool takes_two_strings =
      timed.shape.empty() && (m.starts_with("movs") || m.starts_with("cmps"));
  if (takes_two_strings || m.starts_with("stos") || m.starts_with("scas")) {
    timed.writes |= 1U << static_cast<unsigned>(Register::di);
  }
  if (m.starts_with("lods") || takes_two_strings) {
    timed.writes |= 1U << static_cast<unsigned>(Register::si);
  }
  if (m.starts_with("popa")) timed.writes = ~(1U << static_cast<unsigned>(Register::sp));
  if (m.starts_with("loop")) timed.writes |= 1U << static_cast<unsigned>(Register::cx);
  return timed;
}

}  // namespace fixproof::judge
