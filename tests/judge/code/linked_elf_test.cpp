// Programs and shared libraries of ELF, as ld makes them and damaged.
#include <elf.h>
#include <fmt/format.h>

#include <cstring>
#include <fstream>
#include <iterator>

#include "judge/code/load.hpp"
#include "support/usage_error.hpp"
#include "tests/judge/code/judged.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/test.hpp"

namespace {

using namespace fixproof;
using judged::expect;
using judged::judge;

const std::string shared = "-shared|-z|noseparate-code";
const std::string program = "-static|-z|noseparate-code";
const std::string position_independent = "-pie|--no-dynamic-linker|-z|noseparate-code";
const std::string quickly = "--as|mul|--cases|5000";

std::string linked(const ScratchFolder& folder, int bits, const std::string& source,
                   const std::string& options, const std::string& name = "linked") {
  const std::string from = folder.write(
      name + ".asm", fmt::format("bits {}\n{}{}", bits, bits == 64 ? "default rel\n" : "", source));
  const std::string object = folder.path(name + ".o");
  const std::string format = bits == 64 ? "elf64" : "elf32";
  EXPECT_EQ(command::run({"nasm", "-f", format, "-o", object, from}).status, 0) << source;
  std::string to = folder.path(name);
  std::vector<std::string> words{"ld", "-m", bits == 64 ? "elf_x86_64" : "elf_i386", "-e", "0"};
  for (const std::string& word : command::split(options, '|')) words.push_back(word);
  words.insert(words.end(), {"-o", to, object});
  const auto run = command::run(words);
  EXPECT_EQ(run.status, 0) << run.err;
  return to;
}

/// A product to which what the relocations of this width reach is added: 1 + 2 + 4 - 7.
std::string linked_product(int bits) {
  if (bits == 64) {
    return "global mul:function, add4:function, one:data 8\n"
           "mul: movsxd rax, edi\nmovsxd rsi, esi\nimul rax, rsi\nsar rax, 16\n"
           "mov rcx, [one wrt ..got]\nadd eax, [rcx]\nmov rcx, [to_two]\nadd eax, [rcx]\n"
           "mov rcx, [to_one]\nsub eax, [rcx]\nadd eax, 1\ncall add4 wrt ..plt\nsub eax, 7\nret\n"
           "section .more exec\nadd4: add eax, 4\nret\nsection .data\none: dq 1\ntwo: dq "
           "2\nto_one: dq one\n"
           "to_two: dq two\n";
  }
  return "extern _GLOBAL_OFFSET_TABLE_\nglobal mul:function, add4:function, one:data 4\n"
         "mul: push ebx\ncall .here\n.here: pop ebx\n"
         "add ebx, _GLOBAL_OFFSET_TABLE_+$$-.here wrt ..gotpc\n"
         "mov eax, [esp+8]\nimul dword [esp+12]\nshrd eax, edx, 16\n"
         "mov ecx, [ebx+one wrt ..got]\nadd eax, [ecx]\nmov ecx, [ebx+to_two wrt ..gotoff]\n"
         "add eax, [ecx]\nmov ecx, [ebx+to_one wrt ..gotoff]\nsub eax, [ecx]\nadd eax, 1\n"
         "call add4 wrt ..plt\nsub eax, 7\npop ebx\nret\n"
         "section .more exec\nadd4: add eax, 4\nret\nsection .data\none: dd 1\ntwo: dd 2\nto_one: "
         "dd one\n"
         "to_two: dd two\n";
}

struct JudgeLinkedElf : testing::Test {
  void SetUp() override {
    if (!command::has("ld")) GTEST_SKIP() << "no ld";
  }

  ScratchFolder folder;
};

TEST_F(JudgeLinkedElf, EveryKindIsLoaded) {
  for (const int bits : {32, 64}) {
    for (const std::string& kind : {shared, program, position_independent}) {
      SCOPED_TRACE(fmt::format("{} bits, {}", bits, kind));
      const std::string file = linked(folder, bits, linked_product(bits), kind);
      expect(judge(file + ":mul", quickly), 0,
             {"linked ELF file", "AGREES on 5,000 cases", "no foreign memory is used"});
    }
    const std::string file =
        linked(folder, bits, linked_product(bits), program + "|-Ttext-segment=0x9000000");
    expect(judge(file + ":mul", "--list"), 0, {"org 0x9000", "ret"});
  }
}

TEST_F(JudgeLinkedElf, AStrippedLibraryHasItsDynamicSymbols) {
  for (const int bits : {32, 64}) {
    const std::string file = linked(folder, bits, linked_product(bits), shared + "|-s");
    expect(judge(file, quickly + "|--symbol|mul"), 0, {"AGREES on 5,000 cases"});
    command::expect_usage_error(
        judge(file, quickly), "name the routine as FILE:ROUTINE or with --symbol; choose one of ");
    const std::string without = linked(folder, bits, linked_product(bits), program + "|-s");
    command::expect_usage_error(judge(without, quickly),
                                "the linked ELF file has no global function");
    command::expect_usage_error(judge(without + ":mul", quickly), "has no symbols; use --at");
  }
}

TEST_F(JudgeLinkedElf, AStaticFunctionHasItsName) {
  // As a linker that optimises the whole program leaves functions.
  const std::string source =
      "static mul:function\nmul: movsxd rax, edi\nmovsxd rsi, esi\nimul rax, rsi\n"
      "add rax, 0x8000\nsar rax, 16\nret\n"
      "global go:function, table:data\ngo: jmp mul\ntable: dd 0\n";
  const std::string file = linked(folder, 64, source, program);
  expect(judge(file + ":mul", quickly), 0, {"AGREES on 5,000 cases"});
  command::expect_usage_error(judge(file + ":mull", quickly),
                              "choose one of go, mul; did you mean mul?\n");
  const std::string more = "static mul:function\nmul: ret\n";
  const std::string both = linked(folder, 64, more, program + "|" + file + ".o", "both");
  command::expect_usage_error(judge(both + ":mul", quickly),
                              "there are 2 static functions of that name; use --at");
}

TEST_F(JudgeLinkedElf, ANameThatTheFileLacksIsNamedWhereItIsUsed) {
  const std::string names = "extern other\nglobal f:function\nf: ";
  for (const std::string& file :
       {linked(folder, 64, names + "call other wrt ..plt\nret\n", shared, "by_table"),
        linked(folder, 32, names + "call other\nret\n", shared + "|-z|notext", "in_code"),
        linked(folder, 32, names + "mov eax, [other+8]\nret\n", shared + "|-z|notext", "reads")}) {
    expect(judge(file, quickly), 1,
           {"the routine uses 'other', which needs another file or the loader of the system, at ",
            "h; link it statically"});
  }
  // A weak one is 0.
  expect(judge(linked(folder, 64,
                      "extern hook:weak\nglobal f:function\nf: mov rax, [hook wrt ..got]\n"
                      "movsxd rdi, edi\nmovsxd rsi, esi\nadd rax, rdi\nimul rax, rsi\nsar rax, 16\n"
                      "ret\n",
                      shared),
               quickly),
         0, {"AGREES on 5,000 cases"});
}

TEST_F(JudgeLinkedElf, WhatTheLoaderOfASystemDecidesIsNamed) {
  if (!command::has("gcc")) GTEST_SKIP() << "no gcc";
  const std::string source = folder.write(
      "lib.c",
      "__thread int counter;\nint counts(int a, int b) { return ++counter + a + b; }\n"
      "static int one(int a) { return a; }\nstatic void* choose(void) { return one; }\n"
      "int chosen(int) __attribute__((ifunc(\"choose\")));\n"
      "static int hidden(int) __attribute__((ifunc(\"choose\")));\n"
      "int calls(int a, int b) { return chosen(a) + b; }\n"
      "int hides(int a, int b) { return hidden(a) + b; }\n"
      "int adds(int a, int b) { return a + b; }\n");
  const std::string to = folder.path("lib.so");
  ASSERT_EQ(command::run({"gcc", "-O1", "-fPIC", "-shared", "-nostdlib", "-o", to, source}).status,
            0);
  const std::string as_add = "--as|add|--cases|1000";
  expect(judge(to + ":adds", as_add), 0, {"AGREES on 1,000 cases"});
  expect(judge(to + ":calls", as_add), 1, {"the routine uses 'chosen', which needs another file"});
  expect(judge(to + ":hides", as_add), 1, {"the routine uses 'hidden', which needs another file"});
  expect(judge(to + ":counts", as_add), 1, {"the routine uses '__tls_get_addr', which needs"});
}

TEST_F(JudgeLinkedElf, AVariableOfAnotherFileIsRefused) {
  const std::string library =
      linked(folder, 64, "global value:data 8\nsection .data\nvalue: dq 5\n", shared, "other.so");
  const std::string file =
      linked(folder, 64, "extern value\nglobal f\nf: mov eax, [abs value]\nret\n",
             "-z|noseparate-code|" + library);
  command::expect_usage_error(
      judge(file, quickly),
      "has the variable 'value' from a shared library; link it with -static-pie");
}

TEST_F(JudgeLinkedElf, WhatDoesNotFitIsRefused) {
  const std::string large = "global f\nf: ret\nsection .bss\nresb 0x200000\n";
  command::expect_usage_error(judge(linked(folder, 64, large, shared), quickly),
                              "KiB of code and data, and there is room for less than 1 MiB; give ");
  command::expect_usage_error(
      judge(linked(folder, 32, linked_product(32), program + "|-Ttext-segment=0x50000000"),
            quickly),
      "the ELF file is linked for 50000000h, and programs have room up to 40000000h");
  command::expect_usage_error(
      judge(linked(folder, 32, linked_product(32), shared), quickly + "|--bits|16"),
      "--bits 16: a linked ELF file has 32-bit code; leave --bits out");
  if (command::run({"ld", "-z", "pack-relative-relocs", "-v"}).err.empty()) {
    command::expect_usage_error(
        judge(linked(folder, 64, linked_product(64), shared + "|-z|pack-relative-relocs"), quickly),
        "has packed relocations; link it without -z pack-relative-relocs");
  }
}

TEST_F(JudgeLinkedElf, AFunctionMayFollowTheFile) {
  const std::string file = linked(folder, 64, linked_product(64), shared);
  expect(judge(file + ":mul", quickly), 0, {"linked: linked ELF file", "AGREES on 5,000 cases"});
  command::expect_usage_error(judge(file + ":none", quickly),
                              "--symbol 'none': there is no such symbol");
  command::expect_usage_error(judge(file + ":mul", quickly + "|--symbol|mul"),
                              ":mul' and --symbol both name the routine; leave one out");
  command::expect_usage_error(judge(file + ":mul", quickly + "|--at|7"),
                              "--at and --symbol, or FILE:FUNCTION, both name the routine");
  command::expect_usage_error(judge(folder.path("none") + ":mul", quickly),
                              "none:mul: there is no such file");
  // A file of that name wins.
  expect(judge(folder.write("linked:mul", "\xF7\xEB\x0F\xAC\xD0\x10\xC3"), judged::in_registers), 0,
         {"linked:mul: flat binary"});
}

std::string bytes_in(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

template <class T>
T value_at(const std::string& bytes, std::size_t offset) {
  T value{};
  std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

/// The bytes with a value elsewhere.
template <class T>
std::string with(std::string bytes, std::size_t offset, const T& value) {
  std::memcpy(bytes.data() + offset, &value, sizeof value);
  return bytes;
}

/// What load_bytes() says against the bytes; empty if it takes them.
std::string refusal_of(const std::string& bytes) {
  try {
    const judge::Image image = judge::load_bytes("lib.so", bytes, {.symbol = "mul"});
    EXPECT_LE(image.base, image.first);
    EXPECT_LT(image.first, image.end);
    EXPECT_LE(image.index_of(image.end), image.memory.size());
    EXPECT_TRUE(image.entry >= image.first && image.entry < image.end);
    return "";
  } catch (const support::UsageError& error) {
    EXPECT_TRUE(std::string_view(error.what()).starts_with("lib.so: ")) << error.what();
    return error.what();
  }
}

TEST_F(JudgeLinkedElf, CutAndChangedFilesAreRefusedOrLoaded) {
  for (const int bits : {32, 64}) {
    // Without the padding to pages, which is half of the file.
    const std::string whole =
        bytes_in(linked(folder, bits, linked_product(bits), shared + "|-z|max-page-size=16"));
    ASSERT_LT(whole.size(), 4000U);
    EXPECT_EQ(refusal_of(whole), "");
    for (std::size_t size = 1; size < whole.size(); size += 3) {
      EXPECT_NE(refusal_of(whole.substr(0, size)), "") << size;
    }
    for (std::size_t at = 16; at < whole.size(); ++at) {
      std::string changed = whole;
      for (const char value : {'\xFF', '\x7F'}) {
        changed[at] = value;
        (void)refusal_of(changed);
      }
    }
  }
}

/// A shared library of 64 bits whose tables a test changes.
struct DamagedElf : JudgeLinkedElf {
  void SetUp() override {
    JudgeLinkedElf::SetUp();
    if (IsSkipped()) return;
    bytes = bytes_in(linked(folder, 64, linked_product(64), shared));
    header = value_at<Elf64_Ehdr>(bytes, 0);
  }

  [[nodiscard]] std::size_t first_of(unsigned type) const {
    for (unsigned i = 0; i < header.e_shnum; ++i) {
      const std::size_t at = header.e_shoff + i * sizeof(Elf64_Shdr);
      if (value_at<Elf64_Shdr>(bytes, at).sh_type == type) return at;
    }
    ADD_FAILURE() << "no section of type " << type;
    return 0;
  }
  [[nodiscard]] Elf64_Shdr section_at(std::size_t at) const {
    return value_at<Elf64_Shdr>(bytes, at);
  }
  /// Expects that a change of the first program header leads to a message.
  template <class Change>
  void expect_refused(Change change, const std::string& part = "the ELF file is damaged") {
    auto segment = value_at<Elf64_Phdr>(bytes, header.e_phoff);
    ASSERT_EQ(segment.p_type, unsigned{PT_LOAD});
    change(segment);
    command::expect_contains(refusal_of(with(bytes, header.e_phoff, segment)), part);
  }

  std::string bytes;
  Elf64_Ehdr header{};
};

TEST_F(DamagedElf, Segments) {
  expect_refused([this](Elf64_Phdr& s) { s.p_offset = bytes.size() + 1; });
  expect_refused([this](Elf64_Phdr& s) { s.p_offset = bytes.size() - s.p_filesz + 1; });
  expect_refused([](Elf64_Phdr& s) { s.p_offset = ~std::uint64_t{0}; });
  expect_refused([](Elf64_Phdr& s) { s.p_memsz = s.p_filesz - 1; });
  expect_refused([](Elf64_Phdr& s) { s.p_memsz = ~std::uint64_t{0}; });
  expect_refused([](Elf64_Phdr& s) { s.p_vaddr = 0x100000; });  // above the next one
  expect_refused([](Elf64_Phdr& s) { s.p_type = PT_NULL; }, "has no symbols");
  auto changed = header;
  changed.e_phoff = bytes.size() - 8;
  command::expect_contains(refusal_of(with(bytes, 0, changed)), "is damaged");
  changed = header;
  changed.e_phentsize = 8;
  command::expect_contains(refusal_of(with(bytes, 0, changed)), "is damaged");
  changed = header;
  changed.e_phnum = 0;
  command::expect_contains(refusal_of(with(bytes, 0, changed)), "the ELF file has no code");
  changed = header;
  changed.e_shnum = 0;
  command::expect_contains(refusal_of(with(bytes, 0, changed)), "has no section headers");
  changed = header;
  changed.e_type = ET_CORE;
  command::expect_contains(refusal_of(with(bytes, 0, changed)),
                           "is neither an object nor a program");
}

TEST_F(DamagedElf, Relocations) {
  const std::size_t list_at = first_of(SHT_RELA);
  Elf64_Shdr list = section_at(list_at);
  const auto first = value_at<Elf64_Rela>(bytes, list.sh_offset);
  for (const std::uint64_t place : {std::uint64_t{0x100000}, ~std::uint64_t{0}, ~std::uint64_t{4},
                                    std::uint64_t{0x7FFFFFFF}, std::uint64_t{0xFFFFF000}}) {
    auto changed = first;
    changed.r_offset = place;
    command::expect_contains(refusal_of(with(bytes, list.sh_offset, changed)), "is damaged");
  }
  auto changed = first;
  changed.r_info = ELF64_R_INFO(99U, R_X86_64_GLOB_DAT);
  command::expect_contains(refusal_of(with(bytes, list.sh_offset, changed)), "is damaged");
  changed.r_info = ELF64_R_INFO(0U, R_X86_64_SIZE64);
  command::expect_contains(refusal_of(with(bytes, list.sh_offset, changed)),
                           "the ELF file has a relocation of type 33; give the object");
  list.sh_link = 99;
  command::expect_contains(refusal_of(with(bytes, list_at, list)), "is damaged");
  list = section_at(list_at);
  list.sh_size = bytes.size() + 24;
  command::expect_contains(refusal_of(with(bytes, list_at, list)), "is damaged");
  list = section_at(list_at);
  list.sh_type = SHT_REL;
  command::expect_contains(refusal_of(with(bytes, list_at, list)),
                           "the ELF file has relocations without addends");
}

TEST_F(DamagedElf, Symbols) {
  const std::size_t table_at = first_of(SHT_SYMTAB);
  Elf64_Shdr table = section_at(table_at);
  table.sh_size = 1U << 30U;
  command::expect_contains(refusal_of(with(bytes, table_at, table)), "is damaged");
  table = section_at(table_at);
  table.sh_link = 99;
  command::expect_contains(refusal_of(with(bytes, table_at, table)), "is damaged");
  const auto last = section_at(table_at).sh_info;  // the first global one
  const std::size_t symbol_at = section_at(table_at).sh_offset + last * sizeof(Elf64_Sym);
  auto symbol = value_at<Elf64_Sym>(bytes, symbol_at);
  symbol.st_name = ~0U;
  const std::string text = refusal_of(with(bytes, symbol_at, symbol));
  EXPECT_TRUE(text.empty() || text.find("is damaged") != std::string::npos) << text;
}

// No relocation names the entries of the table by which such code finds `half`, `shift` and
// `inner`.
TEST_F(JudgeLinkedElf, TheTableOfOffsetsOfMips) {
  if (!command::has("mips-linux-gnu-gcc")) GTEST_SKIP() << "no mips-linux-gnu-gcc";
  const std::string source = folder.write(
      "f.c",
      "int half = 0x8000; int* to_half = &half; static int shift = 16; int missing(int);\n"
      "__attribute__((noinline)) long long inner(int a, int b) {"
      " return a * (long long)b + *to_half; }\n"
      "int f(int a, int b) { return (int)(inner(a, b) >> shift); }\n"
      "int g(int a, int b) { return missing(a) + b; }\n");
  for (const std::string kind : {"-shared -fPIC", "-pie -fPIE"}) {
    SCOPED_TRACE(kind);
    const std::string file = folder.path("mips.elf");
    const auto made =
        command::run({"sh", "-c",
                      "mips-linux-gnu-gcc -O2 -nostdlib -Wl,-e,f,--unresolved-symbols=ignore-all " +
                          kind + " -o " + file + " " + source});
    ASSERT_EQ(made.status, 0) << made.err;
    expect(judge(file + ":f", quickly), 0, {"half-up, the rounding that", "AGREES on 5,000 cases"});
    expect(judge(file + ":g", quickly), 1, {"uses 'missing', which needs another file"});
    // More entries than there is room for.
    std::ifstream in(file, std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(in), {}};
    const std::size_t count = bytes.find(std::string("\x70\0\0\x0A", 4));
    ASSERT_NE(count, std::string::npos);
    for (const std::string& many : {std::string("\0\2\0\0", 4), std::string("\x7F\0\0\0", 4)}) {
      command::expect_usage_error(
          judge(folder.write("many.elf", bytes.replace(count + 4, 4, many)) + ":f", quickly),
          "the ELF file is damaged");
    }
  }
}

}  // namespace
