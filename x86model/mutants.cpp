#include "x86model/mutants.hpp"

#include <array>
#include <utility>

#include "x86model/execute.hpp"
#include "x86model/instruction_table.hpp"
#include "x86model/text.hpp"

namespace x86model {

namespace {

/// The next byte register; AH follows DH and BH.
Register next_byte(Register r) {
  constexpr auto byte_registers = 8;
  return static_cast<Register>((static_cast<int>(r) + 1) % byte_registers);
}

Register next(Register r) {
  switch (r) {
    case Register::ax:
      return Register::cx;
    case Register::cx:
      return Register::dx;
    case Register::dx:
      return Register::bx;
    case Register::bx:
      return Register::ax;
    case Register::si:
      return Register::di;
    case Register::di:
    case Register::sp:
      return Register::bp;
    case Register::bp:
      break;
  }
  return Register::si;
}

/// The next of the registers that can address memory.
Register next_base(Register r) {
  switch (r) {
    case Register::bx:
      return Register::si;
    case Register::si:
      return Register::di;
    default:
      return Register::bx;
  }
}

/// The alternatives for a constant.
std::vector<Operand> other_constants(const Operand& o) {
  const auto literal = [&](int value) {
    Operand other = o;
    other.scaling = Scaling::literal;
    other.value = value;
    return other;
  };
  constexpr int half = 0x8000;
  constexpr int bits = 16;
  switch (o.scaling) {
    case Scaling::half_unit:
      return {literal(half - 1), literal(half + 1), literal(0)};
    case Scaling::word_bits:
      return {literal(bits - 1), literal(bits + 1)};
    case Scaling::literal:
    case Scaling::bytes:
      break;
  }
  return {literal(o.value - 1), literal(o.value + 1)};
}

std::vector<Operand> other_operands(const Operand& o) {
  std::vector<Operand> others;
  if (o.kind == Operand::Kind::reg) {
    others.push_back(o);
    others.back().reg = o.size == Size::byte ? next_byte(o.reg) : next(o.reg);
  } else if (o.kind == Operand::Kind::immediate) {
    others = other_constants(o);
  } else if (o.kind == Operand::Kind::memory) {
    const int step = o.size == Size::byte ? 1 : 2;
    others.assign(3, o);
    others[0].reg = next_base(o.reg);
    others[1].value -= step;
    others[2].value += step;
    if (o.segment != SegmentOverride::none) {
      others.push_back(o);
      others.back().segment = SegmentOverride::none;
    }
  }
  return others;
}

/// The program with `count` instructions at `at` replaced by `by`, and the jump targets adjusted.
Program spliced(const Program& program, std::size_t at, std::size_t count,
                std::span<const Instruction> by) {
  Program changed;
  const auto place = [&](const Instruction& i) { changed.code.at(changed.size++) = i; };
  for (std::size_t i = 0; i < at; ++i) place(program.code.at(i));
  for (const Instruction& i : by) place(i);
  for (std::size_t i = at + count; i < program.size; ++i) place(program.code.at(i));
  for (std::size_t i = 0; i < changed.size; ++i) {
    for (Operand& o : changed.code.at(i).operands) {
      if (o.kind != Operand::Kind::label || static_cast<std::size_t>(o.value) <= at) continue;
      o.value += static_cast<int>(by.size()) - static_cast<int>(count);
    }
  }
  return changed;
}

/// Builds the mutants of one program.
class MutantBuilder {
 public:
  explicit MutantBuilder(const Program& sound) : sound_(sound) {}

  std::vector<Mutant> all() {
    for (std::size_t at = 0; at < sound_.size; ++at) {
      mnemonics(at);
      operands(at);
      if (is_control_flow(sound_.code.at(at).mnemonic)) jumps(at);
      add(at, {}, "left out");
      const Instruction& i = sound_.code.at(at);
      Instruction again = i;
      again.label = nullptr;
      again.is_procedure = false;
      add(at, std::array{i, again}, "twice");
    }
    return std::move(mutants_);
  }

 private:
  void add(std::size_t at, std::span<const Instruction> by, const std::string& what) {
    mutants_.push_back({spliced(sound_, at, 1, by), at, std::to_string(at)});
    mutants_.back().change.append(" ").append(text_of(sound_.code.at(at)));
    mutants_.back().change.append(" -> ").append(what);
  }

  void replace(std::size_t at, const Instruction& by) {
    const std::string text = text_of(by);
    if (text != text_of(sound_.code.at(at))) add(at, std::array{by}, text);
  }

  void mnemonics(std::size_t at) {
    Instruction by = sound_.code.at(at);
    const auto& row = mnemonic_rows.at(static_cast<std::size_t>(by.mnemonic));
    for (const Mnemonic wrong : row.confused_with) {
      by.mnemonic = wrong;
      replace(at, by);
    }
  }

  void operands(std::size_t at) {
    const Instruction& i = sound_.code.at(at);
    if (i.operands[1].kind == Operand::Kind::reg || i.operands[1].kind == Operand::Kind::memory) {
      Instruction by = i;
      std::swap(by.operands[0], by.operands[1]);
      replace(at, by);
    }
    for (std::size_t o = 0; o < i.operands.size(); ++o) {
      for (const Operand& other : other_operands(i.operands.at(o))) {
        Instruction by = i;
        by.operands.at(o) = other;
        replace(at, by);
      }
    }
  }

  void jumps(std::size_t at) {
    const Instruction& i = sound_.code.at(at);
    if (i.mnemonic == Mnemonic::call || i.mnemonic == Mnemonic::ret) return;
    Instruction by = i;
    by.mnemonic = Mnemonic::jmp;
    replace(at, by);
    for (std::size_t to = 0; to < sound_.size; ++to) {
      const Instruction& target = sound_.code.at(to);
      if (target.label == nullptr || target.is_procedure) continue;
      by = i;
      by.operands[0].name = target.label;
      by.operands[0].value = static_cast<int>(to);
      replace(at, by);
    }
  }

  const Program& sound_;
  std::vector<Mutant> mutants_;
};

}  // namespace

std::vector<Mutant> mutants(const Program& sound) { return MutantBuilder(sound).all(); }

}  // namespace x86model
