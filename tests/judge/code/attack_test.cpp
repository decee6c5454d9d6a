// Hundreds of routines of each width that try to leave their memory. Those of 16 and 32 bits run on
// this processor, those of 64 bits on Unicorn. None may lead to a result that it did not return, or
// leave a process or a file behind.
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <iterator>

#include "judge/code/load.hpp"
#include "judge/code/runner.hpp"
#include "tests/judge/code/replies.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/test.hpp"
#include "verify/machine_code/host_segment.hpp"

namespace {

using namespace fixproof;

/// What no routine returns: 64-bit code puts it into replies that it forges.
constexpr std::uint32_t mark = 0x64B17C0D;
constexpr std::size_t cases_asked = 3;

/// The descriptor to which a process will reply: it is the last of the two pipes that are opened
/// for it.
int coming_descriptor() {
  std::array<int, 4> next{};
  for (int& i : next) i = dup(STDERR_FILENO);
  for (const int i : next) close(i);
  return next.back();
}

/// 64-bit code that writes a reply of forged answers.
std::string forger() {
  std::vector<judge::Answer> answers(cases_asked);
  for (auto& answer : answers) answer.words.fill(mark);
  const std::string reply = replies::bytes_of(answers);
  std::string code = fmt::format(
      "bits 64\nwide: lea rsi, [rel forged]\nmov edi, {}\nmov edx, {}\nmov eax, 1\nsyscall\n"
      "jmp $\nforged: dd {}\n",
      coming_descriptor(), sizeof(std::uint32_t) + reply.size(), reply.size());
  for (const char byte : reply) code += fmt::format("db {}\n", static_cast<unsigned char>(byte));
  return code;
}

/// Routines as NASM source, each behind a global name.
class Routines {
 public:
  explicit Routines(int bits) : bits_(bits), text_(fmt::format("bits {}\norg 0x100\n", bits)) {
    // The byte 40h is an INC in 16-bit and 32-bit code and a prefix in 64-bit code.
    text_ += (bits == 64 ? "default rel\nland: jmp wide\n"
                         : "land: xor eax, eax\ndb 0x40, 0x90\njz wide\nret\n") +
             forger() + fmt::format("bits {}\n", bits);
  }

  void add(const std::string& code) {
    text_ += fmt::format("align 16\ntry{}:\n{}\nret\n", count_++, code);
  }
  [[nodiscard]] const std::string& text() const { return text_; }
  [[nodiscard]] int count() const { return count_; }
  [[nodiscard]] const char* a() const { return bits_ == 16 ? "ax" : bits_ == 32 ? "eax" : "rax"; }
  [[nodiscard]] int bits() const { return bits_; }

 private:
  int bits_;
  std::string text_;
  int count_ = 0;
};

constexpr std::array selectors{0x33, 0x2B, 0x23, 0x10, 0x18, 0x00, 0x07,  0x0F,
                               0x17, 0x1F, 0x27, 0x2F, 0x53, 0x7B, 0xFFFF};

void add_far_transfers(Routines& routines) {
  // Where this segment may be in the low 4 GiB, and where 64-bit programs often are.
  const std::vector<std::string> places{"land",       "0",         "0x400000", "0x40000000 + land",
                                        "0x7ffff000", "0xfffff000"};
  for (const int selector : selectors) {
    for (const auto& place : places) {
      routines.add(fmt::format("jmp dword {}:{}", selector, place));
      routines.add(fmt::format("push dword {}\npush dword {}\no32 retf", selector, place));
    }
    routines.add(fmt::format("call dword {}:land", selector));
    routines.add(fmt::format("pushf\npush {}\npush land\niret", selector));
    routines.add(
        fmt::format("jmp far [place{0}]\nplace{0}: dd land\ndw {1}", routines.count(), selector));
  }
}

void add_segments(Routines& routines) {
  for (const char* segment : {"ds", "es", "fs", "gs", "ss"}) {
    for (const int selector : selectors) {
      for (const char* address : {"0x1000", "0x400000", "0xffffe000"}) {
        routines.add(fmt::format("mov ax, {}\nmov {}, ax\nmov eax, [{}:dword {}]", selector,
                                 segment, segment, address));
      }
    }
  }
}

/// The way back: its bytes, the segments that it names, and jumps into the middle of it.
void add_exit(Routines& routines) {
  // Were a linear address in it, that of what follows the segment would tell the segment's.
  for (int i = 0; i < 5; ++i) {
    routines.add(
        fmt::format("pop {0}\nmov{2} ecx, {0}\nmov edi, [ecx + {1}]\nmov ecx, ds\n"
                    "lsl ecx, ecx\ninc ecx\nsub edi, ecx\nadd edi, wide\n"
                    "push dword 0x33\npush edi\no32 retf",
                    routines.a(), i, routines.bits() == 16 ? "zx" : ""));
  }
  for (int i = 0; i < 8; ++i) {
    routines.add(fmt::format("pop {0}\nadd {0}, {1}\njmp {0}", routines.a(), i));
    for (int descriptor = 0; descriptor < 4; ++descriptor) {
      routines.add(fmt::format("jmp {}:{}", descriptor * 8 + 7, i));
      routines.add(fmt::format("mov ax, {}\nmov es, ax\nmov eax, [es:{}]", descriptor * 8 + 7, i));
    }
  }
}

/// Instructions of each width.
constexpr std::array of_any_width{"syscall",
                                  "sysenter",
                                  "sysexit",
                                  "int 0x80",
                                  "int3",
                                  "hlt",
                                  "cli",
                                  "sti",
                                  "rdtsc",
                                  "rdpmc",
                                  "rdmsr",
                                  "wrmsr",
                                  "clts",
                                  "invd",
                                  "wbinvd",
                                  "ud2",
                                  "xgetbv",
                                  "xsetbv",
                                  "cpuid",
                                  "rdrand eax",
                                  "in al, 0x60",
                                  "out 0x60, al",
                                  "str eax",
                                  "sldt eax",
                                  "smsw eax",
                                  "lmsw ax",
                                  "sgdt [land]",
                                  "sidt [land]",
                                  "lgdt [land]",
                                  "lidt [land]",
                                  "lldt ax",
                                  "ltr ax",
                                  "invlpg [land]",
                                  "lar eax, ax",
                                  "lsl eax, ax",
                                  "verr ax",
                                  "verw ax",
                                  "fnstenv [land]",
                                  "fnsave [land]",
                                  "fxsave [land]",
                                  "emms",
                                  "movd eax, mm0",
                                  "movd eax, xmm0",
                                  "xbegin land",
                                  "vmcall",
                                  "std",
                                  "cld",
                                  "enter 0x7fff, 31",
                                  "leave",
                                  "xlatb"};
/// Those that 64-bit code does not have.
constexpr std::array narrow_only{
    "into",         "pusha",        "popa",        "salc", "bound eax, [land]",
    "mov cr0, eax", "mov eax, cr3", "mov dr7, eax"};
/// Those that only 64-bit code has, or that need 64 bits.
constexpr std::array wide_only{"mov cr0, rax",
                               "mov cr3, rax",
                               "mov cr4, rax",
                               "mov cr8, rax",
                               "mov rax, cr3",
                               "mov dr7, rax",
                               "swapgs",
                               "sysret",
                               "o64 sysret",
                               "o64 sysexit",
                               "rdfsbase rax",
                               "wrfsbase rax",
                               "wrgsbase rax",
                               "mov ecx, 0xc0000080\nwrmsr",
                               "mov ecx, 0xc0000082\nwrmsr\nsyscall",
                               "mov ecx, 0xc0000100\nwrmsr\nmov eax, [fs:0]",
                               "mov ecx, 0x176\nwrmsr\nsysenter",
                               "invpcid rax, [land]",
                               "vmrun",
                               "vmload",
                               "clgi",
                               "stgi",
                               "skinit",
                               "rsm",
                               "xsave [rsp-4096]",
                               "xrstor [land]",
                               "fxrstor [land]",
                               "cmpxchg16b [land]",
                               "maskmovdqu xmm0, xmm1",
                               "clflush [land]",
                               "monitor",
                               "mwait",
                               "iretq",
                               "o64 retf",
                               "jmp far [land]",
                               "call far [land]",
                               "rep insb",
                               "rep outsd",
                               "int1",
                               "lock inc eax",
                               "push qword [esp]",
                               "db 0x62",
                               "db 0xc4",
                               "db 0x9a",
                               "db 0xf1",
                               "times 16 db 0x66\nnop",
                               "lgdt [.gdt]\nlidt [.gdt]\nint3\n.gdt: dw 0xffff\ndq 0x100"};

void add_instructions(Routines& routines) {
  for (const char* code : of_any_width) routines.add(code);
  for (const char* code : narrow_only) routines.add(code);
  for (int bit = 0; bit < 22; ++bit) {
    routines.add(fmt::format("pushfd\n{}\nxor dword [ebp], {}\npopfd\nnop",
                             routines.bits() == 16 ? "movzx ebp, sp" : "mov ebp, esp", 1 << bit));
  }
  for (int i = 0; i < 256; i += 5) routines.add(fmt::format("int {}", i));
  for (const char* place : {"0", "1", "0xfffe", "0x7fffffff", "0xffffffff"}) {
    routines.add(fmt::format("mov esp, {}\npush eax", place));
    routines.add(fmt::format("mov edi, {}\nmov [edi], eax", place));
    routines.add(fmt::format("mov edi, {}\njmp {}di", place, routines.a()[0] == 'e' ? "e" : ""));
    routines.add(fmt::format("mov esi, land\nmov edi, {}\nmov ecx, -1\nrep a32 movsd", place));
  }
}

/// Where the process may have memory, and the ends of what addresses there are.
constexpr std::array<std::string_view, 12> wide_places{
    "0x100000",       "0xffffffff",         "0x100000000",        "0x555555554000",
    "0x5555555d0000", "0x7ffff7fc0000",     "0x7ffffffde000",     "0x7fffffffffff",
    "0x800000000000", "0xffff800000000000", "0xffffffffff600000", "0xffffffffffffffff"};

void add_wide_memory(Routines& routines) {
  for (const std::string_view place : wide_places) {
    const std::string at = fmt::format("mov rdi, {}\nlea rsi, [land]\n", place);
    for (const char* code :
         {"mov rax, [rdi]", "mov [rdi], rax", "jmp rdi", "call rdi", "push rdi\nret", "jmp [rdi]",
          "mov rsp, rdi\npush rax", "mov rsp, rdi\npop rax", "mov ecx, 4096\nrep movsq",
          "mov rcx, -1\nrep stosb", "std\nmov rcx, -1\nrep movsb", "movups [rdi], xmm0",
          "lock xadd [rdi], rax", "fnsave [rdi]", "enter 0x7fff, 31", "mov rsp, rdi\nint3"}) {
      routines.add(at + code);
    }
    for (const char* msr : {"0xc0000100", "0xc0000101"}) {  // the bases of FS and GS
      routines.add(
          fmt::format("mov rax, {}\nmov rdx, rax\nshr rdx, 32\nmov ecx, {}\nwrmsr\n"
                      "mov [fs:0], eax\nmov [gs:0], eax",
                      place, msr));
    }
  }
}

void add_wide_transfers(Routines& routines) {
  for (const int selector : selectors) {
    for (const char* place : {"land", "wide", "0", "0x7ffff7fc0000"}) {
      routines.add(fmt::format("mov rax, {}\npush {}\npush rax\no64 retf", place, selector));
      routines.add(fmt::format("mov rax, {}\npush {}\npush rsp\npushfq\npush {}\npush rax\niretq",
                               place, selector, selector));
    }
    for (const char* segment : {"ds", "es", "fs", "gs", "ss"}) {
      routines.add(
          fmt::format("mov eax, {0}\nmov {1}, ax\nmov eax, [{1}:0x1000]", selector, segment));
    }
    // A table of descriptors of its own: 32-bit code, and data.
    routines.add(
        fmt::format("lgdt [.table]\npush {}\nlea rax, [land]\npush rax\no64 retf\n"
                    ".table: dw 0xffff\ndq .gdt - 8\n"
                    ".gdt: times 7 dq 0x00cf9b000000ffff, 0x00cf93000000ffff",
                    selector));
  }
  // Pages of its own, on, and 32-bit code without them.
  routines.add(
      "mov rax, cr4\nor eax, 0x20\nmov cr4, rax\nlea rax, [land]\nmov cr3, rax\n"
      "mov rax, cr0\nor eax, 0x80000001\nmov cr0, rax\nmov rax, [0x7ffff000]");
  routines.add("xor eax, eax\nmov cr0, rax\njmp land");
  for (int i = 0; i < 8; ++i) {
    routines.add(fmt::format("mov rax, [rsp]\nadd rax, {}\njmp rax", i));
    routines.add(fmt::format("mov rax, [rsp]\nmov byte [rax+{}], 0x0f\nmov rcx, [rax+8]", i));
  }
}

void add_wide_instructions(Routines& routines) {
  for (const char* code : of_any_width) routines.add(code);
  for (const char* code : wide_only) routines.add(code);
  for (int bit = 0; bit < 22; ++bit) {
    routines.add(fmt::format("pushfq\nxor dword [rsp], {}\npopfq\nnop", 1 << bit));
  }
  for (int i = 0; i < 256; i += 5) routines.add(fmt::format("int {}", i));
  // What is no code.
  for (std::uint64_t i = 0; i < 100; ++i) {
    cases::Draw draw(64, i);
    std::string bytes = "db 0";
    for (int n = 0; n < 40; ++n) bytes += fmt::format(", {}", draw.bits() & 0xFFU);
    routines.add("nop\n" + bytes);
  }
}

std::size_t open_descriptors() {
  const std::filesystem::directory_iterator first("/proc/self/fd");
  return static_cast<std::size_t>(std::distance(begin(first), end(first)));
}

void add_all(Routines& routines) {
  if (routines.bits() == 64) {
    add_wide_memory(routines);
    add_wide_transfers(routines);
    return add_wide_instructions(routines);
  }
  add_far_transfers(routines);
  add_segments(routines);
  add_exit(routines);
  add_instructions(routines);
}

void expect_kept_in(int bits, judge::On machine) {
  if (const auto absence = machine_code::HostSegment::absence();
      machine == judge::On::processor && !absence.empty()) {
    GTEST_SKIP() << absence;
  }
  Routines routines(bits);
  add_all(routines);
  EXPECT_GE(routines.count(), 200);
  const ScratchFolder folder;
  judge::LoadOptions options;
  options.bits = bits;
  judge::Subject subject{.image = judge::load(folder.write("attack.asm", routines.text()), options),
                         .frame = judge::frame_named(
                             bits == 64 ? "eax, ebx -> eax" : "dx:ax, cx:bx -> dx:ax", bits, {}),
                         .variant = {.operation = cases::Operation::mul, .format = cases::q16_16}};
  const auto symbols = subject.image.symbols;
  const std::vector<std::uint32_t> words{0x10000, 0x10000, 0x18000, 0x20000, 1, 2};
  const std::size_t open = open_descriptors();
  int ran = 0;
  for (const judge::Symbol& symbol : symbols) {
    if (!symbol.name.starts_with("try") || symbol.name.find('.') != std::string::npos) continue;
    ++ran;
    subject.image.entry = symbol.offset;
    judge::Runner runner(subject, machine);
    const auto answers = runner.answers(words);
    EXPECT_LE(answers.size(), cases_asked) << symbol.name;
    for (const judge::Answer& answer : answers) EXPECT_NE(answer.words[0], mark) << symbol.name;
    EXPECT_NE(runner.downfall(), judge::Downfall::false_reply) << symbol.name;
  }
  EXPECT_EQ(ran, routines.count());
  EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1) << "a child is left";
  EXPECT_EQ(open_descriptors(), open);
}

TEST(Attack, RoutinesOf16BitsStayInTheirSegment) { expect_kept_in(16, judge::On::processor); }
TEST(Attack, RoutinesOf32BitsStayInTheirSegment) { expect_kept_in(32, judge::On::processor); }
TEST(Attack, RoutinesOf64BitsStayInTheirMemory) { expect_kept_in(64, judge::On::unicorn); }

}  // namespace
