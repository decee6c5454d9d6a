// Compares the symbolic run with the interpreter: every operand has one path, with the same ending
// and the same results. Mutants put every instruction in every place. The test counts the cases
// that it cannot compare and limits their number.
#include <iostream>

#include "tests/support/test.hpp"
#include "tests/x86model/cases.hpp"
#include "verify/parties/answer.hpp"
#include "x86model/mutants.hpp"
#include "x86model/symbolic/call.hpp"
#include "x86model/symbolic/evaluate.hpp"
#include "x86model/symbolic/smt.hpp"
#include "x86model/text.hpp"

namespace {

using namespace x86model;
namespace sym = x86model::symbolic;

/// The interpreter's ending and, if it returned, its results.
struct Answer {
  Outcome outcome;
  std::vector<std::uint32_t> words;
};

std::uint32_t held(std::size_t r) { return 0x9E3779B9U * static_cast<std::uint32_t>(r + 1); }

/// The stack starts with zeros, the value of a symbolic variable that is not set.
template <Routine routine>
Answer interpreted(std::span<const Instruction> code, std::span<const std::uint32_t> in) {
  CallMachine<routine, 16> m;
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

std::uint64_t fixed_mul(const Build& build, std::span<const std::uint64_t> factors) {
  const Program program = assemble(listing(Routine::mul, Target::i8088), build);
  const std::array in{static_cast<std::uint32_t>(factors[0]),
                      static_cast<std::uint32_t>(factors[1])};
  return interpreted<Routine::mul>(program.instructions(), in).words.at(0);
}

/// Each product of the 8088 transforms has four paths, which is too many to follow. A call of
/// FixedMul stands for its product there, as in a proof.
constexpr bool is_summed_up(Routine routine, Target target) {
  return target == Target::i8088 && (routine == Routine::xformvec || routine == Routine::concat);
}

struct Tally {
  std::size_t compared = 0;
  std::size_t endless = 0;    ///< of those compared: neither run ends
  std::size_t given_up = 0;   ///< an address that is not constant, or a loop that is too long
  std::size_t off_table = 0;  ///< of those compared: a read beyond the cosine table
  std::size_t left_open = 0;  ///< the result depends on what a call leaves in BX, CX, flags or
                              ///< below the stack

  void add(const Tally& other) {
    compared += other.compared;
    endless += other.endless;
    given_up += other.given_up;
    off_table += other.off_table;
    left_open += other.left_open;
  }
  [[nodiscard]] std::size_t skipped() const { return given_up + left_open; }
  void print() const {
    std::cout << compared << " cases compared, of them " << endless << " endless and " << off_table
              << " off the table; skipped: " << given_up << " given up, " << left_open
              << " left open\n";
  }
};

template <Routine routine, Target target>
class Paths {
 public:
  Paths(std::span<const Instruction> code, const Build& build)
      : paths_(sym::run(terms_, code, sym::enter(terms_, routine), options(terms_))),
        evaluation_(terms_, [build](const std::string& name, auto arguments) {
          return name == "fixedmul" ? fixed_mul(build, arguments) : function(name, arguments);
        }) {
    for (const sym::Path& path : paths_) {
      results_.push_back(path.outcome == Outcome::returned
                             ? sym::results(terms_, routine, path.state)
                             : std::vector<sym::Term>());
      std::vector<sym::Term> roots = results_.back();
      roots.push_back(path.condition);
      left_open_.push_back(depends_on_unknown(roots));
    }
  }

  void compare(std::span<const std::uint32_t> in, const Answer& expected, Tally& tally) {
    for (std::size_t i = 0; i < in.size(); ++i) {
      evaluation_.set(sym::operand_name(routine, static_cast<int>(i)), in[i]);
    }
    for (std::size_t r = 0; r < register_count; ++r) {
      evaluation_.set(sym::numbered("register", r), held(r));
    }
    std::optional<std::size_t> taken;
    for (std::size_t i = 0; i < paths_.size(); ++i) {
      if (evaluation_(paths_[i].condition) == 0) continue;
      ASSERT_FALSE(taken.has_value()) << "two paths";
      taken = i;
    }
    ASSERT_TRUE(taken.has_value()) << "no path";
    const sym::Path& path = paths_[*taken];
    // A flag that a call leaves undefined has a value in a real run.
    const bool lost_flag = is_summed_up(routine, target) && path.outcome == Outcome::undefined_flag;
    if (evaluation_(path.in_table) == 0) {
      ++tally.compared;
      ++tally.off_table;
      ASSERT_EQ(expected.outcome, Outcome::bad_address);
    } else if (left_open_[*taken] || lost_flag) {
      ++tally.left_open;
    } else if (is_given_up(path.outcome) && path.outcome != expected.outcome) {
      ++tally.given_up;
    } else {
      ++tally.compared;
      if (expected.outcome == Outcome::step_limit) ++tally.endless;
      ASSERT_EQ(path.outcome, expected.outcome);
      for (std::size_t i = 0; i < results_[*taken].size(); ++i) {
        ASSERT_EQ(evaluation_(results_[*taken][i]), expected.words.at(i)) << "word " << i;
      }
    }
  }

 private:
  static sym::RunOptions options(sym::Terms& terms) {
    sym::RunOptions chosen{.calls_are_fixed_mul = is_summed_up(routine, target)};
    if (routine == Routine::cossin) {
      chosen.enumerated = terms.variable(sym::operand_name(routine, 0), 16);
    }
    return chosen;
  }

  static bool is_given_up(Outcome outcome) {
    return outcome == Outcome::bad_address || outcome == Outcome::step_limit;
  }

  [[nodiscard]] bool depends_on_unknown(std::span<const sym::Term> roots) const {
    const auto reached = sym::reached_from(terms_, roots);
    return std::any_of(reached.begin(), reached.end(), [&](sym::Term t) {
      return terms_[t].op == sym::Op::variable && terms_[t].name.starts_with("unknown");
    });
  }

  sym::Terms terms_;
  std::vector<sym::Path> paths_;
  sym::Evaluation evaluation_;
  std::vector<std::vector<sym::Term>> results_;
  std::vector<bool> left_open_;
};

/// Compares every `step`-th case of the routine, from case `first` on.
template <Routine routine, Target target>
void expect_agreement(const Program& program, const Build& build, std::size_t first,
                      std::size_t step, const std::string& what, Tally& tally) {
  Paths<routine, target> paths(program.instructions(), build);
  const auto words = test::cases(routine);
  const auto in = static_cast<std::size_t>(arity(routine).in);
  for (std::size_t i = first; i < words.size() / in; i += step) {
    const auto operands = std::span(words).subspan(i * in, in);
    paths.compare(operands, interpreted<routine>(program.instructions(), operands), tally);
    if (testing::Test::HasFatalFailure()) {
      ADD_FAILURE() << name_of(routine) << ", " << what << ", case " << i;
      return;
    }
  }
}

TEST(Symbolic, IsTheInterpreterOnEveryRoutine) {
  Tally tally;
  std::size_t cases = 0;
  test::each_routine([&]<Routine routine, Target target>() {
    for (const Build& build : test::builds) {
      if (!test::is_for(build, target)) continue;
      const Program program = assemble(listing(routine, target), build);
      expect_agreement<routine, target>(program, build, 0, 1, "sound", tally);
      cases += test::cases(routine).size() / static_cast<std::size_t>(arity(routine).in);
    }
  });
  tally.print();
  EXPECT_EQ(tally.compared, cases);
  EXPECT_EQ(tally.endless, 0U);
}

/// Compares every `mutant_step`-th mutant of a routine on every `case_step`-th case.
template <Routine routine, Target target>
void expect_agreement_when_broken(std::size_t mutant_step, std::size_t case_step, Tally& tally) {
  const Program sound = assemble(listing(routine, target), {});
  // Excludes the FixedMul inside an 8088 transform, which is mutated on its own.
  std::size_t own = 1;
  while (own < sound.size && !sound.code.at(own).is_procedure) ++own;
  const auto broken = mutants(sound);
  for (std::size_t i = 0; i < broken.size(); i += mutant_step) {
    if (broken[i].position >= own) break;
    expect_agreement<routine, target>(broken[i].program, {}, i % case_step, case_step,
                                      broken[i].change, tally);
    if (testing::Test::HasFatalFailure()) return;
  }
}

TEST(Symbolic, IsTheInterpreterOnBrokenRoutines) {
  Tally tally;
  test::each_routine([&]<Routine routine, Target target>() {
    if (testing::Test::HasFatalFailure()) return;
    Tally own;
    if (routine == Routine::mul || routine == Routine::div) {
      expect_agreement_when_broken<routine, target>(1, 37, own);
    } else if (routine == Routine::concat) {
      expect_agreement_when_broken<routine, target>(131, 50, own);
    } else {
      expect_agreement_when_broken<routine, target>(23, 50, own);
    }
    std::cout << name_of(routine) << (target == Target::i386 ? " i386: " : " i8088: ");
    own.print();
    EXPECT_GT(own.compared, 50U);
    // Only where calls of FixedMul stand for products can a result depend on what a call leaves.
    const bool has_table = routine == Routine::cossin;
    EXPECT_EQ(own.off_table > 0, has_table);
    EXPECT_TRUE(is_summed_up(routine, target) || own.left_open == 0);
    EXPECT_LE(own.given_up, own.compared / 40);
    EXPECT_LE(own.skipped(), own.compared / 8);
    tally.add(own);
  });
  tally.print();
  EXPECT_GT(tally.compared, 10'000U);
}

}  // namespace
