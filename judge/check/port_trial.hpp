/// @file
/// Finds the named rules that a subject follows on all cases.
#pragma once

#include <vector>

#include "judge/check/judged_case.hpp"
#include "judge/check/ports.hpp"

namespace fixproof::check {

/// Compares the results of a subject with every named rule of an operation in a format.
class PortTrial {
 public:
  explicit PortTrial(const cases::Variant& variant);

  /// Adds a case of the operation, with its words as the subject reads them.
  void add(const JudgedCase& one);

  /// Returns the rules that agree with every case, or none if there are no cases.
  [[nodiscard]] std::vector<const PortRule*> followed() const;

 private:
  cases::Format format_;
  bool has_cases_ = false;
  std::vector<const PortRule*> followed_;
};

}  // namespace fixproof::check
