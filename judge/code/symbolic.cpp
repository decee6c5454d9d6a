#include "judge/code/symbolic.hpp"

#include <fmt/format.h>

#include <map>
#include <optional>
#include <set>
#include <utility>

#include "judge/code/operand.hpp"
#include "judge/code/symbolic_machine.hpp"
#include "x86model/symbolic/alu.hpp"

namespace fixproof::judge {

namespace {

namespace sym = x86model::symbolic;
using sym::Term;
using x86model::Mnemonic;
using x86model::Register;
using x86model::Size;

constexpr std::size_t max_paths = 200;
constexpr std::size_t max_steps = 20'000;

class Explorer : private SymbolicMachine {
 public:
  Explorer(const Subject& subject, Listing& listing, sym::Terms& terms)
      : SymbolicMachine(subject.image, terms), subject_(subject), listing_(listing) {}

  std::vector<Path> all() {
    threads_.push_back(start());
    while (!threads_.empty()) {
      Thread thread = std::move(threads_.back());
      threads_.pop_back();
      follow(std::move(thread));
    }
    return std::move(paths_);
  }

 private:
  Thread start() {
    Thread thread;
    thread.condition = t_.truth(true);
    thread.at = image_.entry;
    for (std::size_t r = 0; r < x86model::register_count; ++r) {
      thread.state.registers.at(r) = t_.variable(sym::numbered("register", r), 32);
    }
    const auto parameters = parameters_of(subject_.variant);
    std::uint32_t top = image_.stack_top;
    const auto push_all = [&](std::size_t i) {
      const Term value = extended(parameters[i], i, std::max(width(), parameters[i].bits));
      top -= static_cast<std::uint32_t>(t_.width(value) / 8);
      store_at(thread, image_.data_at(top), value);
    };
    const Frame& frame = subject_.frame;
    for (std::size_t i = 0; frame.on_stack && i < parameters.size(); ++i) {
      push_all(frame.first_is_top ? parameters.size() - 1 - i : i);
    }
    after_ = frame.callee_pops ? image_.stack_top : top;
    for (std::size_t i = 0; i < frame.in.size(); ++i) {
      if (frame.in[i].is_pointer) throw Obstacle("operands behind pointers are not modelled");
      int bits = 0;
      for (const RegisterName& part : frame.in[i].parts) bits += bits_of(part);
      const Term value = extended(parameters[i], i, bits);
      for (const RegisterName& part : frame.in[i].parts) {
        bits -= bits_of(part);
        thread.state.write(t_, part.number, part.size, t_.extract(value, bits, bits_of(part)));
      }
    }
    const std::uint32_t slot = static_cast<std::uint32_t>(width()) / 8;
    if (frame.is_far) {
      top -= slot;
      store_at(thread, image_.data_at(top), t_.constant(image_.code_segment, width()));
    }
    top -= slot;
    store_at(thread, image_.data_at(top), t_.constant(image_.exit, width()));
    const RegisterName sp = word_register(Register::sp);
    thread.state.write(t_, sp.number, sp.size, t_.constant(top, width()));
    begin_ = thread.state;
    return thread;
  }

  Term extended(const Parameter& p, std::size_t index, int bits) {
    const Term value = t_.variable(operand_name(index), p.bits);
    return p.is_signed ? t_.sign_extend(value, bits) : t_.zero_extend(value, bits);
  }

  void follow(Thread thread) {
    for (std::size_t steps = 0; steps < max_steps; ++steps) {
      if (thread.at == image_.exit) return returned(thread);
      const std::uint32_t linear = image_.code_at(thread.at);
      if (linear < image_.first || linear >= image_.end) throw Obstacle("a path leaves the code");
      const Line& line = listing_.at(thread.at);
      try {
        thread.at += line.bytes;
        if (!step(thread, line)) throw Obstacle("this instruction is not modelled");
      } catch (const Obstacle& obstacle) {
        throw Obstacle(fmt::format("{} at {:04x}h: {}", line.text, line.at, obstacle.what()));
      }
      if (t_.is_constant(thread.condition) && t_.value(thread.condition) == 0) return;
    }
    throw Obstacle(fmt::format("a path has more than {} instructions", max_steps));
  }

  void returned(const Thread& thread) {
    Path path{.condition = thread.condition};
    const int bits = subject_.variant.format.word_bits;
    const Frame& frame = subject_.frame;
    std::vector<RegisterName> parts;
    if (!frame.on_stack) {
      parts = frame.out.front().parts;
    } else {
      if (bits > width()) parts.push_back(word_register(Register::dx));
      parts.push_back(word_register(Register::ax));
    }
    std::optional<Term> value;
    for (const RegisterName& part : parts) {
      const Term read = thread.state.read(t_, part.number, part.size);
      value = value ? sym::join(t_, *value, read) : read;
    }
    path.result = t_.extract(*value, 0, bits);
    const RegisterName sp = word_register(Register::sp);
    path.kept = t_.equal(thread.state.read(t_, sp.number, sp.size), t_.constant(after_, width()));
    for (const RegisterName& kept : frame.kept) {
      path.kept = t_.both(path.kept, t_.equal(thread.state.read(t_, kept.number, kept.size),
                                              begin_.read(t_, kept.number, kept.size)));
    }
    paths_.push_back(path);
  }

  /// Executes one instruction. Returns false if it is not modelled.
  bool step(Thread& thread, const Line& line) {
    const std::string m = line.text.substr(0, line.text.find(' '));
    const auto parsed = operands_of(line);
    if (!parsed) return false;
    const auto& o = *parsed;
    int bits = o.empty() ? width() : o[0].bits;
    for (const Operand& operand : o) {
      if (operand.kind == Operand::Kind::reg && bits == 0) bits = bits_of(operand.reg);
    }
    if (!o.empty() && o[0].kind == Operand::Kind::reg) bits = bits_of(o[0].reg);
    if (o.size() == 1 && transferred(thread, m, o[0], line)) return true;
    if (o.size() <= 1 && (m == "ret" || m == "retf")) {
      const Term to = pop(thread, width());
      if (!t_.is_constant(to)) return false;
      thread.at = static_cast<std::uint32_t>(t_.value(to));
      if (m == "retf") pop(thread, width());
      if (o.size() == 1) move_stack(thread, o[0].value);
      return true;
    }
    if (bits == 0) return false;
    return sign_extended(thread, m) || moved(thread, m, o, bits) || computed(thread, m, o, bits) ||
           multiplied(thread, m, o, bits);
  }

  bool transferred(Thread& thread, const std::string& m, const Operand& o, const Line& line) {
    if (m.starts_with("set") && o.kind != Operand::Kind::immediate) {
      const auto c = condition(thread, m.substr(3));
      if (c) write(thread, o, t_.ite(*c, t_.constant(1, 8), t_.constant(0, 8)));
      return c.has_value();
    }
    if (o.kind != Operand::Kind::immediate || target_of(line) != o.value) return false;
    if (m == "call") push(thread, t_.constant(thread.at, width()));
    if (m == "call" || m == "jmp") {
      thread.at = o.value;
      return true;
    }
    if (!m.starts_with('j')) return false;
    const auto taken = condition(thread, m.substr(1));
    if (!taken) return false;
    if (t_.is_constant(*taken)) {
      if (t_.value(*taken) != 0) thread.at = o.value;
      return true;
    }
    if (paths_.size() + threads_.size() > max_paths) {
      throw Obstacle(fmt::format("there are more than {} paths", max_paths));
    }
    Thread other = thread;
    other.at = o.value;
    other.condition = t_.both(thread.condition, *taken);
    thread.condition = t_.both(thread.condition, t_.negation(*taken));
    threads_.push_back(std::move(other));
    return true;
  }

  /// CWD, CDQ and CWDE extend AX or EAX by its sign.
  bool sign_extended(Thread& thread, const std::string& m) {
    if (m != "cwd" && m != "cdq" && m != "cwde") return false;
    const Size size = m == "cdq" ? Size::dword : Size::word;
    const int n = size == Size::dword ? 32 : 16;
    const Term wide = t_.sign_extend(thread.state.read(t_, Register::ax, size), 2 * n);
    if (m == "cwde") {
      thread.state.write(t_, Register::ax, Size::dword, wide);
    } else {
      thread.state.write(t_, Register::dx, size, t_.extract(wide, n, n));
    }
    return true;
  }

  bool moved(Thread& thread, const std::string& m, const std::vector<Operand>& o, int bits) {
    if (m == "nop" && o.empty()) return true;
    if (m == "mov" && o.size() == 2) return write(thread, o[0], read(thread, o[1], bits)), true;
    if (m == "push" && o.size() == 1) {
      push(thread, read(thread, o[0], o[0].kind == Operand::Kind::immediate ? width() : bits));
      return true;
    }
    if (m == "pop" && o.size() == 1) return write(thread, o[0], pop(thread, bits)), true;
    if (m == "xchg" && o.size() == 2) {
      const Term first = read(thread, o[0], bits);
      write(thread, o[0], read(thread, o[1], bits));
      write(thread, o[1], first);
      return true;
    }
    if (m == "movzx" || m == "movsx") {
      const int from = o[1].kind == Operand::Kind::reg ? bits_of(o[1].reg) : o[1].bits;
      if (from == 0 || from >= bits) return false;
      const Term value = read(thread, o[1], from);
      write(thread, o[0], m == "movzx" ? t_.zero_extend(value, bits) : t_.sign_extend(value, bits));
      return true;
    }
    if (m == "leave" && o.empty()) {
      const RegisterName bp = word_register(Register::bp);
      const RegisterName sp = word_register(Register::sp);
      thread.state.write(t_, sp.number, sp.size, thread.state.read(t_, bp.number, bp.size));
      thread.state.write(t_, bp.number, bp.size, pop(thread, width()));
      return true;
    }
    return false;
  }

  bool set(Thread& thread, const Operand& to, const sym::Result& result) {
    write(thread, to, result.value);
    thread.state.flags = result.flags;
    return true;
  }

  bool shifted(Thread& thread, const std::string& m, const std::vector<Operand>& o, int bits) {
    static const std::map<std::string, Mnemonic> known{
        {"shl", Mnemonic::shl},  {"sal", Mnemonic::shl}, {"shr", Mnemonic::shr},
        {"sar", Mnemonic::sar},  {"rol", Mnemonic::rol}, {"shld", Mnemonic::shld},
        {"shrd", Mnemonic::shrd}};
    const auto shift = known.find(m);
    if (shift == known.end() || o.back().kind != Operand::Kind::immediate) return false;
    const int count = static_cast<int>(o.back().value & 31U);
    if (count == 0) return true;
    const Term a = read(thread, o[0], bits);
    if (o.size() == 2) {
      const sym::FlagTerms before = thread.state.flags;
      set(thread, o[0], sym::shift(t_, shift->second, a, count));
      if (m == "rol") {
        thread.state.flags.zero = before.zero;
        thread.state.flags.sign = before.sign;
      }
      return true;
    }
    if (count >= bits) return false;
    return set(thread, o[0],
               sym::double_shift(t_, shift->second, a, read(thread, o[1], bits), count));
  }

  bool computed_from_one(Thread& thread, const std::string& m, const Operand& o, int bits) {
    if (m != "neg" && m != "not" && m != "inc" && m != "dec") return false;
    const Term no_borrow = t_.truth(false);
    const Term a = read(thread, o, bits);
    const Term one = t_.constant(1, bits);
    if (m == "neg") return set(thread, o, sym::sub(t_, t_.constant(0, bits), a, no_borrow));
    if (m == "not") {
      write(thread, o, t_.bit_xor(a, t_.constant(~std::uint64_t{0}, bits)));
      return true;
    }
    const sym::FlagTerm carry = thread.state.flags.carry;
    set(thread, o, m == "inc" ? sym::add(t_, a, one, no_borrow) : sym::sub(t_, a, one, no_borrow));
    thread.state.flags.carry = carry;
    return true;
  }

  bool computed_from_two(Thread& thread, const std::string& m, const std::vector<Operand>& o,
                         int bits) {
    static const std::set<std::string> known{"add", "adc",  "sub", "sbb", "cmp",
                                             "and", "test", "or",  "xor"};
    if (!known.contains(m)) return false;
    const Term a = read(thread, o[0], bits);
    const Term b = read(thread, o[1], bits);
    const Term carry =
        m == "adc" || m == "sbb" ? defined(thread.state.flags.carry) : t_.truth(false);
    const auto result = [&] {
      if (m == "add" || m == "adc") return sym::add(t_, a, b, carry);
      // SBB of a register from itself spreads the carry.
      if (m == "sub" || m == "sbb" || m == "cmp") return sym::sub(t_, a, b, carry);
      if (m == "xor") return sym::logic(t_, t_.bit_xor(a, b));
      const Term both = t_.bit_and(a, b);
      return sym::logic(t_, m == "or" ? t_.bit_xor(t_.bit_xor(a, b), both) : both);
    }();
    if (m == "cmp" || m == "test") {
      thread.state.flags = result.flags;
      return true;
    }
    return set(thread, o[0], result);
  }

  bool computed(Thread& thread, const std::string& m, const std::vector<Operand>& o, int bits) {
    if (o.empty()) return false;
    return shifted(thread, m, o, bits) ||
           (o.size() == 1 && computed_from_one(thread, m, o[0], bits)) ||
           (o.size() == 2 && computed_from_two(thread, m, o, bits));
  }

  bool multiplied(Thread& thread, const std::string& m, const std::vector<Operand>& o, int bits) {
    const bool divides = m == "div" || m == "idiv";
    if ((m != "mul" && m != "imul" && !divides) || bits == 8 || o.empty()) return false;
    const Size size = bits == 16 ? Size::word : Size::dword;
    sym::State& state = thread.state;
    if (o.size() > 1) {
      const Term a = read(thread, o[o.size() == 3 ? 1 : 0], bits);
      const auto product = sym::multiply(t_, Mnemonic::imul, a, read(thread, o.back(), bits));
      write(thread, o[0], t_.extract(product.value, 0, bits));
      state.flags = product.flags;
      return true;
    }
    const Term operand = read(thread, o[0], bits);
    if (!divides) {
      const auto product = sym::multiply(t_, m == "mul" ? Mnemonic::mul : Mnemonic::imul,
                                         state.read(t_, Register::ax, size), operand);
      state.write(t_, Register::ax, size, t_.extract(product.value, 0, bits));
      state.write(t_, Register::dx, size, t_.extract(product.value, bits, bits));
      state.flags = product.flags;
      return true;
    }
    const Term dividend =
        t_.concat(state.read(t_, Register::dx, size), state.read(t_, Register::ax, size));
    const auto division =
        sym::divide(t_, m == "div" ? Mnemonic::div : Mnemonic::idiv, dividend, operand);
    paths_.push_back(
        {.condition = t_.both(thread.condition, division.faults), .divide_error = true});
    thread.condition = t_.both(thread.condition, t_.negation(division.faults));
    state.write(t_, Register::ax, size, division.quotient);
    state.write(t_, Register::dx, size, division.remainder);
    state.flags = {};
    return true;
  }

  const Subject& subject_;
  Listing& listing_;
  std::vector<Thread> threads_;
  std::vector<Path> paths_;
  sym::State begin_;
  std::uint32_t after_ = 0;  ///< the right SP after the return
};

}  // namespace

std::string operand_name(std::size_t index) { return {static_cast<char>('a' + index)}; }

SymbolicRun run_symbolically(const Subject& subject, Listing& listing, sym::Terms& terms) {
  SymbolicRun run;
  try {
    run.paths = Explorer(subject, listing, terms).all();
  } catch (const Obstacle& obstacle) {
    run.obstacle = obstacle.what();
  }
  return run;
}

}  // namespace fixproof::judge
