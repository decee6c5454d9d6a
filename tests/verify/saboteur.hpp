/// @file
/// Parties that lie in one way, and plans small enough to run many of.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "verify/engine.hpp"
#include "verify/party.hpp"
#include "verify/plan.hpp"

namespace fixproof::test {

/// Answers as another party does, then spoils each case as it is told.
class Saboteur final : public Party {
 public:
  /// Gets the operands of a case, and its result words and ending to change.
  using Spoil =
      std::function<void(std::span<const std::uint32_t>, std::span<std::uint32_t>, Ending&)>;

  Saboteur(std::string name, const Party& honest, Spoil spoil)
      : name_(std::move(name)), honest_(honest), spoil_(std::move(spoil)) {}

  [[nodiscard]] std::string_view name() const override { return name_; }
  [[nodiscard]] bool answers(const Variant& variant) const override {
    return honest_.answers(variant);
  }
  void answer(const Variant& variant, const Batch& batch) const override {
    honest_.answer(variant, batch);
    const std::size_t in = words_in(variant.operation);
    const std::size_t out = words_out(variant.operation);
    for (std::size_t i = 0; i < batch.endings.size(); ++i) {
      spoil_(batch.in.subspan(i * in, in), batch.out.subspan(i * out, out), batch.endings[i]);
    }
  }

 private:
  std::string name_;
  const Party& honest_;
  Spoil spoil_;
};

/// The fast oracle under the name `saboteur`, spoilt.
inline Saboteur saboteur(Saboteur::Spoil spoil) {
  return {"saboteur", party_named("fast"), std::move(spoil)};
}

/// A plan of level 1 of one variant, the saboteur judged against the honest fast oracle.
inline Plan plan_against_fast(const Variant& variant, std::uint64_t seed = 1) {
  return {1, seed, {{variant, {"saboteur", "fast"}}}};
}

/// Runs that plan.
inline Report judge(const Saboteur& liar, const Variant& variant, const RunOptions& options = {}) {
  const std::array<const Party*, 2> both{&liar, &party_named("fast")};
  return run(plan_against_fast(variant), both, options);
}

}  // namespace fixproof::test
