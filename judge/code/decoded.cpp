#include "judge/code/decoded.hpp"

#include <Zydis/Zydis.h>

#include <algorithm>
#include <array>

#include "x86model/flags.hpp"

namespace fixproof::judge {

namespace {

using x86model::Register;
using x86model::Size;

// Flags have the bits of the FLAGS register here and in Zydis.
static_assert(ZYDIS_CPUFLAG_CF == x86model::CF && ZYDIS_CPUFLAG_OF == x86model::OF);

using Operands = std::array<ZydisDecodedOperand, ZYDIS_MAX_OPERAND_COUNT>;

std::optional<RegisterName> name_of(ZydisRegister reg) {
  const char* const name = ZydisRegisterGetString(reg);
  return name == nullptr ? std::nullopt : register_named(name);
}

bool is_segment(ZydisRegister reg) { return ZydisRegisterGetClass(reg) == ZYDIS_REGCLASS_SEGMENT; }

Operand memory_operand(const ZydisDecodedOperand& from, int address_bits) {
  Operand to{.kind = Operand::Kind::memory,
             .value = static_cast<std::uint64_t>(from.mem.disp.value),
             .address_bits = address_bits};
  for (const ZydisRegister reg : {from.mem.base, from.mem.index}) {
    if (reg == ZYDIS_REGISTER_NONE) continue;
    const auto base = name_of(reg);
    if (!base) return {};
    to.bases.push_back(*base);
  }
  if (from.mem.index != ZYDIS_REGISTER_NONE) to.scale = from.mem.scale;
  return to;
}

/// Memory at a distance from the next instruction.
Operand relative_operand(const ZydisDecodedInstruction& i, const ZydisDecodedOperand& from,
                         std::uint32_t at) {
  ZyanU64 address = 0;
  ZydisCalcAbsoluteAddress(&i, &from, at, &address);
  return {.kind = Operand::Kind::memory, .value = address, .address_bits = i.address_width};
}

Operand operand_of(const ZydisDecodedInstruction& i, const ZydisDecodedOperand& from,
                   std::uint32_t at) {
  Operand to;
  switch (from.type) {
    case ZYDIS_OPERAND_TYPE_REGISTER:
      if (const auto reg = name_of(from.reg.value)) {
        to.kind = Operand::Kind::reg;
        to.reg = *reg;
      } else if (is_segment(from.reg.value)) {
        to.kind = Operand::Kind::segment;
      }
      break;
    case ZYDIS_OPERAND_TYPE_MEMORY:
      to = from.mem.base == ZYDIS_REGISTER_RIP ? relative_operand(i, from, at)
                                               : memory_operand(from, i.address_width);
      break;
    case ZYDIS_OPERAND_TYPE_IMMEDIATE:
      to.kind = Operand::Kind::immediate;
      to.value = from.imm.value.u;
      break;
    default:
      break;
  }
  to.bits = from.size;
  return to;
}

/// AH to BH count as parts of AX to BX.
unsigned bit_of(const RegisterName& reg) { return 1U << reg.holder(); }

unsigned registers_written(const ZydisDecodedInstruction& i, const Operands& operands) {
  unsigned written = 0;
  constexpr unsigned sp = 1U << static_cast<unsigned>(Register::sp);
  for (std::size_t n = 0; n < i.operand_count; ++n) {
    const ZydisDecodedOperand& o = operands.at(n);
    const bool is_hidden = o.visibility == ZYDIS_OPERAND_VISIBILITY_HIDDEN;
    if (o.type == ZYDIS_OPERAND_TYPE_REGISTER &&
        (o.actions & ZYDIS_OPERAND_ACTION_MASK_WRITE) != 0) {
      const auto reg = name_of(o.reg.value);
      if (reg && !(is_hidden && bit_of(*reg) == sp)) written |= bit_of(*reg);
    }
    // A string instruction advances the registers of its addresses.
    if (o.type == ZYDIS_OPERAND_TYPE_MEMORY && is_hidden &&
        i.meta.category == ZYDIS_CATEGORY_STRINGOP) {
      if (const auto reg = name_of(o.mem.base)) written |= bit_of(*reg);
    }
  }
  return written;
}

x86model::FlagUse flag_effects(const ZydisDecodedInstruction& i, const Operands& operands) {
  if (i.cpu_flags == nullptr) return {};
  const auto arithmetic = [](ZydisAccessedFlagsMask flags) {
    return static_cast<std::uint16_t>(flags & x86model::arithmetic_flags);
  };
  const ZydisAccessedFlags& all = *i.cpu_flags;
  x86model::FlagUse effects{.reads = arithmetic(all.tested),
                            .sets = arithmetic(all.modified | all.set_0 | all.set_1),
                            .leaves_undefined = arithmetic(all.undefined)};
  // REPE and REPNE read only the ZF that the comparison before has set. PUSHF and LAHF copy flags,
  // undefined ones too, and decide nothing by them.
  const bool copies = i.mnemonic == ZYDIS_MNEMONIC_PUSHF || i.mnemonic == ZYDIS_MNEMONIC_PUSHFD ||
                      i.mnemonic == ZYDIS_MNEMONIC_LAHF;
  if (copies || i.meta.category == ZYDIS_CATEGORY_STRINGOP) effects.reads = 0;
  // Zydis 4 has AF as undefined after SBB, unlike Intel's manual and itself after SUB.
  if (i.mnemonic == ZYDIS_MNEMONIC_SBB) effects = {effects.reads, x86model::arithmetic_flags, 0};
  // Zydis has OF as undefined for all counts; Intel defines it for a count of one.
  const bool shifts =
      i.meta.category == ZYDIS_CATEGORY_SHIFT || i.meta.category == ZYDIS_CATEGORY_ROTATE;
  if (shifts && i.operand_count_visible > 1) {
    const ZydisDecodedOperand& count = operands.at(i.operand_count_visible - 1U);
    if (count.type == ZYDIS_OPERAND_TYPE_IMMEDIATE && count.imm.value.u == 1) {
      effects.sets |= x86model::OF;
      effects.leaves_undefined &= static_cast<std::uint16_t>(~x86model::OF);
    }
  }
  return effects;
}

void note_prefixes(const ZydisDecodedInstruction& i, Decoded& to) {
  to.prefixes = i.raw.prefix_count;
  for (std::size_t n = 0; n < i.raw.prefix_count; ++n) {
    const std::uint8_t byte = i.raw.prefixes[n].value;
    // TZCNT, LZCNT and POPCNT have such a byte as a part of their opcode.
    const bool is_of_opcode = i.raw.prefixes[n].type == ZYDIS_PREFIX_TYPE_MANDATORY;
    to.has_repeat |= !is_of_opcode && (byte == 0xF2 || byte == 0xF3);
    to.overrides_segment |= (byte & 0xE7U) == 0x26 || byte == 0x64 || byte == 0x65;
    to.needs_386 |= byte >= 0x64 && byte <= 0x67;
  }
}

/// The components of the 386 manual, 17.2.2.3: every byte, but a displacement or immediate as one.
int components_of(const ZydisDecodedInstruction& i) {
  const int opcode = i.opcode_map == ZYDIS_OPCODE_MAP_DEFAULT ? 1
                     : i.opcode_map == ZYDIS_OPCODE_MAP_0F    ? 2
                                                              : 3;
  return i.raw.prefix_count + opcode + ((i.attributes & ZYDIS_ATTRIB_HAS_MODRM) != 0 ? 1 : 0) +
         ((i.attributes & ZYDIS_ATTRIB_HAS_SIB) != 0 ? 1 : 0) + (i.raw.disp.size > 0 ? 1 : 0) +
         (i.raw.imm[0].size > 0 ? 1 : 0);
}

/// The condition that the low half of the opcode encodes.
std::optional<x86model::alu::ConditionCode> condition_of(const ZydisDecodedInstruction& i) {
  const unsigned row = i.opcode >> 4U;
  const bool has_condition =
      i.opcode_map == ZYDIS_OPCODE_MAP_DEFAULT
          ? row == 7
          : i.opcode_map == ZYDIS_OPCODE_MAP_0F && (row == 4 || row == 8 || row == 9);
  if (!has_condition) return std::nullopt;
  return static_cast<x86model::alu::ConditionCode>(i.opcode & 0xFU);
}

bool uses_accumulator(const ZydisDecodedInstruction& i) {
  const std::uint8_t opcode = i.opcode;
  return i.opcode_map == ZYDIS_OPCODE_MAP_DEFAULT &&
         ((opcode >= 0xA0 && opcode <= 0xA3) || (opcode < 0x40 && (opcode & 6U) == 4) ||
          (opcode & 0xFEU) == 0xA8 || (opcode > 0x90 && opcode < 0x98));
}

bool is_privileged(const ZydisDecodedInstruction& i) {
  // Zydis does not count these. A system of 64 bits lets no program use CLI and STI, though IOPL
  // could.
  const bool is_missing = i.mnemonic == ZYDIS_MNEMONIC_CLI || i.mnemonic == ZYDIS_MNEMONIC_STI ||
                          i.mnemonic == ZYDIS_MNEMONIC_LGDT;
  return is_missing || (i.attributes & ZYDIS_ATTRIB_IS_PRIVILEGED) != 0;
}

std::string mnemonic_of(const ZydisDecodedInstruction& i) {
  std::string name = ZydisMnemonicGetString(i.mnemonic);
  if (name == "ret" && i.meta.branch_type == ZYDIS_BRANCH_TYPE_FAR) name += 'f';
  return name;
}

}  // namespace

Decoded decoded(std::span<const std::uint8_t> bytes, std::uint32_t at, int bits) {
  ZydisDecoder decoder;
  ZydisDecoderInit(&decoder,
                   bits == 16   ? ZYDIS_MACHINE_MODE_REAL_16
                   : bits == 32 ? ZYDIS_MACHINE_MODE_LEGACY_32
                                : ZYDIS_MACHINE_MODE_LONG_64,
                   bits == 16   ? ZYDIS_STACK_WIDTH_16
                   : bits == 32 ? ZYDIS_STACK_WIDTH_32
                                : ZYDIS_STACK_WIDTH_64);
  ZydisDecodedInstruction i{};
  Operands operands{};
  Decoded result;
  if (!ZYAN_SUCCESS(
          ZydisDecoderDecodeFull(&decoder, bytes.data(), bytes.size(), &i, operands.data()))) {
    return result;
  }
  result.mnemonic = mnemonic_of(i);
  result.bytes = i.length;
  result.width = i.operand_width;
  result.opcode = i.opcode;
  result.condition = condition_of(i);
  result.components = components_of(i);
  result.uses_accumulator = uses_accumulator(i);
  result.has_displacement = i.raw.disp.size > 0;
  result.has_wide_addresses = i.address_width == 32;
  result.is_privileged = is_privileged(i);
  result.needs_386 = i.opcode_map != ZYDIS_OPCODE_MAP_DEFAULT;  // the tables have no 0F of a 286
  note_prefixes(i, result);
  result.flags = flag_effects(i, operands);
  result.writes = registers_written(i, operands);
  for (std::size_t n = 0; n < i.operand_count_visible; ++n) {
    const ZydisDecodedOperand& o = operands.at(n);
    if (o.type == ZYDIS_OPERAND_TYPE_IMMEDIATE && o.imm.is_relative != 0) {
      ZyanU64 target = 0;
      ZydisCalcAbsoluteAddress(&i, &o, at, &target);
      result.target = static_cast<std::uint32_t>(target);
    }
    const bool is_386_segment =
        o.type == ZYDIS_OPERAND_TYPE_REGISTER &&
        (o.reg.value == ZYDIS_REGISTER_FS || o.reg.value == ZYDIS_REGISTER_GS);
    result.needs_386 |= is_386_segment;
    result.operands.push_back(operand_of(i, o, at));
  }
  // AAM and AAD by ten are written without their operand.
  const bool is_decimal = i.mnemonic == ZYDIS_MNEMONIC_AAM || i.mnemonic == ZYDIS_MNEMONIC_AAD;
  if (is_decimal && result.operands.front().value == 10) result.operands.clear();
  return result;
}

bool is_conditional(const Decoded& instruction) {
  return instruction.condition.has_value() && instruction.target.has_value();
}

bool may_pass(const Decoded& instruction) {
  return is_conditional(instruction) || instruction.mnemonic.starts_with("loop") ||
         instruction.mnemonic.ends_with("cxz");
}

bool ends_flow(const Decoded& instruction) {
  const std::string& m = instruction.mnemonic;
  return m.empty() || m == "jmp" || m == "hlt" || m.starts_with("ret") || m.starts_with("iret");
}

}  // namespace fixproof::judge
