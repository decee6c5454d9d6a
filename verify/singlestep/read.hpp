/// @file
/// Reads single-step cases in the formats of SingleStepTests: JSON, and binary MOO.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "x86model/clocks.hpp"

namespace fixproof::singlestep {

/// The registers of a case. The first eight are the general registers in encoding order, as in
/// x86model::Register. Those after `flags` exist only on the 386, and a case may omit them.
enum class Place : std::uint8_t {
  ax,
  cx,
  dx,
  bx,
  sp,
  bp,
  si,
  di,
  cs,
  ss,
  ds,
  es,
  ip,
  flags,
  fs,
  gs,
  cr0,
  cr2,
  cr3,
  dr6,
  dr7,
};
inline constexpr std::size_t place_count = static_cast<std::size_t>(Place::dr7) + 1;

/// The register's name in the sets of a processor, such as `eflags` for `flags` in the 386 sets.
std::string_view name_of(Place place, x86model::Cpu cpu);
/// 16 or 32.
int bits_of(Place place, x86model::Cpu cpu);
/// The number of a processor's address lines.
int address_bits(x86model::Cpu cpu);
/// The largest number of `bits` bits.
constexpr std::uint32_t largest(int bits) { return 0xFFFFFFFFU >> (32 - bits); }

using Ram = std::map<std::uint32_t, std::uint8_t>;

struct State {
  std::array<std::optional<std::uint32_t>, place_count> registers;
  Ram ram;

  /// The value of a register that the state lists.
  [[nodiscard]] std::uint32_t operator[](Place place) const {
    return registers[static_cast<std::size_t>(place)].value();
  }
};

struct Case {
  std::size_t index = 0;  ///< position in the file, from 0
  std::string name;
  std::vector<std::uint8_t> bytes;
  State initial;
  /// The reader fills in unchanged registers. `ram` holds only the bytes that the file lists.
  State final;
};

using UseCase = std::function<void(const Case&)>;

/// Calls `use` for every case of a file, JSON or MOO, plain or gzip, in order. The contents tell
/// the format. The reader ignores queue, cycles, exception and hash. It keeps one case at a time in
/// memory beside the file's contents.
/// @throws UsageError naming the file and the position if the format is wrong or there are no
/// cases; errors that `use` throws get the same prefix
void read_cases(const std::string& path, x86model::Cpu cpu, const UseCase& use);

}  // namespace fixproof::singlestep
