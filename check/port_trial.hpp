/// @file
/// Finds the named rules that a subject follows on all cases.
#pragma once

#include <vector>

#include "check/judged_case.hpp"
#include "check/ports.hpp"

namespace fixproof::check {

class PortTrial {
 public:
  PortTrial(cases::Operation operation, const cases::Format& format);

  /// Adds a case of the operation, with its words as the subject read them.
  void add(const JudgedCase& one);

  /// Returns the rules without an exception; none if there are no cases.
  [[nodiscard]] std::vector<const PortRule*> followed() const;

 private:
  cases::Format format_;
  bool has_cases_ = false;
  std::vector<const PortRule*> followed_;
};

}  // namespace fixproof::check
