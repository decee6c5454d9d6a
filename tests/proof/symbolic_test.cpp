// The symbolic run is the interpreter's: for every operand one path, which ends as the interpreter
// does, with the same results. Broken programs too, so that every instruction is met in every
// place.
#include <gtest/gtest.h>

#include <optional>

#include "tests/x86model/cases.hpp"
#include "x86model/mutants.hpp"
#include "x86model/symbolic/call.hpp"
#include "x86model/symbolic/evaluate.hpp"

namespace {

using namespace x86model;
namespace sym = x86model::symbolic;

/// What the interpreter makes of a case: results where it returned, and how it ended.
struct Answer {
  Outcome outcome;
  std::vector<std::uint32_t> words;
};

/// What register number `r` holds before a call.
std::uint32_t held(std::size_t r) { return 0x9E3779B9U * static_cast<std::uint32_t>(r + 1); }

/// From a stack of zeros, which is what a symbolic variable comes to if it is not set.
template <Routine routine>
Answer interpreted(std::span<const Instruction> code, std::span<const std::uint32_t> in) {
  CallMachine<routine, 16> m;
  if constexpr (routine == Routine::cossin) load_cosine_table(m);
  for (std::size_t r = 0; r < register_count; ++r) {
    m.registers.write(static_cast<Register>(r), Size::dword, held(r));
  }
  enter<routine>(m, in);
  Answer answer{run(code, m).outcome, {}};
  if (answer.outcome != Outcome::returned) return answer;
  answer.words.resize(static_cast<std::size_t>(arity(routine).out));
  leave<routine>(m, answer.words);
  return answer;
}

std::uint64_t function(const std::string& name, std::span<const std::uint64_t> arguments) {
  if (name == "cosword" && arguments[0] >= 4 * cosine_table.size()) return 0;
  return sym::concrete(name, arguments);
}

/// The paths of one program, asked case by case.
template <Routine routine>
class Paths {
 public:
  explicit Paths(std::span<const Instruction> code)
      : paths_(sym::run(terms_, code, sym::enter(terms_, routine), options(terms_))),
        evaluation_(terms_, function) {
    for (const sym::Path& path : paths_) {
      results_.push_back(path.outcome == Outcome::returned
                             ? sym::results(terms_, routine, path.state)
                             : std::vector<sym::Term>());
    }
  }

  /// Nothing where the case leaves the cosine table, which the interpreter's memory goes beyond.
  std::optional<Answer> answer(std::span<const std::uint32_t> in) {
    for (std::size_t i = 0; i < in.size(); ++i) {
      evaluation_.set(sym::operand_name(routine, static_cast<int>(i)), in[i]);
    }
    for (std::size_t r = 0; r < register_count; ++r) {
      evaluation_.set(sym::numbered("register", r), held(r));
    }
    std::optional<Answer> answer;
    for (std::size_t i = 0; i < paths_.size(); ++i) {
      if (evaluation_(paths_[i].condition) == 0) continue;
      EXPECT_FALSE(answer.has_value()) << "two paths";
      if (evaluation_(paths_[i].in_table) == 0) return std::nullopt;
      answer = Answer{paths_[i].outcome, {}};
      for (const sym::Term word : results_[i]) {
        answer->words.push_back(static_cast<std::uint32_t>(evaluation_(word)));
      }
    }
    EXPECT_TRUE(answer.has_value()) << "no path";
    return answer;
  }

 private:
  static sym::RunOptions options(sym::Terms& terms) {
    sym::RunOptions chosen;
    if (routine == Routine::cossin) {
      chosen.enumerated = terms.variable(sym::operand_name(routine, 0), 16);
    }
    return chosen;
  }

  sym::Terms terms_;
  std::vector<sym::Path> paths_;
  sym::Evaluation evaluation_;
  std::vector<std::vector<sym::Term>> results_;
};

/// Compares every `step`-th case of the routine.
template <Routine routine>
void expect_agreement(const Program& program, std::size_t step, const std::string& what,
                      std::size_t& compared) {
  Paths<routine> paths(program.instructions());
  const auto words = test::cases(routine);
  const auto in = static_cast<std::size_t>(arity(routine).in);
  for (std::size_t i = 0; i < words.size() / in; i += step) {
    const auto operands = std::span(words).subspan(i * in, in);
    const Answer expected = interpreted<routine>(program.instructions(), operands);
    // A loop without an end has no path to its end.
    if (expected.outcome == Outcome::step_limit) continue;
    const auto answer = paths.answer(operands);
    if (!answer) continue;
    // Addresses that are not constants are refused, and long loops: a broken program may have such.
    const bool given_up =
        answer->outcome == Outcome::bad_address || answer->outcome == Outcome::step_limit;
    if (given_up && what != "sound") continue;
    ++compared;
    ASSERT_EQ(answer->outcome, expected.outcome) << what << " case " << i;
    ASSERT_EQ(answer->words, expected.words) << what << " case " << i;
  }
}

/// The transforms for the 8088 have four ways through each of their products: too many to follow.
constexpr bool is_followed(Routine routine, Target target) {
  return target == Target::i386 || routine == Routine::mul || routine == Routine::div ||
         routine == Routine::cossin;
}

TEST(Symbolic, IsTheInterpreterOnEveryRoutine) {
  std::size_t compared = 0;
  test::each_routine([&]<Routine routine, Target target>() {
    if constexpr (is_followed(routine, target)) {
      for (const Build& build : test::builds) {
        if (build.chapter_52 && target == Target::i8088) continue;
        expect_agreement<routine>(assemble(listing(routine, target), build), 1, "sound", compared);
      }
    }
  });
}

TEST(Symbolic, IsTheInterpreterOnBrokenRoutines) {
  std::size_t compared = 0;
  test::each_routine([&]<Routine routine, Target target>() {
    if constexpr (is_followed(routine, target) && routine != Routine::concat) {
      const bool is_long = routine == Routine::xformvec || routine == Routine::cossin;
      const auto broken = mutants(assemble(listing(routine, target), {}));
      for (std::size_t i = 0; i < broken.size(); i += is_long ? 23 : 1) {
        expect_agreement<routine>(broken[i].program, is_long ? 50 : 37, broken[i].change, compared);
        if (testing::Test::HasFatalFailure()) return;
      }
    }
  });
  EXPECT_GT(compared, 5'000U);
}

}  // namespace
