#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <filesystem>
#include <iterator>
#include <sstream>
#include <string_view>
#include <system_error>

#include "judge/code/assemble.hpp"
#include "judge/code/load.hpp"
#include "judge/code/tool.hpp"
#include "support/bounded_file.hpp"
#include "support/plain_text.hpp"
#include "support/usage_error.hpp"

namespace fixproof::judge {

namespace {

namespace fs = std::filesystem;
using support::UsageError;

constexpr std::size_t max_bytes = std::size_t{1} << 20U;
constexpr std::size_t max_map_bytes = std::size_t{1} << 22U;

std::vector<std::string> nasm(const std::vector<std::string>& arguments) {
  std::vector<std::string> all{"nasm", "-f", "bin", "-w-all"};
  all.insert(all.end(), arguments.begin(), arguments.end());
  return all;
}

std::string_view advice_on(std::string_view error) {
  if (error.ends_with("in 16-bit mode") || error.ends_with("in 32-bit mode") ||
      error.ends_with("in non-64-bit mode")) {
    return "; without BITS in the source the code has 16 bits: add --bits 32 or 64";
  }
  if (error.find("unable to open") != std::string_view::npos &&
      !error.ends_with("Too many open files")) {
    return "; a source may use the files in its folder and below";
  }
  return "";
}

/// Reads the symbols of NASM's map file and the end of its sections without contents (.bss), and
/// returns the origin.
std::uint32_t read_map(Image& image, const std::string& map) {
  std::istringstream lines(map);
  std::string line;
  std::string part;
  std::uint32_t origin = 0;
  while (std::getline(lines, line)) {
    if (line.starts_with("-- ")) part = line.substr(3, 7);
    std::istringstream words(line);
    std::string first;
    std::string second;
    std::string name;
    words >> first >> second >> name;
    std::uint32_t value = 0;
    const char* const end = first.data() + first.size();
    const auto [stop, error] = std::from_chars(first.data(), end, value, 16);
    if (first.empty() || error != std::errc() || stop != end) continue;
    if (part == "Program") origin = value;
    // The line goes on with the end, the length and the class.
    std::string length;
    std::string kind;
    if (part == "Section" && words >> length >> kind && kind == "nobits") {
      image.reserved = std::max(
          image.reserved, value + static_cast<std::uint32_t>(std::stoul(length, nullptr, 16)));
    }
    // The second number is the address for which the code is assembled.
    if (part == "Symbols" && !name.empty()) {
      std::from_chars(second.data(), second.data() + second.size(), value, 16);
      image.symbols.push_back({name, value});
    }
  }
  return origin;
}

/// Splits a line of a source into words of lower case, without brackets and the comment.
std::vector<std::string> words_of(std::string line) {
  line.resize(std::min(line.size(), line.find(';')));
  for (char& c : line) {
    const auto byte = static_cast<unsigned char>(c);
    c = c == '[' || c == ']' ? ' ' : static_cast<char>(std::tolower(byte));
  }
  std::istringstream stream(line);
  return {std::istream_iterator<std::string>(stream), {}};
}

/// Directives that may stand before the one that states the width.
bool is_directive(const std::string& word) {
  constexpr std::array<std::string_view, 8> names{"org",     "cpu",     "global", "extern",
                                                  "section", "segment", "static", "default"};
  return word.starts_with('%') || std::find(names.begin(), names.end(), word) != names.end();
}

}  // namespace

std::optional<int> bits_of_source(const std::string& path) {
  std::istringstream lines(support::read_bounded(path, max_bytes));
  for (std::string line; std::getline(lines, line);) {
    const std::vector<std::string> words = words_of(line);
    if (words.empty()) continue;
    std::string width;
    if (words[0] == "bits" && words.size() == 2) width = words[1];
    if (words[0].starts_with("use")) width = words[0].substr(3);
    if (width == "16" || width == "32" || width == "64") return std::stoi(width);
    if (!is_directive(words[0])) break;
  }
  return std::nullopt;
}

namespace {

/// The folder of the file to which a name leads, with a slash at its end.
/// @throws UsageError if it is not known, because then a source might read every folder
std::string folder_of(const std::string& name) {
  std::error_code error;
  const fs::path folder = fs::weakly_canonical(name, error).parent_path();
  if (error || !folder.is_absolute()) {
    throw UsageError(fmt::format("its folder is not known: {}", error.message()));
  }
  return (folder / "").string();
}

}  // namespace

void load_source(Image& image, const std::string& path) {
  image.container = "NASM source";
  const ToolFile code;
  const ToolFile map;
  // A name that starts with a minus sign must not be an option.
  const std::string name = path.starts_with('-') ? "./" + path : path;
  const std::string folder = folder_of(name);
  if (!confines_tools()) image.container += ", assembled without confinement";
  const proof::Output output =
      run_tool(nasm({"--before", fmt::format("[bits {}]", image.bits), "--before",
                     fmt::format("[map brief symbols {}]", map.name()), "-i", folder, "-o",
                     code.name(), name}),
               "", folder, {&code, &map});
  if (output.status != 0) {
    // The text is "FILE:LINE: error: what"; load() adds the file.
    std::string said = output.err.substr(0, output.err.find('\n'));
    if (said.starts_with(name + ":")) said.erase(0, name.size() + 1);
    throw UsageError(fmt::format("nasm: {}{}", support::printable(said), advice_on(said)));
  }
  const std::uint32_t origin = read_map(image, map.contents(max_map_bytes));
  load_flat(image, code.contents(max_bytes), origin);
}

std::string assembled(const std::string& source) {
  const ToolFile text(source);
  const ToolFile code;
  const proof::Output output =
      run_tool(nasm({"-o", code.name(), text.name()}), "", "", {&text, &code});
  return output.status == 0 ? code.contents(max_bytes) : "";
}

}  // namespace fixproof::judge
