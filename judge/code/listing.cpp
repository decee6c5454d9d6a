#include "judge/code/listing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <span>

#include "judge/code/assemble.hpp"

namespace fixproof::judge {

namespace {

/// Bytes of code that one run of ndisasm reads.
constexpr std::uint32_t window = 512;

/// Returns a place as a distance from the function before it: no disassembler of all processors is
/// at hand.
std::string place_named(const Image& image, std::uint32_t offset) {
  const Symbol* best = nullptr;
  for (const Symbol& symbol : image.symbols) {
    if (symbol.offset <= offset && (best == nullptr || symbol.offset > best->offset)) {
      best = &symbol;
    }
  }
  return best == nullptr ? fmt::format("{:x}h", offset)
                         : fmt::format("{}+{:x}h", best->name, offset - best->offset / 2 * 2);
}

}  // namespace

const Line& Listing::at(std::uint32_t offset) {
  if (const auto known = lines_.find(offset); known != lines_.end()) return known->second;
  if (image_.architecture != nullptr) {
    return lines_.emplace(offset, Line{.at = offset, .text = place_named(image_, offset)})
        .first->second;
  }
  const std::uint32_t first = image_.index_of(image_.code_at(offset));
  const auto last = std::min(static_cast<std::uint32_t>(image_.memory.size()), first + window);
  const std::string bytes(image_.memory.begin() + std::min(first, last),
                          image_.memory.begin() + last);
  const bool is_cut_off = first + window < image_.memory.size();
  for (Line& line : disassembled(image_.bits, offset, bytes)) {
    // The window may cut off its last instructions.
    if (is_cut_off && line.at != offset && line.at + longest_instruction > offset + window) break;
    lines_.try_emplace(line.at, std::move(line));
  }
  return lines_[offset];
}

Decoded Listing::decoded_at(std::uint32_t offset) const {
  const std::size_t first =
      std::min<std::size_t>(image_.index_of(image_.code_at(offset)), image_.memory.size());
  const std::size_t count =
      std::min<std::size_t>(longest_instruction, image_.memory.size() - first);
  return decoded(std::span(image_.memory).subspan(first, count), offset, image_.bits);
}

std::vector<Line> reachable(const Image& image, Listing& listing) {
  std::map<std::uint32_t, Line> found;
  std::vector<std::uint32_t> left{image.entry};
  while (!left.empty()) {
    std::uint32_t at = left.back();
    left.pop_back();
    while (image.code_at(at) >= image.first && image.code_at(at) < image.end &&
           !found.contains(at)) {
      const Line& line = found.try_emplace(at, listing.at(at)).first->second;
      const Decoded instruction = listing.decoded_at(at);
      if (instruction.target) left.push_back(*instruction.target);
      // Zydis knows opcodes that NASM writes as bytes.
      if (ends_flow(instruction) || line.text.starts_with("db ")) break;
      at += line.bytes;
    }
  }
  std::vector<Line> lines;
  for (auto& [offset, line] : found) lines.push_back(std::move(line));
  return lines;
}

namespace {

/// Returns the offsets of lines to which other lines jump.
std::set<std::uint32_t> targets_among(const std::vector<Line>& lines, const Listing& listing) {
  std::set<std::uint32_t> starts;
  std::set<std::uint32_t> targets;
  for (const Line& line : lines) starts.insert(line.at);
  for (const Line& line : lines) {
    const auto target = listing.decoded_at(line.at).target;
    if (target && starts.contains(*target)) targets.insert(*target);
  }
  return targets;
}

std::string text_of_bytes(const Image& image, std::uint32_t at, std::uint32_t count) {
  std::string text;
  for (std::uint32_t i = 0; i < count; ++i) {
    text += fmt::format("{}0x{:02x}", i == 0 ? "db " : ", ",
                        image.memory.at(image.index_of(image.code_at(at)) + i));
  }
  return text;
}

}  // namespace

std::string source_of(const Image& image) {
  Listing listing(image);
  const std::vector<Line> lines = reachable(image, listing);
  const std::set<std::uint32_t> targets = targets_among(lines, listing);
  const auto bytes_at = [&](std::uint32_t at, std::uint32_t count) {
    return text_of_bytes(image, at, count);
  };
  // Each line has two forms: the instruction, and its bytes.
  std::vector<std::string> as_text;
  std::vector<std::string> as_bytes;
  for (const Line& line : lines) {
    std::string text = line.text;
    const auto target = listing.decoded_at(line.at).target;
    const std::size_t hex = text.rfind(" 0x");
    if (target && targets.contains(*target) && hex != std::string::npos) {
      text.replace(hex, std::string::npos, fmt::format(" at_{:04x}", *target));
    }
    as_text.push_back(text);
    as_bytes.push_back(fmt::format("{:<40}; {}", bytes_at(line.at, line.bytes), line.text));
  }
  const auto source = [&](const std::vector<std::string>& chosen) {
    std::string text = fmt::format("        bits {}\n        org 0x{:x}\n\n", image.bits,
                                   lines.empty() ? image.entry : lines.front().at);
    std::uint32_t at = lines.front().at;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      // Bytes that no path reaches, such as a table between instructions, or that overlap.
      for (; at < lines[i].at; ++at) text += "        " + bytes_at(at, 1) + '\n';
      if (targets.contains(lines[i].at)) text += fmt::format("at_{:04x}:\n", lines[i].at);
      text += fmt::format("        {}\n", chosen[i]);
      at = lines[i].at + lines[i].bytes;
    }
    return text;
  };
  const Line& last = lines.back();
  const std::string wanted(
      image.memory.begin() + image.index_of(image.code_at(lines.front().at)),
      image.memory.begin() + image.index_of(image.code_at(last.at + last.bytes)));
  // NASM chooses the shortest encoding. An instruction for which that differs becomes bytes.
  std::vector<std::string> chosen = as_text;
  const std::string all = assembled(source(chosen));
  if (all == wanted) return source(chosen);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::vector<std::string> one = as_bytes;
    one[i] = as_text[i];
    if (assembled(source(one)) != wanted) chosen[i] = as_bytes[i];
  }
  if (assembled(source(chosen)) != wanted) return source(as_bytes);
  return source(chosen);
}

}  // namespace fixproof::judge
