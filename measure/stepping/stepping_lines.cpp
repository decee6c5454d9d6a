// The variants that step straight lines, with their drawn pixels.
#include <array>
#include <cstddef>
#include <span>

#include "fixed/fixed.hpp"
#include "measure/stepping/stepping_line.hpp"
#include "xsharp/raster/depth_buffer.hpp"

namespace fixproof::measure {

namespace {

constexpr std::int64_t one_level = 65536;
/// Surfaces use these of the 256 light levels, so stepping errors stay within the 256.
constexpr LineFormat light_words{8, 16, 2 * one_level, 254 * one_level};
constexpr LineFormat wide_light_words{0, 16, 2 * one_level, 254 * one_level};
constexpr LineFormat depth_words{8, 16, 0, 32767 * one_level};
/// Two bits fewer, for a buffer that is not cleared: one unit is four units of depth.
constexpr LineFormat uncleared_words{10, 18, 0, 32767 * one_level};
/// 1.0 is 256 texels. The range is from the middle of the first texel to that of the last.
constexpr LineFormat texel_words{0, 8, 128, 65536 - 128};

/// A bitmap whose texels hold their column, or their row.
std::span<const std::uint8_t> columns_or_rows(bool rows) {
  static const auto bitmaps = [] {
    std::array<std::vector<std::uint8_t>, 2> both;
    for (std::size_t i = 0; i < xsharp::bitmap_texels; ++i) {
      both[0].push_back(static_cast<std::uint8_t>(i % 256));
      both[1].push_back(static_cast<std::uint8_t>(i / 256));
    }
    return both;
  }();
  return bitmaps.at(rows ? 1 : 0);
}

/// Checks that the drawn pixel is the whole part of the stepped value, masked.
void check_drawn(const LineFormat& format, const xsharp::StepWords& words, std::int64_t mask,
                 std::int64_t drawn, std::size_t k, SteppedValue& value) {
  const std::uint32_t word = words.start + static_cast<std::uint32_t>(k) * words.step;
  const std::int64_t stepped = static_cast<std::int32_t>(word << format.dropped);
  if (((stepped >> format.drawn_below) & mask) != (drawn & mask)) value.within = false;
}

void step_light(LineRule rule, const LineFormat& format, const SpanPlace& place, Ends which,
                cases::Draw draw, SteppedSpan& out) {
  const LineEnds ends = choose_ends(format, place, which, draw);
  const xsharp::StepWords words = line_words(rule, ends, place, format.dropped);
  judge_line(rule, format, ends, place, words, out);
  std::array<std::uint8_t, xsharp::longest_span> room{};
  const auto row = std::span(room).first(place.pixels);
  if (format.dropped == 0) {
    xsharp::PlainLoops().gouraud_wide(row, words.start, words.step);
  } else {
    xsharp::PlainLoops().gouraud(row, static_cast<std::uint16_t>(words.start),
                                 static_cast<std::uint16_t>(words.step));
  }
  for (std::size_t k = 0; k < row.size(); ++k) {
    out.drawn.push_back(row[k]);
    check_drawn(format, words, 0xFF, row[k], k, out.values[k]);
  }
}

/// Draws into its own buffer. Without clearing, depths of the next picture get an offset.
void step_depth(LineRule rule, const LineFormat& format, const SpanPlace& place, Ends which,
                cases::Draw draw, SteppedSpan& out) {
  const LineEnds ends = choose_ends(format, place, which, draw);
  const xsharp::StepWords words = line_words(rule, ends, place, format.dropped);
  judge_line(rule, format, ends, place, words, out);
  using xsharp::DepthBuffering;
  xsharp::DepthBuffer buffer(format.dropped == xsharp::dropped_bits ? DepthBuffering::on
                                                                    : DepthBuffering::no_clear);
  buffer.begin(static_cast<std::int32_t>(place.pixels), 1);
  const std::uint32_t nothing = buffer.words(xsharp::Step<fixproof::q16_16>{}).start;
  const auto depths = buffer.pixels(0, 0, place.pixels);
  std::array<std::uint8_t, xsharp::longest_span> pixels{};
  xsharp::PlainLoops().depth(std::span(pixels).first(place.pixels), depths, 1,
                             nothing + words.start, words.step);
  const std::int64_t mask = (std::int64_t{1} << (32 - format.drawn_below)) - 1;
  for (std::size_t k = 0; k < depths.size(); ++k) {
    out.drawn.push_back(depths[k] - (static_cast<std::int32_t>(nothing) >> 8));
    check_drawn(format, words, mask, out.drawn[k], k, out.values[k]);
  }
}

void step_texels(LineRule rule, const LineFormat& format, const SpanPlace& place, Ends which,
                 cases::Draw draw, SteppedSpan& out) {
  const LineEnds across = choose_ends(format, place, which, draw);
  const LineEnds down = choose_ends(format, place, which, draw);
  const xsharp::StepWords u = line_words(rule, across, place, 0);
  const xsharp::StepWords v = line_words(rule, down, place, 0);
  static thread_local SteppedSpan other;
  other.clear();
  judge_line(rule, format, across, place, u, out);
  judge_line(rule, format, down, place, v, other);
  std::array<std::uint8_t, xsharp::longest_span> columns{};
  std::array<std::uint8_t, xsharp::longest_span> rows{};
  const auto draw_from = [&](bool rows_of, std::span<std::uint8_t> row) {
    xsharp::PlainLoops().texture(row.first(place.pixels), columns_or_rows(rows_of), u.start, u.step,
                                 v.start, v.step);
  };
  draw_from(false, columns);
  draw_from(true, rows);
  for (std::size_t k = 0; k < place.pixels; ++k) {
    check_drawn(format, u, 0xFF, columns.at(k), k, out.values[k]);
    check_drawn(format, v, 0xFF, rows.at(k), k, other.values[k]);
    out.values[k] = nearer_bound(out.values[k], other.values[k]);
    out.drawn.push_back(rows.at(k) * 256 + columns.at(k));
    out.exact[k] += other.exact[k] * 256;
  }
}

using StepLine = void (*)(LineRule, const LineFormat&, const SpanPlace&, Ends, cases::Draw,
                          SteppedSpan&);

struct LineKind {
  const char* value;
  Drawn drawn;
  const char* range;
  LineFormat format;
  StepLine step;
};

constexpr std::array line_kinds{
    LineKind{"intensity 8.8", Drawn::level, "2 to 254", light_words, step_light},
    LineKind{"intensity 16.16", Drawn::level, "2 to 254", wide_light_words, step_light},
    LineKind{"depth 16.8", Drawn::depth, "0 to 32767", depth_words, step_depth},
    LineKind{"depth 14.8, not cleared", Drawn::depth, "0 to 32767, a unit is four", uncleared_words,
             step_depth},
    LineKind{"texture 8.8, affine", Drawn::texel, "0.5 to 255.5", texel_words, step_texels},
};

struct NamedRule {
  LineRule rule;
  const char* name;
};
constexpr std::array named_rules{
    NamedRule{LineRule::rounded, "rounded"}, NamedRule{LineRule::cut, "cut"},
    NamedRule{LineRule::i8088, "8088"}, NamedRule{LineRule::at_end, "rounded, no pre-step"},
    NamedRule{LineRule::whole_words, "whole words, cut"}};

}  // namespace

std::vector<SteppingVariant> line_variants() {
  std::vector<SteppingVariant> variants;
  for (const LineKind& kind : line_kinds) {
    for (const NamedRule& rule : named_rules) {
      variants.push_back(
          {kind.value, rule.name, kind.drawn, kind.range,
           [kind, rule](const SpanPlace& place, Ends which, cases::Draw draw, SteppedSpan& out) {
             kind.step(rule.rule, kind.format, place, which, draw, out);
           }});
    }
  }
  return variants;
}

}  // namespace fixproof::measure
