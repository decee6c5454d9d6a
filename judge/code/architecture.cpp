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
// and zSeries ELF ABI Supplement.

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

constexpr std::array architectures{
    Architecture{
        .name = "ARM",
        .machine = EM_ARM,
        .is_64 = false,
        .is_big_endian = false,
        .emulator = UC_ARCH_ARM,
        .mode = UC_MODE_ARM,
        .model = UC_CPU_ARM_MAX,
        .runs = {RegisterRun{"r0 r1 r2 r3 r4 r5 r6 r7 r8 r9 r10 r11 r12", UC_ARM_REG_R0},
                 {"sp", UC_ARM_REG_SP},
                 {"lr", UC_ARM_REG_LR}},
        .program_counter = UC_ARM_REG_PC,
        .settings = {Setting{UC_ARM_REG_C1_C0_2, 0xF0'0000}, {UC_ARM_REG_FPEXC, 0x4000'0000}},
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
                 .emulator = UC_ARCH_ARM64,
                 .mode = UC_MODE_ARM,
                 .runs = {RegisterRun{"x0 x1 x2 x3 x4 x5 x6 x7 x8 x9 x10 x11 x12 x13 x14 x15 x16 "
                                      "x17 x18 x19 x20 x21 x22 x23 x24 x25 x26 x27 x28",
                                      UC_ARM64_REG_X0},
                          {"x29 x30", UC_ARM64_REG_X29},
                          {"sp", UC_ARM64_REG_SP}},
                 .program_counter = UC_ARM64_REG_PC,
                 .settings = {Setting{UC_ARM64_REG_CPACR_EL1, 0x30'0000}},
                 .system_calls = {2, -1},
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
                 .emulator = UC_ARCH_RISCV,
                 .mode = UC_MODE_RISCV32,
                 .runs = {RegisterRun{riscv_names, UC_RISCV_REG_X1}},
                 .program_counter = UC_RISCV_REG_PC,
                 .settings = {Setting{UC_RISCV_REG_MSTATUS, riscv_floating_point}},
                 .system_calls = {8, 11},
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
                 .emulator = UC_ARCH_RISCV,
                 .mode = UC_MODE_RISCV64,
                 .runs = {RegisterRun{riscv_names, UC_RISCV_REG_X1}},
                 .program_counter = UC_RISCV_REG_PC,
                 .settings = {Setting{UC_RISCV_REG_MSTATUS, riscv_floating_point}},
                 .system_calls = {8, 11},
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
    Architecture{.name = "MIPS, big-endian",
                 .machine = EM_MIPS,
                 .is_64 = false,
                 .is_big_endian = true,
                 .emulator = UC_ARCH_MIPS,
                 .mode = UC_MODE_MIPS32 | UC_MODE_BIG_ENDIAN,
                 .runs = {RegisterRun{mips_names, UC_MIPS_REG_1}},
                 .program_counter = UC_MIPS_REG_PC,
                 .settings = {Setting{UC_MIPS_REG_CP0_STATUS, mips_floating_point}},
                 .divide_errors = {mips_trap, -1},
                 .stack_pointer = "sp",
                 .link = "ra",
                 .callee = "t9",
                 .arguments = "a0 a1 a2 a3",
                 .results = "v0 v1",
                 .kept = mips_kept,
                 .bases = {BaseRegister{"gp", "_gp"}},
                 .has_even_pairs = true,
                 .first_on_stack = 16,
                 .toolchains = {"mips-linux-gnu"},
                 .package = "gcc-mips-linux-gnu"},
    Architecture{.name = "MIPS",
                 .machine = EM_MIPS,
                 .is_64 = false,
                 .is_big_endian = false,
                 .emulator = UC_ARCH_MIPS,
                 .mode = UC_MODE_MIPS32,
                 .runs = {RegisterRun{mips_names, UC_MIPS_REG_1}},
                 .program_counter = UC_MIPS_REG_PC,
                 .settings = {Setting{UC_MIPS_REG_CP0_STATUS, mips_floating_point}},
                 .divide_errors = {mips_trap, -1},
                 .stack_pointer = "sp",
                 .link = "ra",
                 .callee = "t9",
                 .arguments = "a0 a1 a2 a3",
                 .results = "v0 v1",
                 .kept = mips_kept,
                 .bases = {BaseRegister{"gp", "_gp"}},
                 .has_even_pairs = true,
                 .first_on_stack = 16,
                 .toolchains = {"mipsel-linux-gnu"},
                 .package = "gcc-mipsel-linux-gnu"},
    Architecture{.name = "68000",
                 .machine = EM_68K,
                 .is_64 = false,
                 .is_big_endian = true,
                 .emulator = UC_ARCH_M68K,
                 .mode = UC_MODE_BIG_ENDIAN,
                 .model = UC_CPU_M68K_M68020,
                 .runs = {RegisterRun{"d0 d1 d2 d3 d4 d5 d6 d7", UC_M68K_REG_D0},
                          {"a0 a1 a2 a3 a4 a5 a6 sp", UC_M68K_REG_A0}},
                 .program_counter = UC_M68K_REG_PC,
                 .divide_errors = {5, -1},
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
                 .emulator = UC_ARCH_PPC,
                 .mode = UC_MODE_PPC32 | UC_MODE_BIG_ENDIAN,
                 .runs = {RegisterRun{"r0 r1 r2 r3 r4 r5 r6 r7 r8 r9 r10 r11 r12 r13 r14 r15 r16 "
                                      "r17 r18 r19 r20 r21 r22 r23 r24 r25 r26 r27 r28 r29 r30 r31",
                                      UC_PPC_REG_0},
                          {"lr", UC_PPC_REG_LR}},
                 .program_counter = UC_PPC_REG_PC,
                 .settings = {Setting{UC_PPC_REG_MSR, 0x2000}},
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
                 .emulator = UC_ARCH_S390X,
                 .mode = UC_MODE_BIG_ENDIAN,
                 .runs = {RegisterRun{"r0 r1 r2 r3 r4 r5 r6 r7 r8 r9 r10 r11 r12 r13 r14 r15",
                                      UC_S390X_REG_R0}},
                 .program_counter = UC_S390X_REG_PC,
                 // Addresses of 64 bits. Unicorn begins with 24, and LA and LAY, with which
                 // compilers add, cut their sums to those.
                 .settings = {Setting{UC_S390X_REG_PSWM, 0x1'8000'0000}},
                 // LCTLG 0,0,0(1), and the bit that allows floating point.
                 .first_code = {.code = std::string_view("\xEB\0\x10\0\0\x2F", 6),
                                .base = "r1",
                                .value = 0x4'0000},
                 .stack_pointer = "r15",
                 .link = "r14",
                 .arguments = "r2 r3 r4 r5 r6",
                 .results = "r2",
                 .kept = "r6 r7 r8 r9 r10 r11 r12 r13",
                 .first_on_stack = 160,
                 .toolchains = {"s390x-linux-gnu"},
                 .package = "gcc-s390x-linux-gnu",
                 .relocations = {R_390_RELATIVE, R_390_64, R_390_GLOB_DAT, R_390_JMP_SLOT}},
};

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

const Architecture* architecture_of_elf(std::string_view bytes) {
  constexpr std::size_t place_of_machine = 18;  // of two bytes, in files of both classes
  if (bytes.size() < place_of_machine + 2 || !bytes.starts_with("\177ELF")) return nullptr;
  const bool is_64 = bytes[EI_CLASS] == ELFCLASS64;
  const bool is_big_endian = bytes[EI_DATA] == ELFDATA2MSB;
  const auto low = static_cast<unsigned char>(bytes[place_of_machine + (is_big_endian ? 1 : 0)]);
  const auto high = static_cast<unsigned char>(bytes[place_of_machine + (is_big_endian ? 0 : 1)]);
  const unsigned machine = high * 256U + low;
  const auto* const found = std::ranges::find_if(architectures, [&](const Architecture& a) {
    return a.machine == machine && a.is_64 == is_64 && a.is_big_endian == is_big_endian;
  });
  return found == architectures.end() ? nullptr : &*found;
}

std::string names_of_architectures() {
  std::string names;
  for (const Architecture& a : architectures) {
    names += fmt::format("{}{}", names.empty() ? "" : ", ", a.name);
  }
  return names;
}

}  // namespace fixproof::judge
