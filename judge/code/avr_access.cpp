#include "judge/code/avr_access.hpp"

namespace fixproof::judge::avr {

namespace {

using Kind = Reach::Kind;

constexpr std::size_t x = 26;
constexpr std::size_t y = 28;
constexpr std::size_t z = 30;

std::uint16_t pair(const State& s, std::size_t low) {
  return static_cast<std::uint16_t>(s.r[low] | s.r[low + 1] << 8U);
}

Reach data(std::uint32_t address, bool is_write, std::uint32_t bytes = 1) {
  return {Kind::data, address & 0xFFFFU, bytes, is_write};
}

Reach program(const State& s, bool has_high) {
  const std::uint32_t high = has_high ? s.high_z : 0U;
  return {Kind::program, high << 16U | pair(s, z), 1, false};
}

/// 1001 00sd dddd oooo: loads and stores.
Reach moved(const State& s) {
  const bool is_write = (s.word & 0x200U) != 0;
  switch (s.word & 0xFU) {
    case 0x0:
      return data(s.next, is_write);
    case 0x1:
      return data(pair(s, z), is_write);
    case 0x2:
      return data(pair(s, z) - 1U, is_write);
    case 0x4:
    case 0x5:
    case 0x6:
    case 0x7:
      // Stores of this form are those of XMEGA.
      if (is_write) return {Kind::invalid};
      return program(s, (s.word & 2U) != 0);
    case 0x9:
      return data(pair(s, y), is_write);
    case 0xA:
      return data(pair(s, y) - 1U, is_write);
    case 0xC:
    case 0xD:
      return data(pair(s, x), is_write);
    case 0xE:
      return data(pair(s, x) - 1U, is_write);
    case 0xF:
      return data(s.stack + (is_write ? 0U : 1U), is_write);
    default:
      return {Kind::invalid};
  }
}

Reach call(const State& s) {
  const auto bytes = static_cast<std::uint32_t>(s.return_bytes);
  return data(s.stack - bytes + 1, true, bytes);
}

/// 1001 0101: those without operands.
Reach lone(const State& s) {
  const bool is_large = s.return_bytes == 3;
  switch (s.word) {
    case 0x9508:  // RET
    case 0x9518:  // RETI
      return data(s.stack + 1U, false, static_cast<std::uint32_t>(s.return_bytes));
    case 0x9509:  // ICALL
      return call(s);
    case 0x9519:  // EICALL
      return is_large ? call(s) : Reach{Kind::invalid};
    case 0x9419:  // EIJMP
      return {is_large ? Kind::none : Kind::invalid};
    case 0x9588:  // SLEEP
    case 0x9598:  // BREAK
      return {Kind::halt};
    case 0x95C8:  // LPM
      return program(s, false);
    case 0x95D8:  // ELPM
      return program(s, true);
    case 0x95E8:  // SPM
    case 0x95F8:  // SPM Z+
      return {Kind::invalid};
    default:
      return {};
  }
}

}  // namespace

Reach reach_of(const State& s) {
  const std::uint32_t word = s.word;
  if ((word & 0xD000U) == 0x8000U) {  // LDD and STD: 10q0 qqsd dddd yqqq
    const std::uint32_t q = (word >> 8U & 0x20U) | (word >> 7U & 0x18U) | (word & 7U);
    return data(pair(s, (word & 8U) != 0 ? y : z) + q, (word & 0x200U) != 0);
  }
  if ((word & 0xFC00U) == 0x9000U) return moved(s);
  if ((word & 0xFE0EU) == 0x940EU) return call(s);  // CALL
  if ((word & 0xF000U) == 0xD000U) return call(s);  // RCALL
  if ((word & 0xFC00U) == 0x9800U) {                // CBI, SBIC, SBI, SBIS
    return data(first_port + (word >> 3U & 0x1FU), (word & 0x100U) == 0);
  }
  if ((word & 0xF000U) == 0xB000U) {  // IN and OUT: 1011 sAAd dddd AAAA
    return data(first_port + ((word >> 5U & 0x30U) | (word & 0xFU)), (word & 0x800U) != 0);
  }
  // BLD, BST, SBRC and SBRS with a bit of more than three bits.
  if ((word & 0xF808U) == 0xF808U) return {Kind::invalid};
  if ((word & 0xFE00U) == 0x9400U) return lone(s);
  return {};
}

}  // namespace fixproof::judge::avr
