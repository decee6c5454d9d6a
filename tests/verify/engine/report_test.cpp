// Tests that JSON reports are read back completely, resumed at any chunk, and rejected when
// damaged.
#include <atomic>
#include <chrono>
#include <filesystem>

#include "support/build_info/build_info.hpp"
#include "support/file.hpp"
#include "support/sha256.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/test.hpp"
#include "tests/verify/engine/saboteur.hpp"
#include "tests/verify/engine/sealed.hpp"
#include "verify/cases/draw.hpp"
#include "verify/cases/plan.hpp"
#include "verify/recheck.hpp"
#include "verify/report_file.hpp"
#include "verify/report_json.hpp"

namespace fixproof {
namespace report_test {

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
  [[nodiscard]] std::string identity() const override { return party_.identity(); }
  [[nodiscard]] bool answers(const cases::Variant& v) const override { return party_.answers(v); }
  void fill(const cases::Variant& v, const parties::Cases& asked) const override {
    if (batches_-- == 1) stop_ = true;
    party_.answer(v, asked);
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

/// Why the text is refused; empty if it is read.
std::string reason(const std::string& text) {
  try {
    verify::from_json(text);
    return "";
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto place = text.find(from);
  if (place == std::string::npos) throw std::logic_error("no " + from);
  return text.replace(place, from.size(), to);
}

TEST(Reports, EveryFlippedBitIsFound) {
  verify::Report one_chunk(cases::Plan(1, 5, {{div, {"saboteur", "fast"}}}), {1, 1000}, 1);
  verify::run(one_chunk, both());
  const std::string good = verify::to_json(one_chunk);
  ASSERT_EQ(reason(good), "");
  for (std::size_t place = 0; place < good.size(); ++place) {
    for (unsigned bit = 0; bit < 8; ++bit) {
      std::string text = good;
      text[place] = static_cast<char>(static_cast<unsigned char>(text[place]) ^ (1U << bit));
      ASSERT_NE(reason(text), "") << "bit " << bit << " of byte " << place << "\n" << text;
    }
  }
}

TEST(Reports, AnEditWithoutANewDigestIsNamed) {
  const std::string good = verify::to_json(finished());
  for (const auto& [from, to] : {std::pair{R"("faults": )", R"("faults": 1)"},
                                 {R"("seconds": 0.0)", R"("seconds": 1.0)"},
                                 {R"("version": 3)", R"("version": 2)"},
                                 {R"("compiler": ")", R"("compiler": "x)"}}) {
    EXPECT_NE(reason(replaced(good, from, to)).find("the digest at its end"), std::string::npos)
        << from;
  }
}

/// Here the forger computed the digest again.
TEST(Reports, AContradictionIsFoundUnderARightDigest) {
  const std::string good = verify::to_json(finished());
  const auto refused = [&](const std::string& from, const std::string& to,
                           const std::string& wanted) {
    const std::string text = test::sealed(replaced(good, from, to));
    EXPECT_NE(reason(text).find(wanted), std::string::npos) << to << ": " << reason(text);
  };
  refused("fixproof report", "another report", "not a report of fixproof");
  refused(R"("level": 1)", R"("level": 2)", "other cases");
  refused(R"("level": 1)", R"("level": 4)", "no level 4");
  refused(R"("level": 1)", R"("level": 1.9)", "1.9 is not a count");
  refused(R"("level": 1)", R"("level": 1.0)", "1.0 is not a count");
  refused(R"("level": 1)", R"("level": "one")", R"("one" is not a count)");
  refused(R"("level": 1)", R"("level": 2, "level": 1)", R"(the key "level" occurs twice)");
  refused(R"("level": 1)", R"("level": 1, "note": 1)", "other keys");
  refused(R"("level": 1)", R"("level":  1)", "other keys or spaces");
  refused(R"("version": 3)", R"("version": 3.5)", "3.5 is not a count");
  refused(R"("version": 3)", R"("version": 4)", "fixproof 1.0.0 wrote");
  refused(R"("chapter": 54)", R"("chapter": 54.5)", "54.5");
  refused(R"("seed": "5")", R"("seed": "five")", "'five' is not a seed");
  refused(R"("mul")", R"("mull")", "mull");
  refused(R"("i386")", R"("i486")", "i486");
  refused(R"("faults": 0)", R"("faults": -1)", "-1 is not a count");
  refused(R"("faults": 0)", R"("faults": 1)", "the counts of row 1");
  refused(R"("cases": )", R"("cases": 1)", "totals");
  refused(R"("mismatches": )", R"("mismatches": 1)", "totals");
  refused(R"("complete": true)", R"("complete": false)", "totals");
  refused(R"("operation")", R"("operations")", "operation");
  refused(R"("saboteur": "a saboteur")", R"("liar": "a saboteur")", "the parties of the rows");
  refused(R"("chunks": [)", R"("chunks": ["0 0 0000000000000000",)", "results");
  refused(R"("chunks": [)", R"("chunks": [7,)", "results");
  for (const char* text : {"[]", "1", "null", "{}", R"({"format": 1})", R"("fixproof report")"}) {
    EXPECT_THROW(verify::from_json(text), std::runtime_error) << text;
  }
}

TEST(Reports, NothingFollowsThem) {
  const std::string good = verify::to_json(finished({1, 20}));
  for (const char* more : {" ", "\n", "x", "{}"}) EXPECT_NE(reason(good + more), "");
  EXPECT_EQ(reason(good + '\0'), "not JSON: a zero byte");
}

TEST(Reports, OldOnesAreRefusedWithWhatToDo) {
  std::string old = verify::to_json(finished());
  old = replaced(old.substr(0, old.rfind(",\n \"digest\"")) + "\n}\n", R"("version": 3)",
                 R"("version": 2)");
  EXPECT_EQ(reason(old),
            "written in format 2 by a fixproof 0.1.0 that did not record its build; this fixproof "
            "reads format 3: run the verification again");
}

TEST(Reports, ARepeatedRowIsRefusedBeforeAnythingElseIsRead) {
  const std::string good = verify::to_json(finished({1, 20}));
  const std::string rows = "\"rows\": [";
  const auto begin = good.find(rows) + rows.size();
  const auto end = good.find("\n  },", begin) + 5;
  std::string many;
  for (int i = 0; i < 1'000; ++i) many += good.substr(begin, end - begin);
  const std::string text = test::sealed(replaced(good, rows, rows + many));
  EXPECT_EQ(reason(text), "row 2 repeats mul i386 on");
}

TEST(Reports, SayWhatMadeThem) {
  const verify::Report report = verify::from_json(verify::to_json(finished()));
  ASSERT_EQ(report.makers.size(), 1U);
  const verify::Maker& maker = report.makers[0];
  EXPECT_EQ(maker.version, support::program_version());
  EXPECT_EQ(maker.commit, support::source_commit());
  EXPECT_FALSE(maker.compiler.empty());
  EXPECT_EQ(
      maker.executable,
      support::sha256_hex(support::read_file(std::filesystem::read_symlink("/proc/self/exe"))));
  EXPECT_EQ(maker.parties, (std::map<std::string, std::string>{{"fast", "built-in integers"},
                                                               {"saboteur", "a saboteur"}}));
}

/// Answers like the fast party and has a name that is not UTF-8.
class Foreign final : public parties::Party {
 public:
  [[nodiscard]] std::string_view name() const override { return "foreign"; }
  [[nodiscard]] std::string identity() const override { return "Z\xfcse CPU\n\x1b~"; }
  [[nodiscard]] bool answers(const cases::Variant& v) const override {
    return parties::party_named("fast").answers(v);
  }
  void fill(const cases::Variant& v, const parties::Cases& asked) const override {
    parties::party_named("fast").answer(v, asked);
  }
};

TEST(Reports, NameAForeignProcessorInAscii) {
  const Foreign foreign;
  verify::Report report(cases::Plan(1, 5, {{div, {"fast", "foreign"}}}), {1, 1000}, 1);
  verify::run(report,
              std::array<const parties::Party*, 2>{&foreign, &parties::party_named("fast")});
  const verify::Report read = verify::from_json(verify::to_json(report));
  EXPECT_EQ(read.makers.at(0).parties.at("foreign"), "Z?se CPU??~");
}

// A build with debugging information may be that large.
TEST(Reports, DigestFilesOfAnySize) {
  const ScratchFolder folder;
  constexpr std::uintmax_t more_than_read_file_takes = (std::uintmax_t{256} << 20U) + 1;
  std::filesystem::resize_file(folder.write("zeros", ""), more_than_read_file_takes);
  EXPECT_EQ(support::sha256_hex_of_file(folder.path("zeros")),
            "da6ce8755151acd05195db67ebce3ee0fb5f4012e71e821cc5750f3304eaf41e");
  EXPECT_EQ(support::sha256_hex_of_file(folder.write("text", "text")), support::sha256_hex("text"));
  EXPECT_EQ(support::sha256_hex_of_file(folder.write("empty", "")), support::sha256_hex(""));
  EXPECT_THROW(support::sha256_hex_of_file(folder.path("none")), std::runtime_error);
  EXPECT_THROW(support::sha256_hex_of_file(folder.path()), std::runtime_error);
}

/// The report of two parties that answer alike.
verify::Report report_of_two(const test::Saboteur::Spoil& spoil) {
  const test::Saboteur one("one", parties::party_named("fast"), spoil);
  const test::Saboteur two("two", parties::party_named("fast"), spoil);
  verify::Report report(cases::Plan(1, 5, {{div, {"one", "two"}}}), {}, 3);
  verify::run(report, std::array<const parties::Party*, 2>{&one, &two});
  EXPECT_EQ(report.mismatches(), 0U);
  return report;
}

TEST(Reports, OneBitOfOneAnswerChangesTheDigestOfItsChunk) {
  const verify::Report honest = report_of_two([](Words, auto, parties::Ending&) {});
  const auto is_one = [](Words in) { return in[0] == 0x8001U && in[1] == 0x55555555U; };
  const verify::Report bit =
      report_of_two([&](Words in, std::span<std::uint32_t> out, parties::Ending&) {
        if (is_one(in)) out[0] ^= 0x80000000U;
      });
  const verify::Report fault = report_of_two([&](Words in, auto, parties::Ending& ending) {
    if (is_one(in)) ending = parties::Ending::divide_error;
  });
  const verify::Report unspecified =
      report_of_two([](Words, std::span<std::uint32_t> out, parties::Ending& ending) {
        if (ending == parties::Ending::divide_error) out[0] ^= 0x12345678U;
      });
  EXPECT_EQ(honest.chunks, unspecified.chunks);
  for (const verify::Report* other : {&bit, &fault}) {
    std::size_t differing = 0;
    for (std::size_t i = 0; i < honest.chunks.size(); ++i) {
      if (honest.chunks[i].answers != other->chunks[i].answers) ++differing;
    }
    EXPECT_EQ(differing, 1U);
  }
}

TEST(Reports, ExchangedAnswersOfTwoPartiesChangeTheDigestOfTheirChunk) {
  const auto result_if_one_errs = [](std::string_view wrong) {
    const auto party = [&](const char* name) {
      const bool errs = wrong == name;
      return test::Saboteur(name, parties::party_named("fast"),
                            [errs](Words in, std::span<std::uint32_t> out, parties::Ending&) {
                              const bool is_one = in[0] == 0x8001U && in[1] == 0x55555555U;
                              if (errs && is_one) out[0] ^= 1U;
                            });
    };
    const test::Saboteur one = party("one");
    const test::Saboteur two = party("two");
    verify::Report report(cases::Plan(1, 5, {{div, {"fast", "one", "two"}}}), {}, 3);
    verify::run(report,
                std::array<const parties::Party*, 3>{&parties::party_named("fast"), &one, &two});
    EXPECT_EQ(report.mismatches(), 1U);
    return report.chunks;
  };
  EXPECT_NE(result_if_one_errs("one"), result_if_one_errs("two"));
}

TEST(Reports, ChunksRunAgainFindChangedResults) {
  const auto everything = [](const verify::Report& report) {
    try {
      verify::recheck(report, both(), report.done.size());
      return std::string();
    } catch (const std::runtime_error& error) {
      return std::string(error.what());
    }
  };
  verify::Report report = finished({2, 3});
  EXPECT_EQ(everything(report), "");
  EXPECT_EQ(everything(fresh()), "");
  for (std::uint64_t verify::ChunkResult::*part :
       {&verify::ChunkResult::faults, &verify::ChunkResult::mismatches,
        &verify::ChunkResult::answers}) {
    verify::Report changed = report;
    ++(changed.chunks[4].*part);
    EXPECT_EQ(everything(changed).find("chunk 4 (mul i386 on, "), 0U) << everything(changed);
  }
  // One of three chunks runs again, each time another.
  verify::Report changed = finished({1, 12});
  ASSERT_EQ(changed.chunks_done(), 3U);
  changed.chunks[12].answers ^= 1U;
  int found = 0;
  for (int i = 0; i < 100; ++i) {
    try {
      verify::recheck(changed, both(), 1);
    } catch (const std::runtime_error&) {
      ++found;
    }
  }
  EXPECT_GT(found, 0);
  EXPECT_LT(found, 100);
}

TEST(Reports, ChunksDoneMustFitTheCounts) {
  verify::Report report = finished();
  report.done[3] = false;
  EXPECT_THROW(verify::from_json(verify::to_json(report)), std::runtime_error);
  report = finished();
  ++report.findings[0].cases;
  EXPECT_THROW(verify::from_json(verify::to_json(report)), std::runtime_error);
  report = finished();
  ++report.chunks[0].faults;
  EXPECT_THROW(verify::from_json(verify::to_json(report)), std::runtime_error);
  report = finished();
  report.makers.clear();
  EXPECT_THROW(verify::from_json(verify::to_json(report)), std::runtime_error);
  report = finished();
  report.findings[0].shown.pop_back();
  EXPECT_THROW(verify::from_json(verify::to_json(report)), std::runtime_error);
}

// merged() sorts the mismatches, so it would change a report that has them in another order.
TEST(Reports, MismatchesMustBeInOrderAndCounted) {
  verify::Report report = finished();
  std::vector<verify::Mismatch>& shown = report.findings[0].shown;
  ASSERT_GE(shown.size(), 2U);
  EXPECT_NO_THROW(verify::from_json(verify::to_json(report)));
  std::swap(shown[0], shown[1]);
  EXPECT_THROW(verify::from_json(verify::to_json(report)), std::runtime_error);
  std::swap(shown[0], shown[1]);
  shown[1] = shown[0];
  EXPECT_THROW(verify::from_json(verify::to_json(report)), std::runtime_error);
}

TEST(Reports, MismatchesMustBeOfAChunkThatCountsThem) {
  verify::Report report(cases::Plan(1, 5, {{mul, {"saboteur", "fast"}}}), {}, 3);
  verify::Maker maker = verify::this_build();
  maker.parties = {{"fast", ""}, {"saboteur", ""}};
  report.add(maker);
  const auto add = [&](std::uint64_t number, std::uint64_t mismatches) {
    const cases::Chunk chunk = report.plan.chunk(number);
    report.add(number, {{chunk.cases, 0, mismatches, {}}, 0});
  };
  add(0, 0);
  add(1, 1);
  report.findings[0].shown = {{1, report.plan.chunk(1).first, {1, 2}, {}, {}}};
  EXPECT_NO_THROW(verify::from_json(verify::to_json(report)));
  report.findings[0].shown = {{0, report.plan.chunk(0).first, {1, 2}, {}, {}}};
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
  const ScratchFolder folder;
  const std::string file = folder.path("report.json");
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
}

}  // namespace report_test
}  // namespace fixproof
