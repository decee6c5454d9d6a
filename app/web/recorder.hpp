/// @file
/// Records every state of a run of the model.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/web/edit.hpp"
#include "x86model/call_loop.hpp"
#include "x86model/clocks.hpp"
#include "x86model/routine.hpp"
#include "x86model/run.hpp"

namespace fixproof::web {

/// The machine after an instruction.
struct Snapshot {
  std::size_t position = 0;  ///< of the instruction; 0 in the first snapshot, which has none
  std::array<std::uint32_t, x86model::register_count> registers{};
  x86model::Flags flags{};
  std::vector<std::uint16_t> memory{};  ///< the contents of the run's cells
  x86model::Range clocks{};             ///< since the routine's first instruction
};

/// A word or a byte of the memory that a record keeps.
struct Cell {
  enum class Kind : std::uint8_t { word, pixel, depth };
  std::uint32_t address = 0;
  Kind kind = Kind::word;  ///< a pixel is a byte, a depth a word
};

struct Run {
  std::string name;
  x86model::Target target{};
  std::vector<x86model::Instruction> code{};
  std::vector<std::string> names{};  ///< of labels that a person typed; the code points to them
  bool is_loop = false;  ///< an inner loop, which has cells for pixels instead of a result
  std::vector<Cell> cells{};
  std::vector<Snapshot> snapshots{};  ///< the first is the state on entry
  x86model::Ending ending{};
  /// Whether the record ends at ending.position because the processor lacks that instruction.
  bool lacks_instruction = false;
  std::vector<std::uint32_t> result{};  ///< empty unless the routine returned
};

/// Returns the builds of a routine: `i386-on`, `i386-off`, `i8088-on`, `i8088-off`, and `i386-52`,
/// `i8088-on-repaired` and `i8088-off-scanned` where they exist. Those of cossin are `i386`,
/// `i8088` and `i8088-printed`.
std::vector<std::string> builds_of(x86model::Routine routine);

/// A record of a routine ends after this many instructions. The listings take fewer; a typed one
/// may never end.
inline constexpr std::uint64_t most_of_routine = 10'000;

/// Runs one of builds_of(routine) and records every state.
/// @param in as many words as the routine takes
/// @param edit the code and the registers in place of the build's
Run record(x86model::Routine routine, std::string_view build, std::span<const std::uint32_t> in,
           Edit edit);

/// The inner loops by the names that the page has for them.
inline constexpr std::array<std::string_view, 3> loop_names{"gouraud", "depth", "texture"};

/// Returns the builds of an inner loop, such as `byte-i386-loop` of gouraud and
/// `i386-dec-jnz-printed` of depth. The unrolled loops are left out, because they have up to 320
/// copies of the code for one pixel.
std::vector<std::string> builds_of_loop(std::string_view loop);

/// The most pixels that the page asks of a loop.
inline constexpr std::uint32_t most_pixels = 64;
/// A record of a loop ends after this many instructions, because a loop that starts with a count of
/// 0 draws 65,536 pixels or more.
inline constexpr std::uint64_t most_instructions = 1000;

/// Runs one of builds_of_loop(loop) and records every state. DepthTest draws pixels of AL = ffh at
/// Screen, over a depth buffer of zeros. The other loops draw from 2800h in a segment of their own.
/// A texel is the sum of its row and its column, modulo 256.
/// @param call at most most_pixels pixels; its place and colour are ignored
/// @param edit the code and the registers in place of the build's
Run record_loop(std::string_view loop, std::string_view build, x86model::LoopCall call, Edit edit);

/// Returns the number of instructions after which the runs first differ, in the last instruction or
/// in the state of the machine. Returns 0 if they do not differ.
std::size_t first_difference(const Run& a, const Run& b);

}  // namespace fixproof::web
