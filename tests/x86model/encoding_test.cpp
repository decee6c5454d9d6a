#include "x86model/encoding.hpp"

#include "tests/support/test.hpp"
#include "verify/machine_code/machine_code.hpp"
#include "x86model/cosine_table.hpp"
#include "x86model/notation.hpp"
#include "x86model/text.hpp"

namespace {

using namespace x86model;
using namespace x86model::notation;

/// The programs together contain every form, so a wrong length of any form changes some sum.
TEST(Encoding, ProgramsAreAsLongAsNasmMakesThem) {
  for (const fixproof::machine_code::ProgramKey& key : fixproof::machine_code::all_programs()) {
    const auto assembled = fixproof::machine_code::machine_code(key);
    if (assembled.empty()) GTEST_SKIP() << fixproof::machine_code::machine_code_absence();
    const std::size_t table = key.routine == Routine::cossin ? 4 * cosine_table.size() : 0;
    int bytes = 0;
    const Program program = assemble(listing(key.routine, key.target), key.build);
    for (const Instruction& i : program.instructions()) bytes += encoding_of(i).bytes();
    EXPECT_EQ(static_cast<std::size_t>(bytes), assembled.size() - table)
        << fixproof::machine_code::name_of(key);
  }
}

TEST(Encoding, LoopsAreAsLongAsNasmMakesThem) {
  for (const LoopForm& form : all_loop_forms()) {
    const auto assembled = fixproof::machine_code::machine_code(form);
    if (assembled.empty()) GTEST_SKIP() << fixproof::machine_code::machine_code_absence();
    int bytes = 0;
    for (const Instruction& i : code_of(form)) bytes += encoding_of(i).bytes();
    EXPECT_EQ(static_cast<std::size_t>(bytes), assembled.size())
        << fixproof::machine_code::name_of(form);
  }
}

/// Tests the length of each label's prefix, not only of whole programs: the displacement that NASM
/// puts at the end of a jump must lead to the place that the lengths give its label.
TEST(Encoding, LabelsStandWhereNasmPutsThem) {
  constexpr std::uint8_t short_jump = 0xEB;
  std::size_t jumps = 0;
  for (const fixproof::machine_code::ProgramKey& key : fixproof::machine_code::all_programs()) {
    const auto assembled = fixproof::machine_code::machine_code(key);
    if (assembled.empty()) GTEST_SKIP() << fixproof::machine_code::machine_code_absence();
    const Program program = assemble(listing(key.routine, key.target), key.build);
    const auto code = program.instructions();
    std::vector<std::int32_t> starts{0};
    for (const Instruction& i : code) starts.push_back(starts.back() + encoding_of(i).bytes());
    for (std::size_t i = 0; i < code.size(); ++i) {
      const Operand& to = code[i].operands[0];
      if (to.kind != Operand::Kind::label) continue;
      const auto end = static_cast<std::size_t>(starts[i + 1]);
      const bool near = code[i].mnemonic == Mnemonic::call ||
                        (code[i].mnemonic == Mnemonic::jmp &&
                         assembled[static_cast<std::size_t>(starts[i])] != short_jump);
      const auto place =
          near ? static_cast<std::int16_t>(assembled[end - 2] | unsigned{assembled[end - 1]} << 8U)
               : static_cast<std::int8_t>(assembled[end - 1]);
      EXPECT_EQ(starts[i + 1] + place, starts[static_cast<std::size_t>(to.value)])
          << fixproof::machine_code::name_of(key) << ' ' << text_of(code[i]);
      ++jumps;
    }
  }
  EXPECT_GT(jumps, 100U);
}

TEST(Encoding, PositionsAreThoseOfFirstBytes) {
  const std::array code{mov(al, dh), add(dx, bp), stosb(), ret()};
  EXPECT_EQ(position_at(code, 0), 0U);
  EXPECT_EQ(position_at(code, 2), 1U);
  EXPECT_EQ(position_at(code, 4), 2U);
  EXPECT_EQ(position_at(code, 5), 3U);
  for (const std::uint32_t nowhere : {1U, 3U, 6U, 7U, 0xFFFFU}) {
    EXPECT_EQ(position_at(code, nowhere), code.size()) << nowhere;
  }
}

/// The bytes as an assembler lists them, then the components that a 386 counts.
TEST(Encoding, PartsOfSomeInstructions) {
  struct Case {
    Instruction instruction;
    int bytes = 0;
    int components = 0;
  };
  const std::array cases{
      Case{push(bp), 1, 1},                            // 55
      Case{mov(bp, sp), 2, 2},                         // 89 E5
      Case{mov(word[di], ax), 2, 2},                   // 89 05
      Case{mov(ax, word[bp + 4]), 3, 3},               // 8B 46 04
      Case{mov(ax, word[CosTable + bx]), 4, 3},        // 8B 87 iw
      Case{mov(ax, word[cs(CosTable + bx)]), 5, 4},    // 2E 8B 87 iw
      Case{mov(eax, dword[cs(CosTable + bx)]), 6, 5},  // 2E 66 8B 87 iw
      Case{mov(eax, dword[bp + 4]), 4, 4},             // 66 8B 46 04
      Case{push(word[si + 200]), 4, 3},                // FF B4 C8 00
      Case{mov(ax, word[bp]), 3, 3},                   // 8B 46 00
      Case{add(sp, bytes(8)), 3, 3},                   // 83 C4 08
      Case{cmp(bx, 3600), 4, 3},                       // 81 FB 10 0E
      Case{add(ax, half_unit), 3, 2},                  // 05 00 80
      Case{add(eax, half_unit), 6, 3},                 // 66 05 00 80 00 00
      Case{adc(edx, 0), 4, 4},                         // 66 83 D2 00
      Case{shr(bx, 1), 2, 2},                          // D1 EB
      Case{shr(eax, word_bits), 4, 4},                 // 66 C1 E8 10
      Case{shld(edx, eax, word_bits), 5, 5},           // 66 0F A4 C2 10
      Case{shrd(eax, edx, 1), 5, 5},                   // 66 0F AC D0 01
      Case{neg(word[bp + 4]), 3, 3},                   // F7 5E 04
      Case{jmp("near"), 2, 2},                         // EB xx
      Case{jmp_near("far"), 3, 2},                     // E9 xx xx
      Case{jz("near"), 2, 2},                          // 74 xx
      Case{call("procedure"), 3, 2},                   // E8 xx xx
      Case{ret(), 1, 1},                               // C3
      Case{mov(al, dh), 2, 2},                         // 88 F0
      Case{mov(al, byte[Texture + bx]), 4, 3},         // 8A 87 iw
      Case{mov(byte[Screen + edi], al), 7, 4},         // 67 88 87 id
      Case{mov(word[ZBuff + twice(edi)], bx), 8, 5},   // 67 89 1C 7D id
      Case{cmp(bx, word[ZBuff + twice(edi)]), 8, 5},   // 67 3B 1C 7D id
      Case{add(esi, dword[IncJ]), 5, 4},               // 66 03 36 iw
      Case{inc(edi), 2, 2},                            // 66 47
      Case{stosb(), 1, 1},                             // AA
      Case{loop("near"), 2, 2},                        // E2 xx
      Case{jmp(bx), 2, 2},                             // FF E3
  };
  for (const Case& c : cases) {
    EXPECT_EQ(encoding_of(c.instruction).bytes(), c.bytes) << text_of(c.instruction);
    EXPECT_EQ(encoding_of(c.instruction).components(), c.components) << text_of(c.instruction);
  }
}

}  // namespace
