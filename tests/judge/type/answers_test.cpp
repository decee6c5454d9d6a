// Questions that need not be asked again, in memory and in a file.
#include "judge/type/answers.hpp"

#include <string>
#include <vector>

#include "support/file.hpp"
#include "support/usage_error.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/test.hpp"

namespace fixproof::judge {
namespace {

using proof::Satisfiability;

/// A solver that counts what it is asked.
struct Counter {
  int asked = 0;
  Satisfiability verdict = Satisfiability::unsatisfiable;

  std::function<proof::SolverAnswer()> ask() {
    return [this] {
      ++asked;
      return proof::SolverAnswer{.verdict = verdict};
    };
  }
};

TEST(TypeAnswers, AQuestionWithoutACounterexampleIsAskedOnce) {
  Answers answers("", "z3");
  Counter counter;
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(answers("one", counter.ask()).verdict, Satisfiability::unsatisfiable);
  }
  EXPECT_EQ(counter.asked, 1);
  EXPECT_EQ(answers.remembered(), 2U);
  answers("two", counter.ask());
  EXPECT_EQ(counter.asked, 2);
}

TEST(TypeAnswers, OtherAnswersAreNotRemembered) {
  Answers answers("", "z3");
  for (const auto verdict : {Satisfiability::satisfiable, Satisfiability::unknown,
                             Satisfiability::one_sided, Satisfiability::disputed}) {
    Counter counter{.verdict = verdict};
    EXPECT_EQ(answers("one", counter.ask()).verdict, verdict);
    EXPECT_EQ(answers("one", counter.ask()).verdict, verdict);
    EXPECT_EQ(counter.asked, 2);
  }
}

/// Asks z3 some questions, with the answers of a file, and returns how many it had to be asked.
int asked_with(const std::string& file, const std::vector<std::string>& questions) {
  Counter counter;
  Answers answers(file, "z3");
  for (const std::string& question : questions) answers(question, counter.ask());
  answers.save();
  return counter.asked;
}

TEST(TypeAnswers, AFileKeepsThem) {
  const ScratchFolder folder;
  const std::string file = folder.path("answers.txt");
  EXPECT_EQ(asked_with(file, {"one"}), 1);
  EXPECT_EQ(asked_with(file, {"one", "two"}), 1);
  EXPECT_EQ(asked_with(file, {"two", "one"}), 0);
}

TEST(TypeAnswers, AFileOfAnotherKindOrSolverIsRefused) {
  const ScratchFolder folder;
  const std::string file = folder.path("answers.txt");
  asked_with(file, {"one"});
  const auto refusal = [](const std::string& path, const std::string& asked) {
    try {
      const Answers answers(path, asked);
      return std::string("accepted");
    } catch (const support::UsageError& error) {
      return std::string(error.what());
    }
  };
  EXPECT_NE(refusal(file, "cvc5").find("first line"), std::string::npos);
  EXPECT_NE(refusal(folder.write("notes.txt", "notes\n"), "z3").find("name another file"),
            std::string::npos);
  const std::string damaged = support::read_file(file) + "0123\n";
  EXPECT_NE(refusal(folder.write("damaged.txt", damaged), "z3").find("'0123' is no digest"),
            std::string::npos);
}

}  // namespace
}  // namespace fixproof::judge
