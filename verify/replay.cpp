#include "verify/replay.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "support/plain_text.hpp"
#include "verify/cases/words.hpp"
#include "verify/parties/library.hpp"

namespace fixproof::verify {

namespace {

std::string_view on_off(bool on) { return on ? "on" : "off"; }

/// The options that select a routine of FIXED.ASM. @param rounding the option for its rounding
std::string routine_options(const cases::Variant& v, std::string_view rounding) {
  std::string options = fmt::format(" --target {}", cases::name_of(v.build.target));
  if (!rounding.empty()) options += fmt::format(" {} {}", rounding, on_off(cases::rounds(v)));
  if (v.build.chapter_52) options += " --chapter 52";
  if (v.build.repaired) options += " --repaired";
  return options;
}

/// The options that select the row of this variant alone.
std::string row_options(const cases::Variant& v) {
  if (v.from) {
    return fmt::format(" --format {} --to {}", cases::name_of(*v.from), cases::name_of(v.format));
  }
  const std::string width = v.format == cases::q8_8 ? " --width half" : "";
  if (v.build.target == cases::Target::standard) {
    const bool has_formats =
        v.operation != cases::Operation::xformvec && v.operation != cases::Operation::concat;
    return has_formats ? fmt::format(" --format {}", cases::name_of(v.format))
                       : " --target standard" + width;
  }
  // Without --chapter 54, the rows of chapter 52 or of the repaired routine would run, too.
  const bool is_in_54 = !v.build.chapter_52 && !v.build.repaired;
  return routine_options(v, "--round") + (is_in_54 ? " --chapter 54" : "") + width;
}

/// The text as one word of a shell.
std::string shell_word(std::string_view text) {
  const auto is_plain = [](char c) {
    constexpr std::string_view marks = "_-+./:,@%";
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
           marks.find(c) != std::string_view::npos;
  };
  if (std::all_of(text.begin(), text.end(), is_plain)) return std::string(text);
  std::string word = "'";
  if (support::printable(text) == text) {
    for (const char c : text) word += c == '\'' ? R"('\'')" : std::string(1, c);
  } else {
    // What could control a terminal appears as numbers, which bash reads.
    word = "$'";
    for (const char c : text) {
      word +=
          is_plain(c) ? std::string(1, c) : fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
    }
  }
  return word + '\'';
}

/// Whether the texts of two answers are of equal ones. A broken run agrees with nothing.
bool are_equal(const std::string& a, const std::string& b) {
  const auto is_hex = [](char c) {
    return c == ' ' || (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f');
  };
  return a == b && (a == "DE" || std::all_of(a.begin(), a.end(), is_hex));
}

}  // namespace

std::string trace_line(const cases::Variant& v, std::span<const std::uint32_t> words) {
  const std::string_view rounding = v.operation == cases::Operation::cossin ? ""
                                    : v.operation == cases::Operation::div  ? "--div-round"
                                                                            : "--mul-round";
  return fmt::format("fixproof trace {}{} {}", cases::name_of(v.operation),
                     routine_options(v, rounding), cases::hex_words(words, cases::operand_bits(v)));
}

Replay replay(const cases::Row& row, const Mismatch& mismatch, const RowCases& among) {
  const cases::Variant& v = row.variant;
  const auto& words = mismatch.smallest.empty() ? mismatch.words : mismatch.smallest;
  const auto& said = mismatch.said;
  Replay result;
  std::vector<std::string> parties = row.parties;
  for (std::size_t i = 1; i < said.size() && !result.differs; ++i) {
    if (are_equal(said[i].second, said[0].second)) continue;
    std::erase_if(parties, [&](const std::string& party) {
      return party != said[0].first && party != said[i].first && !parties::names_function(party);
    });
    result.differs = true;
  }
  const std::string cases =
      said.empty() || result.differs
          ? fmt::format("--case '{}'", cases::hex_words(words, cases::operand_bits(v)))
          : fmt::format("--level {} --seed {}", among.level, among.seed);
  result.verify = fmt::format(
      "fixproof verify {}{} {} --by {} --against {}", cases::name_of(v.operation), row_options(v),
      cases, shell_word(parties.front()),
      shell_word(fmt::format("{}", fmt::join(parties.begin() + 1, parties.end(), ","))));
  const bool has_model = std::ranges::any_of(
      parties, [](const std::string& party) { return party == "model" || party == "interpreter"; });
  if (has_model && v.format == cases::q16_16) result.trace = trace_line(v, words);
  return result;
}

}  // namespace fixproof::verify
