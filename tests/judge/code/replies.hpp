/// @file
/// A server of judge::Runner that says what a test wants.
#pragma once

#include <cstring>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "judge/code/runner.hpp"

namespace replies {

using namespace fixproof;

/// The bytes of all values.
template <class T>
std::string bytes_of_all(const std::vector<T>& values) {
  std::string bytes(values.size() * sizeof(T), '\0');
  if (!values.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
  return bytes;
}
inline std::string bytes_of(const std::vector<judge::Answer>& answers) {
  return bytes_of_all(answers);
}

/// A multiply. Only its number of operands matters here.
inline judge::Subject subject() {
  return {.image = {},
          .frame = {},
          .variant = {.operation = cases::Operation::mul, .format = cases::q16_16}};
}

class Fake final : public judge::Server {
 public:
  struct Said {
    judge::Downfall downfall = judge::Downfall::none;
    std::string bytes{};
    std::uint64_t steps = 0;
  };
  /// What it says to a request of some cases.
  using Act = std::function<Said(std::size_t cases)>;

  explicit Fake(Act act) : act_(std::move(act)) {}

  static Said answers(std::size_t count) {
    return {.bytes = bytes_of(std::vector<judge::Answer>(count))};
  }

  judge::Reply ask(std::string_view request, const judge::Allowance&) override {
    const auto operands = words_in(subject().variant);
    Said said = act_(request.size() / sizeof(std::uint32_t) / operands);
    steps_ = said.steps;
    is_alive_ = said.downfall == judge::Downfall::none;
    return {said.downfall, is_alive_ ? said.bytes : ""};
  }
  [[nodiscard]] bool is_alive() const override { return is_alive_; }
  [[nodiscard]] std::uint64_t steps() const override { return steps_; }

 private:
  Act act_;
  bool is_alive_ = true;
  std::uint64_t steps_ = 0;
};

}  // namespace replies
