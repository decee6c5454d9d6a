// Programs that contain our own listings, and nearly them.
#include <fmt/format.h>

#include "judge/code/find_listing.hpp"
#include "tests/judge/code/judged.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/test.hpp"

namespace {

using judged::expect;
using judged::judge;

/// Digests of docs/originals.md.
const std::string digest_of_mul =
    "digest 3713cdcf6f7c0b06873a2fefe0c65b83e6611d5678414a2a0318476d80011023, the author's";
const std::string digest_of_8088_mul =
    "digest a243d4dfb76039377f64ecff72703277a60f96467782a6f6c4316196a896af99, the author's";

std::string listed(const std::string& listing) { return command::output_of("list " + listing); }

/// Replaces the first `from` of a source, which must be there.
std::string with(std::string source, const std::string& from, const std::string& to) {
  const std::size_t at = source.find(from);
  if (at == std::string::npos) {
    ADD_FAILURE() << from << " is not in " << source;
    return source;
  }
  return source.replace(at, from.size(), to);
}

/// Encodes the beginning as another assembler does.
std::string as_encoded_elsewhere(const std::string& source) {
  return with(source, "        mov bp, sp\n", "        db 0x8B, 0xEC\n");
}

/// As an assembler does that reserves room for a long jump and fills what it does not use.
std::string with_nops(const std::string& source, const std::string& jump) {
  return with(source, jump, jump + "\n        nop\n        nop");
}

void expect_found(const std::string& source, const std::string& options, int status,
                  const std::vector<std::string>& parts) {
  SCOPED_TRACE(options);
  const ScratchFolder folder;
  expect(judge(folder.write("code.bin", command::assemble(source)), "--against-listing|" + options),
         status, parts);
}

TEST(AgainstListing, OneRoutineIsConfirmed) {
  expect_found(listed("mul"), "mul|--target|i386|--round|on|--at|0", 0,
               {"mul-i386-on: confirmed at 0h (0): 9 instructions in 27 bytes\n  " + digest_of_mul,
                "1 of 1 listing confirmed"});
}

TEST(AgainstListing, AllRoutinesOfAProgramAreFoundInItsRange) {
  std::string code(50, '\x0F');  // data that looks like the beginning of an instruction
  std::vector<std::string> parts;
  for (const char* name : {"concat", "xformvec", "cossin", "div", "mul"}) {
    std::string source =
        as_encoded_elsewhere(listed(std::string(name) + " --mul-round on --div-round off"));
    if (std::string(name) == "cossin") source = with_nops(source, "jns .CheckInRange");
    const std::string bytes = command::assemble(source);
    const std::string rounding = std::string(name) == "cossin" ? ""
                                 : name == std::string("div")  ? "-off"
                                                               : "-on";
    parts.push_back(std::string(name) + "-i386" + rounding + ": confirmed at " +
                    fmt::format("{0:x}h ({0}): ", judged::exe_header + code.size()));
    code += bytes;
  }
  const auto end = judged::exe_header + code.size();
  parts.insert(parts.end(),
               {digest_of_mul, "its table of 3,604 bytes is at ", "5 of 5 listings confirmed, "});
  const ScratchFolder folder;
  const auto file = folder.write("demo.exe", judged::exe_of(code + std::string(90, '\x55'), {}));
  const std::string options = "--against-listing|all|--mul-round|on|--div-round|off";
  expect(judge(file, fmt::format("{}|--at|100..{}", options, end)), 0, parts);
  expect(judge(file, options), 0, {"5 of 5 listings confirmed\n"});
  // A byte less, and the last routine is not in the range.
  expect(judge(file, fmt::format("{}|--at|100..{}", options, end - 1)), 1,
         {"mul-i386-on: NOT FOUND", "4 of 5 listings confirmed"});
}

TEST(AgainstListing, TheShareCountsEachByteOfTheRangeOnce) {
  expect_found(listed("mul"), "mul,mul|--at|0..27", 0,
               {"1 of 1 listing confirmed, 27 of 27 bytes"});
  const std::string cossin = command::assemble(listed("cossin"));
  const ScratchFolder folder;
  // The table is behind the range.
  expect(judge(folder.write("code.bin", cossin), "--against-listing|cossin|--at|0..200"), 0,
         {"1 of 1 listing confirmed, ", " of 200 bytes"});
}

TEST(AgainstListing, OptionsThatItWouldIgnoreAreRefused) {
  for (const char* option : {"--rounding|floor", "--format|q8_8", "--cases|5", "--rule|doom"}) {
    command::expect_usage_error(judge("x", std::string("--against-listing|mul|") + option),
                                "has no effect with --against-listing; leave it out");
  }
}

TEST(AgainstListing, TheProgramOfChapter52HasTwoRoutines) {
  const std::string divide = with_nops(listed("div --chapter 52"), "jns .FDP1");
  expect_found(listed("mul --chapter 52") + "\n        db 0\n" + divide, "all|--chapter|52", 0,
               {"mul-i386-on-ch52: confirmed at 0h (0): 9 instructions in 27 bytes",
                "div-i386-on-ch52: confirmed at 1ch (28): ", "2 of 2 listings confirmed"});
}

TEST(AgainstListing, ThePlantedDifferenceIsNamed) {
  expect_found(with(listed("mul"), "add eax, 0x8000", "add eax, 0x7fff"), "mul", 1,
               {"mul-i386-on: DIFFERS at 0h (0) in 1 of 9 instructions, first in\n"
                "  instruction 5\n"
                "    listing  add eax,0x8000\n"
                "    file     add eax,0x7fff, at bh (11)\n",
                "0 of 1 listing confirmed"});
  // The first and the last instruction; one that is left out, one too many.
  expect_found(
      "nop\nret\n" + with(listed("mul"), "push bp", "push bx"), "mul", 1,
      {"DIFFERS at 2h (2) in 1 of 9", "listing  push bp\n    file     push bx, at 2h (2)"});
  expect_found(with(listed("mul"), "        ret", "        retf"), "mul", 1,
               {"in 1 of 9", "instruction 9\n    listing  ret\n    file     retf, at 1ah (26)"});
  expect_found(
      with(listed("mul"), "adc edx, 0", ""), "mul", 1,
      {"in 1 of 9", "instruction 6\n    listing  adc edx,0x0\n    file     nothing, at 11h (17)"});
  expect_found(with(listed("div"), "dec ebx", "dec ebx\ndec ebx"), "div", 1,
               {"in 1 of 29", "    listing  nothing\n    file     dec ebx, at "});
}

TEST(AgainstListing, AJumpToAnotherPlaceIsADifference) {
  expect_found(with(listed("div"), "jns .FDP1", "jns .FDP2"), "div", 1,
               {"in 1 of 29", "    listing  jns ->8\n    file     jns ->17, at "});
}

TEST(AgainstListing, AnotherBuildIsNamed) {
  expect_found(
      listed("mul --round off"), "mul|--round|on", 1,
      {"mul-i386-on: DIFFERS at 0h (0) in 2 of 9", "but mul-i386-off is there, at 0h (0)"});
}

TEST(AgainstListing, ACallMustReachTheSameRoutine) {
  const std::string right = listed("xformvec --target i8088");
  expect_found(right, "xformvec,mul|--target|i8088", 0,
               {"xformvec-i8088-on: confirmed", digest_of_8088_mul, "2 of 2"});
  // The digest does not show where a call leads.
  expect_found(with(right, "sub cx, cx", "xor cx, 1"), "xformvec|--target|i8088", 1,
               {"xformvec-i8088-on: DIFFERS at 0h (0) in 9 of 115", "listing  call ext\n",
                "another routine"});
}

TEST(AgainstListing, TheTableIsComparedToo) {
  const std::string right = listed("cossin");
  expect_found(with(right, " 65535,", " 65534,"), "cossin", 1,
               {"cossin-i386: confirmed", "its table of 3,604 bytes is NOT in the file", "0 of 1"});
  // The digest does not show which entry a read takes.
  const std::size_t last = right.rfind("[cs:CosTable+bx]");
  ASSERT_NE(last, std::string::npos);
  expect_found(std::string(right).replace(last, 16, "[cs:CosTable+bx+4]"), "cossin", 1,
               {"cossin-i386: DIFFERS at 0h (0) in 1 of 52",
                "[cs:bx+TAB], 4h from the place of the first read's table"});
}

TEST(AgainstListing, EveryChangedByteIsADifference) {
  for (const char* name : {"mul", "div", "mul --target i8088"}) {
    const std::string bytes = command::assemble(listed(name));
    fixproof::judge::Code listing(bytes);
    const auto whole = fixproof::judge::compare_listing(listing, 0, listing, 0);
    EXPECT_TRUE(whole.is_equal());
    for (std::uint32_t at = 0; at < whole.end; ++at) {
      std::string changed = bytes;
      changed[at] = static_cast<char>(changed[at] ^ 1);
      fixproof::judge::Code code(changed);
      EXPECT_FALSE(fixproof::judge::compare_listing(listing, 0, code, 0).is_equal()) << name << at;
    }
  }
}

TEST(AgainstListing, MistakesAreNamed) {
  const ScratchFolder folder;
  const auto file = folder.write("code.bin", "\xC3");
  command::expect_usage_error(judge(file, "--against-listing|mul|--at|7"),
                              "--at: the file ends at 1h (1)");
  command::expect_usage_error(judge(file, "--against-listing|mul|--at|0:0"), "without a segment");
  command::expect_usage_error(judge(file, "--against-listing|sqrt"), "--against-listing");
  command::expect_usage_error(judge(file, "--against-listing|mul|--as|mul"), "--against-listing");
  command::expect_usage_error(judge(file, "--as|mul|--target|i386"), "--against-listing");
  command::expect_usage_error(judge(folder.path("none"), "--against-listing|mul"), "none: ");
  expect(judge(file, "--against-listing|mul"), 1, {"mul-i386-on: NOT FOUND"});
}

}  // namespace
