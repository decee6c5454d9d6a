#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "app/cli/measure_text.hpp"
#include "support/plain_text.hpp"

namespace fixproof::cli {

namespace {

std::string sparkline(const measure::ErrorHistogram& histogram) {
  static constexpr std::array heights{"▁", "▂", "▃", "▄", "▅", "▆", "▇", "█"};
  const auto& counts = histogram.counts();
  const std::uint64_t fullest = *std::max_element(counts.begin(), counts.end());
  std::string line;
  for (const std::uint64_t count : counts) {
    line += count == 0 ? " " : heights.at((count * heights.size() - 1) / fullest);
  }
  return line;
}

std::string row_text(const measure::AccuracyRow& row) {
  const measure::ErrorStatistics& e = row.errors;
  if (e.cases() == 0) return fmt::format("  {:<24}no case has a result that fits\n", row.variant);
  std::string text = fmt::format(
      "  {:<24}{:>9}{:>10}{:>10}{:>11}{:>12}{:>10}{:>10}{:>11}  {:>6} |{}|\n", row.variant,
      support::grouped(e.cases()), support::grouped(row.beyond), support::grouped(row.faults),
      largest_text(e.max()), error_text(e.mean(), true), error_text(e.mean_error()),
      error_text(e.root_mean_square()), share_text(e.correct()),
      fmt::format("{:g}", e.histogram().span()), sparkline(e.histogram()));
  if (!row.curve) return text;
  return text + fmt::format("  worst operand    {}: {:.7g} ulp off\n", row.worst, e.max()) +
         text_of(*row.curve);
}

std::string pixels_text(const measure::AccuracyResult& result) {
  std::string text = fmt::format(
      "\nError in pixels of a projected point (x / z, times {}) by its distance, on a page that "
      "reaches\n{} to each side. Each number is the largest error of {} points of an octave.\n\n"
      "{:>15}",
      result.page.constant, result.page.half_width, support::grouped(result.points), "distance");
  const auto& variants = result.pixels;
  for (const measure::PixelErrors& e : variants) text += fmt::format("{:>24}", e.name);
  text += '\n';
  for (std::size_t i = 0; i < variants.front().octaves.size(); ++i) {
    const std::int32_t from = variants.front().octaves[i].nearest;
    text += fmt::format("{:>15}", fmt::format("{} to {}", from, 2 * from));
    for (const auto& e : variants) text += fmt::format("{:>24.4f}", e.octaves[i].max);
    text += '\n';
  }
  text += fmt::format("{:>15}", "safe from");
  for (const measure::PixelErrors& e : variants) text += fmt::format("{:>24}", e.safe_from);
  return text + "\n\nSafe from: at this distance and beyond, no point is half a pixel off.\n";
}

/// @param extra what only this measurement needs to explain
std::string rows_text(std::uint64_t seed, const std::vector<measure::AccuracyRow>& rows,
                      const std::string& extra) {
  std::string text =
      made_by(seed) +
      "\n\nErrors are results minus exact results, in units of the last place. A result is correct "
      "if no\nother word is nearer to the exact result. Left out are cases whose exact result does "
      "not fit a word\nor does not exist. #DE counts divide errors where the result would fit. The "
      "mean is the bias, +- its\nstandard error for random cases; a mean of two or three standard "
      "errors may be chance. Each\nhistogram goes from -span to span, scaled to its largest "
      "count.\n" +
      extra;
  text += fmt::format("\n{:<26}{:>9}{:>10}{:>10}{:>11}{:>12}{:>10}{:>10}{:>11}  {:>6}\n", "",
                      "cases", "left out", "#DE", "max", "mean", "+-", "rms", "correct", "span");
  std::string heading;
  for (const measure::AccuracyRow& row : rows) {
    const std::string here = fmt::format("{}, {}", row.operation, support::printable(row.operands));
    if (here != heading) text += fmt::format("\n{}\n", here);
    heading = here;
    text += row_text(row);
  }
  return text;
}

}  // namespace

std::string text_of(const measure::AccuracyResult& result) {
  const std::string extra =
      missing_libraries() +
      (result.scenes.empty() ? "Name a SCENE to add the operands of a scene.\n" : "");
  return rows_text(result.seed, result.rows, extra) + pixels_text(result);
}

std::string text_of(const measure::FormatAccuracyResult& result) {
  return rows_text(result.seed, result.rows, "");
}

}  // namespace fixproof::cli
