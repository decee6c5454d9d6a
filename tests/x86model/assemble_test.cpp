#include "x86model/assemble.hpp"

#include "tests/support/test.hpp"
#include "x86model/notation.hpp"
#include "x86model/text.hpp"

namespace {

using namespace x86model;
using namespace x86model::notation;

std::vector<std::string> texts(const Program& program) {
  std::vector<std::string> all;
  for (const Instruction& i : program.instructions()) all.push_back(text_of(i));
  return all;
}

TEST(Assemble, TakesTheBranchThatTheSwitchSays) {
  const Listing listing{
      if_(mul_rounding_on),
      inc(ax),
      if_(div_rounding_on),
      inc(bx),
      else_(),
      dec(bx),
      endif(),
      else_(),
      dec(ax),
      if_(div_rounding_on),
      inc(cx),
      endif(),
      endif(),
      ret(),
  };
  using Texts = std::vector<std::string>;
  EXPECT_EQ(texts(assemble(listing, {.mul_rounding = true, .div_rounding = true})),
            (Texts{"inc ax", "inc bx", "ret"}));
  EXPECT_EQ(texts(assemble(listing, {.mul_rounding = true, .div_rounding = false})),
            (Texts{"inc ax", "dec bx", "ret"}));
  EXPECT_EQ(texts(assemble(listing, {.mul_rounding = false, .div_rounding = true})),
            (Texts{"dec ax", "inc cx", "ret"}));
  EXPECT_EQ(texts(assemble(listing, {.mul_rounding = false, .div_rounding = false})),
            (Texts{"dec ax", "ret"}));
}

TEST(Assemble, ResolvesLabelsForwardsAndBackwards) {
  const Program program =
      assemble({label("again"), dec(ax), jz("end"), jmp("again"), label("end"), ret()}, {});
  EXPECT_EQ(program.code.at(1).operands.at(0).value, 3);
  EXPECT_EQ(program.code.at(2).operands.at(0).value, 0);
  EXPECT_STREQ(program.code.at(3).label, "end");
}

TEST(Assemble, RefusesMalformedListings) {
  EXPECT_THROW(assemble({jmp("nowhere"), ret()}, {}), std::logic_error);
  EXPECT_THROW(assemble({if_(mul_rounding_on), ret()}, {}), std::logic_error);
  EXPECT_THROW(assemble({label("a"), label("b"), ret()}, {}), std::logic_error);
  EXPECT_THROW(assemble({ret(), label("behind")}, {}), std::logic_error);
  EXPECT_THROW(assemble({if_(Condition::none), ret(), endif()}, {}), std::logic_error);
}

}  // namespace
