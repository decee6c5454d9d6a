/// @file
/// The lemmas about integers that justify the abstractions of a proof.
#pragma once

#include <span>

namespace fixproof::proof {

struct Lemma {
  const char* name;
  const char* meaning;
  const char* smt;  ///< a complete script that is unsatisfiable if and only if the lemma holds
};

std::span<const Lemma> lemmas();

}  // namespace fixproof::proof
