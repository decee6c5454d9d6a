/// @file
/// Judges and times contenders.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "measure/accuracy/error_statistics.hpp"
#include "measure/host/host_contenders.hpp"
#include "measure/host/host_times.hpp"

namespace fixproof::measure {

/// A contender breaks its documented rule; what() names the case.
class WrongContender : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct HostRow {
  std::string operation;
  std::string name;
  std::string alike;
  HostKind kind;
  std::string rounding;
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

/// Judges and times each contender of each operation.
/// @param timed called with the number of finished rounds
/// @return nothing if `stop` ended the run
/// @throws WrongContender
std::vector<HostRow> measure_host_rows(const std::vector<HostOperation>& operations,
                                       std::uint64_t rounds, const std::atomic<bool>& stop,
                                       const std::function<void(std::uint64_t)>& timed);

}  // namespace fixproof::measure
