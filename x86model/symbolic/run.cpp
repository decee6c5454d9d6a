#include "x86model/symbolic/run.hpp"

#include <cstdint>
#include <string_view>
#include <utility>

#include "x86model/run.hpp"
#include "x86model/symbolic/explorer.hpp"
#include "x86model/symbolic/machine.hpp"

namespace x86model::symbolic {

namespace {

class Runner : public Explorer<Path> {
 public:
  Runner(Terms& terms, std::span<const Instruction> code, const RunOptions& options)
      : Explorer(terms, options.max_paths, options.enumerated), code_(code), options_(options) {}

 private:
  ListingMachine machine_of(Thread& thread) {
    return {t_, thread.state, thread.in_table, options_.memory_is_open};
  }

  bool step(Thread& thread) override {
    if (thread.position >= code_.size()) return end(thread, Outcome::bad_address);
    if (thread.steps > 1 && options_.stop == thread.position) return end(thread, Outcome::proceeds);
    const Instruction& i = code_[thread.position];
    ListingMachine m = machine_of(thread);
    if (i.mnemonic == Mnemonic::ret) {
      Term to;
      if (!m.pop(to) || !t_.is_constant(to)) return end(thread, Outcome::bad_address);
      if (t_.value(to) == return_to_caller<16>) return end(thread, Outcome::returned);
      thread.position = t_.value(to);
      return true;
    }
    if (i.mnemonic == Mnemonic::call && options_.calls_are_fixed_mul) {
      const auto to = static_cast<std::size_t>(i.operands[0].value);
      const bool calls_it = to < code_.size() && code_[to].is_procedure &&
                            std::string_view(code_[to].label) == "FixedMul";
      if (!calls_it || !fixed_mul(thread)) return end(thread, Outcome::bad_address);
      ++thread.position;
      return true;
    }
    if (is_control_flow(i.mnemonic)) return transfer(thread, i);
    const Outcome outcome = execute_any(i, m);
    if (outcome != Outcome::proceeds) return end(thread, outcome);
    if (m.fault) {
      paths_.push_back({take_off(thread, m.fault->condition), thread.in_table,
                        Outcome::divide_error, thread.position, std::move(m.fault->state)});
    }
    ++thread.position;
    return true;
  }

  void give_up(Thread& thread) override { end(thread, Outcome::step_limit); }

  /// @return false, because the thread does not go on
  bool end(Thread& thread, Outcome outcome) {
    paths_.push_back(
        {thread.condition, thread.in_table, outcome, thread.position, std::move(thread.state)});
    return false;
  }

  /// A jump or a call. @return whether the thread goes on
  bool transfer(Thread& thread, const Instruction& i) {
    // The target of a computed jump depends on instruction lengths, which are not modelled here.
    if (i.operands[0].kind == Operand::Kind::reg) return end(thread, Outcome::bad_address);
    const auto to = static_cast<std::size_t>(i.operands[0].value);
    ListingMachine m = machine_of(thread);
    Term taken;
    if (i.mnemonic == Mnemonic::loop) {
      taken = count_down(m);
    } else if (jump_taken(m.domain(), i.mnemonic, m.flags, taken) != Outcome::proceeds) {
      return end(thread, Outcome::undefined_flag);
    }
    if (++thread.jumps[thread.position] > options_.max_jumps) {
      return end(thread, Outcome::step_limit);
    }
    if (i.mnemonic == Mnemonic::call && !m.push(t_.constant(thread.position + 1, 16))) {
      return end(thread, Outcome::bad_address);
    }
    return jump(thread, taken, to, thread.position + 1);
  }

  /// The effect of a call of FixedMul, with its arguments on the stack.
  bool fixed_mul(Thread& thread) {
    State& s = thread.state;
    const Term top = s.read(t_, Register::sp, Size::word);
    if (!t_.is_constant(top)) return false;
    std::array<Term, 4> words;
    for (std::size_t i = 0; i < words.size(); ++i) {
      const Term at = t_.add(top, t_.constant(2 * i, 16));
      if (!machine_of(thread).read_word(at, words[i])) return false;
    }
    const Term product =
        t_.apply("fixedmul", {t_.concat(words[1], words[0]), t_.concat(words[3], words[2])}, 32);
    s.write(t_, Register::ax, Size::word, t_.extract(product, 0, 16));
    s.write(t_, Register::dx, Size::word, t_.extract(product, 16, 16));
    for (const Register r : {Register::bx, Register::cx}) s.write(t_, r, Size::word, unknown());
    s.flags = {};
    // FixedMul may overwrite the stack below.
    for (auto& [at, word] : s.memory) {
      if (at < t_.value(top)) word = unknown();
    }
    return true;
  }

  Term unknown() { return t_.variable(numbered("unknown", unknowns_++), 16); }

  std::span<const Instruction> code_;
  const RunOptions& options_;
  std::uint64_t unknowns_ = 0;
};

}  // namespace

std::vector<Path> run(Terms& terms, std::span<const Instruction> code, const State& start,
                      const RunOptions& options) {
  const Term yes = terms.truth(true);
  return Runner(terms, code, options)
      .all({.state = start, .condition = yes, .in_table = yes, .position = options.first});
}

}  // namespace x86model::symbolic
