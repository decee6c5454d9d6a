#include "verify/singlestep/decode.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "support/usage_error.hpp"
#include "x86model/forms.hpp"

namespace fixproof::singlestep {

namespace {

namespace x86 = x86model;
using x86::Addressing;
using x86::Cpu;
using x86::Mnemonic;
using x86::Operand;
using x86::Register;
using x86::Size;

/// The mnemonics that a three-bit field selects; empty if no listing uses the instruction.
using Group = std::array<std::optional<Mnemonic>, 8>;
constexpr std::nullopt_t no = std::nullopt;
constexpr Group arithmetic{
    Mnemonic::add,  no,           Mnemonic::adc, Mnemonic::sbb, Mnemonic::and_, Mnemonic::sub,
    Mnemonic::xor_, Mnemonic::cmp};
constexpr Group shifts{Mnemonic::rol, no, no, no, Mnemonic::shl, Mnemonic::shr, no, Mnemonic::sar};
constexpr Group group_8f{Mnemonic::pop, no, no, no, no, no, no, no};
constexpr Group group_f7{
    no, no, no, Mnemonic::neg, Mnemonic::mul, Mnemonic::imul, Mnemonic::div, Mnemonic::idiv};
constexpr Group group_ff{
    Mnemonic::inc, Mnemonic::dec, no, no, Mnemonic::jmp, no, Mnemonic::push, no};

bool is_between(std::uint8_t byte, int first, int last) { return byte >= first && byte <= last; }

std::optional<Mnemonic> conditional_jump(std::uint8_t opcode) {
  switch (opcode) {
    case 0x74:
      return Mnemonic::jz;
    case 0x75:
      return Mnemonic::jnz;
    case 0x77:
      return Mnemonic::ja;
    case 0x78:
      return Mnemonic::js;
    case 0x79:
      return Mnemonic::jns;
    case 0x7F:
      return Mnemonic::jg;
    default:
      return std::nullopt;
  }
}

struct ModRm {
  unsigned mod;
  unsigned reg;
  unsigned rm;
};

class Decoder {
 public:
  Decoder(std::span<const std::uint8_t> bytes, Cpu cpu) : bytes_(bytes), cpu_(cpu) {}

  std::variant<Decoded, Skip> decode() {
    const auto opcode = after_prefixes();
    if (!opcode) return Skip::prefix;
    const x86::Instruction instruction = one_byte(*opcode);
    if (skip_) return *skip_;
    if (!uses_prefixes(instruction)) return Skip::prefix;
    // Only since the 286 does PUSH SP store the value that SP had before.
    const Operand& first = instruction.operands[0];
    if (cpu_ == Cpu::i8088 && instruction.mnemonic == Mnemonic::push &&
        first.kind == Operand::Kind::reg && first.reg == Register::sp) {
      return Skip::form;
    }
    // The 286 has the 8088's forms and the 386's in words; the opcodes of the others are refused.
    const auto target = cpu_ == Cpu::i8088 ? x86::Target::i8088 : x86::Target::i386;
    if (!x86::is_modelled(instruction, target)) return Skip::form;
    return Decoded{instruction, position_};
  }

 private:
  [[nodiscard]] bool i386() const { return cpu_ >= Cpu::i386; }

  /// The opcode after CS:, 66h and 67h, each at most once; nothing after another prefix.
  std::optional<std::uint8_t> after_prefixes() {
    while (true) {
      const std::uint8_t byte = next();
      switch (byte) {
        case 0x2E:
          if (std::exchange(code_segment_, true)) return std::nullopt;
          break;
        case 0x66:
          if (!i386()) return byte;
          if (std::exchange(size_, Size::dword) == Size::dword) return std::nullopt;
          break;
        case 0x67:
          if (!i386()) return byte;
          if (std::exchange(long_address_, true)) return std::nullopt;
          break;
        case 0x26:
        case 0x36:
        case 0x3E:
        case 0xF0:
        case 0xF2:
        case 0xF3:
          return std::nullopt;
        case 0x64:
        case 0x65:
          if (i386()) return std::nullopt;
          return byte;
        case 0xF1:  // LOCK again on an 8088, another instruction later
          if (cpu_ == Cpu::i8088) return std::nullopt;
          return byte;
        default:
          return byte;
      }
    }
  }

  /// Whether each prefix applies to an operand.
  [[nodiscard]] bool uses_prefixes(const x86::Instruction& instruction) const {
    const auto any = [&](auto has) {
      return std::any_of(instruction.operands.begin(), instruction.operands.end(), has);
    };
    const bool memory = any([](const Operand& o) { return o.kind == Operand::Kind::memory; });
    const bool dword = any([](const Operand& o) { return o.size == Size::dword; });
    return (memory || (!code_segment_ && !long_address_)) && (dword || size_ != Size::dword);
  }

  x86::Instruction refuse(Skip reason) {
    skip_ = reason;
    return {};
  }
  x86::Instruction row(std::optional<Mnemonic> op, const Operand& first = {},
                       const Operand& second = {}, const Operand& third = {}) {
    if (!op) return refuse(Skip::form);
    return {.mnemonic = *op, .operands = {first, second, third}};
  }

  std::uint8_t next() {
    if (position_ == bytes_.size())
      throw support::UsageError("bytes end before the instruction does");
    return bytes_[position_++];
  }
  std::uint32_t number(Size size) {
    std::uint32_t value = next();
    if (size != Size::byte) value |= std::uint32_t{next()} << 8U;
    if (size == Size::dword) value |= number(Size::word) << 16U;
    return value;
  }
  std::int32_t signed_number(Size size) {
    const std::uint32_t value = number(size);
    if (size == Size::byte) return static_cast<std::int8_t>(value);
    if (size == Size::word) return static_cast<std::int16_t>(value);
    return static_cast<std::int32_t>(value);
  }
  ModRm modrm() {
    const unsigned byte = next();
    return {byte >> 6U, byte >> 3U & 7U, byte & 7U};
  }

  [[nodiscard]] Operand reg(unsigned number) const {
    return {.kind = Operand::Kind::reg, .size = size_, .reg = static_cast<Register>(number)};
  }
  static Operand immediate(std::int32_t value) {
    return {.kind = Operand::Kind::immediate, .value = value};
  }
  /// The immediate of the operand's size.
  Operand whole() { return immediate(static_cast<std::int32_t>(number(size_))); }
  Operand label(Size size) {
    return {.kind = Operand::Kind::label,
            .size = size == Size::byte ? Size::none : size,
            .value = signed_number(size)};
  }
  [[nodiscard]] Operand memory(Addressing addressing, unsigned base,
                               std::int32_t displacement) const {
    return {.kind = Operand::Kind::memory,
            .size = size_,
            .addressing = addressing,
            .segment = code_segment_ ? x86::SegmentOverride::cs : x86::SegmentOverride::none,
            .reg = static_cast<Register>(base),
            .value = displacement};
  }

  Operand rm(const ModRm& m) {
    if (m.mod == 3) return reg(m.rm);
    return long_address_ ? long_memory(m) : short_memory(m);
  }
  Operand short_memory(const ModRm& m) {
    constexpr std::array bases{Register::si, Register::di, Register::bp, Register::bx};
    if (m.mod == 0 && m.rm == 6) return direct();
    if (m.rm < 4) {
      refuse(Skip::addressing);
      return {};
    }
    const std::int32_t displacement =
        m.mod == 0 ? 0 : signed_number(m.mod == 1 ? Size::byte : Size::word);
    return memory(Addressing::base, static_cast<unsigned>(bases.at(m.rm - 4)), displacement);
  }
  Operand long_memory(const ModRm& m) {
    if (m.rm == 4) {
      const ModRm sib = modrm();
      if (m.mod == 0 && sib.mod == 1 && sib.reg != 4 && sib.rm == 5) {
        return memory(Addressing::index_twice, sib.reg, signed_number(Size::dword));
      }
    } else if (m.mod != 0 || m.rm != 5) {
      const std::int32_t displacement =
          m.mod == 0 ? 0 : signed_number(m.mod == 1 ? Size::byte : Size::dword);
      return memory(Addressing::index, m.rm, displacement);
    }
    refuse(Skip::addressing);
    return {};
  }
  Operand direct() {
    return memory(Addressing::direct, 0, static_cast<std::int32_t>(number(Size::word)));
  }

  /// Bit 0 of most opcodes selects words or, with 66h, doublewords.
  void choose_size(std::uint8_t opcode) {
    if ((opcode & 1U) == 0) size_ = Size::byte;
  }

  /// Bit 1 of the opcode puts the register first.
  x86::Instruction register_and_rm(std::optional<Mnemonic> op, std::uint8_t opcode) {
    choose_size(opcode);
    const ModRm m = modrm();
    const Operand other = rm(m);
    return (opcode & 2U) != 0 ? row(op, reg(m.reg), other) : row(op, other, reg(m.reg));
  }

  x86::Instruction group(const Group& mnemonics, std::uint8_t opcode) {
    choose_size(opcode);
    const ModRm m = modrm();
    // The published bytes of an invalid instruction end here.
    if (!mnemonics.at(m.reg)) return refuse(Skip::form);
    return row(mnemonics.at(m.reg), rm(m));
  }

  x86::Instruction one_byte(std::uint8_t opcode) {
    const unsigned low = opcode & 7U;
    if (opcode < 0x40 && low < 4) return register_and_rm(arithmetic.at(opcode >> 3U), opcode);
    if (opcode < 0x40 && low < 6) {
      choose_size(opcode);
      return row(arithmetic.at(opcode >> 3U), reg(0), whole());
    }
    if (is_between(opcode, 0x40, 0x47)) return row(Mnemonic::inc, reg(low));
    if (is_between(opcode, 0x48, 0x4F)) return row(Mnemonic::dec, reg(low));
    if (is_between(opcode, 0x50, 0x57)) return row(Mnemonic::push, reg(low));
    if (is_between(opcode, 0x58, 0x5F)) return row(Mnemonic::pop, reg(low));
    if (is_between(opcode, 0x70, 0x7F)) return row(conditional_jump(opcode), label(Size::byte));
    return irregular(opcode);
  }

  x86::Instruction irregular(std::uint8_t opcode) {
    switch (opcode) {
      case 0x0F:
        return i386() ? two_bytes(next()) : refuse(Skip::form);
      case 0x80:
      case 0x81:
      case 0x83: {
        auto result = group(arithmetic, opcode);
        if (skip_) return result;
        result.operands[1] = opcode == 0x81 ? whole() : immediate(signed_number(Size::byte));
        return result;
      }
      case 0x88:
      case 0x89:
      case 0x8A:
      case 0x8B:
        return register_and_rm(Mnemonic::mov, opcode);
      case 0x8F:
        return group(group_8f, opcode);
      case 0xA0:
      case 0xA1:
      case 0xA2:
      case 0xA3: {
        choose_size(opcode);
        if (long_address_) return refuse(Skip::addressing);
        const Operand place = direct();
        return opcode < 0xA2 ? row(Mnemonic::mov, reg(0), place)
                             : row(Mnemonic::mov, place, reg(0));
      }
      case 0xAA:
        return row(Mnemonic::stosb);
      case 0xAB:
        return row(Mnemonic::stosw);
      case 0xC0:
      case 0xC1: {
        if (cpu_ == Cpu::i8088) return refuse(Skip::form);
        auto result = group(shifts, opcode);
        if (!skip_) result.operands[1] = immediate(next());
        return result;
      }
      case 0xC3:
        return row(Mnemonic::ret);
      case 0xD0:
      case 0xD1: {
        auto result = group(shifts, opcode);
        result.operands[1] = immediate(1);
        return result;
      }
      case 0xE2:
        return row(Mnemonic::loop, label(Size::byte));
      case 0xE8:
        return row(Mnemonic::call, label(Size::word));
      case 0xE9:
        return row(Mnemonic::jmp, label(Size::word));
      case 0xEB:
        return row(Mnemonic::jmp, label(Size::byte));
      case 0xF6:
      case 0xF7:
        return group(group_f7, opcode);
      case 0xFE:
      case 0xFF:
        return group(group_ff, opcode);
      default:
        return refuse(Skip::form);
    }
  }

  /// The two-byte opcodes of the 386, after 0Fh.
  x86::Instruction two_bytes(std::uint8_t opcode) {
    if (opcode != 0xA4 && opcode != 0xAC) return refuse(Skip::form);
    const ModRm m = modrm();
    const Operand first = rm(m);
    if (skip_) return {};
    return row(opcode == 0xA4 ? Mnemonic::shld : Mnemonic::shrd, first, reg(m.reg),
               immediate(next()));
  }

  std::span<const std::uint8_t> bytes_;
  Cpu cpu_;
  Size size_ = Size::word;
  bool code_segment_ = false;
  bool long_address_ = false;
  std::optional<Skip> skip_;
  std::size_t position_ = 0;
};

}  // namespace

std::string_view name_of(Skip reason) {
  static constexpr std::array<std::string_view, skip_count> names{
      "prefix in no listing", "form in no listing", "addressing in no listing",
      "direction flag set", "end of a segment"};
  return names.at(static_cast<std::size_t>(reason));
}

std::variant<Decoded, Skip> decode(std::span<const std::uint8_t> bytes, Cpu cpu) {
  return Decoder(bytes, cpu).decode();
}

}  // namespace fixproof::singlestep
