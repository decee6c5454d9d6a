#include "judge/type/prove_goal.hpp"

#include <fmt/format.h>

#include <array>
#include <memory>
#include <optional>

#include "judge/code/abstract_functions.hpp"
#include "judge/code/machine.hpp"
#include "verify/cases/draw.hpp"
#include "verify/proof/model.hpp"
#include "x86model/symbolic/evaluate.hpp"

namespace fixproof::judge {

namespace {

namespace sym = x86model::symbolic;
using proof::Arithmetic;
using proof::Standing;
using Words = std::vector<std::uint64_t>;

/// For the terms and the machine, and for the search of a counterexample that a solver does not
/// find.
constexpr std::uint64_t cases_to_compare = 200;
constexpr std::uint64_t cases_to_search = 2'000;

/// Calls a function of the System V convention on Unicorn.
class Function {
 public:
  Function(const Image& image, const Frame& frame, const Signature& signature)
      : image_(image),
        frame_(frame),
        signature_(signature),
        machine_(make_emulator(image, nullptr)) {}

  struct Answer {
    End end = End::returned;
    std::uint64_t result = 0;
  };

  Answer operator()(const Words& operands) {
    Registers registers;
    // Registers that hold no operand, and the bits above one, may hold anything.
    cases::Draw noise(0x5eed, calls_++);
    for (std::uint64_t& general : std::span(registers.general).first(register_count)) {
      general = noise.bits();
    }
    for (std::size_t i = 0; i < operands.size(); ++i) {
      const Parameter& p = signature_.operands[i];
      std::uint64_t value = operands[i];
      if (p.is_signed && p.bits < 64 && (value >> (p.bits - 1) & 1U) != 0) {
        value |= ~std::uint64_t{0} << p.bits;
      }
      registers.write(frame_.in[i].parts.front(), value);
    }
    const std::uint32_t top = image_.stack_top - bytes_of_home - 8;
    store(machine_->memory() + image_.data_at(top), image_.exit, 8);
    registers.general[4] = top;
    const Ending ending = machine_->call(registers);
    const std::uint64_t result = registers.general[0];
    const int bits = signature_.result_bits;
    return {ending.end, bits == 64 ? result : result & ((std::uint64_t{1} << bits) - 1)};
  }

 private:
  const Image& image_;
  const Frame& frame_;
  const Signature& signature_;
  std::unique_ptr<Machine> machine_;
  std::uint64_t calls_ = 0;
};

std::string text_of(const Function::Answer& answer) {
  if (answer.end == End::divide_error) return "raises a divide error (#DE)";
  if (answer.end == End::bad_instruction) return "raises an error";
  return fmt::format("returns {:x}h", answer.result);
}

class Prover {
 public:
  Prover(const Goal& goal, const Image& image, const Ask& ask)
      : goal_(goal),
        image_(image),
        ask_(ask),
        frame_(convention_of_64_bits(false, goal.signature)),
        function_(image, frame_, goal.signature) {}

  GoalProof prove() {
    Listing listing(image_);
    SymbolicRun run = run_symbolically(image_, frame_, goal_.signature, listing, terms_,
                                       may_hold(terms_, ask_, proof_.seconds));
    proof_.why = run.obstacle;
    if (!run.obstacle.empty()) return proof_;
    paths_ = std::move(run.paths);
    if (!terms_are_those_of_machine()) {
      proof_.why = "the model of the instructions and Unicorn differ";
      return proof_;
    }
    if (goal_.says.ways.empty())
      proof_.why = "there is no statement about quotients of 64-bit words";
    for (const Statement& statement : goal_.says.ways) {
      if (is_final(statement, Arithmetic::abstract)) return proof_;
    }
    if (!goal_.says.ways.empty() && !search()) {
      is_final(goal_.says.definition, Arithmetic::exact);
    }
    return proof_;
  }

 private:
  bool terms_are_those_of_machine() {
    sym::Evaluation evaluation(terms_, concrete_function);
    for (std::uint64_t n = 0; n < cases_to_compare; ++n) {
      const Words words = operands_of(goal_.signature, n);
      for (std::size_t i = 0; i < words.size(); ++i) evaluation.set(operand_name(i), words[i]);
      const Function::Answer answer = function_(words);
      int taken = 0;
      bool same = true;
      for (const Path& path : paths_) {
        if (evaluation(path.condition) == 0) continue;
        ++taken;
        same = answer.end == end_of(path) &&
               (!path.returns() || evaluation(path.result) == answer.result);
      }
      if (taken != 1 || !same) return false;
    }
    return true;
  }

  bool is_final(const Statement& statement, Arithmetic arithmetic) {
    const PathAnswer answer = ask_all(
        paths(), [&](const Path& path) { return statement(terms_, path); }, arithmetic, ask_,
        [&](std::span<const std::uint64_t> words) {
          return fails(Words(words.begin(), words.end()));
        });
    proof_.seconds += answer.seconds;
    proof_.standing = answer.standing;
    proof_.why = answer.remark;
    return answer.standing == Standing::proven || answer.standing == Standing::disproven;
  }

  /// Tries many cases. Returns whether the function fails for one.
  bool search() {
    for (std::uint64_t n = 0; n < cases_to_search; ++n) {
      if (!fails(operands_of(goal_.signature, n))) continue;
      proof_.standing = Standing::disproven;
      return true;
    }
    return false;
  }

  /// Tells whether the function breaks its definition for operands, and runs it if so.
  bool fails(const Words& words) {
    std::string model;
    for (std::size_t i = 0; i < words.size(); ++i) {
      model +=
          fmt::format("(define-fun {} () (_ BitVec {}) (_ bv{} {}))", operand_name(i),
                      goal_.signature.operands[i].bits, words[i], goal_.signature.operands[i].bits);
    }
    sym::Evaluation evaluation(terms_, concrete_function);
    for (std::size_t i = 0; i < words.size(); ++i) evaluation.set(operand_name(i), words[i]);
    for (const Path& path : paths_) {
      if (evaluation(path.condition) == 0) continue;
      const std::string script =
          question(paths(), path, goal_.says.definition(terms_, path), "true", Arithmetic::exact);
      if (!proof::fault_of_model(script, "(" + model + ")").empty()) return false;
      proof_.counterexample = words;
      proof_.given = text_of(function_(words));
      return true;
    }
    return false;
  }

  static End end_of(const Path& path) {
    return path.divide_error ? End::divide_error
           : path.traps      ? End::bad_instruction
                             : End::returned;
  }

  Paths paths() { return {terms_, paths_, goal_.signature.operands}; }

  const Goal& goal_;
  const Image& image_;
  const Ask& ask_;
  Frame frame_;
  Function function_;
  sym::Terms terms_;
  std::vector<Path> paths_;
  GoalProof proof_;
};

}  // namespace

Words operands_of(const Signature& signature, std::uint64_t number) {
  // Of zeros alone: 0 / 0 is a case of its own.
  if (number == 0) return Words(signature.operands.size());
  cases::Draw draw(0xfeed, number);
  Words words;
  for (const Parameter& p : signature.operands) {
    const std::uint64_t ones = ~std::uint64_t{0} >> (64 - p.bits);
    const std::uint64_t top = std::uint64_t{1} << (p.bits - 1);
    const std::array<std::uint64_t, 8> edges{0, 1, ones, top, top - 1, top + 1, top / 2, ones - 1};
    const auto magnitude = static_cast<std::uint64_t>(draw.magnitude(std::min(p.bits, 62)));
    const std::uint64_t word = draw.below(4) == 0 ? edges.at(draw.below(edges.size()))
                               : draw.coin()      ? draw.bits()
                               : draw.coin()      ? 0 - magnitude
                                                  : magnitude;
    words.push_back(word & ones);
  }
  return words;
}

GoalProof prove(const Goal& goal, const Image& image, const Ask& ask) {
  return Prover(goal, image, ask).prove();
}

}  // namespace fixproof::judge
