#include "judge/desync/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "support/usage_error.hpp"

namespace fixproof::desync {

namespace {

/// How far from its place the counterpart of a record may be. No expression has as many operations.
constexpr std::size_t order_window = 64;

/// How far from its place most operations of an operand are if the other one is computed first.
constexpr std::size_t order_of_operands = 8;

/// A block differs if the runs are unequal at its end and at the ends of the blocks after it, up to
/// this many blocks in all.
constexpr word later_blocks = 8;

/// Skips the records that both sides have, at the same index or within a few records.
/// @return the first index that remains on each side
std::pair<std::size_t, std::size_t> first_unmatched(const std::vector<Record>& a,
                                                    const std::vector<Record>& b) {
  std::vector<bool> has_match(b.size());
  const auto find = [&](const Record& wanted, std::size_t from) {
    const std::size_t end = std::min(b.size(), from + order_window);
    while (from < end && (has_match[from] || b[from].words != wanted.words)) ++from;
    return from == end ? b.size() : from;
  };
  std::size_t next = 0;  // the first record of b without a match
  const auto pass = [&] {
    while (next < b.size() && has_match[next]) ++next;
  };
  for (std::size_t i = 0; i < a.size(); ++i, pass()) {
    const std::size_t match = find(a[i], next);
    if (match != b.size()) {
      has_match[match] = true;
      continue;
    }
    // The other side may have records that follow a[i] before the counterpart of a[i].
    for (std::size_t k = i + 1; k < std::min(a.size(), i + order_window); ++k) {
      const std::size_t later = find(a[k], next);
      if (later == b.size()) continue;
      has_match[later] = true;
      if (later == next) pass();
    }
    return {i, next};
  }
  return {a.size(), next};
}

/// Tells whether the first records without a match may be one operation with other operands. If one
/// side has an operation more, the records after it have a match, up to a later difference or to
/// the end. Then the first record of the other side is far away or of another kind.
bool are_counterparts(const std::vector<Record>& a, std::size_t i, const std::vector<Record>& b,
                      std::size_t j) {
  return i < a.size() && j < b.size() && std::max(i, j) - std::min(i, j) <= order_of_operands &&
         record::kind_of(a[i].words[0]) == record::kind_of(b[j].words[0]);
}

/// @param end the number of the block after the run or the frame
Side side_of(LogFile& log, word block, word end) {
  Side side;
  side.block = block;
  side.entry = log.entry(block);
  side.records = log.records(block);
  side.ends_run = side.entry.is_last;
  if (!side.records.empty() && block + 1 < end) {
    for (Record& record : log.records(block + 1)) side.records.push_back(std::move(record));
    side.ends_run = log.entry(block + 1).is_last;
  }
  return side;
}

/// Finds the record that differs in the first blocks that differ.
void look_into(Comparison& comparison) {
  Side& a = comparison.a;
  Side& b = comparison.b;
  if (a.records.empty() || b.records.empty()) {
    const Entry& x = a.entry;
    const Entry& y = b.entry;
    const bool is_cut =
        x.operations < y.operations ? x.is_last : y.operations < x.operations && y.is_last;
    comparison.verdict = is_cut ? Verdict::ended : Verdict::block;
    comparison.operations = x.first_operation;
    return;
  }
  auto [i, j] = first_unmatched(a.records, b.records);
  if (!are_counterparts(a.records, i, b.records, j)) i = j = std::min(i, j);
  if (i < a.records.size()) a.index = i;
  if (j < b.records.size()) b.index = j;
  if (a.index && b.index) {
    const Cause cause = cause_of(a.records, i, b.records, j);
    comparison.verdict = cause.verdict;
    comparison.origin = cause.origin;
    return;
  }
  const bool is_cut = (!a.index && a.ends_run) || (!b.index && b.ends_run);
  const Side& shorter = a.index ? b : a;
  comparison.verdict = is_cut ? Verdict::ended : Verdict::path;
  comparison.operations = shorter.entry.first_operation + shorter.entry.operations;
}

/// The blocks of a simulation of a frame, `end` excluded.
struct Simulation {
  word first = 0;
  word end = 0;
};

std::map<std::int64_t, Simulation> last_simulations(LogFile& log) {
  std::map<std::int64_t, Simulation> last;
  Simulation* open = nullptr;
  for (word block = 0; block < log.blocks(); ++block) {
    const Entry entry = log.entry(block);
    if (entry.begins_frame) {
      open = &last[entry.frame];
      open->first = block;
    }
    if (open != nullptr) open->end = block + 1;
  }
  if (last.empty()) {
    throw support::UsageError(fmt::format(
        "{}: the log has no frames; --rollback needs calls of record::frame()", log.path()));
  }
  return last;
}

/// The blocks that two simulations of a frame have in common.
struct CommonBlocks {
  word count = 0;
  word operations = 0;            ///< of A
  std::optional<word> different;  ///< the first one after which the sums of hashes stay different
};

CommonBlocks compare_common_blocks(LogFile& a, const Simulation& in_a, LogFile& b,
                                   const Simulation& in_b) {
  CommonBlocks common;
  common.count = std::min(in_a.end - in_a.first, in_b.end - in_b.first);
  word sum_a = 0;
  word sum_b = 0;
  for (word i = 0; i < common.count; ++i) {
    const Entry x = a.entry(in_a.first + i);
    const Entry y = b.entry(in_b.first + i);
    common.operations += x.operations;
    sum_a += x.hash;
    sum_b += y.hash;
    if (sum_a == sum_b) {
      common.different.reset();
    } else if (!common.different) {
      common.different = i;
    }
  }
  return common;
}

/// Tells whether one side has more blocks in a frame. A side whose log ends in the frame may have
/// lost blocks, so the other is not longer.
bool is_longer(const LogFile& a, const Simulation& in_a, const LogFile& b, const Simulation& in_b) {
  const word blocks_a = in_a.end - in_a.first;
  const word blocks_b = in_b.end - in_b.first;
  if (blocks_a == blocks_b) return false;
  return blocks_a < blocks_b ? in_a.end != a.blocks() : in_b.end != b.blocks();
}

}  // namespace

Comparison compare(LogFile& a, LogFile& b) {
  Comparison comparison;
  comparison.blocks = std::min(a.blocks(), b.blocks());
  const auto differ = [&](word block) {
    ++comparison.steps;
    const word end = std::min(comparison.blocks, block + later_blocks);
    for (; block < end; ++block) {
      if (a.entry(block).prefix == b.entry(block).prefix) return false;
    }
    return true;
  };
  if (comparison.blocks == 0) return comparison;
  word high = comparison.blocks - 1;
  if (!differ(high)) {
    const Entry last = a.entry(high);
    comparison.operations = last.first_operation + last.operations;
    return comparison;
  }
  for (word low = 0; low < high;) {
    const word middle = low + (high - low) / 2;
    if (differ(middle)) {
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  comparison.a = side_of(a, high, a.blocks());
  comparison.b = side_of(b, high, b.blocks());
  look_into(comparison);
  return comparison;
}

Comparison compare_last_frames(LogFile& a, LogFile& b) {
  Comparison comparison;
  const auto of_a = last_simulations(a);
  const auto of_b = last_simulations(b);
  const bool is_confirmed = a.confirmed() != record::no_frame && b.confirmed() != record::no_frame;
  const std::int64_t confirmed = std::min(a.confirmed(), b.confirmed());
  for (const auto& [frame, in_a] : of_a) {
    const auto found = of_b.find(frame);
    if (found == of_b.end() || (is_confirmed && frame > confirmed)) continue;
    const Simulation& in_b = found->second;
    ++comparison.blocks;
    const CommonBlocks common = compare_common_blocks(a, in_a, b, in_b);
    comparison.steps += common.count;
    if (common.different) {
      Comparison here = comparison;
      here.a = side_of(a, in_a.first + *common.different, in_a.end);
      here.b = side_of(b, in_b.first + *common.different, in_b.end);
      look_into(here);
      if (here.verdict != Verdict::ended) return here;
      continue;
    }
    comparison.operations += common.operations;
    if (!is_longer(a, in_a, b, in_b)) continue;
    // The first additional operation is in the block after the common ones.
    comparison.a = side_of(a, std::min(in_a.first + common.count, in_a.end - 1), in_a.end);
    comparison.b = side_of(b, std::min(in_b.first + common.count, in_b.end - 1), in_b.end);
    Side& longer = common.count < in_a.end - in_a.first ? comparison.a : comparison.b;
    comparison.verdict = longer.records.empty() ? Verdict::block : Verdict::path;
    if (!longer.records.empty()) longer.index = 0;
    return comparison;
  }
  return comparison;
}

}  // namespace fixproof::desync
