/// @file
/// The registers, flags, stack and memory of a symbolic run, and access to operands in them.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>

#include "judge/code/operand.hpp"
#include "x86model/symbolic/state.hpp"

namespace fixproof::judge {

/// Something that is not modelled. It ends the whole run.
class Obstacle : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A path in progress.
struct Thread {
  x86model::symbolic::State state;  ///< its memory holds bytes, by linear address
  x86model::symbolic::Term condition;
  std::uint32_t at = 0;  ///< offset of the next instruction
};

/// Reads and writes the state of a thread. Every function throws Obstacle if it meets something
/// that is not modelled.
class SymbolicMachine {
 protected:
  using Term = x86model::symbolic::Term;

  SymbolicMachine(const Image& image, x86model::symbolic::Terms& terms)
      : image_(image), t_(terms) {}

  [[nodiscard]] int width() const { return image_.bits; }
  [[nodiscard]] RegisterName word_register(x86model::Register r) const {
    return {r, width() == 16 ? x86model::Size::word : x86model::Size::dword};
  }

  void store_at(Thread& thread, std::uint32_t address, Term value) {
    for (int low = 0; low < t_.width(value); low += 8) {
      thread.state.memory[address++] = t_.extract(value, low, 8);
    }
  }

  Term byte_at(const Thread& thread, std::uint32_t address) {
    const auto known = thread.state.memory.find(address);
    if (known != thread.state.memory.end()) return known->second;
    if (address >= image_.first && address < image_.end) {
      return t_.constant(image_.memory[address], 8);
    }
    throw Obstacle(fmt::format("a read of uninitialised memory at {:x}h is not modelled", address));
  }

  Term load_at(const Thread& thread, std::uint32_t address, int bits) {
    Term value = byte_at(thread, address);
    for (int done = 8; done < bits; done += 8) value = t_.concat(byte_at(thread, ++address), value);
    return value;
  }

  /// @throws Obstacle unless the address is a constant
  std::uint32_t address_of(const Thread& thread, const Operand& o) {
    const int bits = !o.bases.empty()      ? bits_of(o.bases.front())
                     : o.address_bits != 0 ? o.address_bits
                                           : width();
    Term sum = t_.constant(o.value, bits);
    for (const RegisterName& base : o.bases) {
      sum = t_.add(thread.state.read(t_, base.number, base.size), sum);
    }
    if (!t_.is_constant(sum)) throw Obstacle("an address that depends on operands is not modelled");
    return image_.data_at(static_cast<std::uint32_t>(t_.value(sum)));
  }

  Term read(const Thread& thread, const Operand& o, int bits) {
    switch (o.kind) {
      case Operand::Kind::reg:
        return thread.state.read(t_, o.reg.number, o.reg.size);
      case Operand::Kind::immediate:
        return t_.constant(o.value, bits);
      default:
        return load_at(thread, address_of(thread, o), bits);
    }
  }

  void write(Thread& thread, const Operand& o, Term value) {
    if (o.kind == Operand::Kind::reg) {
      return thread.state.write(t_, o.reg.number, o.reg.size, value);
    }
    const std::uint32_t address = address_of(thread, o);
    const std::uint32_t low = image_.data_at(image_.stack_top - stack_bytes);
    if (o.kind != Operand::Kind::memory || address < low ||
        address >= image_.data_at(image_.data)) {
      throw Obstacle("a write outside the stack is not modelled");
    }
    store_at(thread, address, value);
  }

  [[nodiscard]] Operand stack_at(std::uint32_t offset) const {
    return {.kind = Operand::Kind::memory,
            .value = offset,
            .bases = {word_register(x86model::Register::sp)}};
  }
  void move_stack(Thread& thread, std::uint32_t bytes) {
    const RegisterName sp = word_register(x86model::Register::sp);
    thread.state.write(
        t_, sp.number, sp.size,
        t_.add(thread.state.read(t_, sp.number, sp.size), t_.constant(bytes, width())));
  }
  void push(Thread& thread, Term value) {
    move_stack(thread, 0U - static_cast<std::uint32_t>(t_.width(value) / 8));
    write(thread, stack_at(0), value);
  }
  Term pop(Thread& thread, int bits) {
    const Term value = load_at(thread, address_of(thread, stack_at(0)), bits);
    move_stack(thread, static_cast<std::uint32_t>(bits) / 8);
    return value;
  }

  static Term defined(const x86model::symbolic::FlagTerm& flag) {
    if (!flag) throw Obstacle("it reads a flag that is undefined or not modelled");
    return *flag;
  }

  /// Returns the value of a condition such as `nz` or `ge`, or nothing if it is not modelled.
  std::optional<Term> condition(const Thread& thread, const std::string& c) {
    const x86model::symbolic::FlagTerms& f = thread.state.flags;
    const auto differ = [&](Term a, Term b) {
      return t_.either(t_.both(a, t_.negation(b)), t_.both(t_.negation(a), b));
    };
    static const std::map<std::string, std::string> opposites{
        {"nz", "z"}, {"nc", "c"}, {"ns", "s"}, {"no", "o"}, {"ae", "c"}, {"a", "na"},
        {"ge", "l"}, {"g", "ng"}, {"nl", "l"}, {"ne", "z"}, {"nb", "c"}};
    const auto opposite = opposites.find(c);
    if (opposite != opposites.end()) {
      const auto value = condition(thread, opposite->second);
      return value ? std::optional(t_.negation(*value)) : std::nullopt;
    }
    if (c == "z" || c == "e") return defined(f.zero);
    if (c == "c" || c == "b") return defined(f.carry);
    if (c == "s") return defined(f.sign);
    if (c == "o") return defined(f.overflow);
    if (c == "na" || c == "be") return t_.either(defined(f.carry), defined(f.zero));
    if (c == "l") return differ(defined(f.sign), defined(f.overflow));
    if (c == "ng" || c == "le") {
      return t_.either(defined(f.zero), differ(defined(f.sign), defined(f.overflow)));
    }
    return std::nullopt;
  }

  // NOLINTBEGIN(*-non-private-member-variables-in-classes): its one derived class computes with
  // them
  const Image& image_;
  x86model::symbolic::Terms& t_;
  // NOLINTEND(*-non-private-member-variables-in-classes)
};

}  // namespace fixproof::judge
