#include "judge/code/architecture.hpp"

#include <elf.h>
#include <fmt/format.h>
#include <unicorn/unicorn.h>

#include <algorithm>
#include <span>

#include "support/split.hpp"

namespace fixproof::judge {

namespace {

// The conventions are those of: Procedure Call Standard for the Arm Architecture and for the Arm
// 64-bit Architecture (Arm), RISC-V ELF psABI, System V ABI MIPS Processor Supplement, System V ABI
// Motorola 68000 Processor Supplement as GCC follows it, Power Architecture 32-bit ABI Supplement,
// zSeries ELF ABI Supplement, and System V ABI SPARC Processor Supplement.

constexpr std::string_view mips_names =
    "at v0 v1 a0 a1 a2 a3 t0 t1 t2 t3 t4 t5 t6 t7 s0 s1 s2 s3 s4 s5 s6 s7 t8 t9 k0 k1 gp sp fp ra";
constexpr std::string_view mips_kept = "s0 s1 s2 s3 s4 s5 s6 s7 gp fp";
constexpr std::string_view riscv_names =
    "ra sp gp tp t0 t1 t2 s0 s1 a0 a1 a2 a3 a4 a5 a6 a7 s2 s3 s4 s5 s6 s7 s8 s9 s10 s11 t3 t4 t5 "
    "t6";
constexpr std::string_view riscv_kept = "gp tp s0 s1 s2 s3 s4 s5 s6 s7 s8 s9 s10 s11";
constexpr std::uint64_t riscv_floating_point = 0x6000;
constexpr std::uint64_t mips_floating_point = 0x2000'0000;
/// Compilers trap a divisor of 0: the instruction itself has no exception.
constexpr int mips_trap = 22;
constexpr std::array riscv_scratch{Scratch{UC_RISCV_REG_F0, 8}, Scratch{UC_RISCV_REG_F10, 8},
                                   Scratch{UC_RISCV_REG_F28, 4}, Scratch{}};
/// D and DR; DLR, DLGR, DSGR and DSGFR; DL, DLG, DSG and DSGF. Each divides a pair of registers
/// that begins in an even one. All program interruptions have one number in Unicorn.
constexpr std::array<Pattern, 8> s390x_divides{Pattern{0x10BF, 0x1D},
                                               {0x1000'EFFF, 0x87B9},
                                               {0x1000'EFFF, 0x0DB9},
                                               {0xEF00'0000'10FF, 0x8700'0000'00E3},
                                               {0xEF00'0000'10FF, 0x0D00'0000'00E3}};
/// Addresses of 64 bits; otherwise Unicorn takes 24 bits of them.
constexpr std::uint64_t s390x_addresses = 0x1'8000'0000;
/// avr2 to avr51 but avr6: those that have more than 128 KiB of code are other rows, and neither
/// XMEGA nor the smallest have this convention or memory.
constexpr std::array<unsigned, 8> avr_kinds{2, 25, 3, 31, 35, 4, 5, 51};

constexpr Architecture mips(bool is_big_endian) {
  return {.name = is_big_endian ? "big-endian MIPS" : "MIPS",
          .machine = EM_MIPS,
          .is_64 = false,
          .is_big_endian = is_big_endian,
          .word_bits = 32,
          .pointer_bits = 32,
          .emulator = UC_ARCH_MIPS,
          .mode = is_big_endian ? UC_MODE_MIPS32 | UC_MODE_BIG_ENDIAN : UC_MODE_MIPS32,
          .runs = {RegisterRun{mips_names, UC_MIPS_REG_1}},
          .program_counter = UC_MIPS_REG_PC,
          .settings = {Setting{UC_MIPS_REG_CP0_STATUS, mips_floating_point}},
          .scratch = {Scratch{UC_MIPS_REG_HI, 2}},
          .divide_errors = {mips_trap, -1},
          .system_calls = {17, -1},
          .bad_instructions = {20, -1},
          .stack_pointer = "sp",
          .link = "ra",
          .callee = "t9",
          .arguments = "a0 a1 a2 a3",
          .results = "v0 v1",
          .kept = mips_kept,
          .bases = {BaseRegister{"gp", "_gp"}},
          .has_even_pairs = true,
          .first_on_stack = 16,
          .toolchains = {is_big_endian ? "mips-linux-gnu" : "mipsel-linux-gnu"},
          .package = is_big_endian ? "gcc-mips-linux-gnu" : "gcc-mipsel-linux-gnu",
          .relocations = {R_MIPS_REL32, R_MIPS_REL32, R_MIPS_GLOB_DAT, R_MIPS_JUMP_SLOT}};
}

/// An AVR whose return addresses have two or three bytes.
constexpr Architecture avr(bool is_large) {
  return {.name = is_large ? "AVR with over 128 KiB" : "AVR",
          .machine = EM_AVR,
          .is_64 = false,
          .is_big_endian = false,
          .kinds = is_large ? std::array<unsigned, 8>{6} : avr_kinds,
          .kind_bits = 0x7F,
          .word_bits = 8,
          .pointer_bits = 16,
          .data = {.first = 0x80'0000,
                   .variables = 0x80'0200,
                   .code_end = is_large ? 0x80'0000U : 0x2'0000U},
          .is_on_simavr = true,
          .runs = {RegisterRun{"r0 r1 r2 r3 r4 r5 r6 r7 r8 r9 r10 r11 r12 r13 r14 r15 r16 r17 r18 "
                               "r19 r20 r21 r22 r23 r24 r25 r26 r27 r28 r29 r30 r31 sp",
                               0}},
          .stack_pointer = "sp",
          .pushed = {.above = 1, .bytes = is_large ? 3 : 2, .unit = 2},
          .arguments = "r25 r24 r23 r22 r21 r20 r19 r18 r17 r16 r15 r14 r13 r12 r11 r10 r9 r8",
          .results = "r25 r24 r23 r22 r21 r20 r19 r18",
          .kept = "r1 r2 r3 r4 r5 r6 r7 r8 r9 r10 r11 r12 r13 r14 r15 r16 r17 r28 r29",
          .zero = "r1",
          .has_falling_numbers = true,
          .first_on_stack = is_large ? 4U : 3U,
          .toolchains = {"avr"},
          .package = "gcc-avr",
          .linked_as = "avr"};
}

constexpr std::array architectures{
    Architecture{
        .name = "ARM",
        .machine = EM_ARM,
        .is_64 = false,
        .is_big_endian = false,
        .word_bits = 32,
        .pointer_bits = 32,
        .emulator = UC_ARCH_ARM,
        .mode = UC_MODE_ARM,
        .model = UC_CPU_ARM_MAX,
        .runs = {RegisterRun{"r0 r1 r2 r3 r4 r5 r6 r7 r8 r9 r10 r11 r12", UC_ARM_REG_R0},
                 {"sp", UC_ARM_REG_SP},
                 {"lr", UC_ARM_REG_LR}},
        .program_counter = UC_ARM_REG_PC,
        .settings = {Setting{UC_ARM_REG_C1_C0_2, 0xF0'0000}, {UC_ARM_REG_FPEXC, 0x4000'0000}},
        .scratch = {Scratch{UC_ARM_REG_CPSR, 1, 0xF80F'0000},
                    {UC_ARM_REG_D0, 8},
                    {UC_ARM_REG_D16, 16}},
        .system_calls = {2, -1},
        .has_marked_entries = true,
        .stack_pointer = "sp",
        .link = "lr",
        .arguments = "r0 r1 r2 r3",
        .results = "r0 r1",
        .kept = "r4 r5 r6 r7 r8 r9 r10 r11",
        .has_even_pairs = true,
        .toolchains = {"arm-none-eabi", "arm-linux-gnueabihf", "arm-linux-gnueabi"},
        .package = "gcc-arm-none-eabi",
        .relocations = {R_ARM_RELATIVE, R_ARM_ABS32, R_ARM_GLOB_DAT, R_ARM_JUMP_SLOT}},
    Architecture{.name = "AArch64",
                 .machine = EM_AARCH64,
                 .is_64 = true,
                 .is_big_endian = false,
                 .word_bits = 64,
                 .pointer_bits = 64,
                 .emulator = UC_ARCH_ARM64,
                 .mode = UC_MODE_ARM,
                 .runs = {RegisterRun{"x0 x1 x2 x3 x4 x5 x6 x7 x8 x9 x10 x11 x12 x13 x14 x15 x16 "
                                      "x17 x18 x19 x20 x21 x22 x23 x24 x25 x26 x27 x28",
                                      UC_ARM64_REG_X0},
                          {"x29 x30", UC_ARM64_REG_X29},
                          {"sp", UC_ARM64_REG_SP}},
                 .program_counter = UC_ARM64_REG_PC,
                 .settings = {Setting{UC_ARM64_REG_CPACR_EL1, 0x30'0000}},
                 .scratch = {Scratch{UC_ARM64_REG_NZCV, 1, 0xF000'0000},
                             {UC_ARM64_REG_D0, 8},
                             {UC_ARM64_REG_D16, 16}},
                 .system_calls = {2, -1},
                 .bad_instructions = {1, -1},
                 .stack_pointer = "sp",
                 .link = "x30",
                 .arguments = "x0 x1 x2 x3 x4 x5 x6 x7",
                 .results = "x0 x1",
                 .kept = "x19 x20 x21 x22 x23 x24 x25 x26 x27 x28 x29",
                 .above = Above::noise,
                 .toolchains = {"aarch64-linux-gnu", "aarch64-none-elf"},
                 .package = "gcc-aarch64-linux-gnu",
                 .relocations = {R_AARCH64_RELATIVE, R_AARCH64_ABS64, R_AARCH64_GLOB_DAT,
                                 R_AARCH64_JUMP_SLOT}},
    Architecture{.name = "RISC-V of 32 bits",
                 .machine = EM_RISCV,
                 .is_64 = false,
                 .is_big_endian = false,
                 .word_bits = 32,
                 .pointer_bits = 32,
                 .emulator = UC_ARCH_RISCV,
                 .mode = UC_MODE_RISCV32,
                 .runs = {RegisterRun{riscv_names, UC_RISCV_REG_X1}},
                 .program_counter = UC_RISCV_REG_PC,
                 .settings = {Setting{UC_RISCV_REG_MSTATUS, riscv_floating_point}},
                 .scratch = riscv_scratch,
                 .system_calls = {8, 11},
                 .bad_instructions = {2, -1},
                 .stack_pointer = "sp",
                 .link = "ra",
                 .arguments = "a0 a1 a2 a3 a4 a5 a6 a7",
                 .results = "a0 a1",
                 .kept = riscv_kept,
                 .bases = {BaseRegister{"gp", "__global_pointer$"}},
                 .toolchains = {"riscv64-unknown-elf", "riscv32-unknown-elf"},
                 .package = "gcc-riscv64-unknown-elf",
                 .linked_as = "elf32lriscv",
                 .relocations = {R_RISCV_RELATIVE, R_RISCV_32, R_RISCV_32, R_RISCV_JUMP_SLOT}},
    Architecture{.name = "RISC-V of 64 bits",
                 .machine = EM_RISCV,
                 .is_64 = true,
                 .is_big_endian = false,
                 .word_bits = 64,
                 .pointer_bits = 64,
                 .emulator = UC_ARCH_RISCV,
                 .mode = UC_MODE_RISCV64,
                 .runs = {RegisterRun{riscv_names, UC_RISCV_REG_X1}},
                 .program_counter = UC_RISCV_REG_PC,
                 .settings = {Setting{UC_RISCV_REG_MSTATUS, riscv_floating_point}},
                 .scratch = riscv_scratch,
                 .system_calls = {8, 11},
                 .bad_instructions = {2, -1},
                 .stack_pointer = "sp",
                 .link = "ra",
                 .arguments = "a0 a1 a2 a3 a4 a5 a6 a7",
                 .results = "a0 a1",
                 .kept = riscv_kept,
                 .bases = {BaseRegister{"gp", "__global_pointer$"}},
                 .above = Above::extension_of_32,
                 .toolchains = {"riscv64-linux-gnu", "riscv64-unknown-elf"},
                 .package = "gcc-riscv64-linux-gnu",
                 .linked_as = "elf64lriscv",
                 .relocations = {R_RISCV_RELATIVE, R_RISCV_64, R_RISCV_64, R_RISCV_JUMP_SLOT}},
    mips(true),
    mips(false),
    Architecture{.name = "68000",
                 .machine = EM_68K,
                 .is_64 = false,
                 .is_big_endian = true,
                 .word_bits = 32,
                 .pointer_bits = 32,
                 .emulator = UC_ARCH_M68K,
                 .mode = UC_MODE_BIG_ENDIAN,
                 .model = UC_CPU_M68K_M68020,
                 .runs = {RegisterRun{"d0 d1 d2 d3 d4 d5 d6 d7", UC_M68K_REG_D0},
                          {"a0 a1 a2 a3 a4 a5 a6 sp", UC_M68K_REG_A0}},
                 .program_counter = UC_M68K_REG_PC,
                 .scratch = {Scratch{UC_M68K_REG_SR, 1, 0x1F}},
                 .divide_errors = {5, -1},
                 .system_calls = {32, -1},
                 .bad_instructions = {4, 10},
                 .stack_pointer = "sp",
                 .results = "d0 d1",
                 .kept = "d2 d3 d4 d5 d6 d7 a2 a3 a4 a5 a6",
                 .first_on_stack = 4,
                 .toolchains = {"m68k-linux-gnu", "m68k-elf"},
                 .package = "gcc-m68k-linux-gnu",
                 .relocations = {R_68K_RELATIVE, R_68K_32, R_68K_GLOB_DAT, R_68K_JMP_SLOT}},
    Architecture{.name = "PowerPC",
                 .machine = EM_PPC,
                 .is_64 = false,
                 .is_big_endian = true,
                 .word_bits = 32,
                 .pointer_bits = 32,
                 .emulator = UC_ARCH_PPC,
                 .mode = UC_MODE_PPC32 | UC_MODE_BIG_ENDIAN,
                 .runs = {RegisterRun{"r0 r1 r2 r3 r4 r5 r6 r7 r8 r9 r10 r11 r12 r13 r14 r15 r16 "
                                      "r17 r18 r19 r20 r21 r22 r23 r24 r25 r26 r27 r28 r29 r30 r31",
                                      UC_PPC_REG_0},
                          {"lr", UC_PPC_REG_LR}},
                 .program_counter = UC_PPC_REG_PC,
                 .settings = {Setting{UC_PPC_REG_MSR, 0x2000}},
                 .scratch = {Scratch{UC_PPC_REG_CR, 1, 0xFF00'0FFF},
                             {UC_PPC_REG_XER, 1, 0xE000'0000},
                             {UC_PPC_REG_CTR, 1},
                             {UC_PPC_REG_FPR0, 14}},
                 .system_calls = {8, -1},
                 .bad_instructions = {96, -1},
                 .stack_pointer = "r1",
                 .link = "lr",
                 .arguments = "r3 r4 r5 r6 r7 r8 r9 r10",
                 .results = "r3 r4",
                 .kept = "r2 r13 r14 r15 r16 r17 r18 r19 r20 r21 r22 r23 r24 r25 r26 r27 r28 r29 "
                         "r30 r31",
                 .bases = {BaseRegister{"r13", "_SDA_BASE_"}, {"r2", "_SDA2_BASE_"}},
                 .has_even_pairs = true,
                 .first_on_stack = 8,
                 .toolchains = {"powerpc-linux-gnu"},
                 .package = "gcc-powerpc-linux-gnu",
                 .relocations = {R_PPC_RELATIVE, R_PPC_ADDR32, R_PPC_GLOB_DAT, R_PPC_JMP_SLOT}},
    Architecture{.name = "s390x",
                 .machine = EM_S390,
                 .is_64 = true,
                 .is_big_endian = true,
                 .word_bits = 64,
                 .pointer_bits = 64,
                 .emulator = UC_ARCH_S390X,
                 .mode = UC_MODE_BIG_ENDIAN,
                 .runs = {RegisterRun{"r0 r1 r2 r3 r4 r5 r6 r7 r8 r9 r10 r11 r12 r13 r14 r15",
                                      UC_S390X_REG_R0}},
                 .program_counter = UC_S390X_REG_PC,
                 .settings = {Setting{UC_S390X_REG_PSWM, s390x_addresses}},
                 // LCTLG 0,0,0(1), and the bit that allows floating point.
                 .first_code = {.code = std::string_view("\xEB\0\x10\0\0\x2F", 6),
                                .base = "r1",
                                .value = 0x4'0000},
                 .scratch = {Scratch{UC_S390X_REG_PSWM, 1, std::uint64_t{3} << 44U}},
                 .divide_errors = {3, -1},
                 .system_calls = {2, -1},
                 .divides = s390x_divides,
                 .stack_pointer = "r15",
                 .link = "r14",
                 .arguments = "r2 r3 r4 r5 r6",
                 .results = "r2",
                 .kept = "r6 r7 r8 r9 r10 r11 r12 r13",
                 .first_on_stack = 160,
                 .toolchains = {"s390x-linux-gnu"},
                 .package = "gcc-s390x-linux-gnu",
                 .relocations = {R_390_RELATIVE, R_390_64, R_390_GLOB_DAT, R_390_JMP_SLOT}},
    Architecture{.name = "SPARC",
                 .machine = EM_SPARC,
                 .is_64 = false,
                 .is_big_endian = true,
                 .word_bits = 32,
                 .pointer_bits = 32,
                 .emulator = UC_ARCH_SPARC,
                 .mode = UC_MODE_SPARC32 | UC_MODE_BIG_ENDIAN,
                 .runs = {RegisterRun{"g1 g2 g3 g4 g5 g6 g7", UC_SPARC_REG_G1},
                          {"i0 i1 i2 i3 i4 i5 fp i7", UC_SPARC_REG_I0},
                          {"l0 l1 l2 l3 l4 l5 l6 l7", UC_SPARC_REG_L0},
                          {"o0 o1 o2 o3 o4 o5 sp o7", UC_SPARC_REG_O0}},
                 .program_counter = UC_SPARC_REG_PC,
                 .beyond_stop = 4,
                 .divide_errors = {42, -1},
                 .system_calls = {144, 136},
                 .bad_instructions = {2, 3},
                 .stack_pointer = "sp",
                 .link = "o7",
                 .behind_link = 8,
                 .arguments = "o0 o1 o2 o3 o4 o5",
                 .results = "o0 o1",
                 .kept = "g6 g7 i0 i1 i2 i3 i4 i5 fp i7 l0 l1 l2 l3 l4 l5 l6 l7",
                 .first_on_stack = 92,
                 .toolchains = {"sparc64-linux-gnu"},
                 .package = "gcc-sparc64-linux-gnu",
                 .has_library = false,
                 .linked_as = "elf32_sparc",
                 .relocations = {R_SPARC_RELATIVE, R_SPARC_32, R_SPARC_GLOB_DAT, R_SPARC_GLOB_DAT}},
    avr(false),
    avr(true),
};

bool is_big_endian(std::string_view elf) { return elf[EI_DATA] == ELFDATA2MSB; }

/// Reads a number of the header of an ELF file.
unsigned header_number(std::string_view elf, std::size_t at, std::size_t bytes) {
  unsigned value = 0;
  for (std::size_t i = 0; i < bytes; ++i) {
    const std::size_t place = is_big_endian(elf) ? at + i : at + bytes - 1 - i;
    value = value << 8U | static_cast<unsigned char>(elf[place]);
  }
  return value;
}

}  // namespace

RegisterFile::RegisterFile(const Architecture& architecture) {
  for (const RegisterRun& run : architecture.runs) {
    int number = run.first;
    for (const std::string_view name : support::split(run.names, ' ')) {
      names.emplace_back(name);
      numbers.push_back(number++);
    }
  }
}

std::optional<std::size_t> RegisterFile::find(std::string_view name) const {
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) return std::nullopt;
  return static_cast<std::size_t>(found - names.begin());
}

std::vector<std::size_t> RegisterFile::all(std::string_view list) const {
  std::vector<std::size_t> found;
  for (const std::string_view name : support::split(list, ' ')) found.push_back(find(name).value());
  return found;
}

unsigned kind_of_elf(const Architecture& architecture, std::string_view bytes) {
  const std::size_t place_of_flags = architecture.is_64 ? 48 : 36;
  if (bytes.size() < place_of_flags + 4) return 0;
  return header_number(bytes, place_of_flags, 4) & architecture.kind_bits;
}

const Architecture* architecture_of_elf(std::string_view bytes) {
  constexpr std::size_t place_of_machine = 18;  // in files of both classes
  if (bytes.size() < place_of_machine + 2 || !bytes.starts_with("\177ELF")) return nullptr;
  const bool is_64 = bytes[EI_CLASS] == ELFCLASS64;
  const unsigned machine = header_number(bytes, place_of_machine, 2);
  const auto* const found = std::ranges::find_if(architectures, [&](const Architecture& a) {
    return a.machine == machine && a.is_64 == is_64 && a.is_big_endian == is_big_endian(bytes) &&
           (a.kind_bits == 0 || std::ranges::find(a.kinds, kind_of_elf(a, bytes)) != a.kinds.end());
  });
  return found == architectures.end() ? nullptr : &*found;
}

std::string_view emulator_of(const Architecture* architecture) {
  return architecture != nullptr && architecture->is_on_simavr ? "simavr" : "Unicorn";
}

std::string names_of_architectures() {
  std::string names;
  for (const Architecture& a : architectures) {
    names += fmt::format("{}{}", names.empty() ? "" : ", ", a.name);
  }
  return names;
}

}  // namespace fixproof::judge
