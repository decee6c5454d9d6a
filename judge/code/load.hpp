/// @file
/// Reads a user's code from a file.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "judge/code/image.hpp"

namespace fixproof::judge {

struct LoadOptions {
  std::optional<int> bits{};  ///< 16, 32 or 64; by default what the container or the source says
  /// The routine: `OFFSET`, `OFFSET..END`, or `SEGMENT:OFFSET` in an .EXE. Numbers are written as
  /// 0x1f, 1fh or 31; after `SEGMENT:` all are hexadecimal, as in a map file. If empty, `symbol`
  /// names the routine. Without both, the routine is the start of the code, or the only function of
  /// an object.
  std::string at{};
  std::string symbol{};
  /// Whether the toolchain's linker adds what compilers call. load() always does so.
  bool is_linked = false;
};

/// A place as `--at` has it.
struct Location {
  std::optional<std::uint32_t> segment{};
  std::uint32_t offset = 0;
  std::optional<std::uint32_t> end{};  ///< after the routine; more than `offset`
};
/// Parses `OFFSET`, `OFFSET..END` or either after `SEGMENT:`.
/// @throws support::UsageError
Location location_named(std::string_view at);

/// Returns the bytes of a file as they are, of NASM source those that nasm assembles.
/// @throws support::UsageError naming the file and what is wrong with it
std::string bytes_of(const std::string& path);

/// Loads a flat binary, .COM, MZ .EXE, ELF file or NASM source. An .EXE and an ELF file are
/// recognised by their contents, a .COM program and a source by their names. Any other file is a
/// flat binary that starts at address 0.
/// @throws support::UsageError naming the file and what is wrong with it
Image load(const std::string& path, const LoadOptions& options);

/// Loads the contents of a file other than source. Of the path only the ending counts.
/// @throws support::UsageError as load()
Image load_bytes(const std::string& path, const std::string& bytes, const LoadOptions& options);

// The loaders of load(), one for each container. Each fills in `image`, with the start of the code
// as the routine.

/// @param origin the address of the first byte
void load_flat(Image& image, const std::string& bytes, std::uint32_t origin);
/// @throws support::UsageError without the file's name
void load_exe(Image& image, const std::string& bytes);
/// Places the stack and the return address, after `--at` has chosen the segment of the code.
/// @throws support::UsageError without the file's name
void place_stack_of_exe(Image& image);
/// Returns the width of the code in an ELF file: 32 for i386, 64 for x86-64, nothing for others.
std::optional<int> bits_of_elf(std::string_view bytes);
/// Loads an object, a program or a shared library.
/// @pre image.bits is 64 if and only if bits_of_elf() says so
/// @param is_linked as in LoadOptions; without it, an object of another processor is refused
void load_elf(Image& image, const std::string& bytes, bool is_linked);
/// Returns the width that a source states before its first instruction, with BITS or USE.
std::optional<int> bits_of_source(const std::string& path);
/// Assembles a source with nasm, which must be on the PATH.
void load_source(Image& image, const std::string& path);

/// Tells whether the path ends in an extension, in upper or lower case.
bool has_extension(const std::string& path, const std::string& extension);

}  // namespace fixproof::judge
