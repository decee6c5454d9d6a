#include <fmt/format.h>

#include <algorithm>

#include "judge/code/load.hpp"
#include "support/usage_error.hpp"

namespace fixproof::judge {

namespace {

using support::UsageError;

/// Where DOS might load the program. Any paragraph with room for the program's prefix before it
/// would do.
constexpr std::uint16_t load_segment = 0x1000;
constexpr std::uint32_t paragraph = 16;
constexpr std::size_t header_bytes = 0x1C;
/// The memory that a real-mode address can reach.
constexpr std::size_t real_mode_bytes = 0x110000;
/// The program's own stack is used unless it is smaller than this.
constexpr std::uint32_t least_stack = 0x400;

std::uint32_t word_at(const std::string& bytes, std::size_t at) {
  if (at + 2 > bytes.size()) throw UsageError("the .EXE is cut off");
  return static_cast<std::uint8_t>(bytes[at]) |
         static_cast<std::uint32_t>(static_cast<std::uint8_t>(bytes[at + 1])) << 8U;
}

void relocate(Image& image, const std::string& bytes, std::size_t table, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t offset = word_at(bytes, table + 4 * i);
    const std::uint32_t segment = word_at(bytes, table + 4 * i + 2);
    const std::size_t at = image.first + paragraph * segment + offset;
    if (at + 2 > image.end) throw UsageError("a relocation of the .EXE is outside its code");
    const auto value =
        image.memory[at] + 0x100U * image.memory[at + 1] + std::uint32_t{load_segment};
    image.memory[at] = static_cast<std::uint8_t>(value);
    image.memory[at + 1] = static_cast<std::uint8_t>(value >> 8U);
  }
}

}  // namespace

void load_exe(Image& image, const std::string& bytes) {
  image.container = exe_container;
  image.bits = 16;
  image.memory.assign(real_mode_bytes, unused);
  if (bytes.size() < header_bytes) throw UsageError("the .EXE is cut off");
  const std::size_t header = std::size_t{paragraph} * word_at(bytes, 8);
  const std::uint32_t last_page = word_at(bytes, 2);
  const std::size_t pages = word_at(bytes, 4);
  // The header counts only the bytes of the program; debug information may follow.
  const std::size_t program = 512 * pages - (last_page == 0 ? 0 : 512 - last_page);
  if (pages == 0 || last_page > 512 || header < header_bytes || program > bytes.size() ||
      header >= program) {
    throw UsageError("the sizes in the header of the .EXE do not fit the file");
  }
  image.first = paragraph * load_segment;
  image.end = image.first + static_cast<std::uint32_t>(program - header);
  if (image.end > image.memory.size() - 0x20000) throw UsageError("the .EXE is too large");
  std::copy(bytes.begin() + static_cast<std::ptrdiff_t>(header),
            bytes.begin() + static_cast<std::ptrdiff_t>(program),
            image.memory.begin() + image.first);
  relocate(image, bytes, word_at(bytes, 0x18), word_at(bytes, 6));
  image.entry = word_at(bytes, 0x14);
  image.code_segment = static_cast<std::uint16_t>(load_segment + word_at(bytes, 0x16));
  image.data_segment = static_cast<std::uint16_t>(load_segment + word_at(bytes, 0x0E));

  image.stack_top = word_at(bytes, 0x10) & ~1U;
  image.reserved = image.end + paragraph * word_at(bytes, 0x0A);
}

void place_stack_of_exe(Image& image) {
  // The routine returns to the end of its segment, which must be free.
  image.exit = 0x10000 - exit_bytes;
  const std::uint32_t exit = image.code_at(image.exit);
  const std::uint32_t segment = image.data_at(0);
  std::uint32_t top = image.stack_top;
  if (top < least_stack) {
    top = 0xFF00;
    // Both addresses are multiples of 16.
    if (exit > segment && exit < segment + top) top = exit - segment;
    if (top < least_stack || segment + top - least_stack < image.end) {
      throw UsageError("the .EXE has a small stack, and its segment has no room for another one");
    }
  }
  // The stack has, from the top, what pointers point to, then the arguments.
  image.data = top - data_bytes;
  image.stack_top = image.data;
  const bool is_in_stack = exit + exit_bytes > segment && exit < segment + top;
  if (exit < image.reserved || is_in_stack) {
    throw UsageError(fmt::format(
        "the .EXE uses all 64 KiB of the code segment {:x}h; give --at a segment whose last {} "
        "bytes are free",
        image.code_segment - image.first / paragraph, exit_bytes));
  }
}

}  // namespace fixproof::judge
