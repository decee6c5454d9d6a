#include "judge/code/compiler.hpp"

#include <elf.h>
#include <fmt/format.h>
#include <stdlib.h>  // NOLINT(modernize-deprecated-headers): mkdtemp() is POSIX's

#include <algorithm>
#include <boost/process/search_path.hpp>
#include <cstdlib>
#include <map>
#include <set>
#include <sstream>
#include <system_error>

#include "judge/code/elf_file.hpp"
#include "judge/code/load.hpp"
#include "judge/code/tool.hpp"
#include "support/bounded_file.hpp"
#include "support/plain_text.hpp"
#include "support/split.hpp"
#include "support/usage_error.hpp"

namespace fixproof::judge {

namespace {

using support::UsageError;

constexpr std::chrono::minutes most_time{2};
constexpr std::size_t most_bytes = std::size_t{16} << 20U;

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

/// Returns the first line that has an error, or else the first line: warnings and the names of
/// files that include each other may come before it.
std::string first_error(const std::string& text) {
  std::istringstream lines(text);
  std::string other;
  for (std::string line; std::getline(lines, line);) {
    if (line.find("error:") != std::string::npos) return support::printable(line);
    // The linker's errors have no such mark.
    if (other.empty() && line.find("warning:") == std::string::npos) other = line;
  }
  return support::printable(other.empty() ? first_line(text) : other);
}

std::string variable(const char* name, const char* otherwise) {
  const char* const value = std::getenv(name);  // NOLINT(concurrency-mt-unsafe): no one sets it
  return value != nullptr && *value != '\0' ? value : otherwise;
}

bool exists(const std::string& program) { return !boost::process::search_path(program).empty(); }

/// Names of functions and variables that an object uses and does not have, or has.
enum class Names { missing, own };
std::set<std::string> names_in(const std::string& object, const Image& image, Names which) {
  elf::File file(object, image.bits == 64, image.is_big_endian(), image.architecture != nullptr);
  file.expect_sound_tables();
  std::set<std::string> names;
  for (const elf::Section& table : file.sections()) {
    if (table.type != SHT_SYMTAB) continue;
    for (std::uint64_t i = 0; i < file.symbols_in(table); ++i) {
      const elf::Symbol symbol = file.symbol_at(table, i);
      const bool is_missing = symbol.section == SHN_UNDEF;
      if (symbol.name == 0 || symbol.binding == STB_LOCAL ||
          is_missing != (which == Names::missing))
        continue;
      if (is_missing && symbol.binding == STB_WEAK) continue;
      names.insert(file.name_of(table, symbol));
    }
  }
  return names;
}

/// Compilers call functions whose names begin so.
bool needs_library(const std::set<std::string>& names) {
  return std::ranges::any_of(names, [](const std::string& n) { return n.starts_with("__"); });
}

/// The linker of a toolchain, the compiler that knows its libraries, and how the linker is told
/// which processor it links for.
struct Toolchain {
  std::string linker;
  std::string compiler;
  std::string linked_as;
};

/// Runs the linker on what may be hostile.
/// @return nothing if it refuses; then `said` has its first message
std::optional<std::string> linked(const Toolchain& tools, std::vector<std::string> more,
                                  const std::string& object, const ToolFile* script,
                                  std::string& said) {
  const ToolFile in(object);
  const ToolFile out;
  std::vector<std::string> command{tools.linker};
  if (!tools.linked_as.empty()) command.insert(command.end(), {"-m", tools.linked_as});
  std::vector<const ToolFile*> files{&in, &out};
  if (script != nullptr) {
    command.insert(command.end(), {"-T", script->name()});
    files.push_back(script);
  }
  command.insert(command.end(), {"-o", out.name(), in.name()});
  command.insert(command.end(), more.begin(), more.end());
  const proof::Output output = run_tool(command, "", "", files);
  if (output.status == 0) return out.contents(most_bytes);
  said = first_error(output.err);
  return std::nullopt;
}

/// Returns the paths of libgcc for each way in which the compiler translates, its default first;
/// before it those that have `preferred` parts, the last of them first. With options, only the path
/// for these.
std::vector<std::string> libraries_of(const std::string& compiler,
                                      const std::vector<std::string>& preferred,
                                      const std::vector<std::string>& options = {}) {
  if (!exists(compiler)) return {};
  std::vector<std::string> paths;
  const auto add = [&](std::vector<std::string> command) {
    command.insert(command.begin(), compiler);
    command.emplace_back("-print-libgcc-file-name");
    std::string path = first_line(run_compiler(command, "", most_time).out);
    const bool is_new = std::ranges::find(paths, path) == paths.end();
    // Without a library for these options, the compiler prints a name without a folder.
    const bool is_there =
        std::filesystem::path(path).is_absolute() && std::filesystem::exists(path);
    if (is_there && is_new) paths.push_back(std::move(path));
  };
  add(options);
  if (!options.empty()) return paths;
  // Each line is "folder;@option@option".
  std::istringstream lines(run_compiler({compiler, "-print-multi-lib"}, "", most_time).out);
  for (std::string line; std::getline(lines, line);) {
    std::vector<std::string> command;
    const std::size_t end = line.find(';');
    if (end == std::string::npos) continue;
    for (const std::string_view option :
         support::split(std::string_view(line).substr(end + 1), '@')) {
      if (!option.empty()) command.push_back(fmt::format("-{}", option));
    }
    if (!command.empty()) add(command);
  }
  for (const std::string& part : preferred) {
    std::stable_partition(paths.begin(), paths.end(), [&](const std::string& path) {
      return path.find(part) != std::string::npos;
    });
  }
  return paths;
}

/// Tells whether all functions are Thumb code.
bool is_thumb(const std::string& object, const Image& image) {
  if (!image.architecture->has_marked_entries) return false;
  elf::File file(object, false);
  for (const elf::Section& table : file.sections()) {
    if (table.type != SHT_SYMTAB) continue;
    for (std::uint64_t i = 0; i < file.symbols_in(table); ++i) {
      const elf::Symbol symbol = file.symbol_at(table, i);
      if (symbol.type == STT_FUNC && symbol.section != SHN_UNDEF && symbol.value % 2 == 0) {
        return false;
      }
    }
  }
  return true;
}

/// Returns the linker's emulation for an object.
std::string linked_as(const Architecture& architecture, const std::string& object) {
  std::string name(architecture.linked_as);
  if (architecture.kind_bits == 0) return name;
  return name + std::to_string(kind_of_elf(architecture, object));
}

/// Returns the parts of the paths of libraries that fit an object, the best one last.
std::vector<std::string> preferred_libraries(const std::string& object, const Image& image) {
  // A Cortex-M runs Thumb code only, although the linker adds any. All run that of a Cortex-M0.
  if (is_thumb(object, image)) return {"/thumb/", "/v6-m/"};
  const Architecture& architecture = *image.architecture;
  if (architecture.kind_bits == 0) return {};
  return {fmt::format("/{}/", linked_as(architecture, object))};
}

/// Adds the functions of the first library that has one. The linker skips a library for another
/// kind of the processor, or refuses it.
std::optional<std::string> with_library(const Toolchain& tools, const std::string& object,
                                        const std::vector<std::string>& libraries,
                                        const Image& image) {
  std::string ignored;
  const auto missing = names_in(object, image, Names::missing);
  for (const std::string& library : libraries) {
    auto whole = linked(tools, {"-r", library}, object, nullptr, ignored);
    if (whole && names_in(*whole, image, Names::missing) != missing) return whole;
  }
  return std::nullopt;
}

/// Places all code and data from the first address on, one after the other.
/// @param data the memory for data, if it has addresses of its own
std::string script_of(const std::map<std::string, std::uint32_t>& missing, const DataSpace& data) {
  std::string script;
  for (const auto& [name, address] : missing) {
    const bool is_plain = std::ranges::all_of(name, [](unsigned char c) {
      return std::isalnum(c) != 0 || c == '_' || c == '.' || c == '$';
    });
    if (!is_plain) {
      throw UsageError(
          fmt::format("the object uses {}, which it does not have", support::quoted(name)));
    }
    script += fmt::format("\"{}\" = 0x{:x};\n", name, address);
  }
  // Compilers reach the data near _gp with 16 bits.
  return script +
         fmt::format(R"(SECTIONS {{
  . = 0x{:x};
  .text : {{ *(.text .text.*) *(.progmem .progmem.*) }}
{}  .rodata : {{ *(.rodata .rodata.*) }}
  .data : {{ *(.data .data.*) }}
  _gp = ALIGN(16) + 0x7ff0;
  .got : {{ *(.got.plt) *(.got) }}
  .sdata : {{ *(.sdata .sdata.*) }}
  .sbss : {{ *(.sbss .sbss.*) }}
  .bss : {{ *(.bss .bss.*) *(COMMON) }}
}}
)",
                     elf::load_address,
                     data.first == 0 ? "" : fmt::format("  . = 0x{:x};\n", data.variables));
}

/// Addresses that no memory has, and that every call reaches, even one of a Cortex-M0.
std::map<std::string, std::uint32_t> places_of_missing(Image& image,
                                                       const std::set<std::string>& names) {
  constexpr std::uint32_t first = 0x180000 + Symbol::reach;
  constexpr std::uint32_t last = 0x400000;
  std::map<std::string, std::uint32_t> places;
  std::uint32_t next = first;
  for (const std::string& name : names) {
    if (next > last) throw UsageError("the object uses too many functions that it does not have");
    places[name] = next;
    image.missing.push_back({name, next});
    next += 2 * Symbol::reach;
  }
  return places;
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "fixproof.XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) {
    throw UsageError(fmt::format("no folder can be created in {}",
                                 std::filesystem::temp_directory_path().string()));
  }
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

proof::Output run_compiler(const std::vector<std::string>& command, const std::string& input,
                           std::chrono::milliseconds most) {
  try {
    proof::Output output = proof::run_program(command, input, most);
    if (output.in_time && output.status == 0) return output;
    // The first message: the others follow from it.
    throw UsageError(fmt::format("{} {} {}", command.front(),
                                 output.in_time ? "fails:" : "does not end",
                                 first_error(output.err)));
  } catch (const std::system_error& error) {
    throw UsageError(fmt::format("{} cannot be run: {}", command.front(), error.code().message()));
  } catch (const proof::Killed& killed) {
    throw UsageError(fmt::format("{}: {}", command.front(), killed.what()));
  }
}

namespace {

bool is_cxx_source(const std::string& path) {
  return std::ranges::any_of(std::array{".cc", ".cpp", ".cxx"},
                             [&](const char* e) { return has_extension(path, e); });
}

}  // namespace

bool is_c_source(const std::string& path) {
  return has_extension(path, ".c") || is_cxx_source(path);
}

std::string compiled_source(const std::string& path) {
  const bool is_cxx = is_cxx_source(path);
  const TemporaryFolder folder;
  const std::string object = folder.file("source.o");
  // A variable may hold options, too, as make has it.
  std::vector<std::string> command;
  for (const std::string& words :
       {is_cxx ? variable("CXX", "c++") : variable("CC", "cc"),
        is_cxx ? variable("CXXFLAGS", "-O2") : variable("CFLAGS", "-O2")}) {
    for (const std::string_view word : support::split(words, ' ')) {
      if (!word.empty()) command.emplace_back(word);
    }
  }
  const std::string name = path.starts_with('-') ? "./" + path : path;
  command.insert(command.end(), {"-c", "-o", object, name});
  try {
    run_compiler(command, "", most_time);
  } catch (const UsageError& error) {
    const std::string said = error.what();
    if (said.find("stdint.h:") == std::string::npos) throw;
    throw UsageError(fmt::format(
        "{}; add -ffreestanding to the flags, or install the toolchain's C library", said));
  }
  return support::read_bounded(object, most_bytes);
}

std::string linked_object(Image& image, const std::string& object) {
  const Architecture& architecture = *image.architecture;
  std::string said;
  for (const std::string_view name : architecture.toolchains) {
    const Toolchain tools{.linker = fmt::format("{}-ld", name),
                          .compiler = fmt::format("{}-gcc", name),
                          .linked_as = linked_as(architecture, object)};
    if (name.empty() || !exists(tools.linker)) continue;
    std::string whole = object;
    if (needs_library(names_in(object, image, Names::missing))) {
      whole = with_library(tools, object,
                           libraries_of(tools.compiler, preferred_libraries(object, image)), image)
                  .value_or(object);
    }
    auto names = names_in(whole, image, Names::missing);
    names.erase("_GLOBAL_OFFSET_TABLE_");  // the linker makes it
    const auto missing = places_of_missing(image, names);
    const ToolFile script(script_of(missing, architecture.data));
    if (const auto file = linked(tools, {"-e", "0", "--no-warn-mismatch"}, whole, &script, said)) {
      return *file;
    }
    image.missing.clear();
  }
  if (!said.empty()) throw UsageError(fmt::format("the linker says: {}", said));
  throw UsageError(
      fmt::format("an object for {} needs the linker of its toolchain, which is not installed; "
                  "install Debian's package {}, or give a linked file",
                  architecture.name, architecture.package));
}

std::string with_library_functions(const std::string& object, int bits) {
  Image image;
  image.bits = bits;
  if (bits == 16 || !needs_library(names_in(object, image, Names::missing))) return object;
  const Toolchain tools{
      .linker = "ld", .compiler = "gcc", .linked_as = bits == 64 ? "elf_x86_64" : "elf_i386"};
  if (!exists(tools.linker)) return object;
  const auto libraries = libraries_of(tools.compiler, {}, {bits == 64 ? "-m64" : "-m32"});
  return with_library(tools, object, libraries, image).value_or(object);
}

void keep_symbols_of(Image& image, const std::string& object) {
  const auto own = names_in(object, image, Names::own);
  std::erase_if(image.symbols, [&](const Symbol& s) { return !own.contains(s.name); });
}

}  // namespace fixproof::judge
