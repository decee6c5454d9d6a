/// @file
/// How each party is made; see party.hpp for what they are.
#pragma once

#include <memory>

#include "verify/party.hpp"

namespace fixproof {

std::unique_ptr<Party> make_model();
std::unique_ptr<Party> make_interpreter();
std::unique_ptr<Party> make_oracle();
std::unique_ptr<Party> make_fast_oracle();
std::unique_ptr<Party> make_type();
std::unique_ptr<Party> make_silicon();
std::unique_ptr<Party> make_unicorn();

/// Whether the variant is one of FIXED.ASM's: a routine on a processor.
constexpr bool is_routine(const Variant& v) {
  return v.target != Target::standard && v.operation <= Operation::concat;
}

}  // namespace fixproof
