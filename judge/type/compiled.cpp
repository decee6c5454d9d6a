#include "judge/type/compiled.hpp"

#include <fmt/format.h>

#include <chrono>

#include "judge/code/compiler.hpp"
#include "support/bounded_file.hpp"

namespace fixproof::judge {

namespace {

/// All goals take some 10 s.
constexpr std::chrono::minutes most_time{10};
constexpr std::size_t most_bytes = std::size_t{16} << 20U;

}  // namespace

std::string compiled(const Compilation& how, std::span<const Goal> goals) {
  const TemporaryFolder folder;
  const std::string object = folder.file("type.o");
  // Freestanding, an error is UD2 and no code of the C++ library. The arithmetic is the same.
  run_compiler({how.compiler, "-std=c++20", "-ffreestanding", "-fno-exceptions", how.level, "-I",
                how.headers, "-c", "-x", "c++", "-", "-o", object},
               source_of(goals), most_time);
  return support::read_bounded(object, most_bytes);
}

std::string version_of(const std::string& compiler) {
  const std::string text = run_compiler({compiler, "--version"}, "", most_time).out;
  return text.substr(0, text.find('\n'));
}

}  // namespace fixproof::judge
