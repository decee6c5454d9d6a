#include "x86model/decode.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "x86model/forms.hpp"
#include "x86model/instruction_table.hpp"

namespace x86model {

namespace {

struct ModRm {
  unsigned mod;
  unsigned reg;
  unsigned rm;
};

class Decoder {
 public:
  Decoder(std::span<const std::uint8_t> bytes, Cpu cpu) : bytes_(bytes), cpu_(cpu) {}

  /// Decodes until something is no part of the model. Reading goes on with zeros after the end.
  std::variant<Decoded, Undecoded> decode() {
    const auto opcode = after_prefixes();
    if (!opcode) return Undecoded::prefix;
    const std::optional<Instruction> decoded = instruction(*opcode);
    if (position_ > bytes_.size()) return Undecoded::cut_off;
    if (!decoded) return is_addressing_unknown_ ? Undecoded::addressing : Undecoded::form;
    if (!uses_prefixes(*decoded)) return Undecoded::prefix;
    // Only since the 286 does PUSH SP store the value that SP had before.
    const Operand& first = decoded->operands[0];
    if (cpu_ == Cpu::i8088 && decoded->mnemonic == Mnemonic::push &&
        first.kind == Operand::Kind::reg && first.reg == Register::sp) {
      return Undecoded::form;
    }
    // The 286 has the 8088's forms and the 386's in words; the encodings of others are refused.
    const auto target = cpu_ == Cpu::i8088 ? Target::i8088 : Target::i386;
    if (!is_modelled(*decoded, target)) return Undecoded::form;
    return Decoded{*decoded, position_};
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
  [[nodiscard]] bool uses_prefixes(const Instruction& instruction) const {
    const auto any = [&](auto has) {
      return std::any_of(instruction.operands.begin(), instruction.operands.end(), has);
    };
    const bool memory = any([](const Operand& o) { return o.kind == Operand::Kind::memory; });
    const bool dword = any([](const Operand& o) { return o.size == Size::dword; });
    return (memory || (!code_segment_ && !long_address_)) && (dword || size_ != Size::dword);
  }

  std::uint8_t next() {
    const std::size_t at = position_++;
    return at < bytes_.size() ? bytes_[at] : std::uint8_t{0};
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

  [[nodiscard]] Operand reg(unsigned number) const {
    return {.kind = Operand::Kind::reg, .size = size_, .reg = static_cast<Register>(number)};
  }
  static Operand immediate(std::int32_t value) {
    return {.kind = Operand::Kind::immediate, .value = value};
  }
  Operand count() { return immediate(next()); }
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
            .segment = code_segment_ ? SegmentOverride::cs : SegmentOverride::none,
            .reg = static_cast<Register>(base),
            .value = displacement};
  }

  /// The operand of mod and rm; nothing if its addressing is in no listing.
  std::optional<Operand> rm(const ModRm& m) {
    if (m.mod == 3) return reg(m.rm);
    return long_address_ ? long_memory(m) : short_memory(m);
  }
  std::optional<Operand> short_memory(const ModRm& m) {
    constexpr std::array bases{Register::si, Register::di, Register::bp, Register::bx};
    if (m.mod == 0 && m.rm == 6) return direct();
    if (m.rm < 4) return std::nullopt;
    const std::int32_t displacement =
        m.mod == 0 ? 0 : signed_number(m.mod == 1 ? Size::byte : Size::word);
    return memory(Addressing::base, static_cast<unsigned>(bases.at(m.rm - 4)), displacement);
  }
  std::optional<Operand> long_memory(const ModRm& m) {
    if (m.rm == 4) {
      const ModRm sib = mod_rm();
      if (m.mod != 0 || sib.mod != 1 || sib.reg == 4 || sib.rm != 5) return std::nullopt;
      return memory(Addressing::index_twice, sib.reg, signed_number(Size::dword));
    }
    if (m.mod == 0 && m.rm == 5) return std::nullopt;
    const std::int32_t displacement =
        m.mod == 0 ? 0 : signed_number(m.mod == 1 ? Size::byte : Size::dword);
    return memory(Addressing::index, m.rm, displacement);
  }
  std::optional<Operand> direct() {
    if (long_address_) return std::nullopt;
    return memory(Addressing::direct, 0, static_cast<std::int32_t>(number(Size::word)));
  }
  ModRm mod_rm() {
    const unsigned byte = next();
    return {byte >> 6U, byte >> 3U & 7U, byte & 7U};
  }

  [[nodiscard]] bool has_opcode(const EncodingRow& row, std::uint8_t opcode) const {
    if (row.since > cpu_) return false;
    if (has_bytes(row.operands)) return row.opcode == (opcode & 0xFEU);
    if (row.operands == Encoded::r) return row.opcode == (opcode & 0xF8U);
    return row.opcode == opcode;
  }

  std::optional<Instruction> instruction(std::uint8_t opcode) {
    const bool follows_0f = opcode == 0x0F && i386();
    if (follows_0f) opcode = next();
    ModRm m{};
    bool has_read_mod_rm = false;
    for (const EncodingRow& row : encoding_rows) {
      if (row.follows_0f != follows_0f || !has_opcode(row, opcode)) continue;
      if (has_mod_rm(row.operands) && !std::exchange(has_read_mod_rm, true)) m = mod_rm();
      if (has_digit(row.operands) && row.digit != m.reg) continue;
      if (has_bytes(row.operands) && (opcode & 1U) == 0) size_ = Size::byte;
      Instruction decoded{.mnemonic = row.mnemonic};
      is_addressing_unknown_ = !read_operands(row.operands, opcode, m, decoded.operands);
      if (is_addressing_unknown_) return std::nullopt;
      return decoded;
    }
    return std::nullopt;
  }

  /// @return whether their addressing is in a listing
  bool read_operands(Encoded encoded, std::uint8_t opcode, const ModRm& m,
                     std::array<Operand, 3>& operands) {
    auto& [a, b, c] = operands;
    std::optional<Operand> place = Operand{};
    if (has_mod_rm(encoded)) place = rm(m);
    if (encoded == Encoded::a_offset || encoded == Encoded::offset_a) place = direct();
    if (!place) return false;
    a = *place;
    switch (encoded) {
      case Encoded::nothing:
      case Encoded::rm:
      case Encoded::rm_of_words:
        break;
      case Encoded::rm_r:
        b = reg(m.reg);
        break;
      case Encoded::r_rm:
        b = std::exchange(a, reg(m.reg));
        break;
      case Encoded::rm_r_count:
        b = reg(m.reg);
        c = count();
        break;
      case Encoded::rm_1:
        b = immediate(1);
        break;
      case Encoded::rm_count:
        b = count();
        break;
      case Encoded::rm_imm8:
        b = immediate(signed_number(Size::byte));
        break;
      case Encoded::rm_imm:
        b = whole();
        break;
      case Encoded::a_imm:
        a = reg(0);
        b = whole();
        break;
      case Encoded::a_offset:
        b = std::exchange(a, reg(0));
        break;
      case Encoded::offset_a:
        b = reg(0);
        break;
      case Encoded::r:
        a = reg(opcode & 7U);
        break;
      case Encoded::rel8:
        a = label(Size::byte);
        break;
      case Encoded::rel16:
        a = label(Size::word);
        break;
    }
    return true;
  }

  std::span<const std::uint8_t> bytes_;
  Cpu cpu_;
  Size size_ = Size::word;
  bool code_segment_ = false;
  bool long_address_ = false;
  bool is_addressing_unknown_ = false;
  std::size_t position_ = 0;
};

}  // namespace

std::variant<Decoded, Undecoded> decode(std::span<const std::uint8_t> bytes, Cpu cpu) {
  return Decoder(bytes, cpu).decode();
}

}  // namespace x86model
