/// @file
/// The programs that are assembled to machine code, and their names.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "x86model/loop.hpp"
#include "x86model/routine.hpp"
#include "x86model/run.hpp"

namespace fixproof::machine_code {

struct ProgramKey {
  x86model::Routine routine = x86model::Routine::mul;
  x86model::Target target = x86model::Target::i386;
  x86model::Build build;
};

/// Returns the keys of all programs: each routine on each processor under each setting of its own
/// switch, the forms of chapter 52, the 8088 divide as scanned, and the repaired 8088 ConcatXforms.
std::vector<ProgramKey> all_programs();

/// Returns the program's name, such as mul-i386-on or div-i8088-off-scanned. The name has only the
/// routine's own switch, so two keys of the same program share a name.
std::string name_of(const ProgramKey& key);

/// Returns the name of a loop form: gouraud-byte-i386-dec-jnz, with -printed if as printed.
std::string name_of(const x86model::LoopForm& form);

/// Returns the loop's command-line name: gouraud-byte, gouraud-word, depth or texture.
std::string_view name_of_loop(x86model::Loop loop);
std::optional<x86model::Loop> loop_named(std::string_view name);

/// The offset of a program's machine code in its segment: above all memory that x86model/call.hpp
/// writes, and at the start of a page.
inline constexpr std::uint16_t code_origin = x86model::code_address;

}  // namespace fixproof::machine_code
