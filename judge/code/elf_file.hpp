/// @file
/// What objects and linked files of ELF have in common.
#pragma once

#include <cstdint>
#include <cstring>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "judge/code/image.hpp"
#include "support/usage_error.hpp"

namespace fixproof::judge::elf {

/// The address of the first byte of code that may be anywhere. It keeps 0 an invalid pointer.
inline constexpr std::uint32_t load_address = 0x1000;
/// More than there is room for; the parts of a damaged file may add up to any size.
inline constexpr std::size_t max_code_bytes = 0x100000;
/// A name that a file lacks gets an address beyond all memory, so that its use faults, and this
/// many bytes around the address, so that the fault tells the name.
inline constexpr std::uint32_t first_missing = 0x40000000;

struct Section {
  std::uint32_t type = 0;
  std::uint32_t link = 0;
  std::uint32_t info = 0;
  std::uint64_t flags = 0;
  std::uint64_t offset = 0;  ///< in the file
  std::uint64_t size = 0;
  std::uint64_t alignment = 0;
  std::uint32_t place = 0;  ///< in memory, of an object
};
/// A part of a linked file that is loaded.
struct Segment {
  std::uint32_t flags = 0;
  std::uint64_t offset = 0;  ///< in the file
  std::uint64_t address = 0;
  std::uint64_t file_bytes = 0;
  std::uint64_t memory_bytes = 0;
};
struct Symbol {
  std::uint32_t name = 0;
  std::uint16_t section = 0;
  unsigned binding = 0;
  unsigned type = 0;
  std::uint32_t value = 0;
  std::uint64_t size = 0;
};
struct Relocation {
  std::uint32_t type = 0;
  std::uint32_t symbol = 0;
  std::uint64_t offset = 0;
  std::optional<std::int64_t> addend{};  ///< if it does not stand in the section
};

/// The file is damaged.
support::UsageError damaged();

/// Turns a structure of ELF from the other order of bytes to this processor's.
template <class T>
void reverse_fields(T& structure);

/// The tables of a file, of both classes. Each access is checked.
class File {
 public:
  /// @throws support::UsageError also in all other functions, if the file is damaged
  /// @param others_processor whether it is for a processor other than x86
  File(const std::string& bytes, bool is_64, bool is_big_endian = false,
       bool others_processor = false);

  /// ET_REL, ET_EXEC, ET_DYN or another.
  [[nodiscard]] unsigned kind() const { return kind_; }
  [[nodiscard]] bool is_64() const { return is_64_; }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }
  [[nodiscard]] const std::vector<Section>& sections() const { return sections_; }
  [[nodiscard]] std::vector<Section>& sections() { return sections_; }
  [[nodiscard]] const Section& section(std::uint32_t number) const;
  /// Tells whether the section is in memory while the program runs.
  [[nodiscard]] bool is_placed(std::uint32_t section) const;
  /// Returns the segments that are loaded, in the order of the file.
  [[nodiscard]] std::vector<Segment> segments() const;

  [[nodiscard]] std::uint64_t symbols_in(const Section& table) const;
  [[nodiscard]] Symbol symbol_at(const Section& table, std::uint64_t number) const;
  /// Tells whether a section has relocations of the type that the processor uses.
  [[nodiscard]] bool is_list(const Section& section) const;
  [[nodiscard]] bool is_unused_list(const Section& section) const;
  [[nodiscard]] support::UsageError unused_list() const;
  [[nodiscard]] std::uint64_t relocations_in(const Section& list) const;
  [[nodiscard]] Relocation relocation_at(const Section& list, std::uint64_t number) const;
  /// Returns the name of a symbol. All that are read may have 4 MiB together.
  [[nodiscard]] std::string name_of(const Section& table, const Symbol& symbol);
  /// Expects at most one table of symbols of each type, and relocations that do not share bytes:
  /// otherwise a small file could ask for any amount of work.
  void expect_sound_tables() const;

 private:
  template <class T>
  [[nodiscard]] T at(std::uint64_t offset) const {
    T value{};
    if (offset > bytes_.size() || bytes_.size() - offset < sizeof value) throw damaged();
    std::memcpy(&value, bytes_.data() + offset, sizeof value);
    if (is_big_endian_) reverse_fields(value);
    return value;
  }
  template <class Header>
  void read_header();
  template <class Theirs>
  [[nodiscard]] std::vector<Segment> segments_of() const;

  const std::string& bytes_;
  bool is_64_;
  bool is_big_endian_;
  bool others_processor_;
  unsigned kind_ = 0;
  std::uint64_t first_segment_ = 0;  ///< offset of the program headers
  unsigned segments_ = 0;
  unsigned bytes_of_segment_ = 0;
  std::vector<Section> sections_;
  std::size_t name_bytes_ = 0;
};

/// The names that a file lacks, at addresses without memory.
class MissingNames {
 public:
  explicit MissingNames(Image& image) : image_(image) {}

  [[nodiscard]] bool contains(std::uint64_t key) const { return known_.contains(key); }
  /// Returns the address of a name.
  /// @param key  tells names apart
  /// @param name returns the name; called once for each key
  template <class Name>
  std::uint32_t address_of(std::uint64_t key, const Name& name) {
    const auto [known, is_new] = known_.try_emplace(key, 0);
    if (is_new) known->second = add(name());
    return known->second;
  }

 private:
  std::uint32_t add(std::string name);

  Image& image_;
  std::map<std::uint64_t, std::uint32_t> known_;
};

/// Tells whether a user may ask for the function: it is none that a compiler or linker adds.
bool is_routine(const std::string& name);

/// Loads a linked file.
/// @throws support::UsageError without the file's name
void load_linked(Image& image, File& file);

}  // namespace fixproof::judge::elf
