#include "x86model/symbolic/state.hpp"

namespace x86model::symbolic {

Term State::read(Terms& terms, Register r, Size size) const {
  if (size == Size::byte) {
    const auto number = static_cast<std::size_t>(r);
    return terms.extract(registers.at(number % 4), number < 4 ? 0 : 8, 8);
  }
  const Term whole = registers.at(static_cast<std::size_t>(r));
  return size == Size::word    ? terms.extract(whole, 0, 16)
         : size == Size::dword ? terms.extract(whole, 0, 32)
                               : whole;
}

void State::write(Terms& terms, Register r, Size size, Term value) {
  if (size == Size::byte) {
    const auto number = static_cast<std::size_t>(r);
    Term& holder = registers.at(number % 4);
    const Term above = terms.extract(holder, 16, terms.width(holder) - 16);
    const Term low = number < 4 ? value : terms.extract(holder, 0, 8);
    const Term high = number < 4 ? terms.extract(holder, 8, 8) : value;
    holder = terms.concat(above, terms.concat(high, low));
    return;
  }
  Term& whole = registers.at(static_cast<std::size_t>(r));
  const int bits = terms.width(whole);
  // In 64-bit code, 32 bits clear the upper half.
  whole = size == Size::word ? terms.concat(terms.extract(whole, 16, bits - 16), value)
                             : terms.zero_extend(value, bits);
}

}  // namespace x86model::symbolic
