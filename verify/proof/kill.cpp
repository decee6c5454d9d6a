#include "verify/proof/kill.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "support/interrupt.hpp"
#include "support/usage_error.hpp"
#include "verify/cases/plan.hpp"
#include "verify/parties/answer.hpp"
#include "verify/parties/interpreter.hpp"
#include "verify/proof/span_cases.hpp"

namespace fixproof::proof {

namespace {

namespace x86 = x86model;

/// Compares two parties in batches. A batch is small because most mutants fail at once, and a
/// mutant that never ends takes long for each case.
class Duel {
 public:
  Duel(const cases::Variant& v, const parties::Party& judged, const parties::Party& reference)
      : v_(v),
        judged_(judged),
        reference_(reference),
        in_(most * cases::words_in(v.operation)),
        out_(most * cases::words_out(v.operation)),
        expected_(out_.size()) {}

  /// Returns the number of cases before the first difference, or `count` if there is none.
  std::uint64_t passed(const cases::Job& job, std::uint64_t seed, std::uint64_t first,
                       std::uint64_t count) {
    const std::size_t taken = cases::words_in(v_.operation);
    const std::size_t given = cases::words_out(v_.operation);
    for (std::uint64_t done = 0; done < count; done += most) {
      const auto cases = static_cast<std::size_t>(std::min<std::uint64_t>(most, count - done));
      const auto in = std::span(in_).first(cases * taken);
      cases::make_cases(job.stream, v_, seed, first + done, in);
      judged_.answer(v_, {in, std::span(out_).first(cases * given), std::span(ends_).first(cases)});
      reference_.answer(v_, {in, std::span(expected_).first(cases * given),
                             std::span(ends_wanted_).first(cases)});
      for (std::size_t i = 0; i < cases; ++i) {
        const bool same =
            parties::agree({ends_.at(i), std::span(out_).subspan(i * given, given)},
                           {ends_wanted_.at(i), std::span(expected_).subspan(i * given, given)});
        if (!same) return done + i;
      }
    }
    return count;
  }

 private:
  static constexpr std::size_t most = 64;
  const cases::Variant& v_;
  const parties::Party& judged_;
  const parties::Party& reference_;
  std::vector<std::uint32_t> in_, out_, expected_;
  std::array<parties::Ending, most> ends_{}, ends_wanted_{};
};

const parties::Party& reference_for(const cases::Variant& v) {
  return parties::party_named(v.operation == cases::Operation::cossin ? "oracle" : "fast");
}

/// Level 1 of a variant for one party, in two rounds.
class LevelOne {
 public:
  LevelOne(const cases::Variant& v, const parties::Party& judged, std::uint64_t seed)
      : seed_(seed),
        plan_(1, seed,
              {cases::Row{v, {std::string(judged.name()), std::string(reference_for(v).name())}}}),
        duel_(v, judged, reference_for(v)) {}

  /// Runs the next round: first a few cases of every stream, which kill most mutants, then all
  /// others.
  /// @return the number of cases run so far, including the one that differs; nothing if none does
  std::optional<std::uint64_t> next_round() {
    for (const cases::Job& job : plan_.jobs()) {
      const std::uint64_t few = std::min<std::uint64_t>(256, job.cases);
      const std::uint64_t begin = is_first_ ? 0 : few;
      const std::uint64_t end = is_first_ ? few : job.cases;
      const std::uint64_t passed = duel_.passed(job, seed_, begin, end - begin);
      cases_ += passed;
      if (passed < end - begin) return cases_ + 1;
    }
    is_first_ = false;
    return std::nullopt;
  }

 private:
  std::uint64_t seed_;
  cases::Plan plan_;
  Duel duel_;
  std::uint64_t cases_ = 0;
  bool is_first_ = true;
};

/// The result for a program that survived level 1.
template <class Subject>
MutantResult result_of_survivor(const Subject& subject, const x86::Program& program,
                                const Solver& solver, int max_seconds) {
  MutantResult result;
  try {
    result.proof = prove(subject, program, solver, max_seconds);
  } catch (const support::Stopped&) {
    throw;
  } catch (const std::exception& error) {
    result.failure = error.what();
  }
  if (result.proof.standing == Standing::proven) result.fate = Fate::equivalent;
  return result;
}

}  // namespace

std::vector<x86::Mutant> mutants_of(const cases::Variant& v) {
  const x86::Program sound = parties::program_of(v);
  auto all = x86::mutants(sound);
  std::size_t own = 1;
  while (own < sound.size && !sound.code.at(own).is_procedure) ++own;
  std::erase_if(all, [&](const x86::Mutant& m) { return m.position >= own; });
  return all;
}

x86::Mutant mutant_of(const cases::Variant& v, std::size_t number) {
  const auto all = mutants_of(v);
  if (number < 1 || number > all.size()) {
    throw support::UsageError(fmt::format("--mutant {}: {} has mutants 1 to {}; choose one of them",
                                          number, cases::name_of(v), all.size()));
  }
  return all[number - 1];
}

std::optional<std::uint64_t> cases_to_kill(const cases::Variant& v, const parties::Party& judged,
                                           std::uint64_t seed) {
  LevelOne level_one(v, judged, seed);
  const auto killed_by = level_one.next_round();
  return killed_by ? killed_by : level_one.next_round();
}

MutantResult judge(const cases::Variant& v, const x86::Program& program, std::uint64_t seed,
                   const Solver& solver, int max_seconds) {
  const auto party = parties::make_interpreter_of("mutant", program);
  LevelOne level_one(v, *party, seed);
  auto killed_by = level_one.next_round();
  if (!killed_by) {
    // No case can tell the same terms apart.
    if (has_same_terms(v, program.instructions())) return {.fate = Fate::equivalent};
    killed_by = level_one.next_round();
  }
  if (killed_by) return {.fate = Fate::killed, .cases = *killed_by};
  return result_of_survivor(v, program, solver, max_seconds);
}

MutantResult judge(const x86::LoopForm& form, const x86::Program& program, std::uint64_t seed,
                   const Solver& solver, int max_seconds) {
  if (const auto by = spans_to_kill(form, program, seed)) {
    return {.fate = Fate::killed, .cases = *by};
  }
  return result_of_survivor(form, program, solver, max_seconds);
}

}  // namespace fixproof::proof
