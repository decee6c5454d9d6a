/// @file
/// The builds of FIXED.ASM, answered by three parties that share no code.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cases/build.hpp"
#include "cases/format.hpp"
#include "web/formats.hpp"

namespace fixproof::web {

struct BuildAnswer {
  std::string name;
  std::string link;                   ///< the build's name in requests for a trace
  std::optional<std::uint64_t> word;  ///< of the model; empty for a divide error
  bool agrees = false;                ///< whether the type and the oracle give the same
};

/// Multiplies or divides by every build: the model's, which runs the listing. Empty for other
/// operations and for formats that FIXED.ASM does not have.
std::vector<BuildAnswer> answers_of_builds(Operation operation, const cases::Format& format,
                                           std::uint32_t a, std::uint32_t b);

}  // namespace fixproof::web
