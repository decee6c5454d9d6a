/// @file
/// Forms of the instructions of users' code, as NASM writes them.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace user_forms {

/// What a processor may lack.
enum class Feature { none, bmi1, bmi2, lzcnt, popcnt, adx };

/// An instruction; others may stand before it and prepare its operands.
struct Form {
  std::string text;
  Feature feature = Feature::none;
};

/// RBX, RSI, R8 and RAX in the four sizes.
inline std::string sized(const std::string& text, int bits) {
  using fmt::arg;
  using Names = std::array<const char*, 5>;
  static constexpr std::array<Names, 4> by_size{{{"bl", "sil", "r8b", "al", "byte"},
                                                 {"bx", "si", "r8w", "ax", "word"},
                                                 {"ebx", "esi", "r8d", "eax", "dword"},
                                                 {"rbx", "rsi", "r8", "rax", "qword"}}};
  const Names& names = by_size.at(bits == 8 ? 0 : bits == 16 ? 1 : bits == 32 ? 2 : 3);
  return fmt::format(fmt::runtime(text), arg("a", names[0]), arg("b", names[1]), arg("c", names[2]),
                     arg("acc", names[3]), arg("m", names[4]));
}

/// Whether a text names a register or an instruction that only 64-bit code has.
inline bool is_of_64_bits(const std::string& text) {
  constexpr std::array wide{"sil", "r8",  "rax", "rbx",    "rcx", "rdx",
                            "rsi", "rsp", "rbp", "movsxd", "cqo", "cdqe"};
  return std::ranges::any_of(
      wide, [&](const char* each) { return text.find(each) != std::string::npos; });
}

class Forms {
 public:
  std::vector<Form> all;

  void add(const std::string& text, std::initializer_list<int> sizes = {8, 16, 32, 64},
           Feature feature = Feature::none) {
    for (const int bits : sizes) all.push_back({sized(text, bits), feature});
  }
  /// A form for each count, {count} in the text.
  void add_counts(const std::string& text, std::initializer_list<int> sizes,
                  std::initializer_list<int> counts) {
    for (const int count : counts) {
      std::string with = text;
      with.replace(with.find("{count}"), 7, std::to_string(count));
      add(with, sizes);
    }
  }
};

inline std::vector<Form> all_forms() {
  Forms f;
  const std::initializer_list<int> no_bytes{16, 32, 64};
  const std::initializer_list<int> wide{32, 64};

  // What listings have too, in the sizes and registers of 64-bit code.
  for (const char* const op : {"add", "adc", "sub", "sbb", "cmp", "and", "xor", "mov"}) {
    f.add(std::string(op) + " {a}, {b}");
    f.add(std::string(op) + " {a}, 0x75");
    f.add(std::string("mov {m} [rsp-16], {a}\n") + op + " {m} [rsp-16], {b}\nmov {a}, [rsp-16]");
  }
  for (const char* const op : {"inc", "dec", "neg", "not"}) f.add(std::string(op) + " {a}");
  f.add("push {a}\npop {b}", {64});
  f.add("push 0x7F\npop {b}", {64});

  for (const char* const op : {"or", "test", "xchg"}) {
    f.add(std::string(op) + " {a}, {b}");
    f.add(std::string("mov {m} [rsp-16], {a}\n") + op + " [rsp-16], {b}\nmov {a}, [rsp-16]");
  }
  f.add("or {a}, -3");
  f.add("test {a}, 0x75");
  f.add("xchg al, ah", {8});
  f.add("push rbp\npush rbx\nmov rbp, rsp\npush rax\nleave\nmov rsi, rbp\npop rbp", {64});
  for (const char* const op :
       {"cbw", "cwde", "cdqe", "cwd", "cdq", "cqo", "stc", "clc", "cmc", "cld"}) {
    f.add(op, {64});
  }
  for (const char* const condition :
       {"o", "no", "c", "nc", "z", "nz", "be", "a", "s", "ns", "l", "ge", "le", "g"}) {
    f.add(std::string("set") + condition + " {a}", {8});
    f.add(std::string("cmov") + condition + " {a}, {b}", no_bytes);
  }
  f.add("lea {a}, [rsi+8*rcx-5]", no_bytes);
  f.add("lea {a}, [esi+2*ecx+5]", no_bytes);
  for (const char* const op : {"movzx", "movsx"}) {
    f.add(std::string(op) + " {a}, sil", no_bytes);
    f.add(std::string(op) + " {a}, ch", {16, 32});
    f.add(std::string(op) + " {a}, si", wide);
  }
  f.add("movsxd {a}, esi", {64});
  f.add("adcx {a}, {b}", wide, Feature::adx);
  f.add("adox {a}, {b}", wide, Feature::adx);

  // Shifts and rotates. {count} of 32 is that of 0 except for 64 bits.
  for (const char* const op : {"shl", "shr", "sar", "rol", "ror", "rcl", "rcr"}) {
    f.add(std::string(op) + " {a}, cl");
    f.add_counts(std::string(op) + " {a}, {count}", {8, 16, 32, 64}, {0, 1, 2, 5, 7, 8, 9, 16, 17});
    f.add_counts(std::string(op) + " {a}, {count}", {8, 16, 32, 64}, {31, 32, 33, 63});
    f.add_counts(std::string("mov cl, {count}\n") + op + " {a}, cl", {8, 16, 32, 64}, {0, 1, 13});
    f.add(std::string("and cl, 7\n") + op + " {a}, cl");
    f.add(std::string("mov {m} [rsp-16], {a}\n") + op + " {m} [rsp-16], cl\nmov {a}, [rsp-16]");
  }
  for (const char* const op : {"shld", "shrd"}) {
    f.add(std::string(op) + " {a}, {b}, cl", wide);
    f.add_counts(std::string(op) + " {a}, {b}, {count}", no_bytes, {1, 2, 7, 15});
    f.add_counts(std::string(op) + " {a}, {b}, {count}", wide, {16, 17, 31, 32, 33, 63});
    f.add_counts(std::string("mov cl, {count}\n") + op + " {a}, {b}, cl", wide, {0, 1, 13});
  }
  for (const char* const op : {"shlx", "shrx", "sarx"}) {
    f.add(std::string(op) + " {a}, {b}, {c}", wide, Feature::bmi2);
  }
  f.add("rorx {a}, {b}, 7", wide, Feature::bmi2);
  f.add("rorx {a}, {b}, 31", wide, Feature::bmi2);

  // Products: of any numbers, and of extensions of narrower ones.
  for (const char* const op : {"mul", "imul"}) {
    f.add(std::string(op) + " {a}");
    f.add(std::string("movsxd rax, eax\nmovsxd rbx, ebx\n") + op + " {a}", {64});
    f.add(std::string("mov eax, eax\nmov ebx, ebx\n") + op + " {a}", {64});
    f.add(std::string("movzx eax, ax\nmovzx ebx, bl\n") + op + " {a}", wide);
    f.add(std::string("movzx eax, ax\nmovsx rbx, bl\n") + op + " {a}", {64});
    f.add(std::string("mov eax, 1717986919\nmovsxd rbx, ebx\n") + op + " {a}", {64});
    f.add(std::string("mov eax, 3435973837\nmov ebx, ebx\n") + op + " {a}", {64});
    f.add(std::string("mov eax, 77\nmov ebx, 99\n") + op + " {a}");
  }
  f.add("imul {a}, {b}", no_bytes);
  f.add("imul {a}, {a}", no_bytes);
  f.add("imul {a}, {b}, 100", no_bytes);
  f.add("imul {a}, {b}, -30000", no_bytes);
  f.add("imul {a}, {b}, -2000000000", wide);
  f.add("movsxd rbx, ebx\nmovsxd rsi, esi\nimul {a}, {b}", {64});
  f.add("mov ebx, ebx\nmov esi, esi\nimul {a}, {b}", {64});
  f.add("movsx ebx, bx\nmovzx esi, si\nimul {a}, {b}", wide);
  f.add(
      "movsxd rax, eax\nmovsxd rcx, ecx\ntest rdx, rdx\ncmovs rax, rcx\nmovsxd rbx, ebx\n"
      "imul rax, rbx",
      {64});
  f.add("mulx {a}, {b}, {c}", wide, Feature::bmi2);
  f.add("mulx {a}, {a}, {c}", wide, Feature::bmi2);
  f.add("mov edx, edx\nmov r8d, r8d\nmulx {a}, {b}, {c}", wide, Feature::bmi2);

  // Quotients.
  for (const char* const op : {"div", "idiv"}) {
    f.add(std::string(op) + " {a}");
    f.add(std::string("movsx ax, al\n") + op + " {a}", {8});
    f.add(std::string("xor edx, edx\n") + op + " {a}", no_bytes);
    f.add(std::string("mov ebx, 7\nxor edx, edx\n") + op + " {a}", no_bytes);
    f.add(std::string("mov rbx, -1\ncqo\n") + op + " {a}", {64});
    f.add(std::string("mov bl, -1\n") + op + " {a}", {8});
  }
  f.add("cwd\nidiv {a}", {16});
  f.add("cdq\nidiv {a}", {32});
  f.add("cqo\nidiv {a}", {64});
  f.add("shl rax, 63\nmov rbx, -1\ncqo\nidiv rbx", {64});  // the quotient that does not fit

  // Single bits.
  for (const char* const op : {"bt", "bts", "btr", "btc"}) {
    f.add(std::string(op) + " {a}, {b}", no_bytes);
    f.add_counts(std::string(op) + " {a}, {count}", no_bytes, {0, 1, 15, 17, 63});
    f.add(std::string("mov [rsp-16], {a}\n") + op + " {m} [rsp-16], 3\nmov {a}, [rsp-16]",
          no_bytes);
  }
  f.add("bsf {a}, {b}", no_bytes);
  f.add("bsr {a}, {b}", no_bytes);
  f.add("tzcnt {a}, {b}", no_bytes, Feature::bmi1);
  f.add("lzcnt {a}, {b}", no_bytes, Feature::lzcnt);
  f.add("popcnt {a}, {b}", no_bytes, Feature::popcnt);
  f.add("bswap {a}", wide);
  f.add("andn {a}, {b}, {c}", wide, Feature::bmi1);
  for (const char* const op : {"blsr", "blsi", "blsmsk"}) {
    f.add(std::string(op) + " {a}, {b}", wide, Feature::bmi1);
  }
  return f.all;
}

}  // namespace user_forms
