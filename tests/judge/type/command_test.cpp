// `fixproof prove type`.
#include "tests/support/command.hpp"

#include <array>

#include "tests/support/paths.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/test.hpp"

namespace {

using Arguments = std::vector<std::string>;

/// Proves some functions of the headers in a folder.
command::Run prove(const std::string& headers, const Arguments& only) {
  Arguments arguments{paths::command(), "prove",     "type",  "--compiler", TYPE_COMPILER,
                      "--level=-O2",    "--headers", headers, "--only"};
  arguments.insert(arguments.end(), only.begin(), only.end());
  return command::run(arguments);
}

/// A header of the type with one change, in a folder of its own that holds the others, too.
class Changed {
 public:
  Changed(const std::string& header, const std::string& from, const std::string& to) {
    const auto copied = command::run({"cp", "-r", paths::source("fixed"), folder_.path("fixed")});
    EXPECT_EQ(copied.status, 0) << copied.err;
    const std::string file = folder_.path("fixed/" + header);
    // No sed: the text may have any characters.
    const auto changed = command::run(
        {"python3", "-c",
         "import sys; p, a, b = sys.argv[1:]; s = open(p).read(); assert s.count(a) == 1, "
         "s.count(a); open(p, 'w').write(s.replace(a, b))",
         file, from, to});
    EXPECT_EQ(changed.status, 0) << changed.err;
  }
  [[nodiscard]] std::string folder() const { return folder_.path(""); }

 private:
  ScratchFolder folder_;
};

TEST(ProveType, SumsAreProven) {
  if (!command::has("z3")) GTEST_SKIP() << "no z3";
  const auto run = prove(paths::source(""), {"+ "});
  EXPECT_EQ(run.status, 0) << run.out << run.err;
  command::expect_contains(run.out, "18 proven, 0 disproven, 0 not decided");
}

TEST(ProveType, ADefectIsDisproven) {
  if (!command::has("z3")) GTEST_SKIP() << "no z3";
  const Changed changed("detail/exact.hpp", "sum_t<Raw>{a} + sum_t<Raw>{b}",
                        "sum_t<Raw>{a} + sum_t<Raw>{b} + (a == -2023406815 && b == 19088743)");
  const auto run = prove(changed.folder(), {"+ "});
  EXPECT_EQ(run.status, 1) << run.out << run.err;
  command::expect_contains(run.out, "DISPROVEN for 87654321h 1234567h: it returns 8888888");
}

TEST(ProveType, AnErrorThatIsMissingIsDisproven) {
  if (!command::has("z3")) GTEST_SKIP() << "no z3";
  const Changed changed("detail/overflow.hpp", "if (!fits<Raw>(value)) raise();", "");
  const auto run = prove(changed.folder(), {"+             q16_16"});
  EXPECT_EQ(run.status, 1) << run.out << run.err;
  command::expect_contains(run.out, "q16_16, half-up, trap: DISPROVEN");
  command::expect_contains(run.out, "2 proven, 1 disproven");
}

TEST(ProveType, BadUsageIsRefused) {
  struct Row {
    std::string arguments, message;
  };
  const std::array<Row, 5> rows{
      {{"prove type --headers /nowhere", "--headers '/nowhere': there is no fixed/fixed.hpp"},
       {"prove type --compiler no-such-compiler", "no-such-compiler cannot be run"},
       {"prove type --only nothing", "--only: no function has such a text"},
       {"prove type --timeout 0", "--timeout"},
       {"prove type mul", "mul"}}};
  for (const Row& row : rows) {
    const auto run = command::fixproof(row.arguments);
    EXPECT_EQ(run.status, 2) << row.arguments << run.out;
    command::expect_contains(run.err, row.message);
  }
}

TEST(ProveType, TheListNamesEveryGoal) {
  const std::string list = command::output_of("prove type --list");
  for (const char* const line :
       {"/             q16_16, i8088_rounded\n", "*             u16_16, half-even, wrap\n",
        "checked_...   q32_32, checked_divide(x, y).has_value()\n",
        "conversion    q2_30 to q8_8, floor, wrap\n",
        "from integer  std::uint64_t to q24_8, half-up, trap\n"}) {
    command::expect_contains(list, line);
  }
}

}  // namespace
