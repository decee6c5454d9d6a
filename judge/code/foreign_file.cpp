#include "judge/code/foreign_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <utility>

#include "judge/code/load.hpp"
#include "support/usage_error.hpp"

namespace fixproof::judge {

namespace {

using support::UsageError;

constexpr const char* to_compile = "is a source; compile it, as with gcc -c, and give the object";
constexpr const char* to_link = "is an object, but not ELF; link it to a .COM program or an .EXE";
constexpr const char* to_run =
    "is no machine code; judge a program that reads cases, such as --run 'python3 mine.py'";
constexpr const char* to_import =
    "is no machine code; import fixproof in Python to judge a function, or judge a program that "
    "reads cases: --run 'python3 mine.py'";
constexpr const char* to_simulate =
    "describes hardware; simulate it with a bench that reads cases: --run 'vvp -n bench'";
constexpr const char* to_take_elf =
    "does not say for which processor it is; give the ELF file that it was made from";
constexpr const char* to_check =
    "is text, no machine code; judge a program with --run './mine', and results with fixproof "
    "check";
constexpr std::array<std::pair<const char*, const char*>, 21> no_machine_code{{
    {".s", to_compile},    {".pas", to_compile},   {".bas", to_compile},  {".obj", to_link},
    {".py", to_import},    {".js", to_run},        {".rs", to_run},       {".go", to_run},
    {".java", to_run},     {".cs", to_run},        {".awk", to_run},      {".lua", to_run},
    {".rb", to_run},       {".pl", to_run},        {".v", to_simulate},   {".sv", to_simulate},
    {".vhd", to_simulate}, {".vhdl", to_simulate}, {".hex", to_take_elf}, {".srec", to_take_elf},
    {".s19", to_take_elf},
}};

constexpr std::string_view other_system =
    "and judge reads ELF; compile the source for Linux, or judge a program with --run './mine'";

/// How files of other formats begin, and what they are.
constexpr std::array<std::pair<std::string_view, std::string_view>, 7> beginnings{{
    {"\xCF\xFA\xED\xFE", "Mach-O file"},
    {"\xCE\xFA\xED\xFE", "Mach-O file"},
    {"\xFE\xED\xFA\xCF", "Mach-O file"},
    {"\xFE\xED\xFA\xCE", "Mach-O file"},
    {"\xCA\xFE\xBA\xBE", "file of Java or of several Mach-O files"},
    {std::string_view("\0asm", 4), "module of WebAssembly"},
    {"BC\xC0\xDE", "file of LLVM's bitcode"},
}};

/// Tells whether all bytes are text in ASCII. No routine is: each return has a byte above 7fh.
bool is_text(const std::string& bytes) {
  return !bytes.empty() && std::ranges::all_of(bytes, [](unsigned char c) {
    return std::isprint(c) != 0 || std::isspace(c) != 0;
  });
}

}  // namespace

void expect_machine_code(const std::string& path, const std::string& bytes) {
  for (const auto& [extension, what] : no_machine_code) {
    if (has_extension(path, extension)) throw UsageError(what);
  }
  if (is_text(bytes)) throw UsageError(to_check);
  if (bytes.starts_with("!<arch>\n") || bytes.starts_with("!<thin>\n")) {
    throw UsageError("is an archive of objects; give one of them, which ar x takes out");
  }
  // The first section of an object for Windows comes right after the header.
  constexpr std::size_t bytes_of_header = 20;
  if (bytes.size() > bytes_of_header && bytes.compare(bytes_of_header, 6, ".text\0", 6) == 0) {
    throw UsageError(fmt::format("is an object for Windows, {}", other_system));
  }
  for (const auto& [beginning, what] : beginnings) {
    if (!bytes.starts_with(beginning)) continue;
    throw UsageError(fmt::format("is a {}, {}", what, other_system));
  }
}

void expect_no_windows(const std::string& bytes) {
  constexpr std::size_t place_of_header = 0x3C;
  if (bytes.size() < place_of_header + 4) return;
  std::size_t at = 0;
  for (std::size_t i = 4; i-- > 0;) {
    at = at << 8U | static_cast<unsigned char>(bytes[place_of_header + i]);
  }
  if (at > bytes.size() - 4 || bytes.compare(at, 4, std::string_view("PE\0\0", 4)) != 0) return;
  throw UsageError(fmt::format("is a program or library of Windows, {}", other_system));
}

}  // namespace fixproof::judge
