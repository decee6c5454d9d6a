#include "verify/proof/step_proof.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "x86model/run.hpp"
#include "x86model/symbolic/run.hpp"
#include "x86model/symbolic/smt.hpp"

namespace fixproof::proof {

namespace {

namespace x86 = x86model;
namespace sym = x86model::symbolic;
using x86::Counting;
using x86::Loop;
using x86::LoopForm;
using x86::Register;
using x86::Size;

/// All registers except ESP. A loop may change or must preserve them.
constexpr std::array<std::pair<Register, const char*>, 7> open_registers{{{Register::ax, "eax"},
                                                                          {Register::bx, "ebx"},
                                                                          {Register::cx, "ecx"},
                                                                          {Register::dx, "edx"},
                                                                          {Register::si, "esi"},
                                                                          {Register::di, "edi"},
                                                                          {Register::bp, "ebp"}}};

struct WantedStore {
  bool extra;
  std::string address;
  std::string value;
  int width;
};

/// One turn: the registers after it in the order of open_registers, the stores and the condition
/// for them, and the condition for another turn.
struct Turn {
  std::array<std::string, open_registers.size()> after;
  std::string drawn = "true";
  std::vector<WantedStore> stores;
  std::string more;
};

std::string bits(const std::string& word, int high, int low) {
  return fmt::format("((_ extract {} {}) {})", high, low, word);
}
std::string sum(const std::string& a, const std::string& b) {
  return fmt::format("(bvadd {} {})", a, b);
}
std::string low(const std::string& word) { return bits(word, 15, 0); }
std::string with_low(const std::string& word, const std::string& half) {
  return fmt::format("(concat {} {})", bits(word, 31, 16), half);
}
std::string low_sum(const std::string& a, const std::string& b) {
  return with_low(a, sum(low(a), b));
}
std::string widened(const std::string& word) {
  return fmt::format("((_ zero_extend 16) {})", word);
}
std::string minus_one(const std::string& word, int width) {
  return fmt::format("(bvsub {} (_ bv1 {}))", word, width);
}
/// The second byte of a register, such as DH of EDX.
std::string second_byte(const std::string& word) { return bits(word, 15, 8); }

/// Adds the step to a value: 32 bits on a 386, 16 on an 8088.
std::string stepped(const LoopForm& form, const std::string& value, const std::string& step) {
  return form.target == x86::Target::i386 ? sum(value, step) : low_sum(value, low(step));
}

void count(const LoopForm& form, Turn& turn) {
  std::string& ecx = turn.after[2];
  ecx = "ecx";
  turn.more = "true";
  if (form.counting == Counting::unrolled) return;
  const bool whole = form.counting == Counting::dec_jnz && form.target == x86::Target::i386;
  ecx = whole ? minus_one("ecx", 32) : with_low("ecx", minus_one(low("ecx"), 16));
  turn.more =
      whole ? "(distinct ecx (_ bv1 32))" : fmt::format("(distinct {} (_ bv1 16))", low("ecx"));
}

std::string al_set(const std::string& pixel) {
  return fmt::format("(concat {} {})", bits("eax", 31, 8), pixel);
}

/// EBX after the shift. The repaired shift leaves the depth's upper 24 bits; the top byte is
/// don't-care.
std::string shifted_depth(bool as_printed) {
  return as_printed ? fmt::format("(concat {} {})", bits("edx", 23, 0), bits("ebx", 31, 24))
                    : fmt::format("(concat (_ bv0 8) {})", bits("edx", 31, 8));
}

Turn turn_of(const LoopForm& form) {
  Turn turn{.after = {"eax", "ebx", "ecx", "edx", "esi", "edi", "ebp"}, .stores = {}, .more = {}};
  auto& [eax, ebx, ecx, edx, esi, edi, ebp] = turn.after;
  count(form, turn);
  const std::string place = widened(low("edi"));
  switch (form.loop) {
    case Loop::gouraud_byte:
      eax = al_set(second_byte("edx"));
      edx = low_sum("edx", low("ebp"));
      edi = low_sum("edi", "(_ bv1 16)");
      turn.stores = {{true, place, second_byte("edx"), 8}};
      break;
    case Loop::gouraud_word: {
      const std::string once = stepped(form, "edx", "ebp");
      const std::string pair = fmt::format("(concat {} {})", second_byte(once), second_byte("edx"));
      eax = with_low("eax", pair);
      edx = stepped(form, once, "ebp");
      edi = low_sum("edi", "(_ bv2 16)");
      turn.stores = {{true, place, pair, 16}};
      break;
    }
    case Loop::texture: {
      const std::string texel =
          fmt::format("(concat {} {})", second_byte("esi"), second_byte("edx"));
      const std::string pixel = fmt::format("(databyte {})", widened(sum(texel, "(_ bv256 16)")));
      const std::string in_memory = "(concat (dataword (_ bv114 32)) (dataword (_ bv112 32)))";
      eax = al_set(pixel);
      ebx = with_low("ebx", texel);
      edx = stepped(form, "edx", "ebp");
      esi = stepped(form, "esi", form.counting == Counting::unrolled ? "ecx" : in_memory);
      edi = low_sum("edi", "(_ bv1 16)");
      turn.stores = {{true, place, pixel, 8}};
      break;
    }
    case Loop::depth_test: {
      ebx = shifted_depth(form.as_printed);
      edx = sum("edx", "ebp");
      edi = sum("edi", "(_ bv1 32)");
      const std::string index = "(bvadd (bvmul (_ bv2 32) edi) (_ bv1280 32))";
      turn.drawn = fmt::format("(bvsgt {} (dataword {}))", low(ebx), index);
      turn.stores = {{false, sum("edi", "(_ bv256 32)"), bits("eax", 7, 0), 8},
                     {false, index, low(ebx), 16}};
      break;
    }
  }
  return turn;
}

/// A machine with free registers and only the return address on its stack.
sym::State open_state(sym::Terms& terms) {
  sym::State state{};
  for (const auto& [r, name] : open_registers) {
    state.registers.at(static_cast<std::size_t>(r)) = terms.variable(name, 32);
  }
  constexpr std::uint32_t top = 0x5E;
  state.registers.at(static_cast<std::size_t>(Register::sp)) = terms.constant(top, 32);
  state.memory[top] = terms.constant(x86::return_to_caller<16>, 16);
  return state;
}

sym::RunOptions one_turn(const LoopForm& form, const x86::Program& program) {
  sym::RunOptions options{.memory_is_open = true};
  if (form.counting == Counting::unrolled) {
    options.first = 1;
    options.stop = program.size - 1;
  } else {
    options.first = form.loop == Loop::gouraud_word ? 1 : 0;
    options.stop = options.first;
  }
  return options;
}

constexpr const char* memory_functions =
    "(declare-fun databyte ((_ BitVec 32)) (_ BitVec 8))\n"
    "(declare-fun dataword ((_ BitVec 32)) (_ BitVec 16))\n";

std::string equality(const sym::Terms& terms, sym::Term term, const std::string& wanted) {
  return fmt::format(" (= {} {})", sym::name_in_smt(terms, term), wanted);
}

/// States that a path stores the specified values. Adds its terms to `roots`.
std::string stores_right(const sym::Terms& terms, const sym::State& state, const Turn& turn,
                         std::vector<sym::Term>& roots) {
  if (state.stores.empty()) return fmt::format(" (not {})", turn.drawn);
  if (state.stores.size() != turn.stores.size()) return " false";
  std::string text = " " + turn.drawn;
  for (std::size_t i = 0; i < turn.stores.size(); ++i) {
    const sym::Store& store = state.stores[i];
    const WantedStore& wanted = turn.stores[i];
    // The solver would reject a comparison of different widths.
    if (store.extra != wanted.extra || terms.width(store.value) != wanted.width) return " false";
    roots.insert(roots.end(), {store.address, store.value});
    text += equality(terms, store.address, wanted.address);
    text += equality(terms, store.value, wanted.value);
  }
  return text;
}

/// States that a path ends as specified. Adds its terms to `roots`.
std::string path_right(const LoopForm& form, sym::Terms& terms, const sym::Path& path,
                       const Turn& turn, std::vector<sym::Term>& roots) {
  const bool goes_on = path.outcome == x86::Outcome::proceeds;
  if (!goes_on && path.outcome != x86::Outcome::returned) return "false";
  std::string right = goes_on ? " " + turn.more : fmt::format(" (not {})", turn.more);
  for (std::size_t i = 0; i < open_registers.size(); ++i) {
    const sym::Term value = path.state.read(terms, open_registers[i].first, Size::dword);
    roots.push_back(value);
    const bool is_ebx = open_registers.at(i).first == Register::bx;
    if (is_ebx && form.loop == Loop::depth_test && !form.as_printed) {
      // The top byte is left over from an earlier depth, and nothing reads it.
      right += fmt::format(" (= {} {})", bits(sym::name_in_smt(terms, value), 23, 0),
                           bits("edx", 31, 8));
    } else {
      right += equality(terms, value, turn.after.at(i));
    }
  }
  // RET pops the return address.
  const sym::Term sp = path.state.read(terms, Register::sp, Size::word);
  roots.push_back(sp);
  right += equality(terms, sp, goes_on ? "(_ bv94 16)" : "(_ bv96 16)");
  return fmt::format("(and{}{})", right, stores_right(terms, path.state, turn, roots));
}

std::string script(const sym::Terms& terms, const std::vector<sym::Term>& roots,
                   const std::string& question) {
  return fmt::format("(set-logic QF_UFBV)\n{}{}{}(assert {})\n(check-sat)\n", memory_functions,
                     sym::declare_variables(terms, roots), sym::define(terms, roots), question);
}

/// All registers, so that the script declares even those on which a path does not depend.
std::vector<sym::Term> all_registers(sym::Terms& terms) {
  std::vector<sym::Term> all;
  for (const auto& [r, name] : open_registers) all.push_back(terms.variable(name, 32));
  return all;
}

/// States that GouraudWords halves the count before its first turn and changes nothing else, for
/// counts that are not negative.
std::string halving_question(const LoopForm& form, const x86::Program& program) {
  sym::Terms terms;
  std::vector<sym::Term> roots = all_registers(terms);
  std::string right;
  const auto paths = sym::run(terms, program.instructions(), open_state(terms),
                              {.memory_is_open = true, .stop = 1});
  for (const sym::Path& path : paths) {
    right += fmt::format(" {}", path.outcome == x86::Outcome::proceeds);
    for (const auto& [r, name] : open_registers) {
      roots.push_back(path.state.read(terms, r, Size::dword));
      const bool is_count = r == Register::cx;
      const std::string half = form.target == x86::Target::i386
                                   ? "(bvlshr ecx (_ bv1 32))"
                                   : with_low("ecx", "(bvlshr ((_ extract 15 0) ecx) (_ bv1 16))");
      right += equality(terms, roots.back(), is_count ? half : name);
    }
  }
  const int top = form.target == x86::Target::i386 ? 31 : 15;
  return script(terms, roots,
                fmt::format("(and (= {} #b0) (not (and true{})))", bits("ecx", top, top), right));
}

}  // namespace

std::vector<std::string> step_questions(const LoopForm& form, const x86::Program& program) {
  sym::Terms terms;
  const Turn turn = turn_of(form);
  const sym::State start = open_state(terms);
  std::vector<std::string> scripts;
  std::string ways;
  std::vector<sym::Term> conditions = all_registers(terms);
  for (const sym::Path& path :
       sym::run(terms, program.instructions(), start, one_turn(form, program))) {
    std::vector<sym::Term> roots = all_registers(terms);
    roots.push_back(path.condition);
    const std::string right = path_right(form, terms, path, turn, roots);
    scripts.push_back(
        script(terms, roots,
               fmt::format("(and {} (not {}))", sym::name_in_smt(terms, path.condition), right)));
    conditions.push_back(path.condition);
    ways += ' ' + sym::name_in_smt(terms, path.condition);
  }
  scripts.push_back(script(terms, conditions, fmt::format("(not (or false{}))", ways)));
  if (one_turn(form, program).first == 1 && form.counting != Counting::unrolled) {
    scripts.push_back(halving_question(form, program));
  }
  return scripts;
}

std::string depth_comment_question(const LoopForm& form) {
  sym::Terms terms;
  const x86::Program program = x86::assemble(x86::listing(form), {});
  sym::RunOptions options = one_turn(form, program);
  // Runs the shift alone.
  options.stop = 1;
  const auto paths = sym::run(terms, program.instructions(), open_state(terms), options);
  std::vector<sym::Term> roots = all_registers(terms);
  roots.push_back(paths.front().state.read(terms, Register::bx, Size::word));
  return script(
      terms, roots,
      fmt::format("(distinct {} {})", sym::name_in_smt(terms, roots.back()), bits("edx", 23, 8)));
}

}  // namespace fixproof::proof
