#include "measure/player/model_call.hpp"

#include <stdexcept>

#include "verify/parties/parties.hpp"

namespace fixproof::player {

namespace {

// NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables): see Recording
thread_local OperandLog* log_of_thread = nullptr;
// NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables): see InBuild
thread_local const InBuild* build_of_thread = nullptr;

}  // namespace

InBuild::InBuild(const cases::Build& build) : build_(build), outer_(build_of_thread) {
  build_of_thread = this;
}

InBuild::~InBuild() { build_of_thread = outer_; }

const cases::Build& InBuild::current() {
  if (build_of_thread == nullptr) throw std::logic_error("a ModelNumber outside a build");
  return build_of_thread->build_;
}

Recording::Recording(OperandLog& log) {
  if (log_of_thread != nullptr) throw std::logic_error("two recordings on one thread");
  log_of_thread = &log;
}

Recording::~Recording() { log_of_thread = nullptr; }

bool call_model(const cases::Variant& variant, std::span<const std::uint32_t> in,
                std::span<std::uint32_t> out) {
  static const std::unique_ptr<parties::Party> model = parties::make_model();
  if (log_of_thread != nullptr) {
    auto& words = log_of_thread->at(static_cast<std::size_t>(variant.operation));
    words.insert(words.end(), in.begin(), in.end());
  }
  std::array<parties::Ending, 1> ending{};
  model->answer(variant, {in, out, ending});
  if (ending[0] == parties::Ending::value) return true;
  if (ending[0] == parties::Ending::divide_error) return false;
  throw std::logic_error("a listing did not end");
}

}  // namespace fixproof::player
