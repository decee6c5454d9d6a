#include <elf.h>
#include <fmt/format.h>

#include <cstring>

#include "judge/load.hpp"
#include "support/plain_text.hpp"
#include "support/usage_error.hpp"

namespace fixproof::judge {

namespace {

using support::UsageError;

/// The address of the first section. It keeps 0 an invalid pointer.
constexpr std::uint32_t origin = 0x1000;
/// More than there is room for; sections of a damaged file may add up to any
/// size.
constexpr std::size_t max_code_bytes = 0x100000;
/// The names that are read, together. Those of C++ may be long, those of a damaged file of any
/// length.
constexpr std::size_t max_name_bytes = std::size_t{1} << 22U;

class Object {
 public:
  Object(Image& image, const std::string& bytes) : image_(image), bytes_(bytes) {}

  void load() {
    const auto header = at<Elf32_Ehdr>(0);
    if (header.e_ident[EI_CLASS] != ELFCLASS32 || header.e_ident[EI_DATA] != ELFDATA2LSB ||
        header.e_machine != EM_386) {
      throw UsageError(
          "the ELF file is not i386 code; compile with -m32, "
          "assemble with -f elf32");
    }
    if (header.e_type != ET_REL) {
      throw UsageError("the ELF file is linked; give the object from before linking");
    }
    if (header.e_shentsize != sizeof(Elf32_Shdr)) throw damaged();
    for (std::uint32_t i = 0; i < header.e_shnum; ++i) {
      sections_.push_back(at<Elf32_Shdr>(header.e_shoff + std::uint64_t{i} * sizeof(Elf32_Shdr)));
    }
    place();
    expect_sound_tables();
    read_symbols();
    for (const Elf32_Shdr& section : sections_) {
      if (section.sh_type == SHT_REL) relocate(section);
      if (section.sh_type == SHT_RELA && is_placed(section.sh_info)) {
        throw UsageError(
            "the ELF file has relocations with addends, which "
            "i386 code does not use");
      }
    }
  }

 private:
  static UsageError damaged() { return UsageError("the ELF file is damaged"); }

  template <class T>
  [[nodiscard]] T at(std::uint64_t offset) const {
    T value{};
    if (offset > bytes_.size() || bytes_.size() - offset < sizeof value) throw damaged();
    std::memcpy(&value, bytes_.data() + offset, sizeof value);
    return value;
  }

  [[nodiscard]] std::string text_at(const Elf32_Shdr& strings, std::uint32_t offset) {
    std::string text;
    for (std::uint64_t i = std::uint64_t{strings.sh_offset} + offset;; ++i) {
      const char c = at<char>(i);
      if (c == '\0') return text;
      if (name_bytes_++ == max_name_bytes) {
        throw UsageError("the names in the ELF file have more than 4 MiB");
      }
      text += c;
    }
  }

  [[nodiscard]] bool is_placed(std::uint32_t section) const {
    return section < sections_.size() && (sections_[section].sh_flags & SHF_ALLOC) != 0;
  }

  /// Places the sections one after the other.
  void place() {
    std::string flat;
    for (Elf32_Shdr& section : sections_) {
      if ((section.sh_flags & SHF_ALLOC) == 0) continue;
      const std::size_t alignment = section.sh_addralign == 0 ? 1 : section.sh_addralign;
      if (alignment > 0x1000) throw damaged();
      if (flat.size() + alignment + std::size_t{section.sh_size} > max_code_bytes) {
        throw UsageError("the ELF file has more than 1 MiB of code and data");
      }
      flat.resize((flat.size() + alignment - 1) / alignment * alignment);
      section.sh_addr = origin + static_cast<std::uint32_t>(flat.size());
      if (section.sh_type == SHT_NOBITS) {
        flat.resize(flat.size() + section.sh_size);
      } else {
        if (section.sh_offset > bytes_.size() ||
            bytes_.size() - section.sh_offset < section.sh_size) {
          throw damaged();
        }
        flat.append(bytes_, section.sh_offset, section.sh_size);
      }
    }
    if (flat.empty()) throw UsageError("the ELF file has no code");
    image_.container = "ELF object";
    load_flat(image_, flat, origin);
  }

  /// One table of symbols, and relocations that do not share bytes: otherwise a
  /// small file could ask for any amount of work.
  void expect_sound_tables() const {
    std::uint64_t symbol_tables = 0;
    std::uint64_t relocation_bytes = 0;
    for (const Elf32_Shdr& table : sections_) {
      if (table.sh_type == SHT_SYMTAB) ++symbol_tables;
      if (table.sh_type == SHT_REL) relocation_bytes += table.sh_size;
    }
    if (symbol_tables > 1 || relocation_bytes > bytes_.size()) throw damaged();
  }

  [[nodiscard]] const Elf32_Shdr& section(std::uint32_t number) const {
    if (number >= sections_.size()) throw damaged();
    return sections_[number];
  }

  void read_symbols() {
    for (const Elf32_Shdr& table : sections_) {
      if (table.sh_type != SHT_SYMTAB) continue;
      for (std::uint32_t i = 0; i < table.sh_size / sizeof(Elf32_Sym); ++i) {
        const auto symbol = at<Elf32_Sym>(table.sh_offset + i * sizeof(Elf32_Sym));
        const bool is_code =
            is_placed(symbol.st_shndx) && (section(symbol.st_shndx).sh_flags & SHF_EXECINSTR) != 0;
        const auto binding = ELF32_ST_BIND(symbol.st_info);
        if (!is_code || symbol.st_name == 0 || binding == STB_LOCAL) continue;
        image_.symbols.push_back({text_at(section(table.sh_link), symbol.st_name),
                                  section(symbol.st_shndx).sh_addr + symbol.st_value});
      }
    }
  }

  [[nodiscard]] std::uint32_t value_of(const Elf32_Shdr& table, std::uint32_t number) {
    if (number >= table.sh_size / sizeof(Elf32_Sym)) throw damaged();
    const auto symbol = at<Elf32_Sym>(table.sh_offset + number * sizeof(Elf32_Sym));
    if (symbol.st_shndx == SHN_ABS) return symbol.st_value;
    if (!is_placed(symbol.st_shndx)) {
      throw UsageError(
          fmt::format("the code uses {}, which the object does not have",
                      support::quoted(text_at(section(table.sh_link), symbol.st_name))));
    }
    return section(symbol.st_shndx).sh_addr + symbol.st_value;
  }

  void relocate(const Elf32_Shdr& list) {
    if (!is_placed(list.sh_info)) return;  // debugging information
    const Elf32_Shdr& to = section(list.sh_info);
    for (std::uint32_t i = 0; i < list.sh_size / sizeof(Elf32_Rel); ++i) {
      const auto one = at<Elf32_Rel>(list.sh_offset + i * sizeof(Elf32_Rel));
      const std::uint32_t type = ELF32_R_TYPE(one.r_info);
      const std::uint32_t size = type == R_386_16 || type == R_386_PC16 ? 2 : 4;
      if (one.r_offset > to.sh_size || to.sh_size - one.r_offset < size) throw damaged();
      const std::uint32_t place = to.sh_addr + one.r_offset;
      std::uint32_t value = value_of(section(list.sh_link), ELF32_R_SYM(one.r_info));
      switch (type) {
        case R_386_32:
        case R_386_16:
          break;
        case R_386_PC32:
        case R_386_PLT32:
        case R_386_PC16:
          value -= place;
          break;
        default:
          throw UsageError(
              fmt::format("the object has a relocation of type {}; compile with -fno-pic", type));
      }
      std::uint32_t carry = value;
      std::uint32_t sum = 0;
      for (std::uint32_t byte = 0; byte < size; ++byte) {
        sum += image_.memory[place + byte] + (carry & 0xFFU);
        image_.memory[place + byte] = static_cast<std::uint8_t>(sum);
        sum >>= 8U;
        carry >>= 8U;
      }
    }
  }

  Image& image_;
  const std::string& bytes_;
  std::vector<Elf32_Shdr> sections_;
  std::size_t name_bytes_ = 0;
};

}  // namespace

void load_elf(Image& image, const std::string& bytes) { Object(image, bytes).load(); }

}  // namespace fixproof::judge
