/// @file
/// Parties with one deliberate error, and plans that are small enough to run often.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "verify/cases/plan.hpp"
#include "verify/engine.hpp"
#include "verify/parties/party.hpp"

namespace fixproof::test {

/// Answers like another party, then applies `spoil` to each case.
class Saboteur final : public parties::Party {
 public:
  /// Takes the operands of a case, and the result words and the ending that it may change.
  using Spoil = std::function<void(std::span<const std::uint32_t>, std::span<std::uint32_t>,
                                   parties::Ending&)>;

  Saboteur(std::string name, const parties::Party& honest, Spoil spoil)
      : name_(std::move(name)), honest_(honest), spoil_(std::move(spoil)) {}

  [[nodiscard]] std::string_view name() const override { return name_; }
  [[nodiscard]] std::string identity() const override { return "a saboteur"; }
  [[nodiscard]] bool answers(const cases::Variant& variant) const override {
    return honest_.answers(variant);
  }
  void fill(const cases::Variant& variant, const parties::Cases& asked) const override {
    honest_.answer(variant, asked);
    const std::size_t in = cases::words_in(variant);
    const std::size_t out = cases::words_out(variant);
    for (std::size_t i = 0; i < asked.endings.size(); ++i) {
      spoil_(asked.in.subspan(i * in, in), asked.out.subspan(i * out, out), asked.endings[i]);
    }
  }

 private:
  std::string name_;
  const parties::Party& honest_;
  Spoil spoil_;
};

inline Saboteur saboteur(Saboteur::Spoil spoil) {
  return {"saboteur", parties::party_named("fast"), std::move(spoil)};
}

/// A level 1 plan of one variant that judges the saboteur against the correct fast oracle.
inline cases::Plan plan_against_fast(const cases::Variant& variant, std::uint64_t seed = 1) {
  return {1, seed, {{variant, {"saboteur", "fast"}}}};
}

inline verify::Report judge(const Saboteur& liar, const cases::Variant& variant,
                            const verify::RunOptions& options = {}) {
  const std::array<const parties::Party*, 2> both{&liar, &parties::party_named("fast")};
  return verify::run(plan_against_fast(variant), both, options);
}

}  // namespace fixproof::test
