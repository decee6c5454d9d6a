#include "judge/code/load.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <stdexcept>
#include <string_view>

#include "judge/code/compiler.hpp"
#include "judge/code/foreign_file.hpp"
#include "judge/code/machine.hpp"
#include "judge/code/routine_named.hpp"
#include "support/bounded_file.hpp"
#include "support/plain_text.hpp"
#include "support/usage_error.hpp"

namespace fixproof::judge {

namespace {

using support::UsageError;

constexpr std::size_t max_file_bytes = std::size_t{1} << 20U;
/// Debugging information, which is not loaded, may be many times as long as code.
constexpr std::size_t max_bytes_with_information = std::size_t{1} << 24U;
constexpr std::uint32_t com_origin = 0x100;

/// Reads 0x1f, 1fh or, in base 10, 31.
std::uint32_t number_in(std::string_view text, int base = 10) {
  std::string_view digits = text;
  if (digits.starts_with("0x") || digits.starts_with("0X")) {
    digits.remove_prefix(2);
    base = 16;
  } else if (digits.ends_with('h') || digits.ends_with('H')) {
    digits.remove_suffix(1);
    base = 16;
  }
  std::uint32_t value = 0;
  const char* const end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, value, base);
  if (digits.empty() || error != std::errc() || stop != end) {
    throw UsageError(fmt::format("--at: {} is not an address; write one like 0x1f or 1fh",
                                 support::quoted(text)));
  }
  return value;
}

void enter_at(Image& image, std::string_view at) {
  const Location place = location_named(at);
  if (place.segment) {
    if (image.container != exe_container) {
      throw UsageError(
          "--at SEGMENT:OFFSET is for an .EXE; this code has one segment, so write --at OFFSET");
    }
    if (*place.segment > 0xFFFF - image.first / 16) {
      throw UsageError("--at: the segment is outside the file");
    }
    image.code_segment = static_cast<std::uint16_t>(*place.segment + image.first / 16);
  }
  image.entry = place.offset;
  image.entry_end = place.end.value_or(0);
}

void find_entry(Image& image, const LoadOptions& options) {
  if (!options.at.empty()) return enter_at(image, options.at);
  if (!options.symbol.empty()) return enter_symbol(image, options.symbol);
  const bool is_object = image.container == object_container;
  if (!is_object && image.container != linked_container) return;
  if (image.symbols.size() != 1) {
    if (image.symbols.empty() && image.hidden.empty())
      throw UsageError(is_object ? "the object has no global function; make the routine global"
                                 : "the linked ELF file has no global function; give --at");
    enter_symbol(image, "");  // throws with the names
  }
  image.entry = image.symbols.front().offset;
}

Image entered(Image image, const LoadOptions& options) {
  find_entry(image, options);
  if (image.architecture != nullptr && image.architecture->has_marked_entries) {
    image.entry_mode = image.entry % 2;
    image.entry -= image.entry_mode;
  }
  if (image.container == exe_container) place_stack_of_exe(image);
  const std::uint32_t entry = image.code_at(image.entry);
  if (entry < image.first || entry >= image.end) {
    throw UsageError(fmt::format("the routine at {:x}h is outside the code, {:x}h to {:x}h",
                                 image.entry, image.first - image.code_at(0),
                                 image.end - image.code_at(0)));
  }
  return image;
}

bool is_source(const std::string& path) {
  return has_extension(path, ".asm") || has_extension(path, ".nasm");
}

void set_bits(Image& image, std::optional<int> known) {
  image.bits = known.value_or(16);
  image.has_assumed_bits = !known;
}

Image image_of_source(const std::string& path, const LoadOptions& options) {
  Image image;
  const std::optional<int> stated = bits_of_source(path);
  if (options.bits && stated && options.bits != stated) {
    throw UsageError(fmt::format("--bits {}: the source says bits {}; leave --bits out",
                                 *options.bits, *stated));
  }
  set_bits(image, options.bits ? options.bits : stated);
  load_source(image, path);
  return image;
}

Image image_of(const std::string& path, const std::string& bytes, const LoadOptions& options) {
  Image image;
  if (bytes.starts_with("\177ELF")) {
    image.architecture = architecture_of_elf(bytes);
    const std::optional<int> bits =
        image.architecture != nullptr ? image.architecture->word_bits : bits_of_elf(bytes);
    if (!bits) {
      const std::string others = names_of_architectures();
      throw UsageError(fmt::format(
          "the ELF file is for none of the processors that judge runs: i386, x86-64{}{}",
          others.empty() ? "; others need Unicorn" : ", ", others));
    }
    if (const std::string absence = absence_on_emulator(image.architecture); !absence.empty()) {
      throw UsageError(absence);
    }
    // An object for the i386 may have 16-bit code.
    image.bits = options.bits.value_or(*bits);
    if ((image.bits == 64) != (*bits == 64) ||
        (image.architecture != nullptr && image.bits != *bits)) {
      throw UsageError(fmt::format("--bits {}: the ELF file has {}-bit code; leave --bits out",
                                   image.bits, *bits));
    }
    load_elf(image, bytes, options.is_linked);
  } else if (bytes.starts_with("MZ")) {
    expect_no_windows(bytes);
    if (options.bits == 32) throw UsageError("--bits 32: a DOS .EXE has 16-bit code");
    load_exe(image, bytes);
  } else if (has_extension(path, ".com")) {
    if (options.bits == 32) throw UsageError("--bits 32: a .COM program has 16-bit code");
    image.container = ".COM program";
    load_flat(image, bytes, com_origin);
  } else {
    expect_machine_code(path, bytes);
    set_bits(image, options.bits);
    image.container = flat_container;
    load_flat(image, bytes, 0);
  }
  return image;
}

/// Puts the file's name before the error that `read` throws.
template <class Read>
auto naming_the_file(const std::string& path, const Read& read) {
  try {
    return read();
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::runtime_error& error) {
    throw UsageError(fmt::format("{}: {}", path, error.what()));
  }
}

}  // namespace

bool has_extension(const std::string& path, const std::string& extension) {
  if (path.size() < extension.size()) return false;
  return std::equal(
      extension.begin(), extension.end(), path.end() - std::ssize(extension),
      [](char a, char b) { return a == std::tolower(static_cast<unsigned char>(b)); });
}

void load_flat(Image& image, const std::string& bytes, std::uint32_t origin) {
  const DataSpace apart = image.architecture != nullptr ? image.architecture->data : DataSpace{};
  const bool is_apart = apart.first != 0;
  image.memory.assign(is_apart           ? apart.first + DataSpace::bytes
                      : image.bits == 16 ? 0x10000
                                         : 0x100000,
                      image.architecture != nullptr ? unused_elsewhere : unused);
  const auto size = static_cast<std::uint32_t>(image.memory.size());
  image.exit = (is_apart ? apart.code_end : image.base + size) - exit_bytes;
  image.data = image.base + size - exit_bytes - data_bytes;
  image.stack_top = image.data;
  const std::uint32_t room = (is_apart ? image.exit : image.stack_top - stack_bytes) & ~0xFFFU;
  if (origin > room || bytes.size() > room - origin) {
    throw UsageError(fmt::format("the code ends at {:x}h; {}-bit code has room up to {:x}h",
                                 origin + bytes.size(), image.bits, room));
  }
  std::copy(bytes.begin(), bytes.end(), image.memory.begin() + image.index_of(origin));
  image.first = origin;
  image.end = origin + static_cast<std::uint32_t>(bytes.size());
  image.entry = origin;
}

Location location_named(std::string_view at) {
  const std::size_t dots = at.find("..");
  std::string_view start = at.substr(0, dots);
  Location place;
  if (const std::size_t colon = start.find(':'); colon != std::string_view::npos) {
    place.segment = number_in(start.substr(0, colon), 16);
    start.remove_prefix(colon + 1);
  }
  // A map file has addresses in hex, without a sign of that.
  const int base = place.segment ? 16 : 10;
  place.offset = number_in(start, base);
  if (dots != std::string_view::npos) {
    place.end = number_in(at.substr(dots + 2), base);
    if (*place.end <= place.offset) throw UsageError("--at: END must be above OFFSET");
  }
  return place;
}

std::string bytes_of(const std::string& path) {
  return naming_the_file(path, [&] {
    if (!is_source(path)) return support::read_bounded(path, max_file_bytes);
    Image image;
    load_source(image, path);
    return std::string(image.memory.begin() + image.first, image.memory.begin() + image.end);
  });
}

Image load(const std::string& path, const LoadOptions& options) {
  return naming_the_file(path, [&] {
    if (is_source(path)) return entered(image_of_source(path, options), options);
    const bool is_c = is_c_source(path);
    const std::string bytes =
        is_c ? compiled_source(path) : support::read_bounded(path, max_bytes_with_information);
    if (is_c && !bytes.starts_with("\177ELF")) {
      throw UsageError("the compiler does not write ELF objects; choose another with $CC or $CXX");
    }
    LoadOptions linked = options;
    linked.is_linked = true;
    return entered(image_of(path, bytes, linked), options);
  });
}

Image load_bytes(const std::string& path, const std::string& bytes, const LoadOptions& options) {
  return naming_the_file(path, [&] { return entered(image_of(path, bytes, options), options); });
}

}  // namespace fixproof::judge
