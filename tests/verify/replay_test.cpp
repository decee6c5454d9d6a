// Tests that a shell can run the command line of a mismatch and that it repeats the case.
#include "verify/replay.hpp"

#include <sys/wait.h>

#include <cstdio>
#include <filesystem>

#include "cases/plan.hpp"
#include "cases/streams.hpp"
#include "parties/answer.hpp"
#include "tests/support/test.hpp"
#include "verify/engine.hpp"

namespace fixproof {
namespace {

struct Shell {
  std::string out;
  int status = -1;
};

Shell shell(const std::string& line) {
  const std::string folder = std::filesystem::path(FIXPROOF_COMMAND).parent_path();
  const std::string with_path = "PATH='" + folder + "':$PATH; " + line;
  // Safe because the line comes only from this program.
  std::FILE* pipe = popen(with_path.c_str(), "r");  // NOLINT(cert-env33-c)
  Shell result;
  std::array<char, 256> buffer{};
  while (const std::size_t size = std::fread(buffer.data(), 1, buffer.size(), pipe)) {
    result.out.append(buffer.data(), size);
  }
  const int status = pclose(pipe);
  if (WIFEXITED(status)) result.status = WEXITSTATUS(status);
  return result;
}

TEST(Replay, GivesTheAnswerOfTheJudgedPartyForEveryVariant) {
  for (const cases::Variant& listed : cases::all_variants()) {
    for (const cases::Format& format : {cases::q16_16, cases::q8_8}) {
      cases::Variant v = listed;
      v.format = format;
      std::vector<const parties::Party*> able;
      for (const auto& party : parties::parties()) {
        if (party->answers(v) && party->name() != "interpreter") able.push_back(party.get());
      }
      const cases::Row row = parties::row_of(v, able);
      if (!row.compared()) continue;
      std::vector<std::uint32_t> words(cases::words_in(v.operation));
      cases::make_cases(cases::Stream::scaled, v, 1, 3, words);
      const std::string expected = parties::ask(*able.front(), v, words).text(format.word_bits);
      const std::string line = verify::replay(row, words);
      const Shell result = shell(line);
      EXPECT_EQ(result.status, 0) << line;
      EXPECT_NE(result.out.find(expected), std::string::npos) << line << '\n' << result.out;
      EXPECT_EQ(std::count(result.out.begin(), result.out.end(), '\n'), 1) << line;
    }
  }
}

TEST(Replay, NamesPartiesThatAreNotAskedByDefault) {
  const cases::Row row{{.operation = cases::Operation::mul, .format = cases::q8_8},
                       {"interpreter", "model"}};
  const std::array<std::uint32_t, 2> words{0x0180, 0xff00};
  EXPECT_EQ(verify::replay(row, words),
            "fixproof verify mul --target i386 --round on --chapter 54 --width half --case '0180 "
            "ff00' --by "
            "interpreter --against model");
  EXPECT_EQ(shell(verify::replay(row, words)).status, 0);
}

}  // namespace
}  // namespace fixproof
