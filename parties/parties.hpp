/// @file
/// How each party is made; see party.hpp for what they are.
#pragma once

#include <memory>
#include <vector>

#include "parties/party.hpp"

namespace fixproof::parties {

std::unique_ptr<Party> make_model();
std::unique_ptr<Party> make_interpreter();
std::unique_ptr<Party> make_oracle();
std::unique_ptr<Party> make_fast_oracle();
std::unique_ptr<Party> make_type();
/// fixed/batch.hpp on every path there is, the best one first.
std::vector<std::unique_ptr<Party>> make_batch_parties();
std::unique_ptr<Party> make_silicon();
std::unique_ptr<Party> make_unicorn();

/// Whether the variant is one of FIXED.ASM's: a routine on a processor.
constexpr bool is_routine(const cases::Variant& v) {
  return v.target != cases::Target::standard && v.operation <= cases::Operation::concat;
}

/// Whether the model has a program for the variant, at its width: chapter 52 has a form of three
/// routines, the 8088 ConcatXforms has a repaired one, and what runs on 8-bit registers is the
/// multiply and the divide.
constexpr bool has_program(const cases::Variant& v) {
  if (!is_routine(v)) return false;
  const bool binary = v.operation == cases::Operation::mul || v.operation == cases::Operation::div;
  const bool full = v.fraction_bits == 16;
  const bool in_chapter_52 = v.target == cases::Target::i386 && cases::rounds(v) && full &&
                             (binary || v.operation == cases::Operation::concat);
  const bool has_repaired =
      v.operation == cases::Operation::concat && v.target == cases::Target::i8088 && full;
  return (full || binary) && (!v.chapter_52 || in_chapter_52) && (!v.repaired || has_repaired);
}

}  // namespace fixproof::parties
