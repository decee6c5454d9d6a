#include "x86model/symbolic/open_memory.hpp"

#include <algorithm>

#include "x86model/machine.hpp"

namespace x86model::symbolic::open_memory {

namespace {

/// The address of an operand, 32 bits.
Term place_of(Terms& t, const State& state, const Operand& o) {
  const auto displacement = static_cast<std::uint32_t>(o.value + address_of(o.symbol));
  switch (o.addressing) {
    case Addressing::direct:
      return t.constant(displacement & 0xFFFFU, 32);
    case Addressing::index:
      return t.add(state.read(t, o.reg, Size::dword), t.constant(displacement, 32));
    case Addressing::index_twice: {
      const Term index = state.read(t, o.reg, Size::dword);
      return t.add(t.add(index, index), t.constant(displacement, 32));
    }
    case Addressing::base:
      break;
  }
  const Term base = state.read(t, o.reg, Size::word);
  return t.zero_extend(t.add(base, t.constant(displacement & 0xFFFFU, 16)), 32);
}

}  // namespace

std::optional<Term> read(Terms& t, const State& state, const Operand& o, Size size) {
  const auto& stores = state.stores;
  if (!std::all_of(stores.begin(), stores.end(), [](const Store& s) { return s.extra; })) {
    return std::nullopt;
  }
  const Term where = place_of(t, state, o);
  if (size == Size::byte) return t.apply("databyte", {where}, 8);
  const Term low = t.apply("dataword", {where}, 16);
  if (size == Size::word) return low;
  return t.concat(t.apply("dataword", {t.add(where, t.constant(2, 32))}, 16), low);
}

void write(Terms& t, State& state, const Operand& o, Term value) {
  const Store store{false, place_of(t, state, o), value};
  // Storing the same value twice equals storing it once.
  if (state.stores.empty() || state.stores.back() != store) state.stores.push_back(store);
}

void store_string(Terms& t, State& state, Size size) {
  const Term place = state.read(t, Register::di, Size::word);
  state.stores.push_back({true, t.zero_extend(place, 32), state.read(t, Register::ax, size)});
  const Term past = t.add(place, t.constant(size == Size::byte ? 1 : 2, 16));
  state.write(t, Register::di, Size::word, past);
}

}  // namespace x86model::symbolic::open_memory
