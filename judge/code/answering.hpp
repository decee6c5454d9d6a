/// @file
/// Runs all cases of an operation on the machine that can run them, and collects what happens.
#pragma once

#include <functional>

#include "judge/code/verdict.hpp"

namespace fixproof::judge {

/// Receives each case that returns or raises #DE.
using OnAnswer = std::function<void(std::span<const std::uint32_t> words, const Answer& answer,
                                    std::string_view origin)>;

/// Runs every case on the processor. Runs them on Unicorn instead if the processor cannot run the
/// code, or if a call fails on the processor and not on Unicorn. Fills in everything in `verdict`
/// that does not depend on the expected results. After an interrupt it stops with the cases so far.
/// @param begin called before the first case, and again if the cases start over on Unicorn
void run_cases(const Subject& subject, const VerdictOptions& options, Verdict& verdict,
               const std::function<void()>& begin, const OnAnswer& on_answer);

/// Returns the operands in hex, followed by their decimal values in parentheses. Those of xformvec
/// are only in hex.
std::string text_of_operands(const cases::Variant& variant, std::span<const std::uint32_t> words);

}  // namespace fixproof::judge
