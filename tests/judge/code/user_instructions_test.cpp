// The terms of every instruction of users' code, evaluated for many operands and compared with this
// processor and with Unicorn: registers, faults and flags. Which flags are undefined is compared
// with the tables of Zydis.
#include "judge/code/user_instructions.hpp"

#include <fmt/format.h>

#include "judge/code/abstract_functions.hpp"
#include "judge/code/call.hpp"
#include "judge/code/machine.hpp"
#include "tests/judge/code/bare_processor.hpp"
#include "tests/judge/code/user_forms.hpp"
#include "tests/support/test.hpp"
#include "x86model/symbolic/evaluate.hpp"

namespace fixproof::judge {
namespace {

namespace sym = x86model::symbolic;
using bare_processor::Pieces;
using bare_processor::used_registers;
using user_forms::Feature;
using user_forms::Form;

constexpr int states_of_a_form = 150;
constexpr unsigned sp = 4;

/// The flags that terms have.
constexpr std::array flags{std::pair{x86model::CF, "CF"}, std::pair{x86model::ZF, "ZF"},
                           std::pair{x86model::SF, "SF"}, std::pair{x86model::OF, "OF"}};

std::optional<sym::Term>& flag_of(sym::FlagTerms& terms, std::uint16_t flag) {
  return flag == x86model::CF   ? terms.carry
         : flag == x86model::ZF ? terms.zero
         : flag == x86model::SF ? terms.sign
                                : terms.overflow;
}

/// Code with a stack, as the machines of judge/code take it.
Image image_of(const std::string& code, int bits) {
  Image image{.bits = bits, .container = "test", .memory = {}, .symbols = {}, .missing = {}};
  image.memory.assign(0x4000, unused);
  image.first = image.entry = 0x1000;
  image.end = image.first + static_cast<std::uint32_t>(code.size());
  image.stack_top = 0x2800;
  image.data = image.stack_top;
  image.exit = 0x3F00;  // a page of its own: Unicorn 2.0 leaks where code and stack share one
  std::copy(code.begin(), code.end(), image.memory.begin() + image.first);
  image.memory[image.end] = 0xC3;  // RET
  return image;
}

std::uint32_t top_of(const Image& image) {
  return image.stack_top - static_cast<std::uint32_t>(image.bits / 8);
}

/// What a form makes of any state, as terms.
class Model {
 public:
  /// @throws Obstacle if it is not modelled
  Model(const Image& image, bool knows_flags) : image_(image) {
    for (std::size_t r = 0; r < registers_of(image); ++r) {
      state_.registers.at(r) = terms_.variable(sym::numbered("r", r), image.bits);
    }
    state_.registers[sp] = terms_.constant(top_of(image), image.bits);
    for (const auto& [flag, name] : flags) {
      if (knows_flags) flag_of(state_.flags, flag) = terms_.variable(name, 0);
    }
    for (std::uint32_t at = image.first; at < image.end;) {
      decoded_ = decoded(std::span(image.memory).subspan(at, 15), at, image.bits);
      ImageMachine machine(image, terms_, state_);
      execute_on(machine, decoded_);
      if (machine.fault) fault_ = machine.fault->condition;
      at += decoded_.bytes;
      instructions_.emplace_back(decoded_.mnemonic, decoded_.operands.size());
    }
    for (std::uint32_t id = 0; id < terms_.size(); ++id) {
      const sym::Node& node = terms_[sym::Term{id}];
      if (node.name.starts_with("undefined")) undefined_.push_back(node.name);
      if (node.op == sym::Op::apply) functions_.insert(node.name);
    }
    evaluation_.emplace(terms_, concrete_function);
  }

  using Mnemonics = std::vector<std::pair<std::string, std::size_t>>;

  [[nodiscard]] const Decoded& last() const { return decoded_; }
  /// With the number of their operands.
  [[nodiscard]] const Mnemonics& instructions() const { return instructions_; }
  [[nodiscard]] std::size_t registers() const { return registers_of(image_); }
  [[nodiscard]] sym::FlagTerms& known_flags() { return state_.flags; }
  [[nodiscard]] const std::set<std::string>& functions() const { return functions_; }

  void set(const Registers& before) {
    for (std::size_t r = 0; r < registers_of(image_); ++r) {
      evaluation_->set(sym::numbered("r", r), before.general.at(r));
    }
    for (const auto& [flag, name] : flags) {
      evaluation_->set(name, (before.flags & flag) != 0 ? 1 : 0);
    }
  }
  bool faults() { return fault_ && (*evaluation_)(*fault_) != 0; }
  /// Nothing if it is undefined.
  std::optional<std::uint64_t> register_after(std::size_t r) {
    const auto value = [&](std::uint64_t of_undefined) {
      for (const std::string& name : undefined_) evaluation_->set(name, of_undefined);
      return (*evaluation_)(state_.registers.at(r));
    };
    const std::uint64_t all_zeros = value(0);
    if (undefined_.empty()) return all_zeros;
    return all_zeros == value(~std::uint64_t{0}) ? std::optional(all_zeros) : std::nullopt;
  }
  std::uint64_t flag_after(std::uint16_t flag) {
    return (*evaluation_)(*flag_of(state_.flags, flag));
  }

 private:
  const Image& image_;
  sym::Terms terms_;
  sym::State state_{};
  std::optional<sym::Term> fault_;
  Decoded decoded_;
  Mnemonics instructions_;
  std::vector<std::string> undefined_;
  std::set<std::string> functions_;
  std::optional<sym::Evaluation> evaluation_;
};

std::uint64_t random_word(std::mt19937_64& random) {
  constexpr std::array edges{std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{2},
                             ~std::uint64_t{0}, ~std::uint64_t{1}};
  const std::uint64_t value = random();
  switch (random() % 6) {
    case 0:
      return edges.at(value % edges.size());
    case 1:  // near a power of two
      return (std::uint64_t{1} << value % 64) + random() % 3 - 1;
    case 2:  // any size
      return value >> random() % 64;
    case 3:
      return ~(value >> random() % 64);
    default:
      return value;
  }
}

Registers random_state(std::mt19937_64& random, const Image& image) {
  Registers state;
  for (std::size_t r = 0; r < registers_of(image); ++r) {
    const std::uint64_t word = random_word(random);
    state.general.at(r) = image.bits == 64 ? word : word & 0xFFFFFFFFU;
  }
  state.general[sp] = top_of(image);
  state.flags = static_cast<std::uint32_t>(random()) & x86model::arithmetic_flags;
  return state;
}

std::string described(const Form& form, const Registers& before) {
  std::string text = fmt::format("\"{}\" with flags {:x}", form.text, before.flags);
  for (const std::size_t r : used_registers)
    text += fmt::format(", r{} {:x}", r, before.general[r]);
  return text;
}

/// Compares the model with the state after a call.
void compare(const Form& form, Model& model, const Registers& before, bool faulted,
             const Registers& after, const char* machine) {
  const std::string where = machine + (": " + described(form, before));
  ASSERT_EQ(model.faults(), faulted) << where;
  if (faulted) return;
  for (const std::size_t r : used_registers) {
    if (r >= model.registers()) continue;
    const std::uint64_t is = after.general[r];
    ASSERT_EQ(model.register_after(r).value_or(is), is) << where << ": register " << r;
  }
  for (const auto& [flag, name] : flags) {
    if (!flag_of(model.known_flags(), flag)) continue;
    ASSERT_EQ(model.flag_after(flag), (after.flags & flag) != 0 ? 1U : 0U) << where << ": " << name;
  }
}

/// The flags that a form leaves undefined are those of Zydis, and CF where SHL and SHR may move all
/// bits out of bytes and words: Zydis has it as defined for every count.
void compare_undefined_flags(const Form& form, Model& model) {
  const Decoded& last = model.last();
  if (last.flags.sets == 0) return;
  const bool may_lose_carry =
      (last.mnemonic == "shl" || last.mnemonic == "shr") && last.operands.front().bits < 32;
  const Operand& count = last.operands.empty() ? Operand{} : last.operands.back();
  // Zydis does not take counts modulo 32 or 64.
  const std::uint64_t mask = !last.operands.empty() && last.operands[0].bits == 64 ? 63 : 31;
  const bool has_count = last.mnemonic.starts_with("r") || last.mnemonic.starts_with("s");
  const bool is_masked =
      count.kind == Operand::Kind::immediate && (count.value > mask || count.value == 0);
  if (has_count && is_masked) return;
  for (const auto& [flag, name] : flags) {
    const bool is_defined = flag_of(model.known_flags(), flag).has_value();
    if ((last.flags.leaves_undefined & flag) != 0) {
      EXPECT_FALSE(is_defined) << form.text << " leaves " << name << " undefined";
    } else if (flag != x86model::CF || !may_lose_carry) {
      EXPECT_TRUE(is_defined) << form.text << " defines " << name;
    }
  }
}

/// Unicorn 2.0 takes POPCNT for an invalid instruction, and gives BLSI the CF of BLSR.
bool unicorn_has(const Form& form) {
  return form.feature != Feature::popcnt && !form.text.starts_with("blsi ");
}

/// Compares one form on the machines that have it.
class FormTest {
 public:
  FormTest(const Form& form, const std::string& code, int bits)
      : form_(form), image_(image_of(code, bits)), model_(image_, true) {}

  [[nodiscard]] Model& model() { return model_; }

  void on_this_processor(const Pieces& pieces, std::size_t index, std::mt19937_64& random) {
    for_states(random, [&](const Registers& before) {
      Registers after = before;
      const bool faulted = pieces.call(index, after);
      compare(form_, model_, before, faulted, after, "this processor");
    });
  }

  void on_unicorn(std::mt19937_64& random) {
    on(*make_emulator(image_, nullptr), "Unicorn", random);
  }
  /// Code of 32 bits.
  void on_processor_of_judge(std::mt19937_64& random) {
    on(*make_processor(image_), "this processor", random);
  }

 private:
  template <class Body>
  void for_states(std::mt19937_64& random, const Body& body) {
    for (int i = 0; i < states_of_a_form && !testing::Test::HasFatalFailure(); ++i) {
      const Registers before = random_state(random, image_);
      model_.set(before);
      body(before);
    }
  }

  void on(Machine& machine, const char* name, std::mt19937_64& random) {
    for_states(random, [&](const Registers& before) {
      Registers after = before;
      store(machine.memory() + before.general[sp], image_.exit, image_.bits / 8);
      const Ending ending = machine.call(after);
      ASSERT_TRUE(ending.end == End::returned || ending.end == End::divide_error) << form_.text;
      compare(form_, model_, before, ending.end == End::divide_error, after, name);
    });
  }

  const Form& form_;
  Image image_;
  Model model_;
};

/// Whether a row is that of one of these instructions.
bool is_among(const UserInstruction& row,
              const std::set<std::pair<std::string, std::size_t>>& all) {
  const bool has_condition = row.mnemonic.ends_with("cc");
  const std::string_view name =
      row.mnemonic.substr(0, row.mnemonic.size() - (has_condition ? 2 : 0));
  return std::ranges::any_of(all, [&](const auto& each) {
    return each.second == row.operands &&
           (has_condition ? each.first.starts_with(name) : each.first == name);
  });
}

TEST(UserInstructions, AreThoseOfThisProcessorAndOfUnicorn) {
  const std::vector<Form> forms = user_forms::all_forms();
  const Pieces pieces(forms);
  std::mt19937_64 random(2026);
  std::set<std::pair<std::string, std::size_t>> covered;
  if (const std::string why = bare_processor::absence(); !why.empty()) {
    std::cout << "not compared with this processor: " << why << '\n';
  }
  const auto skip = [](const Form& form, const char* machine) {
    std::string text = form.text;
    std::ranges::replace(text, '\n', ';');
    std::cout << "skipped on " << machine << ": " << text << '\n';
  };
  for (std::size_t i = 0; i < forms.size(); ++i) {
    const Form& form = forms[i];
    SCOPED_TRACE(form.text);
    FormTest test(form, pieces.code(i), 64);
    const auto& instructions = test.model().instructions();
    covered.insert(instructions.begin(), instructions.end());
    if (instructions.size() == 1) compare_undefined_flags(form, test.model());
    if (bare_processor::has(form.feature)) {
      test.on_this_processor(pieces, i, random);
    } else {
      skip(form, "this processor");
    }
    if (unicorn_has(form)) {
      test.on_unicorn(random);
    } else {
      skip(form, "Unicorn");
    }
    if (HasFatalFailure()) return;
  }
  for (const UserInstruction& row : user_instructions()) {
    EXPECT_TRUE(is_among(row, covered)) << row.mnemonic << " has no form";
  }
}

TEST(UserInstructions, Of32BitCodeAreThoseOfThisProcessorAndOfUnicorn) {
  std::vector<Form> forms = user_forms::all_forms();
  std::erase_if(forms, [](const Form& form) {
    return !bare_processor::has(form.feature) || !unicorn_has(form) ||
           user_forms::is_of_64_bits(form.text);
  });
  const Pieces pieces(forms, 32);
  std::mt19937_64 random(386);
  const std::string why = absence_on_processor(image_of("", 32));
  if (!why.empty()) std::cout << "not compared with this processor: " << why << '\n';
  for (std::size_t i = 0; i < forms.size(); ++i) {
    SCOPED_TRACE(forms[i].text);
    FormTest test(forms[i], pieces.code(i), 32);
    if (why.empty()) test.on_processor_of_judge(random);
    test.on_unicorn(random);
    if (HasFatalFailure()) return;
  }
}

/// The abstract functions in the terms of a form.
std::set<std::string> functions_in(const std::string& text) {
  const std::vector<Form> forms{{text}};
  const Image image = image_of(Pieces(forms).code(0), 64);
  return Model(image, true).functions();
}

TEST(UserInstructions, AProductOfNarrowNumbersHasOneName) {
  using Names = std::set<std::string>;
  const std::string narrow = "movsx ebx, bx\nmovsx esi, si\n";
  EXPECT_EQ(functions_in("imul bx, si"), Names{"smul32"});
  EXPECT_EQ(functions_in(narrow + "imul ebx, esi"), Names{"smul32"});
  EXPECT_EQ(functions_in("movsx rbx, bx\nmovsx rsi, si\nimul rbx, rsi"), Names{"smul32"});
  EXPECT_EQ(functions_in("movzx ebx, bx\nmovzx esi, sil\nimul rbx, rsi"), Names{"smul32"});
  EXPECT_EQ(functions_in("movsxd rax, eax\nmovsxd rbx, ebx\nimul rbx"), Names{"smul32"});
  EXPECT_EQ(functions_in("mov eax, eax\nmov ebx, ebx\nmul rbx"), Names{"umul32"});
  EXPECT_EQ(functions_in("imul sil"), Names{"smul32"});
  EXPECT_EQ(functions_in("mulx ebx, esi, r8d"), Names{"umul32"});
  EXPECT_EQ(functions_in("imul rbx, rsi"), (Names{"mullo64", "smulh64"}));
  EXPECT_EQ(functions_in("mul rbx"), (Names{"mullo64", "umulh64"}));
  EXPECT_EQ(functions_in("mov eax, 6\nmov ebx, 7\nmul rbx"), Names{});
}

TEST(UserInstructions, ADivideIsNamedByItsDividend) {
  using Names = std::set<std::string>;
  EXPECT_EQ(functions_in("cqo\nidiv rbx"), (Names{"squot64", "srest64"}));
  EXPECT_EQ(functions_in("xor edx, edx\ndiv rbx"), (Names{"uquot64", "urest64"}));
  EXPECT_EQ(functions_in("idiv rbx"), (Names{"sdiv128", "sfault128", "srem128"}));
  EXPECT_EQ(functions_in("div rbx"), (Names{"udiv128", "urem128"}));
}

}  // namespace
}  // namespace fixproof::judge
