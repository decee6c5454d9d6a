#include "judge/code/timed_line.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "x86model/alu.hpp"
#include "x86model/words.hpp"

namespace fixproof::judge {

namespace {

using x86model::Register;
using x86model::Size;

bool is_shift(std::string_view m) {
  constexpr std::array<std::string_view, 9> all{"shl", "shr", "sar",  "rol", "ror",
                                                "rcl", "rcr", "shld", "shrd"};
  return std::ranges::find(all, m) != all.end();
}

/// Reads one operand into the shape and what depends on it.
void add_operand(TimedLine& timed, const Operand& o) {
  const bool counts = is_shift(timed.mnemonic) && !timed.shape.empty();
  switch (o.kind) {
    case Operand::Kind::reg:
      if (counts && o.reg == RegisterName{Register::cx, Size::byte}) {
        timed.shape += 'c';
        return;
      }
      timed.shape += 'r';
      if (timed.bits == 0) timed.bits = o.bits;
      return;
    case Operand::Kind::memory:
      timed.shape += o.scale > 1 ? '?' : 'm';
      if (timed.bits == 0) timed.bits = o.bits;
      timed.bases = o.bases;
      return;
    case Operand::Kind::immediate: {
      const bool by_one = counts && (timed.opcode == 0xD0 || timed.opcode == 0xD1);
      const bool by_byte = timed.mnemonic == "imul" && timed.opcode == 0x6B;
      timed.shape += by_one ? '1' : by_byte ? 'b' : 'i';
      timed.immediate = static_cast<std::uint32_t>(o.value);
      return;
    }
    case Operand::Kind::segment:
      timed.shape += 's';
      return;
    case Operand::Kind::other:
      timed.shape += '?';
      return;
  }
}

}  // namespace

bool is_taken(const TimedLine& line, const Registers& before) {
  using x86model::ZF;
  if (is_conditional(line)) {
    const x86model::Flags flags{static_cast<std::uint16_t>(before.flags), 0};
    return x86model::alu::holds(x86model::Words{}, *line.condition, flags);
  }
  if (!may_pass(line)) return true;
  const RegisterName counter{Register::cx, line.has_wide_addresses ? Size::dword : Size::word};
  const std::uint64_t count = before.read(counter);
  if (line.mnemonic.ends_with("cxz")) return count == 0;
  if (count == 1) return false;
  const bool is_zero = (before.flags & ZF) != 0;
  if (line.mnemonic == "loope") return is_zero;
  return line.mnemonic != "loopne" || !is_zero;
}

TimedLine timed_line(const Line& line, const Decoded& decoded) {
  TimedLine timed{decoded, line, {}, 0, {}, 0};
  for (const Operand& operand : timed.operands) add_operand(timed, operand);
  return timed;
}

}  // namespace fixproof::judge
