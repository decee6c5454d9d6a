// The abstract functions of 64-bit code: a solver must compute from their exact definitions what
// the evaluation of terms does.
#include "judge/code/abstract_functions.hpp"

#include <fmt/format.h>

#include "tests/support/command.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/test.hpp"

namespace fixproof::judge {
namespace {

std::string literal(std::uint64_t value) { return fmt::format("(_ bv{} 64)", value); }

std::string applied_to(const char* name, const std::vector<std::uint64_t>& words) {
  std::string text = std::string("(") + name;
  for (const std::uint64_t word : words) text += " " + literal(word);
  return text + ")";
}

TEST(AbstractFunctions, HaveTheValuesOfTheirDefinitions) {
  if (!command::has("z3")) GTEST_SKIP() << "no z3";
  constexpr std::uint64_t lowest = std::uint64_t{1} << 63U;
  constexpr std::array edges{std::uint64_t{0},         std::uint64_t{1}, std::uint64_t{7},
                             ~std::uint64_t{0},        lowest,           lowest - 1,
                             std::uint64_t{0xFFFFFFFF}};
  std::mt19937_64 random(128);
  const auto word = [&] {
    const std::uint64_t value = random();
    return value % 3 == 0 ? edges.at(random() % edges.size()) : value >> random() % 64;
  };
  std::string script = "(set-logic QF_BV)\n" + declare_functions(proof::Arithmetic::exact);
  int questions = 0;
  const auto ask = [&](const std::string& claim) {
    script += fmt::format("(push)\n(assert (not {}))\n(check-sat)\n(pop)\n", claim);
    ++questions;
  };
  for (int i = 0; i < 60; ++i) {
    const std::vector two{word(), word()};
    for (const char* const name :
         {low_product_64, unsigned_high_product_64, signed_high_product_64, quotient_64,
          remainder_64, unsigned_quotient_64, unsigned_remainder_64}) {
      // Of a divide that faults nothing is asked.
      const bool divides = name[1] == 'q' || name[1] == 'r';
      if (divides && (two[1] == 0 || (two[0] == lowest && two[1] == ~std::uint64_t{0}))) continue;
      ask(fmt::format("(= {} {})", applied_to(name, two), literal(concrete_function(name, two))));
    }
    const std::vector three{random() % 2 == 0 ? word() : word() >> 32U, word(), word()};
    const bool overflows = concrete_function(signed_quotient_overflows_128, three) != 0;
    ask(fmt::format("(= {} {})", applied_to(signed_quotient_overflows_128, three), overflows));
    for (const char* const name : {signed_quotient_128, signed_remainder_128, unsigned_quotient_128,
                                   unsigned_remainder_128}) {
      if (name[0] == 's' ? overflows : three[0] >= three[2]) {
        EXPECT_EQ(concrete_function(name, three), 0U);
        continue;
      }
      ask(fmt::format("(= {} {})", applied_to(name, three),
                      literal(concrete_function(name, three))));
    }
  }
  const ScratchFolder folder;
  std::string expected;
  for (int i = 0; i < questions; ++i) expected += "unsat\n";
  EXPECT_EQ(command::run({"z3", folder.write("q.smt2", script)}).out, expected);
}

TEST(AbstractFunctions, AreDeclaredForAbstractArithmetic) {
  if (!command::has("z3")) GTEST_SKIP() << "no z3";
  const ScratchFolder folder;
  const std::string script = "(set-logic QF_UFBV)\n" +
                             declare_functions(proof::Arithmetic::abstract) +
                             "(assert (distinct (mullo64 (_ bv2 64) (_ bv3 64)) (_ bv6 64)))\n"
                             "(assert (sfault128 (_ bv0 64) (_ bv1 64) (_ bv1 64)))\n(check-sat)\n";
  EXPECT_EQ(command::run({"z3", folder.write("q.smt2", script)}).out, "sat\n");
}

}  // namespace
}  // namespace fixproof::judge
