#include <elf.h>
#include <fmt/format.h>

#include <cstring>
#include <map>
#include <optional>

#include "judge/code/bytes.hpp"
#include "judge/code/compiler.hpp"
#include "judge/code/elf_file.hpp"
#include "judge/code/load.hpp"
#include "support/plain_text.hpp"
#include "support/usage_error.hpp"

namespace fixproof::judge {

namespace {

using elf::Relocation;
using elf::Section;
using support::UsageError;

class Object {
 public:
  Object(Image& image, elf::File& file) : image_(image), file_(file), missing_(image) {}

  void load() {
    file_.expect_sound_tables();
    place();
    read_symbols();
    for (const Section& section : file_.sections()) {
      if (file_.is_list(section)) relocate(section);
      if (file_.is_unused_list(section) && file_.is_placed(section.info)) {
        throw file_.unused_list();
      }
    }
  }

 private:
  /// The bytes of an entry of the global offset table.
  [[nodiscard]] std::uint32_t entry_bytes() const { return file_.is_64() ? 8 : 4; }

  /// Appends zeros to the code and data, and returns where they start.
  static std::uint32_t reserve(std::string& flat, std::uint64_t alignment, std::uint64_t size) {
    if (alignment > 0x1000) throw elf::damaged();
    if (size > elf::max_code_bytes || flat.size() + alignment + size > elf::max_code_bytes) {
      throw UsageError("the ELF file has more than 1 MiB of code and data");
    }
    if (alignment > 1) flat.resize((flat.size() + alignment - 1) / alignment * alignment);
    const auto start = static_cast<std::uint32_t>(flat.size());
    flat.resize(flat.size() + size);
    return start;
  }

  /// Places the sections one after the other.
  void place() {
    std::string flat;
    for (Section& section : file_.sections()) {
      if ((section.flags & SHF_ALLOC) == 0) continue;
      const std::uint32_t start = reserve(flat, section.alignment, section.size);
      section.place = elf::load_address + start;
      if (section.type == SHT_NOBITS) continue;
      if (section.offset > file_.bytes().size() ||
          file_.bytes().size() - section.offset < section.size) {
        throw elf::damaged();
      }
      flat.replace(start, section.size, file_.bytes(), section.offset, section.size);
    }
    if (flat.empty()) throw UsageError("the ELF file has no code");
    place_common_symbols(flat);
    place_offset_table(flat);
    image_.container = object_container;
    load_flat(image_, flat, elf::load_address);
  }

  /// Places variables without a section, which older compilers make of `int counter;` in C.
  void place_common_symbols(std::string& flat) {
    for (const Section& table : file_.sections()) {
      if (table.type != SHT_SYMTAB) continue;
      for (std::uint64_t i = 0; i < file_.symbols_in(table); ++i) {
        const elf::Symbol symbol = file_.symbol_at(table, i);
        if (symbol.section != SHN_COMMON) continue;
        common_[i] = elf::load_address + reserve(flat, symbol.value, symbol.size);
      }
    }
  }

  /// Places the global offset table of position-independent code. Each relocation that needs an
  /// entry gets one of its own.
  void place_offset_table(std::string& flat) {
    flat.resize((flat.size() + 7) / 8 * 8);
    offset_table_ = next_entry_ = elf::load_address + static_cast<std::uint32_t>(flat.size());
    for (const Section& list : file_.sections()) {
      if (!file_.is_list(list) || !file_.is_placed(list.info)) continue;
      for (std::uint64_t i = 0; i < file_.relocations_in(list); ++i) {
        if (needs_entry(file_.relocation_at(list, i).type)) flat.append(entry_bytes(), '\0');
      }
    }
  }

  [[nodiscard]] bool needs_entry(std::uint32_t type) const {
    if (!file_.is_64()) return type == R_386_GOT32 || type == R_386_GOT32X;
    return type == R_X86_64_GOTPCREL || type == R_X86_64_GOTPCRELX ||
           type == R_X86_64_REX_GOTPCRELX;
  }

  void read_symbols() {
    for (const Section& table : file_.sections()) {
      if (table.type != SHT_SYMTAB) continue;
      for (std::uint64_t i = 0; i < file_.symbols_in(table); ++i) {
        const elf::Symbol symbol = file_.symbol_at(table, i);
        const bool is_code = file_.is_placed(symbol.section) &&
                             (file_.section(symbol.section).flags & SHF_EXECINSTR) != 0;
        if (!is_code || symbol.name == 0 || symbol.binding == STB_LOCAL) continue;
        std::string name = file_.name_of(table, symbol);
        if (!elf::is_routine(name)) continue;
        image_.symbols.push_back(
            {std::move(name), file_.section(symbol.section).place + symbol.value});
      }
    }
  }

  [[nodiscard]] std::uint32_t value_of(const Section& table, std::uint32_t number) {
    const elf::Symbol symbol = file_.symbol_at(table, number);
    if (symbol.section == SHN_ABS) return symbol.value;
    if (const auto place = common_.find(number); place != common_.end()) return place->second;
    if (file_.is_placed(symbol.section)) return file_.section(symbol.section).place + symbol.value;
    if (symbol.binding == STB_WEAK) return 0;
    return missing_.address_of(number, [&] { return file_.name_of(table, symbol); });
  }

  /// All 16-bit addresses have memory, so no fault tells that a name is missing.
  void expect_present(const Section& table, std::uint32_t number) {
    if (!missing_.contains(number)) return;
    const std::string name = file_.name_of(table, file_.symbol_at(table, number));
    throw UsageError(
        fmt::format("the code uses {}, which the object does not have", support::quoted(name)));
  }

  [[nodiscard]] std::uint32_t entry_for(std::uint32_t value) {
    store(image_.memory.data() + next_entry_, value, static_cast<int>(entry_bytes()));
    next_entry_ += entry_bytes();
    return next_entry_ - entry_bytes();
  }

  /// Returns what a relocation adds to the bytes at `place`.
  [[nodiscard]] std::uint32_t addend_of(const Relocation& one, const Section& symbols,
                                        std::uint32_t place) {
    const std::uint32_t type = one.type;
    if (type == R_386_GOTPC) return offset_table_ - place;
    const std::uint32_t value = value_of(symbols, one.symbol);
    switch (type) {
      case R_386_16:
      case R_386_PC16:
        expect_present(symbols, one.symbol);
        return type == R_386_16 ? value : value - place;
      case R_386_32:
        return value;
      case R_386_PC32:
      case R_386_PLT32:
        return value - place;
      case R_386_GOTOFF:
        return value - offset_table_;
      case R_386_GOT32:
      case R_386_GOT32X: {
        // Without a base register, the ModR/M byte before the place asks for an absolute address.
        const bool is_absolute = (image_.memory[place - 1] & 0xC7U) == 5;
        return entry_for(value) - (is_absolute ? 0 : offset_table_);
      }
      default:
        throw UsageError(fmt::format(
            "the object has a relocation of type {}; compile with -fno-pic -fno-pie", type));
    }
  }

  /// The same for x86-64, whose addresses here have less than 32 bits.
  [[nodiscard]] std::uint32_t addend_of_64_bits(const Relocation& one, const Section& symbols,
                                                std::uint32_t place) {
    const std::uint32_t value = value_of(symbols, one.symbol);
    switch (one.type) {
      case R_X86_64_64:
      case R_X86_64_32:
      case R_X86_64_32S:
        return value;
      case R_X86_64_PC32:
      case R_X86_64_PLT32:
      case R_X86_64_PC64:
        return value - place;
      case R_X86_64_GOTPCREL:
      case R_X86_64_GOTPCRELX:
      case R_X86_64_REX_GOTPCRELX:
        return entry_for(value) - place;
      default:
        throw UsageError(fmt::format(
            "the object has a relocation of type {}; compile with -fno-pic -fno-pie", one.type));
    }
  }

  [[nodiscard]] std::uint32_t bytes_of(const Relocation& one) const {
    if (file_.is_64()) return one.type == R_X86_64_64 || one.type == R_X86_64_PC64 ? 8 : 4;
    return one.type == R_386_16 || one.type == R_386_PC16 ? 2 : 4;
  }

  void relocate(const Section& list) {
    if (!file_.is_placed(list.info)) return;  // debugging information
    const Section& to = file_.section(list.info);
    for (std::uint64_t i = 0; i < file_.relocations_in(list); ++i) {
      const Relocation one = file_.relocation_at(list, i);
      const std::uint32_t size = bytes_of(one);
      if (one.offset > to.size || to.size - one.offset < size) throw elf::damaged();
      const std::uint32_t place = to.place + static_cast<std::uint32_t>(one.offset);
      std::uint8_t* const bytes = image_.memory.data() + place;
      const Section& symbols = file_.section(list.link);
      if (one.addend) {
        const std::uint32_t added = addend_of_64_bits(one, symbols, place);
        const auto sum = static_cast<std::int64_t>(static_cast<std::int32_t>(added)) + *one.addend;
        store(bytes, static_cast<std::uint64_t>(sum), static_cast<int>(size));
      } else {
        const std::uint32_t added = addend_of(one, symbols, place);
        store(bytes, std::uint64_t{fetch(bytes, static_cast<int>(size))} + added,
              static_cast<int>(size));
      }
    }
  }

  Image& image_;
  elf::File& file_;
  elf::MissingNames missing_;
  std::map<std::uint64_t, std::uint32_t> common_;  ///< the addresses of variables without a section
  std::uint32_t offset_table_ = 0;
  std::uint32_t next_entry_ = 0;  ///< the first free one of the table
};

}  // namespace

void load_elf(Image& image, const std::string& bytes) {
  const bool is_other = image.architecture != nullptr;
  elf::File file(bytes, image.bits == 64, image.is_big_endian(), is_other);
  switch (file.kind()) {
    case ET_REL: {
      if (is_other) {
        load_elf(image, linked_object(image, bytes));
        image.container = object_container;
        return keep_symbols_of(image, bytes);
      }
      const std::string whole = with_library_functions(bytes, image.bits);
      elf::File all(whole, image.bits == 64);
      Object(image, all).load();
      if (whole != bytes) keep_symbols_of(image, bytes);
      return;
    }
    case ET_EXEC:
    case ET_DYN:
      return elf::load_linked(image, file);
    default:
      throw UsageError("the ELF file is neither an object nor a program or shared library");
  }
}

std::optional<int> bits_of_elf(std::string_view bytes) {
  Elf32_Ehdr header{};  // in 64 bits, too, these members have their places
  if (bytes.size() < sizeof header) return std::nullopt;
  std::memcpy(&header, bytes.data(), sizeof header);
  if (header.e_ident[EI_DATA] != ELFDATA2LSB) return std::nullopt;
  if (header.e_ident[EI_CLASS] == ELFCLASS32 && header.e_machine == EM_386) return 32;
  if (header.e_ident[EI_CLASS] == ELFCLASS64 && header.e_machine == EM_X86_64) return 64;
  return std::nullopt;
}

}  // namespace fixproof::judge
