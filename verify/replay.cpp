#include "verify/replay.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "cases/words.hpp"

namespace fixproof::verify {

namespace {

std::string_view on_off(bool on) { return on ? "on" : "off"; }

std::string variant_options(const cases::Variant& v, std::string_view rounding_option) {
  std::string options = fmt::format(" --target {}", cases::name_of(v.build.target));
  if (v.build.target != cases::Target::standard && v.operation != cases::Operation::cossin) {
    options += fmt::format(" {} {}", rounding_option, on_off(cases::rounds(v)));
  }
  if (v.build.chapter_52) options += " --chapter 52";
  if (v.build.repaired) options += " --repaired";
  return options;
}

std::string_view rounding_option(const cases::Variant& v) {
  return v.operation == cases::Operation::div ? "--div-round" : "--mul-round";
}

}  // namespace

std::string trace_line(const cases::Variant& v, std::span<const std::uint32_t> words) {
  return fmt::format("fixproof trace {}{} {}", cases::name_of(v.operation),
                     variant_options(v, rounding_option(v)),
                     cases::hex_words(words, cases::operand_bits(v)));
}

std::string replay(const cases::Row& row, std::span<const std::uint32_t> words) {
  const cases::Variant& v = row.variant;
  const std::string hex = cases::hex_words(words, cases::operand_bits(v));
  if (v.build.target != cases::Target::standard && v.format == cases::q16_16) {
    return fmt::format("echo '{}' | fixproof eval {}{} --by {}", hex, cases::name_of(v.operation),
                       variant_options(v, rounding_option(v)), row.parties.front());
  }
  if (!cases::has_routine_format(v)) {
    return fmt::format("fixproof verify {} --format {} --by {} --against {} --case '{}'",
                       cases::name_of(v.operation), cases::name_of(v.format), row.parties.front(),
                       fmt::join(row.parties.begin() + 1, row.parties.end(), ","), hex);
  }
  constexpr std::array<std::string_view, 4> usual{"model", "oracle", "fast", "type"};
  const bool unusual =
      std::any_of(row.parties.begin(), row.parties.end(), [&](const std::string& party) {
        return std::find(usual.begin(), usual.end(), party) == usual.end();
      });
  // Without these options, other chapters, widths or the repaired routine would run too.
  const bool other_chapter =
      (v.build.target == cases::Target::i386 || cases::loses_carry(v)) && !v.build.chapter_52;
  std::string line =
      fmt::format("fixproof verify {}{}{}{} --case '{}'", cases::name_of(v.operation),
                  variant_options(v, "--round"), other_chapter ? " --chapter 54" : "",
                  v.format == cases::q8_8 ? " --width half" : "", hex);
  if (unusual) {
    line += fmt::format(" --by {} --against {}", row.parties.front(),
                        fmt::join(row.parties.begin() + 1, row.parties.end(), ","));
  }
  return line;
}

}  // namespace fixproof::verify
