// Tests that routines execute everything that the model implements.
#include "tests/support/test.hpp"
#include "tests/x86model/cases.hpp"
#include "x86model/forms.hpp"
#include "x86model/text.hpp"

namespace {

using namespace x86model;

TEST(Coverage, EveryInstructionOfEveryProgramIsExecuted) {
  test::each_routine([]<Routine routine, Target target>() {
    for (const Build& build : test::builds) {
      if (!test::is_for(build, target)) continue;
      const Program program = assemble(listing(routine, target), build);
      std::vector<bool> executed(program.size);
      const auto words = test::cases(routine);
      const auto in = static_cast<std::size_t>(arity(routine).in);
      std::array<std::uint32_t, 12> out{};
      for (std::size_t i = 0; i + in <= words.size(); i += in) {
        call<routine, 16>(program.instructions(), std::span(words).subspan(i, in),
                          std::span(out).first(static_cast<std::size_t>(arity(routine).out)),
                          [&](std::size_t at, const auto&) { executed[at] = true; });
      }
      for (std::size_t at = 0; at < program.size; ++at) {
        EXPECT_TRUE(executed[at]) << name_of(routine) << ": " << at << ' '
                                  << text_of(program.code.at(at));
      }
    }
  });
}

TEST(Coverage, The8088HasOnlyItsOwnInstructions) {
  const std::set<Mnemonic> of_the_386{Mnemonic::shld, Mnemonic::shrd};
  test::each_routine([&]<Routine routine, Target target>() {
    if (target == Target::i386) return;
    const Program program = assemble(listing(routine, target), {});
    for (const Instruction& i : program.instructions()) {
      EXPECT_FALSE(of_the_386.contains(i.mnemonic)) << text_of(i);
      for (const Operand& o : i.operands) EXPECT_NE(o.size, Size::dword) << text_of(i);
      if (detail::is_shift(i.mnemonic)) {
        EXPECT_EQ(i.operands[1].value, 1) << "an 8088 shifts by one: " << text_of(i);
      }
    }
  });
}

TEST(Coverage, FormsAreThoseOfTheListings) {
  using namespace x86model::notation;
  EXPECT_TRUE(is_modelled(adc(bx, dx), Target::i8088));
  EXPECT_TRUE(is_modelled(imul(ebx), Target::i386)) << "a register stands for r/m";
  EXPECT_FALSE(is_modelled(imul(ebx), Target::i8088));
  EXPECT_FALSE(is_modelled(imul(bx), Target::i386));
  EXPECT_FALSE(is_modelled(shl(bx, 2), Target::i8088));
  EXPECT_TRUE(is_modelled(shl(bx, 1), Target::i8088));
  EXPECT_TRUE(is_modelled(shl(bx, 2), Target::i386));
  EXPECT_FALSE(is_modelled(add(eax, dx), Target::i386)) << "operands of two sizes";
}

}  // namespace
