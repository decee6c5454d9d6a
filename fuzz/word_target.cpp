#include "fuzz/word_target.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <initializer_list>
#include <map>
#include <string_view>
#include <utility>

#include "fuzz/words.hpp"
#include "verify/cases/plan.hpp"
#include "verify/cases/stream_makers.hpp"
#include "verify/cases/streams.hpp"

namespace fixproof::fuzz {

namespace {

void draw_fresh(const cases::Variant& variant, std::span<std::uint32_t> words, cases::Draw& draw) {
  static std::map<std::pair<cases::Operation, int>, cases::Plan> plans;
  const auto key = std::pair(variant.operation, variant.format.fraction_bits);
  const cases::Plan& plan =
      plans.try_emplace(key, 1, 1994, std::vector<cases::Row>{{variant, {"a", "b"}}}).first->second;
  const cases::Job& job = plan.jobs()[draw.below(plan.jobs().size())];
  cases::make_cases(job.stream, variant, draw.bits(), draw.below(job.cases), words);
}

/// The value of a word in ulps.
std::int64_t units(std::uint32_t word, const cases::Format& format) {
  const auto raw = static_cast<std::int64_t>(word);
  return raw < format.limit() ? raw : raw - 2 * format.limit();
}

/// Moves the dividend to an edge for the divisor, or for its whole part as on an 8088.
void aim_quotient(const cases::Format& format, std::span<std::uint32_t> words, cases::Draw& draw) {
  const std::array<std::int64_t, 4> edges{0, 1, format.limit(), 2 * format.limit()};
  const std::int64_t quotient =
      draw.coin() ? draw.magnitude(format.word_bits - 1) : edges[draw.below(edges.size())];
  const bool whole = draw.coin();
  // A quotient of twice the range needs a divisor below 1/2.
  if (!whole && quotient >= format.limit()) {
    words[1] = format.word(draw.either_sign(draw.magnitude(format.fraction_bits - 1)));
  }
  const std::int64_t d = units(words[1], format);
  const std::int64_t divisor = whole ? d / format.one() : d;
  const int scale = whole ? 0 : format.fraction_bits;
  // Doubles the quotient, so that halves are integers. Skips dividends that do not fit a word.
  const std::int64_t twice = 2 * quotient + static_cast<std::int64_t>(draw.below(3)) - 1;
  if (divisor == 0 || std::abs(twice) > (std::int64_t{1} << 62) / std::abs(divisor)) return;
  const std::int64_t n =
      (twice * divisor >> (scale + 1)) + static_cast<std::int64_t>(draw.below(3)) - 1;
  words[0] = format.word(draw.either_sign(n));
}

void step_word(const cases::Format& format, std::uint32_t& word, cases::Draw& draw) {
  const std::int64_t value = units(word, format);
  const auto small = static_cast<std::int64_t>(draw.below(4));
  switch (draw.below(5)) {
    case 0:
      word = format.word(value + draw.either_sign(small + 1));
      break;
    case 1:
      word = format.word(-value);
      break;
    case 2:
      word = format.word(value ^ std::int64_t{1}
                                     << draw.below(static_cast<std::uint64_t>(format.word_bits)));
      break;
    case 3:
      word = format.word(value * 2 + (small & 1));
      break;
    default:
      word = format.word(value / 2);
  }
}

std::vector<VariantParties> all_variants() {
  std::vector<cases::Operation> operations;
  for (const cases::Variant& variant : cases::all_variants())
    operations.push_back(variant.operation);
  std::vector<std::string_view> names{"oracle"};
  for (const auto& party : parties::parties()) {
    if (party->name() != "oracle" && party->name() != "unicorn") names.push_back(party->name());
  }
  return parties_by_variant(operations, names);
}

}  // namespace

const std::vector<VariantParties>& parties_by_variant(WordTarget target) {
  using enum cases::Operation;
  constexpr auto hear = [](std::initializer_list<cases::Operation> operations) {
    constexpr auto names =
        std::to_array<std::string_view>({"oracle", "fast", "type", "model", "interpreter"});
    return parties_by_variant(operations, names);
  };
  static const std::array<std::vector<VariantParties>, 4> all{
      hear({div}), hear({mul}), hear({concat, xformvec}), all_variants()};
  return all.at(static_cast<std::size_t>(target));
}

std::size_t input_size(WordTarget target) {
  const bool pair = target == WordTarget::divide || target == WordTarget::multiply;
  const std::size_t words = pair ? 2 : cases::max_words_in;
  return (target == WordTarget::agreement ? 1 : 0) + words * bytes_of_word;
}

void mutate_case(const cases::Variant& variant, std::span<std::uint32_t> words, cases::Draw& draw) {
  const cases::Format format{.word_bits = cases::operand_bits(variant),
                             .fraction_bits = variant.format.fraction_bits};
  std::uint32_t& word = words[draw.below(words.size())];
  switch (draw.below(variant.operation == cases::Operation::div ? 5 : 4)) {
    case 0:
      draw_fresh(variant, words, draw);
      break;
    case 1: {
      static const auto wide = cases::boundary_lattice(32);
      const std::array<std::int64_t, 4> ends{-format.limit(), format.limit() - 1, -format.one(),
                                             -1};
      word = draw.below(4) == 0
                 ? format.word(ends[draw.below(ends.size())])
                 : format.word(static_cast<std::int64_t>(wide[draw.below(wide.size())]));
      break;
    }
    case 2:
      step_word(format, word, draw);
      break;
    case 3:
      std::swap(word, words[draw.below(words.size())]);
      step_word(format, word, draw);
      break;
    default:
      aim_quotient(format, words, draw);
  }
}

std::size_t mutate_input(WordTarget target, std::span<std::uint8_t> room, std::size_t size,
                         std::uint32_t seed) {
  const std::size_t whole = input_size(target);
  if (room.size() < whole) return std::min(size, room.size());
  std::fill(room.begin() + static_cast<std::ptrdiff_t>(std::min(size, whole)),
            room.begin() + static_cast<std::ptrdiff_t>(whole), std::uint8_t{0});
  cases::Draw draw(seed, 0);
  const auto& variants = parties_by_variant(target);
  std::size_t tested = draw.below(variants.size());
  auto bytes = room.first(whole);
  if (target == WordTarget::agreement) {
    if (draw.below(4) == 0) bytes[0] = static_cast<std::uint8_t>(tested);
    tested = bytes[0] % variants.size();
    bytes = bytes.subspan(1);
  }
  std::array<std::uint32_t, cases::max_words_in> words{};
  const auto all = std::span(words).first(bytes.size() / bytes_of_word);
  read_words(bytes, all);
  const cases::Variant& variant = variants[tested].variant;
  const auto one_case = all.first(cases::words_in(variant.operation));
  const std::uint32_t mask = ~std::uint32_t{0} >> (32 - cases::operand_bits(variant));
  for (auto& word : one_case) word &= mask;
  for (auto more = draw.below(3) + 1; more > 0; --more) mutate_case(variant, one_case, draw);
  write_words(all, bytes);
  return whole;
}

}  // namespace fixproof::fuzz
