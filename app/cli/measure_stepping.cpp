#include <fmt/format.h>

#include "app/cli/measure_text.hpp"
#include "measure/host/provenance.hpp"
#include "support/plain_text.hpp"
#include "verify/parties/machines.hpp"
#include "xsharp/raster/span_loops.hpp"

namespace fixproof::cli {

namespace {

std::string figure_text(double x) { return x < 1e-9 ? "0" : fmt::format("{:.4g}", x); }
std::string share_text(double x) { return x == 0 ? "0" : fmt::format("{:.3g} %", 100 * x); }
std::string clocks_text(const measure::Bounds& b) { return between(b.min, b.max, 1); }

template <class Columns>
std::string rows_text(const std::vector<measure::SteppingRow>& rows, Columns columns) {
  std::string text;
  std::string heading;
  for (const measure::SteppingRow& row : rows) {
    if (row.variant.value != heading) text += fmt::format("\n{}\n", row.variant.value);
    heading = row.variant.value;
    text += fmt::format("  {:<22}{}\n", row.variant.rule, columns(row));
  }
  return text;
}

std::string error_columns(const measure::SteppingRow& row) {
  const measure::SteppingStatistics& s = row.statistics;
  std::string text =
      fmt::format("{:>7}{:>10}{:>10}{:>8.3f}", name_of(row.variant.drawn), figure_text(s.all.error),
                  figure_text(s.all.bound), s.part_of_bound);
  for (const std::size_t i : {4U, 8U, 12U, 16U}) {
    text += fmt::format("{:>10}", figure_text(s.along.at(i).error));
  }
  return text + fmt::format("{:>10}", figure_text(s.along.back().bound));
}

std::string picture_columns(const measure::SteppingRow& row) {
  const measure::SteppingStatistics& s = row.statistics;
  return fmt::format("{:>10}{:>9}{:>12}{:>10}{:>8}{:>10}",
                     share_text(measure::share_of(s.wrong, s.drawn)), s.max_error,
                     support::grouped(s.bands.drawn),
                     share_text(measure::share_of(s.bands.wrong, s.bands.drawn)), s.bands.widest,
                     share_text(measure::share_of(s.missed, s.wanted)));
}

std::string setups_text(const std::vector<measure::SetupClocks>& setups) {
  std::string text = fmt::format(
      "\nClocks of the setup by Intel's tables, or bus time of an 8088 if larger. Each stepped "
      "value "
      "takes a\nFixedDiv for its slope and a FixedMul for its start, both rounded. Means of random "
      "spans.\n\n{:<18}{:>12}{:>14}\n",
      "", "divide", "multiply");
  for (const measure::SetupClocks& s : setups) {
    text += fmt::format("{:<18}{:>12}{:>14}\n", x86model::name_of(s.cpu), clocks_text(s.divide),
                        clocks_text(s.multiply));
  }
  return text;
}

std::string pixels_text(const std::vector<measure::PixelCost>& pixels) {
  std::string text = fmt::format(
      "\nClocks per pixel of the document's loops, counted by DEC and JNZ. The columns with a "
      "length "
      "include\na pixel's share of the setup of a span of that length.\n\n{:<18}{:<6}{:>12}",
      "", "", "pixel");
  for (const std::uint32_t length : measure::costed_lengths) text += fmt::format("{:>14}", length);
  text += '\n';
  for (const measure::PixelCost& p : pixels) {
    text +=
        fmt::format("{:<18}{:<6}{:>12}", p.loop, x86model::name_of(p.cpu), clocks_text(p.pixel));
    for (const measure::Bounds& b : p.of_span) text += fmt::format("{:>14}", clocks_text(b));
    text += '\n';
  }
  return text;
}

std::string times_text(const measure::SteppingResult& result) {
  std::string text = fmt::format(
      "\nNanoseconds on {}, {}: the loops in C++ over spans of {} pixels, and the\nsetup of a "
      "value; "
      "minimum and median of {} rounds.\n\n{:<26}{:>9}{:>9}{:>9}\n\n",
      parties::processor_name(), measure::compiler_flags(), xsharp::longest_span, result.rounds, "",
      "ns", "median", "spread");
  for (const measure::SteppingTimes& t : result.times) {
    text += fmt::format("{:<26}{}  a {}\n", t.what, columns_of(t.times), t.of);
  }
  return text;
}

}  // namespace

std::string text_of(const measure::SteppingResult& result) {
  std::string text = fmt::format(
      "{}\n\n"
      "Values stepped across {} span{} of each length from 1 to {} pixels, compared with exact "
      "values.\nErrors are of values before truncation, in the unit that is drawn. max: the "
      "largest "
      "error; bound: its\nderived bound; of it: the largest error as a part of its own bound. Then "
      "the errors along spans of\n{} pixels, and the bound at the last pixel.\n",
      made_by(result.seed), support::grouped(result.spans), result.spans == 1 ? "" : "s",
      xsharp::longest_span, xsharp::longest_span);
  text += fmt::format("\n{:<24}{:>7}{:>10}{:>10}{:>8}{:>10}{:>10}{:>10}{:>10}{:>10}\n", "", "unit",
                      "max", "bound", "of it", "at 1/4", "at 1/2", "at 3/4", "last", "bound") +
          rows_text(result.rows, error_columns);
  text +=
      "\nPixels of the spans with random ends, half of all spans. wrong: pixels that differ from "
      "the "
      "exact\npicture, which is truncated as well; by most: by how many units at most. bands: runs "
      "of "
      "equal pixels;\nwrong: bands that the exact picture does not have from end to end; widest: "
      "the "
      "longest run of wrong\npixels. missed: values or texels of the exact span that are never "
      "drawn.\n";
  text += fmt::format("\n{:<24}{:>10}{:>9}{:>12}{:>10}{:>8}{:>10}\n", "", "wrong", "by most",
                      "bands", "wrong", "widest", "missed") +
          rows_text(result.rows, picture_columns);
  text += setups_text(result.setups) + pixels_text(result.pixels) + times_text(result) +
          "\nThe document's claims, judged by these clocks.\n";
  for (const measure::Claim& claim : result.claims) text += text_of(claim);
  return text;
}

}  // namespace fixproof::cli
