// Claims about quotients, with numbers in place of operands: a solver must call a word right if and
// only if the rules do. That also shows that what a claim asserts of divisions is true.
#include "judge/code/quotient_claim.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <random>

#include "judge/check/operands.hpp"
#include "tests/support/command.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/test.hpp"

namespace fixproof::judge {
namespace {

namespace sym = x86model::symbolic;

/// How a routine divides.
enum class Way { plain, doubled, magnitudes };

class Questions {
 public:
  /// Adds two questions about a result of a / b: whether it can be wrong, and whether it can be
  /// right.
  void add(const check::Rules& rules, Way way, std::int64_t a, std::int64_t b, std::uint64_t said) {
    const cases::Format& format = rules.variant.format;
    const std::uint64_t ones = cases::all_ones(format);
    const std::array words{static_cast<std::uint64_t>(a) & ones,
                           static_cast<std::uint64_t>(b) & ones};
    sym::Terms terms;
    std::optional<MachineDivide> divide;
    if (b != 0) {
      std::int64_t n = a * (std::int64_t{1} << format.fraction_bits);
      std::int64_t d = b;
      if (way == Way::doubled) n = 2 * n + (a < 0 ? 1 : 0) - (b < 0 ? 1 : 0);
      if (way == Way::magnitudes) n = std::abs(n);
      if (way == Way::magnitudes) d = std::abs(d);
      const auto term = [&](std::int64_t value) {
        return terms.constant(static_cast<std::uint64_t>(value), 64);
      };
      divide = {term(n), term(d), term(n / d), term(n % d)};
    }
    const Claim claim = *quotient_claim(rules, terms, divide, way == Way::doubled);
    const std::string right = fmt::format(fmt::runtime(claim.is_right),
                                          fmt::format("(_ bv{} {})", said, format.word_bits));
    script_ += fmt::format(
        "(push)\n(define-fun a () (_ BitVec {0}) (_ bv{1} {0}))\n(define-fun b () (_ BitVec {0}) "
        "(_ bv{2} {0}))\n{3}(push)\n(assert (not {4}))\n(check-sat)\n(pop)\n(assert "
        "{4})\n(check-sat)\n(pop)\n",
        format.word_bits, words[0], words[1], claim.definitions, right);
    const bool is_right = check::keeps(rules, check::Operands(words), said);
    expected_ += is_right ? "unsat\nsat\n" : "sat\nunsat\n";
    rights_ += is_right ? 1 : 0;
    ++all_;
  }

  void expect_answers() const {
    const ScratchFolder folder;
    const auto run = command::run({"z3", folder.write("q.smt2", "(set-logic QF_BV)\n" + script_)});
    EXPECT_EQ(run.out, expected_);
    EXPECT_GT(rights_, all_ / 4);
    EXPECT_LT(rights_, all_ * 3 / 4);
  }

 private:
  std::string script_;
  std::string expected_;
  int rights_ = 0;
  int all_ = 0;
};

TEST(QuotientClaim, CallsRightWhatTheRulesCallRight) {
  if (!command::has("z3")) GTEST_SKIP() << "no z3";
  using check::NoResult;
  using check::Overflow;
  Questions questions;
  std::mt19937_64 random(64);
  const auto operand = [&](const cases::Format& format) {
    const auto bits = random() % static_cast<unsigned>(format.word_bits);
    const auto value = static_cast<std::int64_t>(random() & ((std::uint64_t{2} << bits) - 1));
    if (!format.is_signed) return value & static_cast<std::int64_t>(cases::all_ones(format));
    const std::int64_t half = std::int64_t{1} << (format.word_bits - 1);
    return std::min(value, half - 1) * (random() % 2 == 0 ? 1 : -1);
  };
  for (const char* name : {"q16_16", "q8_8", "q4_4", "u8_8", "q1_7", "q8_0"}) {
    const cases::Format format = cases::format_named(name);
    for (const auto rounding :
         {oracle::Rounding::half_up, oracle::Rounding::half_away, oracle::Rounding::half_even,
          oracle::Rounding::floor, oracle::Rounding::truncate, oracle::Rounding::ceiling}) {
      for (const auto overflow : {Overflow::wrap, Overflow::saturate, Overflow::any}) {
        for (const Way way : {Way::plain, Way::doubled, Way::magnitudes}) {
          const check::Rules rules{
              .variant = cases::variant_of(cases::Operation::div, format),
              .rounding = rounding,
              .overflow = overflow,
              .no_result = format.is_signed ? NoResult::saturate : NoResult::zero};
          // Ties are rare: b is a small even number every other time.
          const std::int64_t b = random() % 2 == 0 ? operand(format) : 2 * (operand(format) % 4);
          const std::int64_t a = operand(format);
          const std::array words{static_cast<std::uint64_t>(a) & cases::all_ones(format),
                                 static_cast<std::uint64_t>(b) & cases::all_ones(format)};
          const auto right = check::expected_of(rules, check::Operands(words)).said;
          const std::uint64_t word = right.value_or(random() & cases::all_ones(format));
          for (const std::uint64_t off : {std::uint64_t{0}, std::uint64_t{1}, ~std::uint64_t{0}}) {
            if (off != 0 && random() % 2 == 0) continue;
            questions.add(rules, way, a, b, (word + off) & cases::all_ones(format));
          }
        }
      }
    }
  }
  questions.expect_answers();
}

}  // namespace
}  // namespace fixproof::judge
