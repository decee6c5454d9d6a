#include "x86model/symbolic/state.hpp"

namespace x86model::symbolic {

Term State::read(Terms& terms, Register r, Size size) const {
  if (size == Size::byte) {
    const auto number = static_cast<std::size_t>(r);
    return terms.extract(registers[number % 4], number < 4 ? 0 : 8, 8);
  }
  const Term whole = registers[static_cast<std::size_t>(r)];
  return size == Size::word ? terms.extract(whole, 0, 16) : whole;
}

void State::write(Terms& terms, Register r, Size size, Term value) {
  if (size == Size::byte) {
    const auto number = static_cast<std::size_t>(r);
    Term& holder = registers[number % 4];
    const Term above = terms.extract(holder, 16, 16);
    const Term low = number < 4 ? value : terms.extract(holder, 0, 8);
    const Term high = number < 4 ? terms.extract(holder, 8, 8) : value;
    holder = terms.concat(above, terms.concat(high, low));
    return;
  }
  Term& whole = registers[static_cast<std::size_t>(r)];
  whole = size == Size::word ? terms.concat(terms.extract(whole, 16, 16), value) : value;
}

}  // namespace x86model::symbolic
