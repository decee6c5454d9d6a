/// @file
/// The two formats of captured cases, and what their readers share.
#pragma once

#include <string>
#include <string_view>

#include "verify/singlestep/read.hpp"

namespace fixproof::singlestep {

/// @throws UsageError naming the case and the member, or the byte where the JSON is damaged
void read_json(std::string_view text, x86model::Cpu cpu, const UseCase& use);

/// The first bytes of a MOO file.
inline constexpr std::string_view moo_magic = "MOO ";
/// @throws UsageError naming the byte and the chunk
void read_moo(std::string_view bytes, x86model::Cpu cpu, const UseCase& use);

/// "case 3 'add ax, bx'", for messages.
std::string label_of(const Case& c);

/// Fills in unchanged registers and calls `use`.
/// @throws UsageError, also for errors of `use`, naming the case
void finish(Case& c, x86model::Cpu cpu, const UseCase& use);

}  // namespace fixproof::singlestep
