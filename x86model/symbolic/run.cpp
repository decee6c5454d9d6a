#include "x86model/symbolic/run.hpp"

#include <numeric>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "x86model/cosine_table.hpp"
#include "x86model/run.hpp"
#include "x86model/symbolic/evaluate.hpp"
#include "x86model/symbolic/open_memory.hpp"

namespace x86model::symbolic {

namespace {

using Word = Machine<16, WordMemory<16, 0>>;

/// A path in progress.
struct Thread {
  State state;
  Term condition;
  Term in_table;
  std::size_t position = 0;
  std::map<std::size_t, int> jumps;   ///< number of jumps by position
  std::vector<std::uint64_t> values;  ///< of the enumerated operand that take this path
  bool has_begun = false;             ///< whether it has executed an instruction
};

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
        const auto to = pop(thread);
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
        const Outcome outcome = execute(thread, i);
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
    if (paths_.size() + threads_.size() > options_.most_paths) {
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
    if (++thread.jumps[thread.position] > options_.most_jumps) {
      return end(thread, Outcome::step_limit), false;
    }
    if (i.mnemonic == Mnemonic::call && !push(thread, t_.constant(thread.position + 1, 16))) {
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

  /// The address of a memory operand: `origin` is that of its named place, or 0 for an offset in
  /// that place.
  Term address(const Thread& thread, const Operand& o, std::int32_t origin) {
    return t_.add(thread.state.read(t_, o.reg, Size::word),
                  t_.constant(static_cast<std::uint32_t>(o.value + origin) & 0xFFFFU, 16));
  }

  std::optional<Term> table_word(Thread& thread, Term offset) {
    const Term inside = t_.below(offset, t_.constant(4 * cosine_table.size(), 16));
    thread.in_table = t_.both(thread.in_table, t_.both(inside, t_.negation(t_.bit(offset, 0))));
    return t_.apply("cosword", {offset}, 16);
  }

  std::optional<Term> memory_word(const Thread& thread, Term where) const {
    if (!t_.is_constant(where)) return std::nullopt;
    const auto found = thread.state.memory.find(static_cast<std::uint32_t>(t_.value(where)));
    if (found == thread.state.memory.end()) return std::nullopt;
    return found->second;
  }

  bool put(Thread& thread, Term where, Term value) {
    if (!t_.is_constant(where)) return false;
    const auto found = thread.state.memory.find(static_cast<std::uint32_t>(t_.value(where)));
    if (found == thread.state.memory.end()) return false;
    found->second = value;
    return true;
  }

  std::optional<Term> read(Thread& thread, const Operand& o, Size size) {
    const int bits = size == Size::byte ? 8 : size == Size::word ? 16 : 32;
    if (o.kind == Operand::Kind::reg) return thread.state.read(t_, o.reg, size);
    if (o.kind == Operand::Kind::immediate) {
      return t_.constant(x86model::detail::immediate<Word>(o), bits);
    }
    if (options_.memory_is_open) return open_memory::read(t_, thread.state, o, size);
    if (size == Size::byte) return std::nullopt;
    // The cosine table is the only data in the code segment.
    const bool in_table = o.segment == SegmentOverride::cs && o.symbol == Symbol::cos_table;
    const Term where = address(thread, o, in_table ? 0 : address_of(o.symbol));
    const auto word = [&](Term at) {
      return in_table ? table_word(thread, at) : memory_word(thread, at);
    };
    const auto low = word(where);
    if (size == Size::word || !low) return low;
    const auto high = word(t_.add(where, t_.constant(2, 16)));
    if (!high) return high;
    return t_.concat(*high, *low);
  }

  bool write(Thread& thread, const Operand& o, Size size, Term value) {
    if (o.kind == Operand::Kind::reg) {
      thread.state.write(t_, o.reg, size, value);
      return true;
    }
    if (o.kind != Operand::Kind::memory || o.segment != SegmentOverride::none) return false;
    if (options_.memory_is_open) {
      open_memory::write(t_, thread.state, o, value);
      return true;
    }
    if (size == Size::byte) return false;
    const Term where = address(thread, o, address_of(o.symbol));
    if (!put(thread, where, t_.extract(value, 0, 16))) return false;
    return size == Size::word ||
           put(thread, t_.add(where, t_.constant(2, 16)), t_.extract(value, 16, 16));
  }

  bool push(Thread& thread, Term value) {
    const Term top = t_.sub(thread.state.read(t_, Register::sp, Size::word), t_.constant(2, 16));
    thread.state.write(t_, Register::sp, Size::word, top);
    return put(thread, top, value);
  }

  std::optional<Term> pop(Thread& thread) {
    const Term top = thread.state.read(t_, Register::sp, Size::word);
    const auto value = memory_word(thread, top);
    thread.state.write(t_, Register::sp, Size::word, t_.add(top, t_.constant(2, 16)));
    return value;
  }

  /// The effect of a call of FixedMul, with its arguments on the stack.
  bool fixed_mul(Thread& thread) {
    State& s = thread.state;
    const Term top = s.read(t_, Register::sp, Size::word);
    if (!t_.is_constant(top)) return false;
    std::array<Term, 4> words;
    for (std::size_t i = 0; i < words.size(); ++i) {
      const auto word = memory_word(thread, t_.add(top, t_.constant(2 * i, 16)));
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

  Outcome execute(Thread& thread, const Instruction& i) {
    using namespace x86model::detail;
    const Mnemonic op = i.mnemonic;
    const Operand& first = i.operands[0];
    const Size size = first.size;
    if (op == Mnemonic::mov) {
      const auto value = read(thread, i.operands[1], size);
      return done(value && write(thread, first, size, *value));
    }
    if (op == Mnemonic::push) {
      const auto value = read(thread, first, size);
      return done(value && push(thread, *value));
    }
    if (op == Mnemonic::pop) {
      const auto value = pop(thread);
      return done(value && write(thread, first, size, *value));
    }
    if (is_store_string(op)) {
      if (!options_.memory_is_open) return Outcome::bad_address;
      open_memory::store_string(t_, thread.state, op == Mnemonic::stosb ? Size::byte : Size::word);
      return Outcome::proceeds;
    }
    if (is_multiply(op)) return multiplied(thread, i);
    if (is_divide(op)) return divided(thread, i);
    return computed(thread, i);
  }

  static Outcome done(bool well) { return well ? Outcome::proceeds : Outcome::bad_address; }

  /// Executes the instructions that replace their first operand.
  Outcome computed(Thread& thread, const Instruction& i) {
    using namespace x86model::detail;
    const Mnemonic op = i.mnemonic;
    const Size size = i.operands[0].size;
    FlagTerms& flags = thread.state.flags;
    const bool with_carry = op == Mnemonic::adc || op == Mnemonic::sbb;
    if (with_carry && !flags.carry) return Outcome::undefined_flag;
    const auto a = read(thread, i.operands[0], size);
    if (!a) return Outcome::bad_address;
    const Term none = t_.truth(false);
    Result result{*a, {}};
    if (is_shift(op) || is_double_shift(op)) {
      const Operand& amount = i.operands[is_shift(op) ? 1 : 2];
      const int count = static_cast<int>(immediate<Word>(amount) & 31U);
      if (count == 0) return Outcome::proceeds;
      if (is_shift(op)) {
        result = shift(t_, op, *a, count);
      } else {
        const auto fill = read(thread, i.operands[1], size);
        if (!fill) return Outcome::bad_address;
        result = double_shift(t_, op, *a, *fill, count);
      }
    } else if (is_one_operand(op)) {
      const Term one = t_.constant(1, t_.width(*a));
      if (op == Mnemonic::neg) result = sub(t_, t_.constant(0, t_.width(*a)), *a, none);
      if (op == Mnemonic::inc) result = add(t_, *a, one, none);
      if (op == Mnemonic::dec) result = sub(t_, *a, one, none);
    } else {
      const auto b = read(thread, i.operands[1], size);
      if (!b) return Outcome::bad_address;
      if (op == Mnemonic::add) result = add(t_, *a, *b, none);
      if (op == Mnemonic::adc) result = add(t_, *a, *b, *flags.carry);
      if (op == Mnemonic::sub || op == Mnemonic::cmp) result = sub(t_, *a, *b, none);
      if (op == Mnemonic::sbb) result = sub(t_, *a, *b, *flags.carry);
      if (op == Mnemonic::and_) result = logic(t_, t_.bit_and(*a, *b));
      if (op == Mnemonic::xor_) result = logic(t_, t_.bit_xor(*a, *b));
    }
    if (op != Mnemonic::cmp && !write(thread, i.operands[0], size, result.value)) {
      return Outcome::bad_address;
    }
    if (op == Mnemonic::inc || op == Mnemonic::dec) result.flags.carry = flags.carry;
    if (op == Mnemonic::rol) {
      result.flags.zero = flags.zero;
      result.flags.sign = flags.sign;
    }
    flags = result.flags;
    return Outcome::proceeds;
  }

  Outcome multiplied(Thread& thread, const Instruction& i) {
    const Size size = i.operands[0].size;
    const auto b = read(thread, i.operands[0], size);
    if (!b) return Outcome::bad_address;
    const Term a = thread.state.read(t_, Register::ax, size);
    const Result result = multiply(t_, i.mnemonic, a, *b);
    const int bits = t_.width(a);
    thread.state.write(t_, Register::ax, size, t_.extract(result.value, 0, bits));
    thread.state.write(t_, Register::dx, size, t_.extract(result.value, bits, bits));
    thread.state.flags = result.flags;
    return Outcome::proceeds;
  }

  Outcome divided(Thread& thread, const Instruction& i) {
    const Size size = i.operands[0].size;
    const auto divisor = read(thread, i.operands[0], size);
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
