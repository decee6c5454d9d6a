// Tests what the panel finds about a party with a planted defect.
#include "fuzz/panel.hpp"

#include "fuzz/finding.hpp"
#include "fuzz/type_rules.hpp"
#include "fuzz/word_target.hpp"
#include "tests/support/test.hpp"
#include "tests/verify/engine/saboteur.hpp"

namespace {

using namespace fixproof;

constexpr cases::Variant div_i8088{.operation = cases::Operation::div,
                                   .build = {.target = cases::Target::i8088}};

/// Divides as the fast oracle does, except for exact ties of the 8088's divide.
test::Saboteur lost_tie() {
  return test::saboteur([](auto in, auto out, parties::Ending& ending) {
    const std::uint32_t whole = in[1] >> 16U;
    const bool positive = in[0] < 0x80000000U && in[1] < 0x80000000U;
    if (ending == parties::Ending::value && positive && in[0] % whole * 2 == whole) --out[0];
  });
}

TEST(Panel, SaysWhatDiffersAndHowToSeeItAgain) {
  const auto liar = lost_tie();
  const fuzz::VariantParties tested{div_i8088, {&parties::party_named("oracle"), &liar}};
  const std::array<std::uint32_t, 2> words{0x0005A5A5, 0x0002FFFF};
  const auto found = fuzz::disagreement(tested, words);
  ASSERT_TRUE(found);
  // 1 / 2, the smallest tie: half a unit, which rounds away from zero.
  EXPECT_NE(found->find("oracle         00000001"), std::string::npos) << *found;
  EXPECT_NE(found->find("saboteur       00000000"), std::string::npos) << *found;
  EXPECT_NE(found->find("fixproof verify div --target i8088 --round on --chapter 54 "
                        "--case '00000001 00020000' --by oracle --against saboteur"),
            std::string::npos)
      << *found;
  EXPECT_NE(found->find("found with  0005a5a5 0002ffff"), std::string::npos) << *found;
}

TEST(Panel, HasNothingToSayWhereAllAgree) {
  const auto liar = lost_tie();
  const fuzz::VariantParties tested{div_i8088, {&parties::party_named("oracle"), &liar}};
  EXPECT_FALSE(fuzz::disagreement(tested, std::array<std::uint32_t, 2>{0x0005A5A4, 0x0002FFFF}));
  // #DE is an answer.
  EXPECT_FALSE(fuzz::disagreement(tested, std::array<std::uint32_t, 2>{1, 0xFFFF}));
  for (const auto target : {fuzz::WordTarget::divide, fuzz::WordTarget::multiply}) {
    EXPECT_FALSE(fuzz::disagreement(fuzz::parties_by_variant(target),
                                    std::array<std::uint32_t, 2>{0x80000000, 0xFFFFFFFF}));
  }
}

TEST(Panel, HearsEveryVariantAtBothWidths) {
  const auto& by_variant = fuzz::parties_by_variant(fuzz::WordTarget::divide);
  // Two processors, rounded or not; chapter 52; the standard rules. All but chapter 52 also in 8.8.
  EXPECT_EQ(by_variant.size(), 11U);
  EXPECT_EQ(std::count_if(by_variant.begin(), by_variant.end(),
                          [](const auto& tested) { return tested.variant.format == cases::q8_8; }),
            5);
  for (const auto& tested : by_variant) EXPECT_EQ(tested.parties.front()->name(), "oracle");
  const auto& all = fuzz::parties_by_variant(fuzz::WordTarget::agreement);
  // The first byte of each input in fuzz/regressions/agreement depends on this number: the five
  // routines and their 8.8 forms, chapter 52, the repaired ConcatXforms, the standard rules.
  EXPECT_EQ(all.size(), 8U + 8U + 4U + 4U + 4U + 3U + 2U + 2U + 2U + 7U);
  for (const auto& variant : cases::all_variants()) {
    EXPECT_TRUE(std::any_of(all.begin(), all.end(), [&](const auto& tested) {
      return tested.variant == variant;
    })) << cases::name_of(variant.operation);
  }
  const auto heard = [&](std::string_view name) {
    return std::any_of(all.begin(), all.end(), [&](const auto& tested) {
      return std::any_of(tested.parties.begin(), tested.parties.end(),
                         [&](const parties::Party* party) { return party->name() == name; });
    });
  };
  for (const auto& party : parties::parties()) {
    if (party->name() == "unicorn") continue;
    EXPECT_EQ(heard(party->name()), party->absence().empty()) << party->name();
  }
}

TEST(TypeRules, HoldOnTheEdges) {
  constexpr auto edges =
      std::to_array<std::uint32_t>({0, 1, 0x7FFF, 0x8000, 0xFFFF, 0x10000, 0x7FFFFFFF, 0x80000000,
                                    0xFFFF0000, 0xFFFF8000, 0xFFFFFFFF, 0x7FF80000, 0xFFF00000});
  for (const auto a : edges) {
    for (const auto b : edges) {
      EXPECT_EQ(fuzz::quotient_difference(a, b).value_or(""), "");
      for (std::uint32_t c = 0; c < 9; ++c) {
        EXPECT_EQ(fuzz::type_difference(std::array<std::uint32_t, 3>{a, b, c}).value_or(""), "");
        EXPECT_EQ(
            fuzz::type_difference(std::array<std::uint32_t, 3>{a, b, 0xFFFFFFF7U - c}).value_or(""),
            "");
      }
    }
  }
}

TEST(Finding, Aborts) {
  EXPECT_DEATH(fuzz::report_finding("of this"), "FINDING: of this");
  fuzz::report_if_any(std::nullopt);
}

}  // namespace
