#include "judge/check/cases.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "support/read_line.hpp"
#include "support/usage_error.hpp"
#include "verify/cases/plan.hpp"
#include "verify/cases/words.hpp"

namespace fixproof::check {

namespace {

constexpr std::uint64_t cases_of_batch = 1024;

/// A plan has cases only for rows of at least two parties, so the row has two placeholders.
cases::Plan plan_of(const cases::Variant& variant, const CaseOptions& options) {
  return {static_cast<int>(options.level), options.seed, {{variant, {"a", "b"}}}};
}

}  // namespace

std::string CaseOptions::command_line(const cases::Variant& variant) const {
  std::string text = fmt::format("fixproof gen {}", cases::name_of(variant.operation));
  const cases::Format format = cases::operand_format(variant);
  if (format != cases::q16_16) text += fmt::format(" --format {}", cases::name_of(format));
  if (variant.from || variant.operation == cases::Operation::convert) {
    text += fmt::format(" --to {}", cases::name_of(variant.format));
  }
  if (variant.terms != cases::Variant{}.terms) text += fmt::format(" --terms {}", variant.terms);
  text += fmt::format(" --level {}", level);
  if (seed != CaseOptions{}.seed) text += fmt::format(" --seed {}", seed);
  if (shard != CaseOptions{}.shard) text += fmt::format(" --shard {}", shard);
  if (cases) text += fmt::format(" --cases {}", *cases);
  return text;
}

GeneratedCases::GeneratedCases(const cases::Variant& variant, const CaseOptions& options)
    : variant_(variant),
      plan_(plan_of(variant_, options)),
      shard_(cases::parse_shard(options.shard)),
      seed_(options.seed),
      all_(plan_.cases()),
      wanted_(std::min(options.cases.value_or(all_), all_)),
      batch_(cases_of_batch * cases::words_in(variant_)) {
  for (const cases::Job& job : plan_.jobs()) count_ += count_of(cases::name_of(job.stream));
}

std::uint64_t GeneratedCases::cases_before(const cases::Chunk& chunk) const {
  std::uint64_t before = chunk.first;
  for (const cases::Job* job = plan_.jobs().data(); job != chunk.job; ++job) before += job->cases;
  return before;
}

// The product stays below 2^64, because a plan has less than 2^32 cases.
std::uint64_t GeneratedCases::taken_of(std::uint64_t cases) const { return cases * wanted_ / all_; }

std::uint64_t GeneratedCases::count_of(std::string_view stream) const {
  std::uint64_t sum = 0;
  for (std::uint64_t i = 0; i < plan_.chunks(); ++i) {
    const cases::Chunk chunk = plan_.chunk(i);
    if (!shard_.has(i) || cases::name_of(chunk.job->stream) != stream) continue;
    const std::uint64_t before = cases_before(chunk);
    sum += taken_of(before + chunk.cases) - taken_of(before);
  }
  return sum;
}

bool GeneratedCases::fill() {
  while (!chunk_ || in_chunk_ == chunk_->cases) {
    while (next_chunk_ < plan_.chunks() && !shard_.has(next_chunk_)) ++next_chunk_;
    if (next_chunk_ == plan_.chunks()) return false;
    chunk_ = plan_.chunk(next_chunk_++);
    in_chunk_ = 0;
    place_ = cases_before(*chunk_);
    origin_ = cases::name_of(chunk_->job->stream);
  }
  const std::uint64_t cases = std::min(cases_of_batch, chunk_->cases - in_chunk_);
  const auto batch = std::span(batch_).first(cases * cases::words_in(variant_));
  cases::make_cases(chunk_->job->stream, variant_, seed_, chunk_->first + in_chunk_, batch);
  in_chunk_ += cases;
  rest_ = batch;
  return true;
}

bool GeneratedCases::next(std::span<std::uint32_t> words) {
  for (;;) {
    if (rest_.empty() && !fill()) return false;
    const auto one = rest_.first(words.size());
    rest_ = rest_.subspan(words.size());
    ++place_;
    if (taken_of(place_) == taken_of(place_ - 1)) continue;
    std::copy(one.begin(), one.end(), words.begin());
    return true;
  }
}

std::optional<ValuedCase> GeneratedCases::next_valued() {
  std::vector<std::uint32_t> words(cases::words_in(variant_));
  if (!next(words)) return std::nullopt;
  std::string line;
  cases::append_operands(line, variant_, words);
  return parse_valued(line, variant_);
}

FileCases::FileCases(const cases::Variant& variant, std::string path)
    : variant_(variant), path_(std::move(path)), file_(path_) {
  if (!file_) {
    throw support::UsageError(
        fmt::format("cannot read {}: {}", path_, std::generic_category().message(errno)));
  }
}

template <class Parse>
bool FileCases::next_line(Parse parse) {
  std::string line;
  try {
    do {
      ++line_;
      if (!support::read_line(file_, line)) return false;
    } while (support::is_blank_or_comment(line));
    parse(line);
  } catch (const support::UsageError& error) {
    throw support::UsageError(fmt::format("{}, line {}: {}", path_, line_, error.what()));
  }
  return true;
}

bool FileCases::next(std::span<std::uint32_t> words) {
  return next_line([&](const std::string& line) { cases::parse_words(line, variant_, words); });
}

std::optional<ValuedCase> FileCases::next_valued() {
  std::optional<ValuedCase> valued;
  next_line([&](const std::string& line) { valued = parse_valued(line, variant_); });
  return valued;
}

}  // namespace fixproof::check
