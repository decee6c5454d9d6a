/// @file
/// Files of single-step cases: the JSON format of SingleStepTests (8088 and 80386 sets).
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

#include "x86model/routine.hpp"

namespace fixproof::singlestep {

/// The registers a case may name. The first eight are the general ones in the order of their
/// encoding, as x86model::Register has them; those after `flags` only the 386 has, and a case may
/// leave them out.
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

/// The register's name in the sets of a processor: `flags`, but `eflags` for the 386.
std::string_view name_of(Place place, x86model::Target cpu);
/// 16 or 32.
int bits_of(Place place, x86model::Target cpu);

/// One state: the registers that are named, and the bytes of memory that are listed.
struct State {
  std::array<std::optional<std::uint32_t>, place_count> registers;
  std::map<std::uint32_t, std::uint8_t> ram;

  /// A register that is named.
  [[nodiscard]] std::uint32_t operator[](Place place) const {
    return registers[static_cast<std::size_t>(place)].value();
  }
};

struct Case {
  std::size_t index = 0;  ///< its place in the file, from 0
  std::string name;
  std::vector<std::uint8_t> bytes;
  State initial;
  /// Registers are complete here: those the file leaves out are unchanged. Memory is only what the
  /// file lists.
  State final;
};

/// Calls `use` for every case of a file, plain or gzip, in order. Queue, cycles and hash are passed
/// over. One case is in memory at a time, beside the file's text.
/// @throws UsageError naming the file and the place where it is not in the format, or has no case;
/// what `use` throws is given its place in the same way
void read_cases(const std::string& path, x86model::Target cpu,
                const std::function<void(const Case&)>& use);

}  // namespace fixproof::singlestep
