// Tests every instruction form of `fixproof step` on both processors against bitwise.hpp.
#include <fmt/format.h>

#include "tests/app/cli/draw.hpp"
#include "tests/support/bitwise.hpp"
#include "tests/support/command.hpp"
#include "tests/support/test.hpp"
#include "verify/parties/answer.hpp"

namespace {

struct InstructionForm {
  std::string name;
  std::string operands;
};

/// Mnemonics, each with the kinds of its operands: b, w, d, i (immediate), 1 (a shift by one) and
/// l (label).
constexpr std::string_view forms_8088 =
    "mov ww,push w,add ww,add wi,adc ww,adc wi,sub ww,sub wi,sbb wi,cmp ww,cmp wi,neg w,inc w,"
    "dec w,mul w,div w,and ww,xor wi,shl w1,shr w1,jmp l,js l,jns l,jz l,ja l,jg l,"
    // of the inner loops
    "mov bb,stosb ,stosw ,jnz l,loop l,jmp w";

/// The additional forms in the listings for the 386.
constexpr std::string_view more_forms_386 =
    "mov dd,add dd,add di,adc di,sub dd,cmp dd,neg d,inc d,dec d,imul d,div d,idiv d,and dd,shl wi,"
    "shr di,shr d1,sar di,rol di,shld ddi,shrd ddi";

std::vector<InstructionForm> forms_of(bool is_386) {
  std::vector<InstructionForm> forms;
  for (const std::string_view part : {forms_8088, is_386 ? more_forms_386 : std::string_view()}) {
    for (const std::string& form : command::split(part, ',')) {
      const auto words = command::split(form, ' ');
      if (words.size() == 2) forms.push_back({words[0], words[1]});
    }
  }
  return forms;
}

constexpr std::array<const char*, 8> names{"ax", "bx", "cx", "dx", "si", "di", "bp", "sp"};
/// The byte registers: the low halves of the first four, then their high halves.
constexpr std::array<const char*, 8> byte_names{"al", "bl", "cl", "dl", "ah", "bh", "ch", "dh"};
constexpr std::size_t ax = 0;
constexpr std::size_t cx = 2;
constexpr std::size_t dx = 3;
constexpr std::size_t di = 5;
constexpr std::size_t sp = 7;

struct State {
  std::array<std::uint32_t, 8> registers{};
  std::array<bool, 8> wide{};
  std::uint16_t flags = 0;

  [[nodiscard]] std::string text() const {
    std::string result;
    for (std::size_t i = 0; i < names.size(); ++i) {
      result += wide.at(i) ? fmt::format("e{}={:08x} ", names.at(i), registers.at(i))
                           : fmt::format("{}={:04x} ", names.at(i), registers.at(i));
    }
    return result + fmt::format("fl={:04x}", flags);
  }
  [[nodiscard]] std::uint32_t read(std::size_t i, int bits) const {
    if (bits == 8) return registers.at(i % 4) / (i < 4 ? 1U : 256U) % 256U;
    return bits == 16 ? registers.at(i) % 0x10000U : registers.at(i);
  }
  void write(std::size_t i, int bits, std::uint32_t value) {
    if (bits == 8) {
      registers.at(i % 4) += (value - read(i, 8)) * (i < 4 ? 1U : 256U);
      return;
    }
    registers.at(i) = bits == 16 ? registers.at(i) / 0x10000U * 0x10000U + value : value;
  }
};

std::string undefined_text(std::uint16_t undefined) {
  std::string text;
  for (const auto& [flag, name] :
       std::array<std::pair<bitwise::Flag, const char*>, 6>{{{bitwise::CF, ",CF"},
                                                             {bitwise::PF, ",PF"},
                                                             {bitwise::AF, ",AF"},
                                                             {bitwise::ZF, ",ZF"},
                                                             {bitwise::SF, ",SF"},
                                                             {bitwise::OF, ",OF"}}}) {
    if ((undefined & flag) != 0) text += name;
  }
  return text.empty() ? "-" : text.substr(1);
}

struct Question {
  std::string line;
  std::string answer;
};

class Questions {
 public:
  explicit Questions(bool is_386) : is_386_(is_386) {}

  /// Draws an instruction of the form and a state, and computes the expected answer.
  Question ask(const InstructionForm& form) {
    const std::string_view kinds = form.operands;
    const std::string_view name = form.name;
    const bool is_byte = kinds.starts_with('b');
    const int bits = kinds.starts_with('d') ? 32 : is_byte ? 8 : 16;
    State state = draw_state(bits == 32);
    const std::size_t first = random_() % 8;
    const std::size_t second = random_() % 8;
    std::string instruction = form.name;
    bitwise::Operands o;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
      instruction += i == 0 ? " " : ", ";
      if (kinds[i] == 'w' || kinds[i] == 'd' || is_byte) {
        const std::size_t which = i == 0 ? first : second;
        instruction += is_byte      ? byte_names.at(which)
                       : bits == 32 ? fmt::format("e{}", names.at(which))
                                    : names.at(which);
        (i == 0 ? o.first : o.second) = state.read(which, bits);
      } else {
        instruction += constant(name, kinds[i], o, bits);
      }
    }
    const std::string line = instruction + " | " + state.text();
    return {line, answer(name, o, state, first, bits)};
  }

 private:
  /// Draws an operand other than a register: returns its text and stores its value in `o`.
  std::string constant(std::string_view name, char kind, bitwise::Operands& o, int bits) {
    if (kind == 'l') return "Somewhere";
    if (!is_shift(name)) {
      o.second = command::draw_word(random_, static_cast<std::uint32_t>(bits));
      return immediate_text(o.second, bits);
    }
    // A count of 1 is a separate form, but 33 is the same count.
    do {
      o.count = static_cast<int>(random_() % (random_() % 2 == 0 ? 34 : 256));
    } while (o.count == 1);
    if (kind == '1') o.count = 1;
    return fmt::format("{}", o.count);
  }

  static bool is_shift(std::string_view name) {
    return name.starts_with("sh") || name == "sar" || name == "rol";
  }

  static std::string answer(std::string_view name, bitwise::Operands o, State state,
                            std::size_t first, int bits) {
    std::uint16_t undefined = 0;
    const bool product = name == "mul" || name == "imul";
    const bool quotient = name == "div" || name == "idiv";
    if (name == "push") {
      state.write(sp, 16, (state.read(sp, 16) + 0xFFFEU) % 0x10000U);
    } else if (name.starts_with("stos")) {
      state.write(di, 16, (state.read(di, 16) + (name == "stosb" ? 1U : 2U)) % 0x10000U);
    } else if (name == "loop") {
      state.write(cx, 16, (state.read(cx, 16) + 0xFFFFU) % 0x10000U);
    } else if (!name.starts_with('j')) {
      if (product || quotient) {
        o.second = o.first;
        o.first = state.read(ax, bits);
        o.high = state.read(dx, bits);
      }
      o.flags = state.flags & bitwise::all_six;
      const bitwise::Answer after = bitwise::execute(name, o, bits);
      if (after.fault) return "DE";
      state.write(product || quotient ? ax : first, bits, after.value);
      if (product || quotient) state.write(dx, bits, after.high);
      state.flags = static_cast<std::uint16_t>((state.flags & ~bitwise::all_six) | after.flags);
      undefined = after.undefined;
    }
    return state.text() + " undef=" + undefined_text(undefined);
  }

  State draw_state(bool all_wide) {
    State state;
    for (std::size_t i = 0; i < names.size(); ++i) {
      state.wide.at(i) = is_386_ && (all_wide || random_() % 2 == 0);
      state.registers.at(i) = command::draw_word(random_, state.wide.at(i) ? 32 : 16);
    }
    state.flags = static_cast<std::uint16_t>(random_());
    return state;
  }

  std::string immediate_text(std::uint32_t value, int bits) {
    if (random_() % 2 == 0) return fmt::format("0x{:x}", value);
    const std::uint64_t range = std::uint64_t{1} << bits;
    return value >= range / 2 ? fmt::format("-{}", range - value) : fmt::format("{}", value);
  }

  bool is_386_;
  command::Random random_{8088};
};

class StepForms : public testing::TestWithParam<const char*> {
 protected:
  static bool is_386() { return GetParam() == std::string_view("386"); }
};

TEST_P(StepForms, DoWhatIntelDefines) {
  constexpr int cases_of_each = 3000;
  Questions questions(is_386());
  std::vector<Question> asked;
  std::string lines;
  for (const InstructionForm& form : forms_of(is_386())) {
    int faults = 0;
    for (int i = 0; i < cases_of_each; ++i) {
      asked.push_back(questions.ask(form));
      lines += asked.back().line + '\n';
      if (asked.back().answer == "DE") ++faults;
    }
    // Divides must often fault and often succeed.
    const bool divides = form.name.ends_with("div");
    EXPECT_EQ(faults > cases_of_each / 20, divides) << form.name;
    EXPECT_LT(faults, cases_of_each * 19 / 20) << form.name;
  }
  const auto answers =
      command::split(command::output_of(fmt::format("step --cpu {}", GetParam()), lines), '\n');
  ASSERT_EQ(answers.size(), asked.size() + 1);
  for (std::size_t i = 0; i < asked.size(); ++i) {
    ASSERT_EQ(answers[i], asked[i].answer) << asked[i].line;
  }
}

/// Whether the instruction can have these operands: only jumps take a label (in place of an
/// immediate), and only shifts have a separate form for a count of one.
bool makes_sense(std::string_view name, std::string_view shape) {
  const bool jumps = name.starts_with('j') || name == "call" || name == "loop";
  const bool shifts = name == "shl" || name == "shr" || name == "sar" || name == "rol";
  if (shape == "l") return jumps;
  if (shape == "i") return !jumps;
  return shifts || !shape.ends_with('1');
}

/// An instruction of that shape with CX, ECX or CL for every register.
std::string sample(std::string_view name, std::string_view shape) {
  std::string text(name);
  for (std::size_t i = 0; i < shape.size(); ++i) {
    text += i == 0 ? " " : ", ";
    const std::string_view kinds = "wdbi1l";
    text += std::array{"cx", "ecx", "cl", "5", "1", "1"}.at(kinds.find(shape[i]));
  }
  return text;
}

constexpr auto mnemonics = std::to_array<const char*>(
    {"mov", "push", "pop",  "add",  "adc",  "sub",   "sbb",   "cmp",   "neg",   "inc",
     "dec", "mul",  "imul", "div",  "idiv", "and",   "xor",   "shl",   "shr",   "sar",
     "rol", "shld", "shrd", "jmp",  "js",   "jns",   "jz",    "ja",    "jg",    "call",
     "ret", "or",   "test", "jnz",  "loop", "stosb", "stosw", "lodsb", "loopz", "not",
     "lea", "nop",  "ror",  "xchg", "cwd",  "movsx", "hlt",   "jc",    "int"});
constexpr auto shapes = std::to_array<const char*>(
    {"",   "w",  "d",   "i",   "l",   "ww", "dd", "wd", "dw", "wi", "di", "w1",
     "d1", "iw", "wwi", "ddi", "ddd", "b",  "bb", "bi", "bw", "wb", "b1"});

TEST_P(StepForms, NoOthersAreModelled) {
  const auto forms = forms_of(is_386());
  std::string lines;
  std::vector<std::string> expected;
  for (const std::string_view name : mnemonics) {
    for (const std::string_view shape : shapes) {
      if (!makes_sense(name, shape)) continue;
      lines += fmt::format("{} | {}\n", sample(name, shape), State{}.text());
      const bool modelled = std::any_of(
          forms.begin(), forms.end(),
          [&](const InstructionForm& form) { return form.name == name && form.operands == shape; });
      // All registers are 0, so every divide faults.
      const char* answer = name.ends_with("div") ? "DE" : "modelled";
      expected.emplace_back(modelled ? answer : "unmodelled");
    }
  }
  const auto run = command::fixproof(fmt::format("step --cpu {}", GetParam()), lines);
  EXPECT_EQ(run.status, 0);
  const auto asked = command::split(lines, '\n');
  const auto given = command::split(run.out, '\n');
  ASSERT_EQ(given.size(), expected.size() + 1) << run.err;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const bool has_state = given[i].starts_with("ax=");
    EXPECT_EQ(has_state ? "modelled" : given[i], expected[i]) << asked[i];
  }
  EXPECT_TRUE(
      run.err.starts_with(fmt::format("fixproof step: {} lines unmodelled, such as ",
                                      std::count(expected.begin(), expected.end(), "unmodelled"))))
      << run.err;
}

INSTANTIATE_TEST_SUITE_P(Processor, StepForms, testing::Values("8088", "386"),
                         [](const auto& test) { return fmt::format("cpu{}", test.param); });

}  // namespace
