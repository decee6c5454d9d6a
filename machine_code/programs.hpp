/// @file
/// Which programs are assembled to machine code, and what each is called.
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

/// One program of the model.
struct ProgramKey {
  x86model::Routine routine = x86model::Routine::mul;
  x86model::Target target = x86model::Target::i386;
  x86model::Build build;
};

/// One key for every program there is: each routine on each processor under each setting of the
/// switch that matters to it, the forms of chapter 52, the 8088 divide as it was scanned, and the
/// 8088 ConcatXforms repaired.
std::vector<ProgramKey> all_programs();

/// The program's name, such as mul-i386-on or div-i8088-off-scanned. Two keys have one name where
/// they assemble to one program: only the switch that matters to the routine is in it.
std::string name_of(const ProgramKey& key);

/// The name of a form of an inner loop, such as gouraud-byte-i386-dec-jnz; one as printed ends in
/// -printed.
std::string name_of(const x86model::LoopForm& form);

/// The loop's name on the command line and in that name: gouraud-byte, gouraud-word, depth,
/// texture.
std::string_view name_of_loop(x86model::Loop loop);
/// The loop of that name; nothing for any other name.
std::optional<x86model::Loop> loop_named(std::string_view name);

/// Where the machine code of a program begins in its segment: above all that x86model/call.hpp
/// puts into memory, and on a page of its own.
inline constexpr std::uint16_t code_origin = x86model::code_address;

}  // namespace fixproof::machine_code
