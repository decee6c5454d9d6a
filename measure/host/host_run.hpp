/// @file
/// Contenders judged and timed.
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

/// A contender breaks the rule that is stated of it; what() names the case.
class WrongContender : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Of one contender at one operation.
struct HostRow {
  std::string operation;
  std::string name;
  std::string alike;
  HostKind kind;
  std::string rounding;
  std::uint64_t cases = 0;
  std::uint64_t exceptions = 0;
  ErrorStatistics errors{};
  Times each{};                  ///< where results do not depend on one another
  std::optional<Times> chain{};  ///< where each is an operand of the next
};

/// Computes all operands of an operation, and its chain, by the loops that are timed, and leaves
/// the contender with what is timed.
/// @throws WrongContender
HostRow judge_contender(const HostOperation& operation, const HostContender& contender);

/// A row for each contender of each operation.
/// @param timed is told how many rounds are done
/// @return nothing where `stop` ended the run
/// @throws WrongContender
std::vector<HostRow> measure_host_rows(const std::vector<HostOperation>& operations,
                                       std::uint64_t rounds, const std::atomic<bool>& stop,
                                       const std::function<void(std::uint64_t)>& timed);

}  // namespace fixproof::measure
