/// @file
/// What the abstractions of a proof rest on, each a statement about integers.
#pragma once

#include <span>

namespace fixproof::proof {

struct Lemma {
  const char* name;
  const char* meaning;
  const char* smt;  ///< a whole script that is unsatisfiable exactly where the lemma holds
};

std::span<const Lemma> lemmas();

}  // namespace fixproof::proof
