#include "verify/machine_code/programs.hpp"

#include <array>
#include <string_view>

#include "x86model/text.hpp"

namespace fixproof::machine_code {

namespace {

using x86model::Routine;
using x86model::Target;

constexpr std::array<std::string_view, x86model::routine_count> names{"mul", "div", "cossin",
                                                                      "xformvec", "concat"};

}  // namespace

std::vector<ProgramKey> all_programs() {
  using enum Routine;
  std::vector<ProgramKey> all;
  for (const Routine routine : {mul, div, cossin, xformvec, concat}) {
    for (const Target target : {Target::i386, Target::i8088}) {
      for (const bool round : {true, false}) {
        // CosSin neither multiplies nor divides.
        if (routine == cossin && !round) continue;
        all.push_back({routine, target, {.mul_rounding = round, .div_rounding = round}});
        if (target != Target::i8088 || (routine != div && routine != concat)) continue;
        all.push_back(all.back());
        bool x86model::Build::*const other =
            routine == div ? &x86model::Build::endif_as_scanned : &x86model::Build::repaired;
        all.back().build.*other = true;
      }
    }
    if (routine == mul || routine == div || routine == concat) {
      all.push_back({routine, Target::i386, {.chapter_52 = true}});
    }
  }
  return all;
}

std::string name_of(const ProgramKey& key) {
  std::string name(names.at(static_cast<std::size_t>(key.routine)));
  name += key.target == Target::i386 ? "-i386" : "-i8088";
  const bool round = key.routine == Routine::div ? key.build.div_rounding : key.build.mul_rounding;
  if (key.routine != Routine::cossin) name += round ? "-on" : "-off";
  if (key.build.chapter_52) name += "-ch52";
  if (key.build.endif_as_scanned) name += "-scanned";
  if (key.build.shl_as_printed) name += "-printed";
  if (key.build.repaired) name += "-repaired";
  return name;
}

std::string name_of(const x86model::LoopForm& form) {
  std::string name(name_of_loop(form.loop));
  name += form.target == Target::i386 ? "-i386-" : "-i8088-";
  name += x86model::name_of(form.counting);
  return name + (form.as_printed ? "-printed" : "");
}

std::string_view name_of_loop(x86model::Loop loop) {
  constexpr std::array<std::string_view, x86model::loop_count> loops{"gouraud-byte", "gouraud-word",
                                                                     "depth", "texture"};
  return loops.at(static_cast<std::size_t>(loop));
}

std::optional<x86model::Loop> loop_named(std::string_view name) {
  for (int i = 0; i < x86model::loop_count; ++i) {
    const auto loop = static_cast<x86model::Loop>(i);
    if (name_of_loop(loop) == name) return loop;
  }
  return std::nullopt;
}

}  // namespace fixproof::machine_code
