#include "x86model/symbolic/run.hpp"

#include <numeric>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "x86model/run.hpp"
#include "x86model/symbolic/evaluate.hpp"
#include "x86model/symbolic/execute.hpp"

namespace x86model::symbolic {

namespace {

class Runner {
 public:
  Runner(Terms& terms, std::span<const Instruction> code, const RunOptions& options)
      : t_(terms),
        code_(code),
        options_(options),
        operands_(terms, options.memory_is_open),
        evaluation_(terms, concrete) {}

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
  /// Follows one thread to its end; branches become new threads.
  void follow(Thread thread) {
    while (true) {
      if (thread.position >= code_.size()) return end(thread, Outcome::bad_address);
      if (thread.has_begun && options_.stop == thread.position) {
        return end(thread, Outcome::proceeds);
      }
      thread.has_begun = true;
      const Instruction& i = code_[thread.position];
      if (i.mnemonic == Mnemonic::ret) {
        const auto to = operands_.pop(thread);
        if (!to || !t_.is_constant(*to)) return end(thread, Outcome::bad_address);
        if (t_.value(*to) == return_to_caller<16>) return end(thread, Outcome::returned);
        thread.position = t_.value(*to);
      } else if (i.mnemonic == Mnemonic::call && options_.calls_are_fixed_mul) {
        const auto to = static_cast<std::size_t>(i.operands[0].value);
        const bool calls_it = to < code_.size() && code_[to].is_procedure &&
                              std::string_view(code_[to].label) == "FixedMul";
        if (!calls_it || !fixed_mul(thread)) return end(thread, Outcome::bad_address);
        ++thread.position;
      } else if (is_control_flow(i.mnemonic)) {
        if (!jump(thread, i)) return;
      } else {
        const Outcome outcome = x86model::detail::is_divide(i.mnemonic)
                                    ? divided(thread, i)
                                    : execute(t_, operands_, thread, i);
        if (outcome != Outcome::proceeds) return end(thread, outcome);
        ++thread.position;
      }
    }
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
    const auto condition = i.mnemonic == Mnemonic::loop ? std::optional(count_down(thread))
                                                        : taken(t_, i.mnemonic, thread.state.flags);
    if (!condition) return end(thread, Outcome::undefined_flag), false;
    if (++thread.jumps[thread.position] > options_.max_jumps) {
      return end(thread, Outcome::step_limit), false;
    }
    if (i.mnemonic == Mnemonic::call &&
        !operands_.push(thread, t_.constant(thread.position + 1, 16))) {
      return end(thread, Outcome::bad_address), false;
    }
    if (!t_.is_constant(*condition)) return branch(std::move(thread), *condition, to), false;
    thread.position = t_.value(*condition) != 0 ? to : thread.position + 1;
    return true;
  }

  /// LOOP: decrements CX. @return whether it is not 0 afterwards
  Term count_down(Thread& thread) {
    const Term count = t_.sub(thread.state.read(t_, Register::cx, Size::word), t_.constant(1, 16));
    thread.state.write(t_, Register::cx, Size::word, count);
    return t_.negation(t_.equal(count, t_.constant(0, 16)));
  }

  /// The effect of a call of FixedMul, with its arguments on the stack.
  bool fixed_mul(Thread& thread) {
    State& s = thread.state;
    const Term top = s.read(t_, Register::sp, Size::word);
    if (!t_.is_constant(top)) return false;
    std::array<Term, 4> words;
    for (std::size_t i = 0; i < words.size(); ++i) {
      const auto word = operands_.memory_word(thread, t_.add(top, t_.constant(2 * i, 16)));
      if (!word) return false;
      words[i] = *word;
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

  /// Executes a divide; if it may fault, the faulting path ends here.
  Outcome divided(Thread& thread, const Instruction& i) {
    const Size size = i.operands[0].size;
    const auto divisor = operands_.read(thread, i.operands[0], size);
    if (!divisor) return Outcome::bad_address;
    const Term dividend = t_.concat(thread.state.read(t_, Register::dx, size),
                                    thread.state.read(t_, Register::ax, size));
    const Division division = divide(t_, i.mnemonic, dividend, *divisor);
    if (t_.is_constant(division.faults)) {
      if (t_.value(division.faults) != 0) return Outcome::divide_error;
    } else {
      Thread faulting = thread;
      faulting.condition = t_.both(thread.condition, division.faults);
      end(faulting, Outcome::divide_error);
      thread.condition = t_.both(thread.condition, t_.negation(division.faults));
    }
    thread.state.write(t_, Register::ax, size, division.quotient);
    thread.state.write(t_, Register::dx, size, division.remainder);
    thread.state.flags = {};
    return Outcome::proceeds;
  }

  Terms& t_;
  std::span<const Instruction> code_;
  const RunOptions& options_;
  Operands operands_;
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
