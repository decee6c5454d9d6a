// Tests that a subject gets the cases of a verification.
#include "judge/check/cases.hpp"

#include "support/usage_error.hpp"
#include "tests/support/test.hpp"
#include "verify/cases/streams.hpp"

namespace {

using fixproof::cases::Operation;
using fixproof::check::CaseOptions;
using fixproof::check::GeneratedCases;
using Words = std::vector<std::uint32_t>;

struct Drawn {
  std::vector<Words> cases;
  std::map<std::string, std::uint64_t> of_stream;
};

Drawn draw_all(Operation operation, const CaseOptions& options) {
  GeneratedCases cases(fixproof::cases::variant_of(operation, fixproof::cases::q16_16), options);
  Drawn drawn;
  Words words(fixproof::cases::words_in(operation));
  while (cases.next(words)) {
    drawn.cases.push_back(words);
    ++drawn.of_stream[std::string(cases.origin())];
  }
  EXPECT_EQ(drawn.cases.size(), cases.count());
  for (const auto& [stream, count] : drawn.of_stream) EXPECT_EQ(count, cases.count_of(stream));
  return drawn;
}

TEST(CheckCases, AreTheStreamsOfLevelOne) {
  // docs/verify.md: a multiply has 1,039,204 cases.
  const Drawn drawn = draw_all(Operation::mul, {});
  EXPECT_EQ(drawn.cases.size(), 1'039'204U);
  EXPECT_EQ(drawn.of_stream.at("lattice"), 39'204U);
  EXPECT_EQ(drawn.of_stream.at("near_product_ties"), 250'000U);
  const fixproof::cases::Variant variant{.operation = Operation::mul,
                                         .build = {.target = fixproof::cases::Target::i8088}};
  Words words(2);
  fixproof::cases::make_cases(fixproof::cases::Stream::near_product_ties, variant, 1994, 249'999,
                              words);
  EXPECT_EQ(drawn.cases.back(), words);
}

TEST(CheckCases, ShardsHaveEveryCaseOnce) {
  for (const auto limit : {std::optional<std::uint64_t>(), std::optional<std::uint64_t>(1000)}) {
    CaseOptions options;
    options.cases = limit;
    auto whole = draw_all(Operation::sqrt, options).cases;
    std::vector<Words> parts;
    for (const char* shard : {"1/3", "2/3", "3/3"}) {
      options.shard = shard;
      const auto part = draw_all(Operation::sqrt, options).cases;
      parts.insert(parts.end(), part.begin(), part.end());
    }
    std::sort(whole.begin(), whole.end());
    std::sort(parts.begin(), parts.end());
    EXPECT_EQ(parts, whole);
  }
}

TEST(CheckCases, AFewAreSpreadOverEveryStream) {
  CaseOptions options;
  options.cases = 1000;
  const Drawn drawn = draw_all(Operation::div, options);
  EXPECT_EQ(drawn.cases.size(), 1000U);
  EXPECT_EQ(drawn.of_stream.size(), 9U);
  // The lattice has 39,204 cases, and eight other streams share 1,000,000.
  EXPECT_NEAR(static_cast<double>(drawn.of_stream.at("fault_edge")), 120, 2);
}

TEST(CheckCases, MoreThanThereAreIsAll) {
  CaseOptions options;
  options.cases = 100'000'000;
  EXPECT_EQ(draw_all(Operation::sqrt, options).cases.size(), 300'198U);
}

TEST(CheckCases, TheSeedChangesThem) {
  CaseOptions options;
  options.cases = 1000;
  const auto first = draw_all(Operation::div, options).cases;
  options.seed = 7;
  EXPECT_NE(draw_all(Operation::div, options).cases, first);
}

TEST(CheckCases, AShardThatIsNone) {
  CaseOptions options;
  options.shard = "4/3";
  EXPECT_THROW(
      GeneratedCases(fixproof::cases::variant_of(Operation::mul, fixproof::cases::q16_16), options),
      fixproof::support::UsageError);
}

}  // namespace
