#include "judge/code/canonical.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>

#include "judge/code/ndisasm.hpp"

namespace fixproof::judge {

namespace {

/// The offsets that one run of ndisasm disassembles from.
constexpr std::uint32_t piece_size = 4096;
/// Each offset's instruction stands alone, at a multiple of this. Behind it are CS: prefixes and a
/// NOP: wherever the disassembler is after the bytes that follow the instruction, it takes the rest
/// for one instruction.
constexpr std::uint32_t slot_size = 2 * longest_instruction;
constexpr char filler = '\x2E';
constexpr char nop = '\x90';

void remove_words(std::string& text) {
  for (const std::string_view word : {"byte ", "short ", "near "}) {
    for (std::size_t at = 0; (at = text.find(word, at)) != std::string::npos;) {
      const bool starts = at == 0 || text[at - 1] == ' ' || text[at - 1] == ',' ||
                          text[at - 1] == '[' || text[at - 1] == ':';
      if (!starts) {
        at += word.size();
        continue;
      }
      text.erase(at, word.size());
      if (text.substr(at, 1) == "+") text.erase(at, 1);
    }
  }
}

/// Reads `0x...` up to the end of the text or to `]`.
std::optional<std::uint32_t> hex_at(std::string_view text, char end) {
  if (!text.starts_with("0x")) return std::nullopt;
  std::uint32_t value = 0;
  const char* const last = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data() + 2, last, value, 16);
  if (error != std::errc() || (stop == last ? '\0' : *stop) != end) return std::nullopt;
  return value;
}

/// Cuts the target off a relative jump.
/// @param at where ndisasm saw the instruction
void take_target(CanonicalLine& line, std::uint32_t at) {
  const std::string_view text = line.text;
  const std::size_t blank = text.find(' ');
  if (blank == std::string_view::npos || !is_jump(text.substr(0, blank))) return;
  const auto target = hex_at(text.substr(blank + 1), '\0');
  if (!target) return;  // in a register or in memory, or far
  const auto distance = static_cast<std::int16_t>(static_cast<std::uint16_t>(*target - at));
  line.target = std::int64_t{line.at} + distance;
  line.text.resize(blank);
}

void take_table(CanonicalLine& line) {
  constexpr std::string_view read = "[cs:bx";
  const std::size_t at = line.text.find(read);
  if (at == std::string::npos) return;
  const std::string_view after = std::string_view(line.text).substr(at + read.size());
  if (after.empty() || (after[0] != '+' && after[0] != '-')) return;
  const auto value = hex_at(after.substr(1), ']');
  if (!value) return;
  line.table = static_cast<std::uint16_t>(after[0] == '+' ? *value : 0U - *value);
  const std::size_t end = line.text.find(']', at);
  line.text.replace(at, end - at, "[cs:bx+TAB");
}

}  // namespace

const CanonicalLine& Code::at(std::uint32_t offset) {
  static const CanonicalLine nothing;
  if (offset >= size()) return nothing;
  std::vector<CanonicalLine>& lines = pieces_[offset / piece_size];
  if (lines.empty()) disassemble(offset / piece_size * piece_size, lines);
  return lines[offset % piece_size];
}

void Code::disassemble(std::uint32_t first, std::vector<CanonicalLine>& lines) const {
  const std::uint32_t count = std::min(piece_size, size() - first);
  std::string slots(std::size_t{slot_size} * count, filler);
  for (std::uint32_t i = 0; i < count; ++i) {
    slots[std::size_t{slot_size} * (i + 1) - 1] = nop;
    const std::uint32_t whole = std::min(longest_instruction, size() - first - i);
    std::copy_n(bytes_.begin() + first + i, whole, slots.begin() + std::ptrdiff_t{slot_size} * i);
  }
  lines.resize(count);
  for (const Line& printed : disassembled(16, 0, slots)) {
    if (printed.at % slot_size != 0 || printed.at / slot_size >= count) continue;
    CanonicalLine& line = lines[printed.at / slot_size];
    line.at = first + printed.at / slot_size;
    if (printed.bytes > size() - line.at) continue;
    line.bytes = printed.bytes;
    line.text = printed.text;
    remove_words(line.text);
    take_target(line, printed.at);
    take_table(line);
  }
}

CanonicalRoutine::CanonicalRoutine(Code& code, std::uint32_t start, bool until_return,
                                   std::size_t most)
    : start_(start) {
  for (std::uint32_t at = start; lines_.size() < most;) {
    const CanonicalLine& line = code.at(at);
    if (line.bytes == 0) break;
    numbers_[at] = lines_.size();
    at += line.bytes;
    if (line.text == "nop") continue;
    lines_.push_back(&line);
    if (until_return && line.text == "ret") break;
  }
}

void CanonicalRoutine::resize(std::size_t count) { lines_.resize(std::min(count, size())); }

std::uint32_t CanonicalRoutine::end() const {
  return lines_.empty() ? start_ : lines_.back()->at + lines_.back()->bytes;
}

std::optional<std::size_t> CanonicalRoutine::target_of(std::size_t number) const {
  const auto& target = lines_[number]->target;
  const auto found = target ? numbers_.find(*target) : numbers_.end();
  if (found == numbers_.end() || found->second >= size()) return std::nullopt;
  return found->second;
}

std::string CanonicalRoutine::text_of(std::size_t number) const {
  const CanonicalLine& one = *lines_[number];
  if (!one.target) return one.text;
  const auto target = target_of(number);
  return target ? fmt::format("{} ->{}", one.text, *target) : one.text + " ext";
}

std::string CanonicalRoutine::text() const {
  std::string all;
  for (std::size_t i = 0; i < size(); ++i) all += text_of(i) + '\n';
  return all;
}

}  // namespace fixproof::judge
