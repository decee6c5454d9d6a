#include "verify/machine_code/machine_code.hpp"

#include <algorithm>

#include "verify/machine_code/table.hpp"

namespace fixproof::machine_code {

namespace {

const Assembled* find(const std::string& name) {
  const auto all = assembled_programs();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Assembled& a) { return a.name == name; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace

std::span<const std::uint8_t> machine_code(const ProgramKey& key) {
  const Assembled* found = find(name_of(key));
  return found == nullptr ? std::span<const std::uint8_t>{} : found->code;
}

std::span<const std::uint8_t> machine_code(const x86model::LoopForm& form) {
  const Assembled* found = find(name_of(form));
  return found == nullptr ? std::span<const std::uint8_t>{} : found->code;
}

std::span<const std::uint8_t> dos_command(const ProgramKey& key) {
  const Assembled* found = find(name_of(key));
  return found == nullptr ? std::span<const std::uint8_t>{} : found->command;
}

std::string machine_code_absence() {
  return assembled_programs().empty() ? "this fixproof was built without NASM" : "";
}

ProgramKey key_of(const cases::Variant& variant) {
  // The first five operations are the model's routines, in the same order.
  static_assert(static_cast<int>(cases::Operation::concat) ==
                static_cast<int>(x86model::Routine::concat));
  return {static_cast<x86model::Routine>(variant.operation), model_target(variant.build.target),
          model_build(variant.build)};
}

}  // namespace fixproof::machine_code
