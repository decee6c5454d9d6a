#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "app/cli/advice_text.hpp"
#include "support/plain_text.hpp"

namespace fixproof::cli {

namespace {

constexpr std::size_t formats_per_turning = trade::max_tried_fraction_bits + 1;

/// A row has the same fraction bits under each way of turning.
std::string cells_of(const trade::TriedFormat& tried) {
  const auto& over = tried.error.over;
  const double seconds = static_cast<double>(over.value_or(0)) / trade::advised_rate;
  return fmt::format("  {:>7}{:>10}  {:<16}", tried.word_bits,
                     over ? "over" : fmt::format("{:.3f}", tried.error.pixels),
                     over ? support::duration(seconds) : "");
}

/// `50 % less`, `100 % more`
std::string change_text(double now, double before) {
  const double saved = 100 * (before - now) / before;
  return fmt::format("{:.0f} % {}", std::abs(saved), saved < 0 ? "more" : "less");
}

/// The fewest fraction bits under each other way of turning.
std::string other_turnings(const trade::FormatReport& report, std::size_t take) {
  std::string text;
  const trade::Turning& taken = report.tried[take].turning;
  for (std::size_t i = 0; i < report.tried.size(); i += formats_per_turning) {
    const trade::Turning& turning = report.tried[i].turning;
    if (turning == taken) continue;
    const auto rows = std::span(report.tried).subspan(i, formats_per_turning);
    const auto first = std::ranges::find_if(rows, [](const auto& row) { return !row.error.over; });
    text += fmt::format("Orientations {}: ", name_of(turning));
    text += first == rows.end() ? std::string("none of these formats stays within the budget.\n")
                                : fmt::format("{} fraction bits and a word of {} bits.\n",
                                              first->fraction_bits, first->word_bits);
  }
  return text;
}

}  // namespace

std::string table_of(const trade::FormatReport& report) {
  std::string heads = fmt::format("{:8}", "");
  std::string columns = fmt::format("{:>8}", "fraction");
  for (std::size_t i = 0; i < report.tried.size(); i += formats_per_turning) {
    heads += fmt::format("  {:<35}", name_of(report.tried[i].turning));
    columns += fmt::format("  {:>7}{:>10}  {:<16}", "word", "pixels", "over after");
  }
  const auto line = [](std::string text) {
    text.erase(text.find_last_not_of(' ') + 1);
    return text + '\n';
  };
  std::string text = line(heads) + line(columns);
  for (std::size_t row = 0; row < formats_per_turning; ++row) {
    std::string cells = fmt::format("{:>8}", report.tried[row].fraction_bits);
    for (std::size_t i = row; i < report.tried.size(); i += formats_per_turning)
      cells += cells_of(report.tried[i]);
    text += line(cells);
  }
  return text;
}

std::string sentences_of(const trade::FormatReport& report) {
  const auto take = trade::narrowest(report.tried);
  if (!take) {
    return fmt::format("No format of up to {} fraction bits stays within {} pixels.\n",
                       trade::max_tried_fraction_bits, report.budget);
  }
  const trade::TriedFormat& best = report.tried[*take];
  const int width = trade::integer_width(best.word_bits);
  const int before = best.word_bits - best.fraction_bits;
  std::string text = fmt::format(
      "Take {} fraction bits, orientations {}: at most {:.3f} pixels off. Every result fits {} "
      "bits before the\npoint, with the sign, so {} bits are the narrowest word: q{}_{}",
      best.fraction_bits, name_of(best.turning), best.error.pixels, before, width,
      width - best.fraction_bits, best.fraction_bits);
  const int spare = width - best.word_bits;
  if (spare > 0) {
    text += fmt::format(", or up to q{}_{} with the {} spare bit{} after the point", before,
                        width - before, spare, spare == 1 ? "" : "s");
  }
  text += fmt::format(".\nIn C++: fixproof::number<std::int{}_t, {}>\n", width, best.fraction_bits);
  const trade::FormatCost& today = report.costs.at(0);
  const trade::FormatCost& then = report.costs.at(1);
  if (width == today.width) {
    return text + "It is as wide as q16_16, so it saves no time and no memory.\n" +
           other_turnings(report, *take);
  }
  return text +
         fmt::format(
             "Vertices and transforms take {} instead of {} bytes, {} than in q16_16. To transform "
             "and project\nthem takes {:.0f} instead of {:.0f} ns a frame here, {}.\n",
             support::grouped(then.bytes), support::grouped(today.bytes),
             change_text(static_cast<double>(then.bytes), static_cast<double>(today.bytes)),
             then.nanoseconds.median, today.nanoseconds.median,
             change_text(then.nanoseconds.median, today.nanoseconds.median)) +
         other_turnings(report, *take);
}

}  // namespace fixproof::cli
