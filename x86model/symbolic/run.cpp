#include "x86model/symbolic/run.hpp"

#include <numeric>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "x86model/run.hpp"
#include "x86model/symbolic/evaluate.hpp"
#include "x86model/symbolic/machine.hpp"
#include "x86model/symbolic/thread.hpp"

namespace x86model::symbolic {

namespace {

class Runner {
 public:
  Runner(Terms& terms, std::span<const Instruction> code, const RunOptions& options)
      : t_(terms), code_(code), options_(options), evaluation_(terms, concrete) {}

  std::vector<Path> all(const State& start) {
    threads_.push_back({start, t_.truth(true), t_.truth(true), options_.first, {}, {}, false});
    if (options_.enumerated) {
      auto& values = threads_.back().values;
      values.resize(std::size_t{1} << t_.width(*options_.enumerated));
      std::iota(values.begin(), values.end(), std::uint64_t{0});
    }
    while (!threads_.empty()) {
      Thread thread = std::move(threads_.back());
      threads_.pop_back();
      follow(std::move(thread));
    }
    return std::move(paths_);
  }

 private:
  ListingMachine machine_of(Thread& thread) {
    return {t_, thread.state, thread.in_table, options_.memory_is_open};
  }

  /// Follows one thread to its end; branches become new threads.
  void follow(Thread thread) {
    while (true) {
      if (thread.position >= code_.size()) return end(thread, Outcome::bad_address);
      if (thread.has_begun && options_.stop == thread.position) {
        return end(thread, Outcome::proceeds);
      }
      thread.has_begun = true;
      const Instruction& i = code_[thread.position];
      ListingMachine m = machine_of(thread);
      if (i.mnemonic == Mnemonic::ret) {
        Term to;
        if (!m.pop(to) || !t_.is_constant(to)) return end(thread, Outcome::bad_address);
        if (t_.value(to) == return_to_caller<16>) return end(thread, Outcome::returned);
        thread.position = t_.value(to);
      } else if (i.mnemonic == Mnemonic::call && options_.calls_are_fixed_mul) {
        const auto to = static_cast<std::size_t>(i.operands[0].value);
        const bool calls_it = to < code_.size() && code_[to].is_procedure &&
                              std::string_view(code_[to].label) == "FixedMul";
        if (!calls_it || !fixed_mul(thread)) return end(thread, Outcome::bad_address);
        ++thread.position;
      } else if (is_control_flow(i.mnemonic)) {
        if (!jump(thread, i)) return;
      } else {
        const Outcome outcome = execute_any(i, m);
        if (outcome != Outcome::proceeds) return end(thread, outcome);
        if (m.fault) split_off(thread, std::move(*m.fault));
        ++thread.position;
      }
    }
  }

  /// Ends the path of the operands for which a divide faults.
  void split_off(Thread& thread, Machine::Fault fault) {
    paths_.push_back({t_.both(thread.condition, fault.condition), thread.in_table,
                      Outcome::divide_error, thread.position, std::move(fault.state)});
    thread.condition = t_.both(thread.condition, t_.negation(fault.condition));
  }

  void end(Thread& thread, Outcome outcome) {
    paths_.push_back(
        {thread.condition, thread.in_table, outcome, thread.position, std::move(thread.state)});
  }

  /// Splits a thread at a jump and keeps the sides that some operand takes.
  void branch(Thread thread, Term condition, std::size_t to) {
    if (paths_.size() + threads_.size() > options_.max_paths) {
      return end(thread, Outcome::step_limit);
    }
    Thread other = thread;
    other.condition = t_.both(thread.condition, condition);
    other.position = to;
    thread.condition = t_.both(thread.condition, t_.negation(condition));
    ++thread.position;
    if (options_.enumerated && t_.depends_only_on(*options_.enumerated, condition)) {
      const std::string& name = t_[*options_.enumerated].name;
      const auto jumps = [&](std::uint64_t value) {
        evaluation_.set(name, value);
        return evaluation_(condition) != 0;
      };
      std::erase_if(other.values, [&](std::uint64_t value) { return !jumps(value); });
      std::erase_if(thread.values, jumps);
      if (!other.values.empty()) threads_.push_back(std::move(other));
      if (!thread.values.empty()) threads_.push_back(std::move(thread));
      return;
    }
    const auto follow_later = [&](Thread& t) {
      if (!t_.is_constant(t.condition) || t_.value(t.condition) != 0) {
        threads_.push_back(std::move(t));
      }
    };
    follow_later(other);
    follow_later(thread);
  }

  /// @return false if the thread has ended or was split
  bool jump(Thread& thread, const Instruction& i) {
    // The target of a computed jump depends on instruction lengths, which are not modelled here.
    if (i.operands[0].kind == Operand::Kind::reg) return end(thread, Outcome::bad_address), false;
    const auto to = static_cast<std::size_t>(i.operands[0].value);
    ListingMachine m = machine_of(thread);
    Term taken;
    if (i.mnemonic == Mnemonic::loop) {
      taken = count_down(m);
    } else if (jump_taken(m.domain(), i.mnemonic, m.flags, taken) != Outcome::proceeds) {
      return end(thread, Outcome::undefined_flag), false;
    }
    if (++thread.jumps[thread.position] > options_.max_jumps) {
      return end(thread, Outcome::step_limit), false;
    }
    if (i.mnemonic == Mnemonic::call && !m.push(t_.constant(thread.position + 1, 16))) {
      return end(thread, Outcome::bad_address), false;
    }
    if (!t_.is_constant(taken)) return branch(std::move(thread), taken, to), false;
    thread.position = t_.value(taken) != 0 ? to : thread.position + 1;
    return true;
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

  Terms& t_;
  std::span<const Instruction> code_;
  const RunOptions& options_;
  Evaluation evaluation_;
  std::vector<Thread> threads_;
  std::vector<Path> paths_;
  std::uint64_t unknowns_ = 0;
};

}  // namespace

std::vector<Path> run(Terms& terms, std::span<const Instruction> code, const State& start,
                      const RunOptions& options) {
  return Runner(terms, code, options).all(start);
}

}  // namespace x86model::symbolic
