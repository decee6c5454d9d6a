/// @file
/// A machine of terms for the code of an image.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>

#include "judge/code/decoded.hpp"
#include "x86model/symbolic/machine.hpp"

namespace fixproof::judge {

/// Something that is not modelled. It ends the whole run.
class Obstacle : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The machine of x86model/execute.hpp for the code of an image; State::memory holds bytes, by
/// linear address. Every function throws Obstacle if it meets something that is not modelled.
class ImageMachine : public x86model::symbolic::Machine {
 public:
  using Term = x86model::symbolic::Term;

  ImageMachine(const Image& image, x86model::symbolic::Terms& terms,
               x86model::symbolic::State& state)
      : Machine(terms, state), image_(image) {}

  using Machine::read;
  using Machine::write;

  [[nodiscard]] x86model::symbolic::Terms& terms() const { return t_; }
  [[nodiscard]] int width() const { return image_.bits; }
  [[nodiscard]] x86model::Size word() const { return whole_register(0, width()).size; }

  [[nodiscard]] Term read(const RegisterName& name) const {
    return t_.extract(state_.registers.at(name.holder()), name.shift(), bits_of(name.size));
  }
  /// Writes a register as an instruction does: 32 bits clear what is above them.
  void write(const RegisterName& name, Term value) {
    const bool is_upper_half_cleared = name.size == x86model::Size::dword && width() == 64;
    put(is_upper_half_cleared ? whole_register(name.holder(), 64) : name,
        is_upper_half_cleared ? t_.zero_extend(value, 64) : value);
  }
  /// Writes a register as a caller does, who leaves anything in its other bits.
  void put(const RegisterName& name, Term value) {
    Term& whole = state_.registers.at(name.holder());
    const int end = name.shift() + bits_of(name.size);
    const int above = t_.width(whole) - end;
    if (name.shift() > 0) value = t_.concat(value, t_.extract(whole, 0, name.shift()));
    whole = above > 0 ? t_.concat(t_.extract(whole, end, above), value) : value;
  }

  void store_at(std::uint32_t address, Term value) {
    for (int low = 0; low < t_.width(value); low += 8) {
      state_.memory[address++] = t_.extract(value, low, 8);
    }
  }

  bool read(const Operand& o, x86model::Size size, Term& value) const {
    value = o.kind == Operand::Kind::reg         ? read(o.reg)
            : o.kind == Operand::Kind::immediate ? t_.constant(o.value, bits_of(size))
                                                 : load(address_term(o), bits_of(size));
    return true;
  }

  bool write(const Operand& o, x86model::Size /*size*/, Term value) {
    if (o.kind == Operand::Kind::reg) {
      write(o.reg, value);
      return true;
    }
    const std::uint32_t address = address_of(o);
    const std::uint32_t low = image_.data_at(image_.stack_top - stack_bytes);
    if (o.kind != Operand::Kind::memory || address < low ||
        address >= image_.data_at(image_.data)) {
      throw Obstacle("a write outside the stack is not modelled");
    }
    store_at(address, value);
    return true;
  }

  /// The path of the operands for which a divide faults ends, even if they are all or none.
  bool faults_if(Term condition) {
    fault = {condition, state_};
    return false;
  }

  /// The count of a shift, if it does not depend on operands.
  [[nodiscard]] std::optional<std::uint32_t> constant_in(const Operand& o) const {
    if (o.kind == Operand::Kind::immediate) return static_cast<std::uint32_t>(o.value);
    if (o.kind != Operand::Kind::reg || !t_.is_constant(read(o.reg))) return std::nullopt;
    return static_cast<std::uint32_t>(t_.value(read(o.reg)));
  }
  [[nodiscard]] std::uint32_t count_in(const Operand& o) const { return constant_in(o).value(); }

  /// The address of a memory operand, of its own width.
  [[nodiscard]] Term address_term(const Operand& o) const {
    const int bits = o.address_bits;
    Term sum = t_.constant(o.value, bits);
    for (const RegisterName& base : o.bases) {
      const bool is_scaled = o.scale > 1 && &base == &o.bases.back();
      sum = t_.add(is_scaled ? times(read(base), o.scale) : read(base), sum);
    }
    return sum;
  }

  void move_stack(std::uint64_t bytes) {
    const Term top = read(x86model::Register::sp, word());
    write(x86model::Register::sp, word(), t_.add(top, t_.constant(bytes, width())));
  }
  bool push(Term value) {
    move_stack(std::uint64_t{0} - static_cast<std::uint64_t>(t_.width(value) / 8));
    return write(top(), word(), value);
  }
  Term pop(x86model::Size size) {
    const Term value = load_at(address_of(top()), bits_of(size));
    move_stack(static_cast<std::uint64_t>(bits_of(size)) / 8);
    return value;
  }
  bool pop(Term& value) {
    value = pop(word());
    return true;
  }
  static bool store_string(x86model::Size /*size*/) {
    throw Obstacle("this instruction is not modelled");
  }

 private:
  [[nodiscard]] Operand top() const {
    return {.kind = Operand::Kind::memory,
            .bases = {whole_register(4, width())},
            .address_bits = width()};
  }

  [[nodiscard]] Term byte_at(std::uint32_t address) const {
    const auto known = state_.memory.find(address);
    if (known != state_.memory.end()) return known->second;
    if (address >= image_.first && address < image_.end) {
      return t_.constant(image_.memory[image_.index_of(address)], 8);
    }
    const std::uint32_t stack = image_.data_at(image_.stack_top - stack_bytes);
    if (address >= stack && address < stack + stack_bytes) {
      // What earlier calls have left: compilers copy unused bytes of an object with the others.
      return t_.variable(x86model::symbolic::numbered("left", address), 8);
    }
    throw Obstacle(fmt::format("a read of uninitialised memory at {:x}h is not modelled", address));
  }

  [[nodiscard]] Term load_at(std::uint32_t address, int bits) const {
    Term value = byte_at(address);
    for (int done = 8; done < bits; done += 8) value = t_.concat(byte_at(++address), value);
    return value;
  }

  /// Loads from a constant address, or from one of several that conditions choose from: compilers
  /// so choose between constants in memory.
  [[nodiscard]] Term load(Term address, int bits) const {
    const x86model::symbolic::Node node = t_[address];
    if (node.op != x86model::symbolic::Op::ite) return load_at(linear(address), bits);
    return t_.ite(node.arguments[0], load(node.arguments[1], bits), load(node.arguments[2], bits));
  }

  [[nodiscard]] std::uint32_t address_of(const Operand& o) const { return linear(address_term(o)); }

  /// @throws Obstacle unless the address is a constant
  [[nodiscard]] std::uint32_t linear(Term address) const {
    if (!t_.is_constant(address)) {
      throw Obstacle("an address that depends on operands is not modelled");
    }
    if (t_.value(address) > std::numeric_limits<std::uint32_t>::max()) {
      throw Obstacle("an address beyond all memory is not modelled");
    }
    return image_.data_at(static_cast<std::uint32_t>(t_.value(address)));
  }

  /// A value times 2, 4 or 8.
  [[nodiscard]] Term times(Term value, int scale) const {
    const int shift = scale == 2 ? 1 : scale == 4 ? 2 : 3;
    return t_.concat(t_.extract(value, 0, t_.width(value) - shift), t_.constant(0, shift));
  }

  const Image& image_;
};

}  // namespace fixproof::judge
