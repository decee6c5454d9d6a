#include "measure/accuracy/accuracy_run.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "measure/accuracy/scene_operands.hpp"
#include "oracle/format.hpp"
#include "verify/cases/draw.hpp"
#include "verify/cases/streams.hpp"

namespace fixproof::measure {

namespace {

using oracle::Integer;

/// Random words of a stream. make_cases() needs an operation; multiplies serve every operation.
std::vector<std::uint32_t> words_of_stream(cases::Stream stream, std::uint64_t seed,
                                           std::size_t words) {
  std::vector<std::uint32_t> all(words + words % 2);
  cases::make_cases(stream, {.operation = cases::Operation::mul}, seed, 0, all);
  all.resize(words);
  return all;
}

/// The upper `bits` bits of a word, sign-extended.
std::uint32_t signed_bits(std::uint32_t word, int bits) {
  return static_cast<std::uint32_t>(static_cast<std::int32_t>(word) >> (32 - bits));
}

/// Maps a uniform word to a uniform operand of the kind.
std::uint32_t confined(OperandKind kind, std::uint32_t word) {
  switch (kind) {
    case OperandKind::factors:
      return signed_bits(word, 24);
    case OperandKind::terms:
      return signed_bits(word, 23);
    case OperandKind::radicand:
      return word >> 1U;
    default:
      return word;
  }
}

/// Whether a word can hold the exact result rounded in either direction.
bool fits(const ExactResult& exact) {
  static const Integer limit = Integer(1) << 31;
  return exact.numerator >= -limit * exact.denominator &&
         exact.numerator <= (limit - 1) * exact.denominator;
}

/// The result is mantissa / 2^places.
double add_scaled(ErrorStatistics& errors, const Integer& mantissa, int places,
                  const ExactResult& exact) {
  const Integer denominator = exact.denominator << places;
  const Integer off = mantissa * exact.denominator - (exact.numerator << places);
  const double error = static_cast<double>(off) / static_cast<double>(denominator);
  errors.add(error, 2 * abs(off) <= denominator);
  return error;
}

}  // namespace

double add_error(ErrorStatistics& errors, const Integer& result, const ExactResult& exact) {
  return add_scaled(errors, result, 0, exact);
}

double add_error(ErrorStatistics& errors, double result, const ExactResult& exact) {
  if (result == std::trunc(result)) return add_scaled(errors, Integer(result), 0, exact);
  int exponent = 0;
  constexpr int bits = std::numeric_limits<double>::digits;
  const double mantissa = std::ldexp(std::frexp(result, &exponent), bits);
  // Positive, because the result is not a whole number.
  const int places = bits - exponent;
  return add_scaled(errors, Integer(static_cast<std::int64_t>(mantissa)), places, exact);
}

std::vector<OperandSet> random_operands(const MeasuredOperation& operation, std::uint64_t seed,
                                        std::uint64_t cases) {
  if (operation.kind == OperandKind::angle) {
    std::vector<std::uint32_t> angles(3600);
    std::iota(angles.begin(), angles.end(), 0U);
    return {{"every angle", std::move(angles)}};
  }
  OperandSet uniform{"uniform",
                     words_of_stream(cases::Stream::uniform, seed, cases * operation.words)};
  for (std::uint32_t& word : uniform.words) word = confined(operation.kind, word);
  std::vector<OperandSet> sets{uniform};
  if (operation.kind == OperandKind::quotients) {
    // Uniform words are nearly all large, so smaller ones add other quotients.
    sets.push_back({"uniform to 2048", std::move(uniform.words)});
    for (std::uint32_t& word : sets.back().words) word = signed_bits(word, 28);
  }
  OperandSet scaled{"log-uniform",
                    words_of_stream(cases::Stream::scaled, seed, cases * operation.words)};
  if (operation.kind == OperandKind::radicand) {
    // Radicands are not negative.
    for (std::uint32_t& word : scaled.words) {
      if (static_cast<std::int32_t>(word) < 0) word = ~word;
    }
  }
  sets.push_back(std::move(scaled));
  return sets;
}

OperandSet scene_operands(const MeasuredOperation& operation, const std::string& scene,
                          const player::OperandLog& log, std::uint64_t cases) {
  std::vector<std::uint32_t> all;
  switch (operation.kind) {
    case OperandKind::factors:
      all = products_of(log);
      break;
    case OperandKind::terms:
      all = dots_of(log);
      break;
    case OperandKind::quotients:
      all = log.at(static_cast<std::size_t>(cases::Operation::div));
      break;
    case OperandKind::angle:
      for (const std::uint32_t word : log.at(static_cast<std::size_t>(cases::Operation::cossin))) {
        // Angles have 16 bits.
        all.push_back(static_cast<std::uint32_t>(static_cast<std::int16_t>(word)));
      }
      break;
    case OperandKind::radicand:
    case OperandKind::radians:
      break;
  }
  const std::uint64_t recorded = all.size() / operation.words;
  const std::uint64_t kept = std::min(recorded, cases);
  OperandSet set{scene, {}};
  for (std::uint64_t i = 0; i < kept; ++i) {
    // A random case from each stretch, because equal steps could alias with the scene's own rhythm.
    const std::uint64_t begin = i * recorded / kept;
    cases::Draw draw(0, i);
    const std::uint64_t chosen = begin + draw.below((i + 1) * recorded / kept - begin);
    const CaseWords words = CaseWords(all).subspan(chosen * operation.words, operation.words);
    set.words.insert(set.words.end(), words.begin(), words.end());
  }
  return set;
}

static support::Json pairs_json(const check::FlawedPairs& pairs) {
  return {{"pairs", pairs.pairs}, {"wrong", pairs.wrong}, {"first", pairs.first}};
}

void to_json(support::Json& json, const AccuracyRow& row) {
  const ErrorStatistics& e = row.errors;
  json = {{"operation", row.operation},
          {"operands", row.operands},
          {"variant", row.variant},
          {"alike", row.alike},
          {"cases", e.cases()},
          {"left_out", row.beyond},
          {"faults", row.faults},
          {"max", e.max()},
          {"mean", e.mean()},
          {"mean_error", e.mean_error()},
          {"rms", e.root_mean_square()},
          {"correct", e.correct()},
          {"histogram", {{"span", e.histogram().span()}, {"counts", e.histogram().counts()}}}};
  if (!row.curve) return;
  json["worst"] = row.worst;
  json["mean_size"] = row.curve->mean_error;
  json["order"] = pairs_json(row.curve->order);
  json["symmetry"] = pairs_json(row.curve->symmetry);
}

std::vector<AccuracyRow> measure_errors(const MeasuredOperation& operation, const OperandSet& set,
                                        const std::atomic<bool>& stop) {
  std::vector<AccuracyRow> rows;
  for (const Subject& subject : operation.subjects) {
    rows.push_back({operation.name, set.name, subject.name, subject.alike, {}, 0, 0});
  }
  const CaseWords words = set.words;
  for (std::size_t i = 0; i + operation.words <= words.size() && !stop; i += operation.words) {
    const CaseWords in = words.subspan(i, operation.words);
    const auto exact = operation.exact(in);
    const bool counts = exact && fits(*exact);
    for (std::size_t k = 0; k < rows.size(); ++k) {
      if (!counts) {
        ++rows[k].beyond;
      } else if (const auto result = operation.subjects[k].answer(in)) {
        add_error(rows[k].errors, *result, *exact);
      } else {
        ++rows[k].faults;
      }
    }
  }
  return rows;
}

}  // namespace fixproof::measure
