// Tests transforms: one translation too many, one element too many, one vector too few.
#include "oracle/exact.hpp"
#include "tests/support/test.hpp"
#include "tests/verify/defects/routine.hpp"
#include "verify/cases/streams.hpp"
#include "verify/parties/party.hpp"

namespace {

namespace x86 = x86model;
using defects::ask;
using defects::Words;
using enum x86model::Routine;
using enum x86model::Target;

constexpr std::uint32_t one = 0x10000;

/// The identity with a translation, in units of 1.0.
Words move(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
  return {one, 0, 0, x * one, 0, one, 0, y * one, 0, 0, one, z * one};
}

Words both(Words first, const Words& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

// Translating by (4, 5, 6), then by (1, 2, 3), translates by (5, 7, 9).
TEST(Defects, TranslationInEveryColumn) {
  const Words moves = both(move(1, 2, 3), move(4, 5, 6));
  for (const auto target : defects::targets) {
    EXPECT_EQ(ask<concat>(target, defects::rounded, moves), defects::values(move(5, 7, 9)));
  }
  Words spoiled = move(5, 7, 9);
  for (std::size_t i = 0; i < spoiled.size(); ++i) {
    if (i % 4 != 3) spoiled[i] += static_cast<std::uint32_t>(i / 4 + 1) * one;
  }
  const x86::Build chapter_52{.chapter_52 = true};
  EXPECT_EQ(ask<concat>(i386, chapter_52, moves), defects::values(spoiled));
  // A first translation of zero hides the defect.
  EXPECT_EQ(ask<concat>(i386, chapter_52, both(move(0, 0, 0), move(4, 5, 6))),
            defects::values(move(4, 5, 6)));
  const auto exact = [&](oracle::TranslationRule rule) {
    const std::span<const std::uint32_t, 24> in(moves.data(), 24);
    const auto product =
        oracle::concat(in.first<12>(), in.last<12>(), oracle::Rounding::half_up, rule, 16);
    return Words(product.begin(), product.end());
  };
  EXPECT_EQ(exact(oracle::TranslationRule::fourth), move(5, 7, 9));
  EXPECT_EQ(exact(oracle::TranslationRule::every), spoiled);
}

// Translations of 0.5 and 0.5 along one axis give 0.0; 1.5 and 0.5 give 1.0.
TEST(Defects, LostCarry) {
  struct Case {
    std::uint32_t first, second, printed, sound;
  };
  constexpr std::uint32_t half = one / 2;
  constexpr std::array cases{
      Case{half, half, 0, one},
      Case{half, one + half, one, 2 * one},
      Case{half - 1, half, one - 1, one - 1},
      Case{0U - half, 0U - half, 0U - 2 * one, 0U - one},
      Case{half, 0x7FFF0000 + half, 0x7FFF0000, 0x80000000},
      Case{0U - half, half, 0U - one, 0},
  };
  const x86::Build repaired{.repaired = true};
  for (const Case& c : cases) {
    for (std::size_t row = 0; row < 3; ++row) {
      const auto moved = [row](std::uint32_t by) {
        Words words = move(0, 0, 0);
        words.at(4 * row + 3) = by;
        return words;
      };
      const Words in = both(moved(c.first), moved(c.second));
      EXPECT_EQ(ask<concat>(i8088, defects::rounded, in), defects::values(moved(c.printed)));
      EXPECT_EQ(ask<concat>(i8088, defects::unrounded, in), defects::values(moved(c.printed)));
      EXPECT_EQ(ask<concat>(i8088, repaired, in), defects::values(moved(c.sound)));
      EXPECT_EQ(ask<concat>(i386, defects::rounded, in), defects::values(moved(c.sound)));
      // XformVec has the ADC at this place.
      Words point{0, 0, 0};
      point.at(row) = c.second;
      Words sum{0, 0, 0};
      sum.at(row) = c.sound;
      EXPECT_EQ(ask<xformvec>(i8088, defects::rounded, both(moved(c.first), point)),
                defects::values(sum));
    }
  }
}

// Of all pairs of 16-bit fractions, (65536 * 65535 / 2) / 65536^2 = (1 - 2^-16) / 2 carry. With n
// rows, the measured share must be within 5 standard deviations, 5 * sqrt(0.25 / n).
TEST(Defects, HalfOfAllSumsLoseACarry) {
  using namespace fixproof;
  constexpr std::size_t cases = 20'000;
  const cases::Variant printed{.operation = cases::Operation::concat,
                               .build = {.target = cases::Target::i8088}};
  cases::Variant sound = printed;
  sound.build.repaired = true;
  std::vector<std::uint32_t> in(cases * cases::words_in(printed.operation));
  cases::make_cases(cases::Stream::uniform, printed, 1994, 0, in);
  const auto answers = [&](const cases::Variant& v) {
    std::vector<std::uint32_t> out(cases * cases::words_out(v.operation));
    std::vector<parties::Ending> endings(cases);
    parties::party_named("model").answer(v, {in, out, endings});
    return out;
  };
  const auto lossy = answers(printed);
  const auto whole = answers(sound);
  std::size_t lost = 0;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    if (lossy[i] == whole[i]) continue;
    EXPECT_EQ(i % 4, 3U);
    EXPECT_EQ(whole[i] - lossy[i], one);
    ++lost;
  }
  constexpr double rows = 3.0 * cases;
  EXPECT_NEAR(static_cast<double>(lost) / rows, (1 - 1 / 65536.0) / 2, 5 * std::sqrt(0.25 / rows));
}

// A transform has three rows of four: 12 doublewords. Row 3, column 3 would be the 16th.
TEST(Defects, OutOfBounds) {
  constexpr std::uint32_t bytes_of_element = 4;
  const auto address = [](std::uint32_t row, std::uint32_t column) {
    return bytes_of_element * (4 * row + column);
  };
  x86::WordMemory<16, 24> transform;
  EXPECT_TRUE(transform.write(address(2, 3), 0));
  EXPECT_TRUE(transform.write(address(2, 3) + 2, 1));
  EXPECT_FALSE(transform.write(address(3, 3), 0));
  EXPECT_FALSE(transform.write(address(3, 3) + 2, 1));
  std::array<std::array<std::int32_t, 4>, 3> rows{};
  EXPECT_THROW(rows.at(3).at(3) = 1, std::out_of_range);
  EXPECT_EQ(x86::arity(xformvec).in, 12 + 3);
  // If a second transform follows, the store hits its row 0, column 3.
  constexpr std::uint32_t bytes_of_transform = 12 * bytes_of_element;
  EXPECT_EQ(address(3, 3), bytes_of_transform + address(0, 3));
  x86::WordMemory<16, 48> two;
  EXPECT_TRUE(two.write(address(3, 3), 0));
}

/// Runs `routine` with its destination pointing at source 0 or 1, and returns the words there. Both
/// routines take two sources and a destination, which lie above the return address.
template <x86::Routine routine>
Words in_place(x86::Target target, const Words& in, std::uint32_t which) {
  x86::CallMachine<routine, 16> machine;
  x86::enter<routine>(machine, in);
  const std::uint32_t sp = machine.registers.read(x86::Register::sp, x86::Size::word);
  std::uint32_t source = 0;
  EXPECT_TRUE(machine.memory.read(sp + 2 + 2 * which, source));
  EXPECT_TRUE(machine.memory.write(sp + 6, source));
  const x86::Program program = x86::assemble(x86::listing(routine, target), defects::rounded);
  EXPECT_EQ(x86::run(program.instructions(), machine).outcome, x86::Outcome::returned);
  Words result;
  for (int i = 0; i < x86::arity(routine).out; ++i, source += 4) {
    std::uint32_t low = 0;
    std::uint32_t high = 0;
    EXPECT_TRUE(machine.memory.read(source, low));
    EXPECT_TRUE(machine.memory.read(source + 2, high));
    result.push_back(high << 16U | low);
  }
  return result;
}

// Swapping x and y of (1, 2, 3) in place uses the new x instead of the old one.
TEST(Defects, InPlace) {
  const Words swap{0, one, 0, 0, one, 0, 0, 0, 0, 0, one, 0};
  const Words in = both(swap, {one, 2 * one, 3 * one});
  for (const auto target : defects::targets) {
    EXPECT_EQ(ask<xformvec>(target, defects::rounded, in),
              defects::values({2 * one, one, 3 * one}));
    EXPECT_EQ(in_place<xformvec>(target, in, 1), (Words{2 * one, 2 * one, 3 * one}));
  }
  // The swap times itself: later elements use the elements already overwritten.
  const Words twice = both(swap, swap);
  for (const auto target : defects::targets) {
    EXPECT_EQ(ask<concat>(target, defects::rounded, twice), defects::values(move(0, 0, 0)));
    EXPECT_EQ(in_place<concat>(target, twice, 0),
              (Words{one, one, 0, 0, 0, 0, 0, 0, 0, 0, one, 0}));
    EXPECT_EQ(in_place<concat>(target, twice, 1),
              (Words{one, 0, 0, 0, one, 0, 0, 0, 0, 0, one, 0}));
  }
}

}  // namespace
