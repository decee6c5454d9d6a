#include "singlestep/decode.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include "support/usage_error.hpp"
#include "x86model/forms.hpp"

namespace fixproof::singlestep {

namespace {

namespace x86 = x86model;
using x86::Mnemonic;
using x86::Operand;
using x86::Size;

/// The mnemonics that a three-bit field selects; empty if no routine uses the instruction.
using Group = std::array<std::optional<Mnemonic>, 8>;
constexpr std::nullopt_t no = std::nullopt;
constexpr Group arithmetic{
    Mnemonic::add,  no,           Mnemonic::adc, Mnemonic::sbb, Mnemonic::and_, Mnemonic::sub,
    Mnemonic::xor_, Mnemonic::cmp};
constexpr Group shifts{Mnemonic::rol, no, no, no, Mnemonic::shl, Mnemonic::shr, no, Mnemonic::sar};
constexpr Group group_f7{
    no, no, no, Mnemonic::neg, Mnemonic::mul, Mnemonic::imul, Mnemonic::div, Mnemonic::idiv};
constexpr Group group_ff{Mnemonic::inc, Mnemonic::dec, no, no, no, no, no, no};
/// MOV of an immediate is defined only for /0. An 8088 also executes the other values as MOV.
constexpr Group group_c7{Mnemonic::mov, no, no, no, no, no, no, no};

bool is_between(std::uint8_t byte, int first, int last) { return byte >= first && byte <= last; }

bool is_prefix(std::uint8_t byte, bool i386) {
  switch (byte) {
    case 0x26:
    case 0x2E:
    case 0x36:
    case 0x3E:
    case 0xF0:
    case 0xF2:
    case 0xF3:
      return true;
    case 0xF1:  // LOCK again on an 8088, another instruction on a 386
      return !i386;
    default:
      return i386 && is_between(byte, 0x64, 0x67);
  }
}

bool is_control_flow(std::uint8_t byte, bool i386) {
  // An 8088 ignores bit 4 of 60h to 6Fh and bit 1 of C0h, C1h, C8h and C9h, so it executes them as
  // jumps and returns.
  const bool alias = is_between(byte, 0x60, 0x6F) || (byte & 0xF6U) == 0xC0U;
  return is_between(byte, 0x70, 0x7F) || byte == 0x9A || (byte & 0xF6U) == 0xC2U ||
         is_between(byte, 0xCC, 0xCF) || is_between(byte, 0xE0, 0xE3) ||
         is_between(byte, 0xE8, 0xEB) || (!i386 && alias);
}

bool is_stack(std::uint8_t byte) { return is_between(byte, 0x50, 0x5F) || byte == 0x8F; }

struct ModRm {
  unsigned mod;
  unsigned reg;
  unsigned rm;
};

class Decoder {
 public:
  Decoder(std::span<const std::uint8_t> bytes, x86::Target cpu)
      : bytes_(bytes), i386_(cpu == x86::Target::i386) {}

  std::variant<Decoded, Skip> decode() {
    std::uint8_t opcode = next();
    if (i386_ && opcode == 0x66) {
      size_ = Size::dword;
      opcode = next();
    }
    if (is_prefix(opcode, i386_)) return Skip::prefix;
    if (is_control_flow(opcode, i386_)) return Skip::control_flow;
    if (is_stack(opcode)) return Skip::memory_operand;
    const Result result = i386_ && opcode == 0x0F ? two_bytes(next()) : one_byte(opcode);
    if (const Skip* reason = std::get_if<Skip>(&result)) return *reason;
    return Decoded{std::get<x86::Instruction>(result), position_};
  }

 private:
  using Result = std::variant<x86::Instruction, Skip>;

  std::uint8_t next() {
    if (position_ == bytes_.size())
      throw support::UsageError("bytes end before the instruction does");
    return bytes_[position_++];
  }
  ModRm modrm() {
    const unsigned byte = next();
    return {byte >> 6U, byte >> 3U & 7U, byte & 7U};
  }
  [[nodiscard]] Operand reg(unsigned number) const {
    return {.kind = Operand::Kind::reg, .size = size_, .reg = static_cast<x86::Register>(number)};
  }
  static Operand immediate(std::uint32_t value) {
    return {.kind = Operand::Kind::immediate, .value = static_cast<std::int32_t>(value)};
  }
  /// An 8-bit immediate: zero-extended in count(), sign-extended in signed_byte().
  Operand count() { return immediate(next()); }
  Operand signed_byte() {
    const std::uint32_t byte = next();
    return immediate((byte ^ 0x80U) - 0x80U);
  }
  Operand whole() {
    std::uint32_t value = 0;
    for (int bits = 0; bits < (size_ == Size::word ? 16 : 32); bits += 8) {
      value |= std::uint32_t{next()} << bits;
    }
    return immediate(value);
  }

  /// The reason why `op` with an r/m operand cannot run, if there is one.
  static std::optional<Skip> refused(std::optional<Mnemonic> op, bool bytes, const ModRm& m) {
    if (!op) return Skip::not_modelled;
    if (bytes) return Skip::byte_operand;
    if (m.mod != 3) return Skip::memory_operand;
    return std::nullopt;
  }

  /// `op` on the r/m operand and on the operand that `second` reads after it.
  template <class Second>
  Result on_rm(std::optional<Mnemonic> op, bool bytes, const ModRm& m, Second second) {
    if (const auto reason = refused(op, bytes, m)) return *reason;
    return x86::Instruction{.mnemonic = *op, .operands = {reg(m.rm), second()}};
  }

  /// Opcodes 00h to 3Fh other than prefixes.
  Result arithmetic_of(std::uint8_t opcode) {
    const auto op = arithmetic[opcode >> 3U];
    const unsigned way = opcode & 7U;
    if (way > 5 || !op) return Skip::not_modelled;
    if (way == 4) return Skip::byte_operand;
    if (way == 5) return x86::Instruction{.mnemonic = *op, .operands = {reg(0), whole()}};
    const ModRm m = modrm();
    return register_and_rm(*op, opcode, m);
  }

  /// Bit 0 of the opcode selects words. Bit 1 puts the register first.
  Result register_and_rm(Mnemonic op, unsigned opcode, const ModRm& m) {
    if (const auto reason = refused(op, (opcode & 1U) == 0, m)) return *reason;
    x86::Instruction result{.mnemonic = op, .operands = {reg(m.rm), reg(m.reg)}};
    if ((opcode & 2U) != 0) std::swap(result.operands[0], result.operands[1]);
    return result;
  }

  Result one_byte(std::uint8_t opcode) {
    if (opcode < 0x40) return arithmetic_of(opcode);
    if (is_between(opcode, 0x40, 0x4F)) {
      const Mnemonic op = opcode < 0x48 ? Mnemonic::inc : Mnemonic::dec;
      return x86::Instruction{.mnemonic = op, .operands = {reg(opcode & 7U)}};
    }
    if (is_between(opcode, 0xB0, 0xB7)) return Skip::byte_operand;
    if (is_between(opcode, 0xB8, 0xBF)) {
      return x86::Instruction{.mnemonic = Mnemonic::mov, .operands = {reg(opcode & 7U), whole()}};
    }
    if (is_between(opcode, 0xA0, 0xA3)) {
      return (opcode & 1U) == 0 ? Skip::byte_operand : Skip::memory_operand;
    }
    return with_modrm(opcode);
  }

  /// The opcodes with a ModR/M byte. Bit 0 selects words.
  Result with_modrm(std::uint8_t opcode) {
    const bool bytes = (opcode & 1U) == 0;
    switch (opcode) {
      case 0x80:
      case 0x81:
      case 0x82:
      case 0x83: {
        const ModRm m = modrm();
        return on_rm(arithmetic[m.reg], bytes, m,
                     [&] { return opcode == 0x81 ? whole() : signed_byte(); });
      }
      case 0x88:
      case 0x8A: {
        const ModRm m = modrm();
        if (m.mod != 3) return Skip::byte_operand;
        size_ = Size::byte;
        return register_and_rm(Mnemonic::mov, opcode | 1U, m);
      }
      case 0x89:
      case 0x8B:
        return register_and_rm(Mnemonic::mov, opcode, modrm());
      case 0xC0:
      case 0xC1: {
        const ModRm m = modrm();
        return on_rm(shifts[m.reg], bytes, m, [&] { return count(); });
      }
      case 0xC6:
      case 0xC7: {
        const ModRm m = modrm();
        return on_rm(group_c7[m.reg], bytes, m, [&] { return whole(); });
      }
      case 0xD0:
      case 0xD1: {
        const ModRm m = modrm();
        return on_rm(shifts[m.reg], bytes, m, [] { return immediate(1); });
      }
      case 0xF6:
      case 0xF7: {
        const ModRm m = modrm();
        return on_rm(group_f7[m.reg], bytes, m, [] { return Operand{}; });
      }
      case 0xFE:
      case 0xFF: {
        const ModRm m = modrm();
        if (opcode == 0xFF && m.reg >= 2 && m.reg <= 5) return Skip::control_flow;
        if (opcode == 0xFF && m.reg == 6) return Skip::memory_operand;
        return on_rm(group_ff[m.reg], bytes, m, [] { return Operand{}; });
      }
      default:
        return Skip::not_modelled;
    }
  }

  /// The two-byte opcodes of the 386, after 0Fh.
  Result two_bytes(std::uint8_t opcode) {
    if (is_between(opcode, 0x80, 0x8F)) return Skip::control_flow;
    if (opcode != 0xA4 && opcode != 0xAC) return Skip::not_modelled;
    const Mnemonic op = opcode == 0xA4 ? Mnemonic::shld : Mnemonic::shrd;
    const ModRm m = modrm();
    if (const auto reason = refused(op, false, m)) return *reason;
    return x86::Instruction{.mnemonic = op, .operands = {reg(m.rm), reg(m.reg), count()}};
  }

  std::span<const std::uint8_t> bytes_;
  bool i386_;
  Size size_ = Size::word;
  std::size_t position_ = 0;
};

}  // namespace

std::string_view name_of(Skip reason) {
  static constexpr std::array<std::string_view, skip_count> names{
      "prefix", "control flow", "not modelled", "8-bit operand", "memory operand"};
  return names.at(static_cast<std::size_t>(reason));
}

std::variant<Decoded, Skip> decode(std::span<const std::uint8_t> bytes, x86::Target cpu) {
  const auto decoded = Decoder(bytes, cpu).decode();
  const Decoded* whole = std::get_if<Decoded>(&decoded);
  if (whole != nullptr && !x86::is_modelled(whole->instruction, cpu)) return Skip::not_modelled;
  return decoded;
}

}  // namespace fixproof::singlestep
