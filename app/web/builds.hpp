/// @file
/// The results of the builds of FIXED.ASM, from three parties that share no code.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/web/formats.hpp"
#include "verify/cases/build.hpp"
#include "verify/cases/format.hpp"

namespace fixproof::web {

struct BuildAnswer {
  std::string name;
  std::string link;                   ///< its name in requests for a trace; empty in 8.8
  std::optional<std::uint64_t> word;  ///< the model's; none for a divide error
  bool agrees = false;                ///< whether the type and the oracle give the same word
};

/// Multiplies or divides with every build. The words are those of the model, which runs the
/// listing. Returns nothing for other operations, and for formats that FIXED.ASM does not have.
std::vector<BuildAnswer> answers_of_builds(Operation operation, const cases::Format& format,
                                           std::uint32_t a, std::uint32_t b);

}  // namespace fixproof::web
