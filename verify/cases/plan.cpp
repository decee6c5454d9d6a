#include "verify/cases/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <numeric>
#include <stdexcept>
#include <system_error>

#include "support/usage_error.hpp"
#include "verify/cases/conversion_makers.hpp"
#include "verify/cases/edges.hpp"
#include "verify/cases/format_makers.hpp"

namespace fixproof::cases {

namespace {

/// A stream and its number of cases in a job. Enumerated streams ignore the number and run whole.
struct Share {
  Stream stream;
  std::uint64_t cases = 0;
};

/// The number of random cases per stream at level 1. Level 1 must take less than 20 s on two slow
/// processors, so operations that take the oracle longer have fewer cases.
std::uint64_t sample_of(Operation operation) {
  switch (operation) {
    case Operation::mul:
      return 250'000;
    case Operation::div:
      return 125'000;
    case Operation::xformvec:
      return 50'000;
    case Operation::concat:
      return 15'000;
    case Operation::sin:
    case Operation::cos:
      return 25'000;
    default:
      return 100'000;
  }
}

constexpr std::uint64_t level_2_factor = 60;

/// A chunk takes some ten milliseconds. This bounds the response time to Ctrl-C and the time that
/// an idle thread waits for the others.
std::uint64_t cases_per_chunk(Operation operation, int level) {
  if (level == 3) return std::uint64_t{1} << 20U;
  switch (operation) {
    case Operation::xformvec:
      return std::uint64_t{1} << 13U;
    case Operation::concat:
      return std::uint64_t{1} << 11U;
    default:
      return std::uint64_t{1} << 16U;
  }
}

std::vector<Share> sampled_streams(Operation operation, std::uint64_t sample) {
  switch (operation) {
    case Operation::mul:
      return {{Stream::lattice},
              {Stream::uniform, sample},
              {Stream::scaled, sample},
              {Stream::product_ties, sample},
              {Stream::near_product_ties, sample}};
    case Operation::div:
      return {{Stream::lattice},
              {Stream::uniform, sample},
              {Stream::scaled, sample},
              {Stream::quotient_ties, sample},
              {Stream::near_quotient_ties, sample},
              {Stream::whole_divisor_ties, sample},
              {Stream::large_quotients, sample},
              {Stream::small_divisors, sample},
              {Stream::fault_edge, sample}};
    case Operation::cossin:
      return {{Stream::every}};
    case Operation::xformvec:
    case Operation::concat:
      return {{Stream::rotations, sample},     {Stream::uniform, sample},
              {Stream::scaled, sample},        {Stream::axes, sample},
              {Stream::lattice_words, sample}, {Stream::transform_ties, sample}};
    case Operation::sqrt:
      return {{Stream::lattice},
              {Stream::uniform, sample},
              {Stream::scaled, sample},
              {Stream::root_ties, sample}};
    case Operation::sin:
    case Operation::cos:
      return {{Stream::lattice},        {Stream::uniform, sample},
              {Stream::scaled, sample}, {Stream::quarter_turns, sample},
              {Stream::hard_angles},    {Stream::edges}};
    case Operation::decimal:
    case Operation::binary64:
    case Operation::to_decimal:
      break;
    case Operation::add:
    case Operation::sub:
      return {{Stream::lattice},
              {Stream::uniform, sample},
              {Stream::scaled, sample},
              {Stream::value_ties, sample},
              {Stream::near_value_ties, sample}};
    case Operation::from_binary64:
    case Operation::convert:
    case Operation::from_decimal:
      return {{Stream::lattice},
              {Stream::uniform, sample},
              {Stream::scaled, sample},
              {Stream::value_ties, sample},
              {Stream::near_value_ties, sample}};
    case Operation::fmod:
    case Operation::remainder:
      return {{Stream::lattice},
              {Stream::uniform, sample},
              {Stream::scaled, sample},
              {Stream::half_multiples, sample}};
    case Operation::mul_div:
      return {{Stream::lattice_words, sample},   {Stream::uniform, sample},
              {Stream::scaled, sample},          {Stream::ratio_ties, sample},
              {Stream::near_ratio_ties, sample}, {Stream::large_ratios, sample}};
    case Operation::hypot3:
      return {{Stream::lattice_words, sample},
              {Stream::uniform, sample},
              {Stream::scaled, sample},
              {Stream::whole_lengths, sample},
              {Stream::near_length_ties, sample}};
    case Operation::mul_add:
    case Operation::lerp:
    case Operation::dot:
      return {{Stream::extremes, sample},     {Stream::lattice_words, sample},
              {Stream::uniform, sample},      {Stream::scaled, sample},
              {Stream::product_ties, sample}, {Stream::near_product_ties, sample}};
    default:  // any other function
      break;
  }
  std::vector<Share> shares{{Stream::lattice}, {Stream::uniform, sample}, {Stream::scaled, sample}};
  if (has_edges(operation)) shares.push_back({Stream::edges});
  return shares;
}

/// Whether a conversion, or an operation of a format that no routine has, offers cases of a stream.
bool offers(const Variant& variant, Stream stream) {
  if (is_conversion(variant.operation)) return has_conversion_stream(stream, variant);
  const Format format = operand_format(variant);
  switch (stream) {
    case Stream::edges:
      return has_edges_in(variant.operation, format);
    case Stream::whole_lengths:
    case Stream::near_length_ties:
      return format.word_bits <= 32;
    case Stream::whole_divisor_ties:
    case Stream::fault_edge:
    case Stream::quarter_turns:
    case Stream::hard_angles:
      return false;
    case Stream::value_ties:
    case Stream::near_value_ties:
      return has_conversion_stream(stream, variant);
    default:
      return maker_format(stream, variant).has_value();
  }
}

std::vector<Share> streams_of(const Variant& variant, int level) {
  if (level == 3) return {{Stream::every}};
  const std::uint64_t factor = level == 2 ? level_2_factor : 1;
  if (has_routine_format(variant)) {
    std::vector<Share> shares =
        sampled_streams(variant.operation, sample_of(variant.operation) * factor);
    // Sums of words are exact.
    std::erase_if(shares, [](const Share& one) {
      return one.stream == Stream::value_ties || one.stream == Stream::near_value_ties;
    });
    return shares;
  }
  // There are three dozen formats, each with its own plan. A conversion has many pairs of them.
  constexpr std::uint64_t sample = 10'000;
  std::vector<Share> shares = sampled_streams(variant.operation, sample * factor);
  std::erase_if(shares, [&](const Share& one) { return !offers(variant, one.stream); });
  return shares;
}

}  // namespace

Plan::Plan(int level, std::uint64_t seed, std::vector<Row> rows)
    : level_(level), seed_(seed), rows_(std::move(rows)) {
  if (level < 1 || level > 3)
    throw std::invalid_argument(fmt::format("there is no level {}; choose 1, 2 or 3", level));
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    if (!rows_[row].compared()) continue;
    const Variant& variant = rows_[row].variant;
    for (const Share& share : streams_of(variant, level)) {
      add_job(row, share.stream, size_of(share.stream, variant).value_or(share.cases));
    }
  }
}

void Plan::add_job(std::size_t row, Stream stream, std::uint64_t cases) {
  const std::uint64_t per_chunk = cases_per_chunk(rows_[row].variant.operation, level_);
  jobs_.push_back({row, stream, cases, per_chunk, chunks_});
  chunks_ += (cases + per_chunk - 1) / per_chunk;
}

Chunk Plan::chunk(std::uint64_t number) const {
  const auto after = std::upper_bound(
      jobs_.begin(), jobs_.end(), number,
      [](std::uint64_t wanted, const Job& job) { return wanted < job.first_chunk; });
  const Job& job = *std::prev(after);
  const std::uint64_t first = (number - job.first_chunk) * job.cases_per_chunk;
  return {&job, first, std::min(job.cases_per_chunk, job.cases - first)};
}

std::uint64_t Plan::cases() const {
  return std::accumulate(jobs_.begin(), jobs_.end(), std::uint64_t{0},
                         [](std::uint64_t sum, const Job& job) { return sum + job.cases; });
}

bool can_be_exhausted(const Variant& v) {
  return words_in(v.operation) * static_cast<std::size_t>(operand_bits(v)) <= 32;
}

std::optional<Variant> at_level(int level, const Variant& variant) {
  Variant v = variant;
  if (level != 3) return v;
  switch (v.operation) {
    case Operation::mul:
    case Operation::div:
      if (v.build.chapter_52) return std::nullopt;
      v.format = q8_8;
      return v;
    case Operation::xformvec:
    case Operation::concat:
      return std::nullopt;
    default:
      return v;
  }
}

Shard parse_shard(const std::string& text) {
  Shard shard;
  const char* end = text.data() + text.size();
  const auto index = std::from_chars(text.data(), end, shard.index);
  if (index.ec == std::errc{} && index.ptr != end && *index.ptr == '/') {
    const auto count = std::from_chars(index.ptr + 1, end, shard.count);
    if (count.ec == std::errc{} && count.ptr == end && shard.index >= 1 &&
        shard.index <= shard.count) {
      return shard;
    }
  }
  throw support::UsageError(fmt::format("--shard {}: give i/n with 1 <= i <= n", text));
}

}  // namespace fixproof::cases
