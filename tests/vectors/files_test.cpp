// The committed cases: the model agrees with them, and they are what the processor says.
#include "tests/vectors/files.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/vectors/cases.hpp"
#include "tests/vectors/processor.hpp"

namespace {

using vectors::Json;

TEST(Vectors, TheModelAgreesWithEveryCommittedCase) {
  for (const auto& file : vectors::committed) {
    const std::string path = vectors::path_of(file);
    const auto run =
        command::fixproof(fmt::format("step --cpu {} --singlestep {}", file.cpu, path));
    EXPECT_EQ(run.status, 0);
    EXPECT_EQ(run.out, fmt::format("{}: {}\n", path, file.summary));
    EXPECT_EQ(run.err, "");
  }
}

TEST(Vectors, SeveralFilesAreJudgedOneAfterTheOther) {
  const std::string first = vectors::path_of(vectors::committed[1]);
  const std::string second = vectors::path_of(vectors::committed[2]);
  const auto run = command::fixproof(fmt::format("step --singlestep {} {}", first, second));
  EXPECT_EQ(run.out, fmt::format("{}: {}\n{}: {}\n", first, vectors::committed[1].summary, second,
                                 vectors::committed[2].summary));
  EXPECT_EQ(run.status, 0);
}

/// The case, with flags that are undefined after it taken away.
Json defined(Json c, std::string_view cpu) {
  const std::string name = vectors::name_in_set("flags", cpu);
  c["final"]["regs"][name] =
      vectors::final_value(c, name) & ~std::uint32_t{vectors::undefined_flags(c)};
  return c;
}

TEST(Vectors, TheProcessorSaysTheSameAgain) {
  if (!vectors::has_processor()) GTEST_SKIP() << "needs an x86-64 processor, to be asked itself";
  const auto files = vectors::make_files();
  ASSERT_EQ(files.size(), vectors::committed.size());
  for (std::size_t i = 0; i < files.size(); ++i) {
    const auto& file = vectors::committed.at(i);
    ASSERT_EQ(files[i].name, file.name);
    const Json made = Json::parse(files[i].text);
    const Json kept = vectors::load(file);
    ASSERT_EQ(made.size(), kept.size());
    for (std::size_t k = 0; k < made.size(); ++k) {
      EXPECT_EQ(defined(made[k], file.cpu), defined(kept[k], file.cpu)) << file.name << ' ' << k;
    }
  }
}

/// The processor's own answer to one instruction: a wrong one would make wrong files.
TEST(Vectors, TheProcessorIsAskedRight) {
  if (!vectors::has_processor()) GTEST_SKIP() << "needs an x86-64 processor, to be asked itself";
  using Code = std::vector<std::uint8_t>;
  vectors::Registers r{.general = {0xFFFF, 1, 2, 3, 4, 5, 6, 7}, .flags = 0xF402};
  EXPECT_TRUE(vectors::execute(Code{0x01, 0xC8}, r)) << "add eax, ecx";
  EXPECT_EQ(r, (vectors::Registers{.general = {0x10000, 1, 2, 3, 4, 5, 6, 7}, .flags = 0xF416}));
  EXPECT_TRUE(vectors::execute(Code{0x66, 0x11, 0xDC}, r)) << "adc sp, bx";
  EXPECT_EQ(r, (vectors::Registers{.general = {0x10000, 1, 2, 3, 7, 5, 6, 7}, .flags = 0xF402}));
  const auto before = r;
  r.general[1] = 0;
  EXPECT_FALSE(vectors::execute(Code{0xF7, 0xF1}, r)) << "div ecx";
  r.general[1] = 1;
  EXPECT_EQ(r, before);
}

}  // namespace
