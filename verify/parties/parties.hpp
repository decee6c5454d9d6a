/// @file
/// Functions that make the parties of party.hpp.
#pragma once

#include <memory>
#include <vector>

#include "verify/parties/party.hpp"

namespace fixproof::parties {

std::unique_ptr<Party> make_model();
std::unique_ptr<Party> make_interpreter();
std::unique_ptr<Party> make_oracle();
std::unique_ptr<Party> make_fast_oracle();
std::unique_ptr<Party> make_type();
/// Makes `batch`, which takes the best path, and one party per path of fixed/batch/batch.hpp.
std::vector<std::unique_ptr<Party>> make_batch_parties();
std::unique_ptr<Party> make_silicon();
std::unique_ptr<Party> make_unicorn();

/// Tells whether the variant is a routine of FIXED.ASM on a processor.
constexpr bool is_routine(const cases::Variant& v) {
  return v.build.target != cases::Target::standard && cases::is_routine(v.operation);
}

/// Tells whether the model has a program for the variant at its width. Chapter 52 has three of the
/// routines. Only the multiply and the divide run on 8-bit registers.
constexpr bool has_program(const cases::Variant& v) {
  if (!is_routine(v) || !cases::has_routine_format(v)) return false;
  const bool binary = v.operation == cases::Operation::mul || v.operation == cases::Operation::div;
  const bool full = v.format == cases::q16_16;
  const bool in_chapter_52 = v.build.target == cases::Target::i386 && cases::rounds(v) && full &&
                             (binary || v.operation == cases::Operation::concat);
  const bool has_repaired = cases::can_be_repaired(v.operation, v.build.target) && full;
  return (full || binary) && (!v.build.chapter_52 || in_chapter_52) &&
         (!v.build.repaired || has_repaired);
}

}  // namespace fixproof::parties
