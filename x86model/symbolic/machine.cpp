#include "x86model/symbolic/machine.hpp"

#include <algorithm>

#include "x86model/cosine_table.hpp"
#include "x86model/machine.hpp"

namespace x86model::symbolic {

std::uint32_t ListingMachine::count_in(const Operand& o) { return immediate<16>(o); }

Term ListingMachine::address_in(const Operand& o, std::int32_t origin) const {
  return t_.add(read(o.reg, Size::word),
                t_.constant(static_cast<std::uint32_t>(o.value + origin) & 0xFFFFU, 16));
}

Term ListingMachine::open_address_in(const Operand& o) const {
  const auto displacement = static_cast<std::uint32_t>(o.value + address_of(o.symbol));
  switch (o.addressing) {
    case Addressing::direct:
      return t_.constant(displacement & 0xFFFFU, 32);
    case Addressing::index:
      return t_.add(read(o.reg, Size::dword), t_.constant(displacement, 32));
    case Addressing::index_twice: {
      const Term index = read(o.reg, Size::dword);
      return t_.add(t_.add(index, index), t_.constant(displacement, 32));
    }
    case Addressing::base:
      break;
  }
  return t_.zero_extend(address_in(o, address_of(o.symbol)), 32);
}

bool ListingMachine::read_table(Term offset, Term& value) {
  const Term inside = t_.below(offset, t_.constant(4 * cosine_table.size(), 16));
  in_table_ = t_.both(in_table_, t_.both(inside, t_.negation(t_.bit(offset, 0))));
  value = t_.apply("cosword", {offset}, 16);
  return true;
}

bool ListingMachine::read_open(const Operand& o, Size size, Term& value) {
  const auto& stores = state_.stores;
  if (!std::all_of(stores.begin(), stores.end(), [](const Store& s) { return s.extra; })) {
    return false;
  }
  const Term where = open_address_in(o);
  value = size == Size::byte ? t_.apply("databyte", {where}, 8) : t_.apply("dataword", {where}, 16);
  if (size != Size::dword) return true;
  value = t_.concat(t_.apply("dataword", {t_.add(where, t_.constant(2, 32))}, 16), value);
  return true;
}

bool ListingMachine::read_word(Term where, Term& value) const {
  if (!t_.is_constant(where)) return false;
  const auto found = state_.memory.find(static_cast<std::uint32_t>(t_.value(where)));
  if (found == state_.memory.end()) return false;
  value = found->second;
  return true;
}

bool ListingMachine::write_word(Term where, Term value) {
  if (!t_.is_constant(where)) return false;
  const auto found = state_.memory.find(static_cast<std::uint32_t>(t_.value(where)));
  if (found == state_.memory.end()) return false;
  found->second = value;
  return true;
}

bool ListingMachine::read(const Operand& o, Size size, Term& value) {
  if (o.kind == Operand::Kind::reg) {
    value = read(o.reg, size);
    return true;
  }
  if (o.kind == Operand::Kind::immediate) {
    value = t_.constant(immediate<16>(o), bits_of(size));
    return true;
  }
  if (memory_is_open_) return read_open(o, size, value);
  if (size == Size::byte) return false;
  // The cosine table is the only data in the code segment.
  const bool in_table = o.segment == SegmentOverride::cs && o.symbol == Symbol::cos_table;
  const Term where = address_in(o, in_table ? 0 : address_of(o.symbol));
  const auto word = [&](Term at, Term& to) {
    return in_table ? read_table(at, to) : read_word(at, to);
  };
  if (!word(where, value)) return false;
  if (size == Size::word) return true;
  Term high;
  if (!word(t_.add(where, t_.constant(2, 16)), high)) return false;
  value = t_.concat(high, value);
  return true;
}

bool ListingMachine::write(const Operand& o, Size size, Term value) {
  if (o.kind == Operand::Kind::reg) {
    write(o.reg, size, value);
    return true;
  }
  if (o.kind != Operand::Kind::memory || o.segment != SegmentOverride::none) return false;
  if (memory_is_open_) {
    const Store store{false, open_address_in(o), value};
    // Storing the same value twice equals storing it once.
    if (state_.stores.empty() || state_.stores.back() != store) state_.stores.push_back(store);
    return true;
  }
  if (size == Size::byte) return false;
  const Term where = address_in(o, address_of(o.symbol));
  if (!write_word(where, t_.extract(value, 0, 16))) return false;
  return size == Size::word ||
         write_word(t_.add(where, t_.constant(2, 16)), t_.extract(value, 16, 16));
}

bool ListingMachine::push(Term value) {
  const Term top = t_.sub(read(Register::sp, Size::word), t_.constant(2, 16));
  write(Register::sp, Size::word, top);
  return write_word(top, value);
}

bool ListingMachine::pop(Term& value) {
  const Term top = read(Register::sp, Size::word);
  write(Register::sp, Size::word, t_.add(top, t_.constant(2, 16)));
  return read_word(top, value);
}

bool ListingMachine::store_string(Size size) {
  if (!memory_is_open_) return false;
  const Term to = read(Register::di, Size::word);
  state_.stores.push_back({true, t_.zero_extend(to, 32), read(Register::ax, size)});
  write(Register::di, Size::word, t_.add(to, t_.constant(size == Size::byte ? 1 : 2, 16)));
  return true;
}

}  // namespace x86model::symbolic
