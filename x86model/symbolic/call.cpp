#include "x86model/symbolic/call.hpp"

#include "x86model/call.hpp"

namespace x86model::symbolic {

namespace {

using x86model::detail::bytes_of_value;
using x86model::detail::data;
using x86model::detail::stack_top;

bool is_binary(Routine r) { return r == Routine::mul || r == Routine::div; }

/// Builds the caller's state; memory grows as it is written.
class Caller {
 public:
  Caller(Terms& terms, Routine routine) : t_(terms), routine_(routine) {
    for (std::size_t r = 0; r < register_count; ++r) {
      state_.registers[r] = t_.variable(numbered("register", r), 32);
    }
    for (int at = 0; at < stack_top; at += 2) {
      write(at, t_.variable(numbered("stack", static_cast<std::uint64_t>(at)), 16));
    }
  }

  State state() {
    if (is_binary(routine_)) {
      push(operand(1));
      push(operand(0));
    } else if (routine_ == Routine::cossin) {
      push(pointer(out() + bytes_of_value));
      push(pointer(out()));
      push(t_.variable(operand_name(routine_, 0), 16));
    } else {
      for (int i = 0; i < arity(routine_).in; ++i) store(data + i * bytes_of_value, operand(i));
      push(pointer(out()));
      push(pointer(data + 12 * bytes_of_value));
      push(pointer(data));
    }
    for (int i = 0; i < arity(routine_).out; ++i) {
      store(out() + i * bytes_of_value,
            t_.variable(numbered("result", static_cast<std::uint64_t>(i)), 32));
    }
    push(t_.constant(return_to_caller<16>, 16));
    state_.write(t_, Register::sp, Size::word, pointer(top_));
    return state_;
  }

 private:
  [[nodiscard]] int out() const { return data + arity(routine_).in * bytes_of_value; }
  Term pointer(int at) { return t_.constant(static_cast<std::uint64_t>(at), 16); }
  Term operand(int index) { return t_.variable(operand_name(routine_, index), 32); }

  void write(int at, Term word) { state_.memory[static_cast<std::uint32_t>(at)] = word; }
  void store(int at, Term value) {
    write(at, t_.extract(value, 0, 16));
    write(at + 2, t_.extract(value, 16, 16));
  }
  void push(Term value) {
    top_ -= t_.width(value) / 8;
    t_.width(value) == 16 ? write(top_, value) : store(top_, value);
  }

  Terms& t_;
  Routine routine_;
  State state_;
  int top_ = stack_top;
};

}  // namespace

std::string operand_name(Routine routine, int index) {
  constexpr int transform = 12;
  // The elements of the first transform, then those of the second operand.
  const auto element = [index](const char* first, const char* second) {
    const bool in_first = index < transform;
    return numbered(in_first ? first : second,
                    static_cast<std::uint64_t>(in_first ? index : index - transform));
  };
  switch (routine) {
    case Routine::mul:
    case Routine::div:
      return index == 0 ? "a" : "b";
    case Routine::cossin:
      return "angle";
    case Routine::xformvec:
      return element("x", "v");
    case Routine::concat:
      break;
  }
  return element("p", "q");
}

State enter(Terms& terms, Routine routine) { return Caller(terms, routine).state(); }

std::vector<Term> results(Terms& terms, Routine routine, const State& end) {
  const auto word = [&](Register r) { return end.read(terms, r, Size::word); };
  if (is_binary(routine)) return {join(terms, word(Register::dx), word(Register::ax))};
  std::vector<Term> all;
  for (int i = 0; i < arity(routine).out; ++i) {
    const auto at = static_cast<std::uint32_t>(data + (arity(routine).in + i) * bytes_of_value);
    all.push_back(join(terms, end.memory.at(at + 2), end.memory.at(at)));
  }
  return all;
}

Term preserves_state(Terms& terms, Routine routine, const State& start, const State& end) {
  Term kept = terms.truth(true);
  for (const Register r : {Register::si, Register::di, Register::bp}) {
    kept = terms.both(
        kept, terms.equal(start.read(terms, r, Size::dword), end.read(terms, r, Size::dword)));
  }
  const Term top = start.read(terms, Register::sp, Size::word);
  kept = terms.both(kept, terms.equal(terms.add(top, terms.constant(2, 16)),
                                      end.read(terms, Register::sp, Size::word)));
  const bool is_transform = routine == Routine::xformvec || routine == Routine::concat;
  const std::uint64_t first = is_transform ? data : terms.value(top) + 2;
  const std::uint64_t beyond =
      is_transform ? first + static_cast<std::uint64_t>(arity(routine).in * bytes_of_value)
                   : stack_top;
  if (!is_transform && routine != Routine::mul) return kept;
  for (const auto& [at, word] : start.memory) {
    if (at < first || at >= beyond) continue;
    kept = terms.both(kept, terms.equal(word, end.memory.at(at)));
  }
  return kept;
}

}  // namespace x86model::symbolic
