/// @file
/// Goes through the cases of an operation with the machine that fits, and collects what happens.
#pragma once

#include <functional>

#include "judge/verdict.hpp"

namespace fixproof::judge {

/// Called for each case that returned or raised #DE.
using OnAnswer = std::function<void(std::span<const std::uint32_t> words, const Answer& answer,
                                    std::string_view origin)>;

/// Runs every case on the processor, or on Unicorn if the processor cannot, or if only the
/// processor's process has trouble. Fills in all of `verdict` that does not depend on right
/// results.
/// @param begin called before the cases, a second time if they start over on Unicorn
void run_cases(const Subject& subject, const VerdictOptions& options, Verdict& verdict,
               const std::function<void()>& begin, const OnAnswer& on_answer);

/// The operands in hex, and in decimal in parentheses.
std::string text_of_operands(const cases::Variant& variant, std::span<const std::uint32_t> words);

}  // namespace fixproof::judge
