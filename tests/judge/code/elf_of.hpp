/// @file
/// Writes linked ELF files of any processor.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace elf_of {

struct Function {
  std::string_view name;
  std::uint32_t address = 0;  ///< with bit 0 for Thumb code
};

/// Memory that is loaded.
struct Part {
  std::uint32_t address = 0;
  std::string bytes{};
};

struct File {
  unsigned machine = 0;
  unsigned flags = 0;
  bool is_64 = false;
  bool is_big_endian = false;
  std::vector<Part> parts{};
  std::vector<Function> functions{};
};

class Writer {
 public:
  explicit Writer(const File& file) : file_(file) {}

  std::string write() {
    const unsigned header = file_.is_64 ? 64 : 52;
    const unsigned segment = file_.is_64 ? 56 : 32;
    const auto parts = static_cast<unsigned>(file_.parts.size());
    const unsigned first = header + parts * segment;
    unsigned end = first;
    for (const Part& part : file_.parts) end += static_cast<unsigned>(part.bytes.size());
    const std::string names = names_of_functions();
    const std::string symbols = symbols_of_functions();
    const auto table = end + static_cast<unsigned>(names.size());
    write_header(table + static_cast<unsigned>(symbols.size()), header, segment, parts);
    unsigned at = first;
    for (const Part& part : file_.parts) {
      write_segment(part, at);
      at += static_cast<unsigned>(part.bytes.size());
    }
    for (const Part& part : file_.parts) out_ += part.bytes;
    out_ += names + symbols;
    const unsigned size_of_symbol = file_.is_64 ? 24 : 16;
    write_section(0, 0, 0, 0, 0, 0);
    write_section(1, 6, first, static_cast<unsigned>(file_.parts[0].bytes.size()), 0, 0);
    write_section(3, 0, end, static_cast<unsigned>(names.size()), 0, 0);
    write_section(2, 0, table, static_cast<unsigned>(symbols.size()), 2, size_of_symbol);
    return out_;
  }

 private:
  void put(std::string& to, std::uint64_t value, int bytes) const {
    for (int i = 0; i < bytes; ++i) {
      const int shift = 8 * (file_.is_big_endian ? bytes - 1 - i : i);
      to += static_cast<char>(value >> shift & 0xFFU);
    }
  }
  void word(std::uint64_t value) { put(out_, value, file_.is_64 ? 8 : 4); }
  void half(std::uint64_t value) { put(out_, value, 2); }
  void number(std::uint64_t value) { put(out_, value, 4); }

  void write_header(unsigned sections, unsigned header, unsigned segment, unsigned parts) {
    out_ =
        std::string("\177ELF") + (file_.is_64 ? '\2' : '\1') + (file_.is_big_endian ? '\2' : '\1');
    out_ += '\1';
    out_.resize(16);
    half(2);  // an executable
    half(file_.machine);
    number(1);
    word(file_.parts[0].address);
    word(header);
    word(sections);
    number(file_.flags);
    half(header);
    half(segment);
    half(parts);
    half(file_.is_64 ? 64 : 40);
    half(4);
    half(2);
  }

  void write_segment(const Part& part, unsigned at) {
    constexpr unsigned loaded = 1;
    constexpr unsigned all_rights = 7;
    number(loaded);
    if (file_.is_64) number(all_rights);
    word(at);
    word(part.address);
    word(part.address);
    word(part.bytes.size());
    word(part.bytes.size());
    if (!file_.is_64) number(all_rights);
    word(1);
  }

  void write_section(unsigned type, unsigned flags, unsigned at, unsigned size, unsigned link,
                     unsigned entry) {
    number(0);
    number(type);
    word(flags);
    word(type == 1 ? file_.parts[0].address : 0);
    word(at);
    word(size);
    number(link);
    number(0);
    word(1);
    word(entry);
  }

  [[nodiscard]] std::string names_of_functions() const {
    std::string names(1, '\0');
    for (const Function& f : file_.functions) names += std::string(f.name) + '\0';
    return names;
  }

  [[nodiscard]] std::string symbols_of_functions() const {
    constexpr unsigned global_function = 0x12;
    std::string all(file_.is_64 ? 24 : 16, '\0');
    unsigned name = 1;
    for (const Function& f : file_.functions) {
      put(all, name, 4);
      if (file_.is_64) {
        put(all, global_function, 1);
        put(all, 0, 1);
        put(all, 1, 2);
        put(all, f.address, 8);
        put(all, 0, 8);
      } else {
        put(all, f.address, 4);
        put(all, 0, 4);
        put(all, global_function, 1);
        put(all, 0, 1);
        put(all, 1, 2);
      }
      name += static_cast<unsigned>(f.name.size()) + 1;
    }
    return all;
  }

  const File& file_;
  std::string out_;
};

inline std::string bytes_of_hex(std::string_view hex) {
  std::string bytes;
  for (std::size_t i = 0; i + 1 < hex.size(); i += 2) {
    bytes += static_cast<char>(std::stoul(std::string(hex.substr(i, 2)), nullptr, 16));
  }
  return bytes;
}

}  // namespace elf_of
