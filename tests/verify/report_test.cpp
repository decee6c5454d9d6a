// Reports in JSON: read back whole, resumed at any chunk, refused when damaged.
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "tests/verify/saboteur.hpp"
#include "verify/draw.hpp"
#include "verify/file.hpp"
#include "verify/report_file.hpp"
#include "verify/report_json.hpp"

namespace fixproof {
namespace {

using Words = std::span<const std::uint32_t>;

constexpr Variant mul{.operation = Operation::mul};
constexpr Variant div{.operation = Operation::div, .target = Target::i8088, .div_round = false};
constexpr Variant cossin{.operation = Operation::cossin};

/// Another party that sets a flag after so many batches.
class Counting final : public Party {
 public:
  Counting(const Party& party, std::uint64_t batches, std::atomic<bool>& stop)
      : party_(party), batches_(batches), stop_(stop) {}
  [[nodiscard]] std::string_view name() const override { return party_.name(); }
  [[nodiscard]] bool answers(const Variant& v) const override { return party_.answers(v); }
  void answer(const Variant& v, const Batch& batch) const override {
    if (batches_-- == 1) stop_ = true;
    party_.answer(v, batch);
  }

 private:
  const Party& party_;
  mutable std::atomic<std::uint64_t> batches_;
  std::atomic<bool>& stop_;
};

const test::Saboteur& liar() {
  static const auto one = test::saboteur([](Words in, std::span<std::uint32_t> out, Ending&) {
    if ((in[0] & 0x1fU) == 0x15U) out[0] ^= 0x100U;
  });
  return one;
}

std::array<const Party*, 2> both() { return {&liar(), &party_named("fast")}; }

/// Several rows, one of which nobody compares, with a liar in the others.
Report fresh(Shard shard = {}) {
  return {Plan(1, 5,
               {{mul, {"saboteur", "fast"}}, {cossin, {"saboteur"}}, {div, {"saboteur", "fast"}}}),
          shard, 3};
}

Report finished(Shard shard = {}) {
  Report report = fresh(shard);
  run(report, both());
  report.seconds = 0;
  return report;
}

TEST(Reports, AreReadBackAsTheyWere) {
  for (const Shard shard : {Shard{1, 1}, Shard{2, 3}, Shard{5, 100000}}) {
    const std::string text = to_json(finished(shard));
    EXPECT_EQ(to_json(from_json(text)), text);
  }
  const Report report = from_json(to_json(finished()));
  EXPECT_TRUE(report.complete());
  EXPECT_GT(report.mismatches(), 0U);
  EXPECT_GT(report.findings[2].faults, 0U);
  EXPECT_FALSE(report.findings[0].shown[0].said.empty());
}

TEST(Reports, GoOnAfterInterruptionsAsIfThereHadBeenNone) {
  const std::string whole = to_json(finished());
  for (std::uint64_t round = 0; round < 20; ++round) {
    Report report = fresh();
    int stops = 0;
    for (; !report.complete(); ++stops) {
      ASSERT_LT(stops, 1000);
      // Stops by itself at some chunk, as Ctrl-C would.
      std::atomic<bool> stop = false;
      const std::uint64_t batches = 60 + mix(100 * round + static_cast<std::uint64_t>(stops)) % 500;
      const Counting counting(liar(), batches, stop);
      const std::array<const Party*, 2> two{&counting, &party_named("fast")};
      run(report, two, {.threads = 2, .stop = &stop});
      report = from_json(to_json(report));
    }
    report.seconds = 0;
    EXPECT_GT(stops, 1);
    EXPECT_EQ(to_json(report), whole);
  }
}

TEST(Reports, ObservedStatesAreConsistent) {
  Report report = fresh();
  int seen = 0;
  run(report, both(),
      {.observe =
           [&](const Report& state) {
             ++seen;
             EXPECT_NO_THROW(from_json(to_json(state)));
           },
       .observe_every = std::chrono::milliseconds(1)});
  EXPECT_GT(seen, 0);
}

TEST(Reports, NoCutTextIsRead) {
  const std::string text = to_json(finished());
  for (std::size_t size = 0; size + 2 < text.size(); size += 1 + size / 20) {
    EXPECT_THROW(from_json(text.substr(0, size)), std::runtime_error) << size;
  }
}

TEST(Reports, DamageIsFound) {
  const std::string good = to_json(finished());
  const auto refused = [&](const std::string& from, const std::string& to) {
    std::string text = good;
    const auto place = text.find(from);
    ASSERT_NE(place, std::string::npos) << from;
    text.replace(place, from.size(), to);
    EXPECT_THROW(from_json(text), std::runtime_error) << from << " -> " << to;
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
    EXPECT_THROW(from_json(text), std::runtime_error) << text;
  }
}

TEST(Reports, ChunksDoneMustFitTheCounts) {
  Report report = finished();
  report.done[3] = false;
  EXPECT_THROW(from_json(to_json(report)), std::runtime_error);
  report = finished();
  ++report.findings[0].cases;
  EXPECT_THROW(from_json(to_json(report)), std::runtime_error);
  report = finished();
  report.findings[0].shown.pop_back();
  EXPECT_THROW(from_json(to_json(report)), std::runtime_error);
}

TEST(Reports, DifferencesAreNamed) {
  const Report report = finished();
  EXPECT_EQ(difference(report, fresh()), "");
  const Report other_seed(Plan(1, 6, report.plan.rows()), Shard{}, 3);
  EXPECT_EQ(difference(report, other_seed), "seed 5, not 6");
  const Report other_level(Plan(2, 5, report.plan.rows()), Shard{}, 3);
  EXPECT_EQ(difference(report, other_level), "level 1, not 2");
  auto rows = report.plan.rows();
  rows[0].parties = {"model", "fast"};
  EXPECT_EQ(difference(report, Report(Plan(1, 5, rows), Shard{}, 3)),
            "row 1 compares saboteur fast, not model fast");
  rows = report.plan.rows();
  rows[2].variant.div_round = true;
  EXPECT_EQ(difference(report, Report(Plan(1, 5, rows), Shard{}, 3)), "another variant in row 3");
}

TEST(Reports, WithARowThatNobodyComparesAreNotRead) {
  const std::string file = testing::TempDir() + "fixproof_report_test.json";
  const auto read = [&](std::vector<std::string> parties) {
    const Plan plan(1, 5, {{mul, {"model", "fast"}}, {cossin, std::move(parties)}});
    replace_file(file, to_json(Report(plan, Shard{}, 3)));
    try {
      return "read " + std::to_string(read_report(file).plan.rows().size());
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
