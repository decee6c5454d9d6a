/// @file
/// The check that a routine preserves the state its C caller relies on.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <span>
#include <string>

#include "x86model/call.hpp"
#include "x86model/text.hpp"

namespace fixproof::parties {

/// Lists the state that a routine has not preserved, such as "esi, sp"; empty if it has preserved
/// all. A register has its 32-bit name if its upper half has changed.
/// @param entered the registers on entry, with SP at the return address
template <x86model::Routine routine, class M>
std::string not_kept(const x86model::Registers<M::word_bits>& entered, const M& left,
                     std::span<const std::uint32_t> in) {
  namespace x86 = x86model;
  using enum x86::Size;
  constexpr auto word_mask = x86::mask(M::word_bits);
  std::string names;
  const auto add = [&](std::string_view name) {
    names += names.empty() ? "" : ", ";
    names += name;
  };
  for (const x86::Register r : {x86::Register::si, x86::Register::di, x86::Register::bp}) {
    const std::uint32_t lost = left.registers.read(r, dword) ^ entered.read(r, dword);
    if (lost != 0) add(x86::name_of(r, lost > word_mask ? dword : word));
  }
  const auto top = (entered.read(x86::Register::sp, word) + M::word_bits / 8) & word_mask;
  if (left.registers.read(x86::Register::sp, word) != top) add("sp");
  // The divides may change their operands: see finding 11.
  if constexpr (routine == x86::Routine::xformvec || routine == x86::Routine::concat) {
    for (std::size_t i = 0; i < in.size(); ++i) {
      const auto at = static_cast<std::int32_t>(i) * x86::detail::bytes_of_value;
      if (x86::detail::load(left, x86::detail::data + at) == in[i]) continue;
      add(fmt::format("operand {}", i + 1));
    }
  }
  return names;
}

}  // namespace fixproof::parties
