#include "judge/code/ndisasm.hpp"

#include <algorithm>
#include <charconv>

#include "judge/code/tool.hpp"

namespace fixproof::judge {

namespace {

std::string_view take_word(std::string_view& line) {
  line.remove_prefix(std::min(line.find_first_not_of(' '), line.size()));
  const std::string_view word = line.substr(0, line.find(' '));
  line.remove_prefix(word.size());
  return word;
}

/// Reads lines of an offset and the bytes, both in hex, then the text. The bytes of a long
/// instruction go on in lines that start with blanks and a minus sign.
std::vector<Line> lines_of(std::string_view output) {
  std::vector<Line> lines;
  while (!output.empty()) {
    std::string_view rest = output.substr(0, output.find('\n'));
    output.remove_prefix(std::min(rest.size() + 1, output.size()));
    const bool goes_on = rest.starts_with(' ');
    std::string_view word = take_word(rest);
    if (goes_on) {
      if (!lines.empty() && word.starts_with('-')) {
        lines.back().bytes += static_cast<std::uint32_t>((word.size() - 1) / 2);
      }
      continue;
    }
    Line& line = lines.emplace_back();
    std::from_chars(word.data(), word.data() + word.size(), line.at, 16);
    line.bytes = static_cast<std::uint32_t>(take_word(rest).size() / 2);
    rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
    line.text = rest;
  }
  return lines;
}

}  // namespace

bool is_jump(std::string_view mnemonic) {
  return mnemonic.starts_with('j') || mnemonic.starts_with("loop") || mnemonic == "call";
}

std::vector<Line> disassembled(int bits, std::uint32_t origin, const std::string& bytes) {
  return lines_of(
      run_tool({"ndisasm", "-b", std::to_string(bits), "-o", std::to_string(origin), "-"}, bytes)
          .out);
}

}  // namespace fixproof::judge
