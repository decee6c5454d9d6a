/// @file
/// Measures the time and the errors of every contender on this processor.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "measure/accuracy/error_statistics.hpp"
#include "measure/host/host_contenders.hpp"
#include "measure/host/host_times.hpp"
#include "measure/measure.hpp"
#include "support/json.hpp"

namespace fixproof::measure {

struct HostRow {
  HostContender contender;
  std::uint64_t cases = 0;
  std::uint64_t exceptions = 0;
  ErrorStatistics errors{};
  Times each{};                  ///< of independent operations
  std::optional<Times> chain{};  ///< of operations on the previous result
};

/// Runs all operands of an operation and its chain through the timed loops, judges the results, and
/// leaves the timed operands loaded.
/// @throws WrongContender
HostRow judge_contender(const HostOperation& operation, const HostContender& contender);

struct HostTable {
  HostOperation operation;
  std::vector<HostRow> rows;

  [[nodiscard]] bool of_vertices() const { return operation.name == "vertex"; }
};

struct HostResult {
  std::uint64_t seed = 0;
  std::uint64_t rounds = 0;
  std::uint64_t cases = 0;  ///< minimum number of checked results
  std::vector<HostTable> tables;
};

/// @throws WrongContender
std::optional<HostResult> measure_host(const MeasureRequest& request, MeasureProgress& progress);

/// Times are nanoseconds of processor time per operation; `spread` is the interquartile range over
/// the median. Errors are in ulps of 16.16; `correct` is the share, 0 ... 1, within half an ulp.
///
///     made       {command, seed, compiler, date, flags, processor}
///     libraries  {libfixmath, FreeType}: whether each is built in
///     rounds     how often every loop was timed
///     operands   {arrays, chains}: the cases in the arrays of each operation (of "vertex" the
///                vertices), and the steps of its chain, if it has one
///     host       a list of {operation: mul, div, sqrt or cos; contender; alike: presets that run
///                the same code; kind: type, plain, library or floating; rounding: as its maker
///                states it; throughput_ns: {min, median, spread}; chain_ns: the same, or null
///                without a chain; cases: results checked; exceptions: those that break the stated
///                rounding within the known error of the contender; accuracy: {max, mean, rms,
///                correct}}
///     vertices   a list of {contender, alike, kind, rounding; ns: {min, median, spread} per
///                vertex; per_second: {most, median}; cases, exceptions, accuracy: of coordinates}
void to_json(support::Json& json, const HostResult& result);

}  // namespace fixproof::measure
