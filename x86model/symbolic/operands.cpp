#include "x86model/symbolic/operands.hpp"

#include "x86model/cosine_table.hpp"
#include "x86model/run.hpp"
#include "x86model/symbolic/open_memory.hpp"

namespace x86model::symbolic {

namespace {

/// Selects the immediates of the listings: 16-bit words.
using Word = Machine<16, WordMemory<16, 0>>;

}  // namespace

/// The address of a memory operand: `origin` is that of its named place, or 0 for an offset in
/// that place.
Term Operands::address(const Thread& thread, const Operand& o, std::int32_t origin) const {
  return t_.add(thread.state.read(t_, o.reg, Size::word),
                t_.constant(static_cast<std::uint32_t>(o.value + origin) & 0xFFFFU, 16));
}

std::optional<Term> Operands::table_word(Thread& thread, Term offset) const {
  const Term inside = t_.below(offset, t_.constant(4 * cosine_table.size(), 16));
  thread.in_table = t_.both(thread.in_table, t_.both(inside, t_.negation(t_.bit(offset, 0))));
  return t_.apply("cosword", {offset}, 16);
}

std::optional<Term> Operands::memory_word(const Thread& thread, Term where) const {
  if (!t_.is_constant(where)) return std::nullopt;
  const auto found = thread.state.memory.find(static_cast<std::uint32_t>(t_.value(where)));
  if (found == thread.state.memory.end()) return std::nullopt;
  return found->second;
}

bool Operands::put(Thread& thread, Term where, Term value) const {
  if (!t_.is_constant(where)) return false;
  const auto found = thread.state.memory.find(static_cast<std::uint32_t>(t_.value(where)));
  if (found == thread.state.memory.end()) return false;
  found->second = value;
  return true;
}

std::optional<Term> Operands::read(Thread& thread, const Operand& o, Size size) const {
  const int bits = size == Size::byte ? 8 : size == Size::word ? 16 : 32;
  if (o.kind == Operand::Kind::reg) return thread.state.read(t_, o.reg, size);
  if (o.kind == Operand::Kind::immediate) {
    return t_.constant(x86model::detail::immediate<Word>(o), bits);
  }
  if (memory_is_open_) return open_memory::read(t_, thread.state, o, size);
  if (size == Size::byte) return std::nullopt;
  // The cosine table is the only data in the code segment.
  const bool in_table = o.segment == SegmentOverride::cs && o.symbol == Symbol::cos_table;
  const Term where = address(thread, o, in_table ? 0 : address_of(o.symbol));
  const auto word = [&](Term at) {
    return in_table ? table_word(thread, at) : memory_word(thread, at);
  };
  const auto low = word(where);
  if (size == Size::word || !low) return low;
  const auto high = word(t_.add(where, t_.constant(2, 16)));
  if (!high) return high;
  return t_.concat(*high, *low);
}

bool Operands::write(Thread& thread, const Operand& o, Size size, Term value) const {
  if (o.kind == Operand::Kind::reg) {
    thread.state.write(t_, o.reg, size, value);
    return true;
  }
  if (o.kind != Operand::Kind::memory || o.segment != SegmentOverride::none) return false;
  if (memory_is_open_) {
    open_memory::write(t_, thread.state, o, value);
    return true;
  }
  if (size == Size::byte) return false;
  const Term where = address(thread, o, address_of(o.symbol));
  if (!put(thread, where, t_.extract(value, 0, 16))) return false;
  return size == Size::word ||
         put(thread, t_.add(where, t_.constant(2, 16)), t_.extract(value, 16, 16));
}

bool Operands::push(Thread& thread, Term value) const {
  const Term top = t_.sub(thread.state.read(t_, Register::sp, Size::word), t_.constant(2, 16));
  thread.state.write(t_, Register::sp, Size::word, top);
  return put(thread, top, value);
}

std::optional<Term> Operands::pop(Thread& thread) const {
  const Term top = thread.state.read(t_, Register::sp, Size::word);
  const auto value = memory_word(thread, top);
  thread.state.write(t_, Register::sp, Size::word, t_.add(top, t_.constant(2, 16)));
  return value;
}

}  // namespace x86model::symbolic
