// Tests that JSON reports are read back completely, resumed at any chunk, and rejected when
// damaged.
#include <atomic>
#include <chrono>
#include <filesystem>

#include "cases/draw.hpp"
#include "cases/plan.hpp"
#include "support/file.hpp"
#include "tests/support/test.hpp"
#include "tests/verify/saboteur.hpp"
#include "verify/report_file.hpp"
#include "verify/report_json.hpp"

namespace fixproof {
namespace {

using Words = std::span<const std::uint32_t>;

constexpr cases::Variant mul{.operation = cases::Operation::mul};
constexpr cases::Variant div{.operation = cases::Operation::div,
                             .build = {.target = cases::Target::i8088, .div_round = false}};
constexpr cases::Variant cossin{.operation = cases::Operation::cossin};

/// Wraps a party and sets a flag after a number of batches.
class Counting final : public parties::Party {
 public:
  Counting(const parties::Party& party, std::uint64_t batches, std::atomic<bool>& stop)
      : party_(party), batches_(batches), stop_(stop) {}
  [[nodiscard]] std::string_view name() const override { return party_.name(); }
  [[nodiscard]] bool answers(const cases::Variant& v) const override { return party_.answers(v); }
  void answer(const cases::Variant& v, const parties::Batch& batch) const override {
    if (batches_-- == 1) stop_ = true;
    party_.answer(v, batch);
  }

 private:
  const parties::Party& party_;
  mutable std::atomic<std::uint64_t> batches_;
  std::atomic<bool>& stop_;
};

const test::Saboteur& liar() {
  static const auto one =
      test::saboteur([](Words in, std::span<std::uint32_t> out, parties::Ending&) {
        if ((in[0] & 0x1fU) == 0x15U) out[0] ^= 0x100U;
      });
  return one;
}

std::array<const parties::Party*, 2> both() { return {&liar(), &parties::party_named("fast")}; }

/// Several rows with a wrong party, except for one row that has nothing to compare.
verify::Report fresh(cases::Shard shard = {}) {
  return {
      cases::Plan(
          1, 5, {{mul, {"saboteur", "fast"}}, {cossin, {"saboteur"}}, {div, {"saboteur", "fast"}}}),
      shard, 3};
}

verify::Report finished(cases::Shard shard = {}) {
  verify::Report report = fresh(shard);
  verify::run(report, both());
  report.seconds = 0;
  return report;
}

TEST(Reports, AreReadBackAsTheyWere) {
  for (const cases::Shard shard :
       {cases::Shard{1, 1}, cases::Shard{2, 3}, cases::Shard{5, 100000}}) {
    const std::string text = verify::to_json(finished(shard));
    EXPECT_EQ(verify::to_json(verify::from_json(text)), text);
  }
  const verify::Report report = verify::from_json(verify::to_json(finished()));
  EXPECT_TRUE(report.complete());
  EXPECT_GT(report.mismatches(), 0U);
  EXPECT_GT(report.findings[2].faults, 0U);
  EXPECT_FALSE(report.findings[0].shown[0].said.empty());
}

TEST(Reports, GoOnAfterInterruptionsAsIfThereHadBeenNone) {
  const std::string whole = verify::to_json(finished());
  for (std::uint64_t round = 0; round < 20; ++round) {
    verify::Report report = fresh();
    int stops = 0;
    for (; !report.complete(); ++stops) {
      ASSERT_LT(stops, 1000);
      // Stops at an arbitrary chunk, as Ctrl-C would.
      std::atomic<bool> stop = false;
      const std::uint64_t batches =
          60 + cases::mix(100 * round + static_cast<std::uint64_t>(stops)) % 500;
      const Counting counting(liar(), batches, stop);
      const std::array<const parties::Party*, 2> two{&counting, &parties::party_named("fast")};
      verify::run(report, two, {.threads = 2, .stop = &stop});
      report = verify::from_json(verify::to_json(report));
    }
    report.seconds = 0;
    EXPECT_GT(stops, 1);
    EXPECT_EQ(verify::to_json(report), whole);
  }
}

TEST(Reports, ObservedStatesAreConsistent) {
  verify::Report report = fresh();
  int seen = 0;
  verify::run(report, both(),
              {.observe =
                   [&](const verify::Report& state) {
                     ++seen;
                     EXPECT_NO_THROW(verify::from_json(verify::to_json(state)));
                   },
               .observe_every = std::chrono::milliseconds(1)});
  EXPECT_GT(seen, 0);
}

TEST(Reports, NoCutTextIsRead) {
  const std::string text = verify::to_json(finished());
  for (std::size_t size = 0; size + 2 < text.size(); size += 1 + size / 20) {
    EXPECT_THROW(verify::from_json(text.substr(0, size)), std::runtime_error) << size;
  }
}

TEST(Reports, DamageIsFound) {
  const std::string good = verify::to_json(finished());
  const auto refused = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    const auto place = text.find(from);
    ASSERT_NE(place, std::string::npos) << from;
    text.replace(place, from.size(), to);
    EXPECT_THROW(verify::from_json(text), std::runtime_error) << from << " -> " << to;
  };
  refused("fixproof report", "another report");
  refused(R"("version": 2)", R"("version": 1)");
  refused(R"("level": 1)", R"("level": 2)");
  refused(R"("level": 1)", R"("level": "one")");
  refused(R"("seed": "5")", R"("seed": "five")");
  refused(R"("mul")", R"("mull")");
  refused(R"("i386")", R"("i486")");
  refused(R"("faults": 0)", R"("faults": -1)");
  refused(R"("cases": )", R"("cases": 1)");
  refused(R"("mismatches": )", R"("mismatches": 1)");
  refused(R"("complete": true)", R"("complete": false)");
  refused(R"("operation")", R"("operations")");
  for (const char* text : {"[]", "1", "null", "{}", R"({"format": 1})", R"("fixproof report")"}) {
    EXPECT_THROW(verify::from_json(text), std::runtime_error) << text;
  }
}

TEST(Reports, ChunksDoneMustFitTheCounts) {
  verify::Report report = finished();
  report.done[3] = false;
  EXPECT_THROW(verify::from_json(verify::to_json(report)), std::runtime_error);
  report = finished();
  ++report.findings[0].cases;
  EXPECT_THROW(verify::from_json(verify::to_json(report)), std::runtime_error);
  report = finished();
  report.findings[0].shown.pop_back();
  EXPECT_THROW(verify::from_json(verify::to_json(report)), std::runtime_error);
}

TEST(Reports, DifferencesAreNamed) {
  const verify::Report report = finished();
  EXPECT_EQ(verify::difference(report, fresh()), "");
  const verify::Report other_seed(cases::Plan(1, 6, report.plan.rows()), cases::Shard{}, 3);
  EXPECT_EQ(verify::difference(report, other_seed), "seed 5, not 6");
  const verify::Report other_level(cases::Plan(2, 5, report.plan.rows()), cases::Shard{}, 3);
  EXPECT_EQ(verify::difference(report, other_level), "level 1, not 2");
  auto rows = report.plan.rows();
  rows[0].parties = {"model", "fast"};
  EXPECT_EQ(verify::difference(report, verify::Report(cases::Plan(1, 5, rows), cases::Shard{}, 3)),
            "row 1 compares saboteur fast, not model fast");
  rows = report.plan.rows();
  rows[2].variant.build.div_round = true;
  EXPECT_EQ(verify::difference(report, verify::Report(cases::Plan(1, 5, rows), cases::Shard{}, 3)),
            "row 3 has another variant");
}

TEST(Reports, WithARowThatNobodyComparesAreNotRead) {
  const std::string file = testing::TempDir() + "fixproof_report_test.json";
  const auto read = [&](std::vector<std::string> parties) {
    const cases::Plan plan(1, 5, {{mul, {"model", "fast"}}, {cossin, std::move(parties)}});
    support::replace_file(file, verify::to_json(verify::Report(plan, cases::Shard{}, 3)));
    try {
      return "read " + std::to_string(verify::read_report(file).plan.rows().size());
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
  };
  EXPECT_EQ(read({"model", "oracle"}), "read 2");
  EXPECT_EQ(read({"oracle"}), file + ": cossin i386 on is not compared");
  EXPECT_EQ(read({}), file + ": cossin i386 on is not compared");
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace fixproof
