// Changes cases one bit at a time. Each change must be reported if that part is compared.
#include <fmt/format.h>

#include "tests/support/bitwise.hpp"
#include "tests/support/test.hpp"
#include "tests/verify/vectors/cases.hpp"

namespace {

using vectors::Json;

/// Calls `use` for every committed case that is run, with its processor.
template <class Use>
void each_case(Use use) {
  for (const auto& file : vectors::committed) {
    for (const Json& c : vectors::load(file)) {
      if (vectors::is_run(c)) use(c, file.cpu);
    }
  }
}

Json flipped(Json c, const std::string& name, unsigned bit) {
  c["final"]["regs"][name] = vectors::final_value(c, name) ^ 1U << bit;
  return c;
}

/// Runs all cases in one file and expects `equal` of them to agree and none to be skipped.
void expect_counts(const Json& cases, std::string_view cpu, std::size_t equal) {
  ASSERT_GT(cases.size(), 0U);
  const auto run = vectors::judge(cases, cpu);
  const std::size_t differing = cases.size() - equal;
  EXPECT_NE(
      run.out.find(fmt::format("FILE: {0} cases, {0} run, {1} equal, {2} differing; 0 skipped",
                               cases.size(), equal, differing)),
      std::string::npos)
      << run.out << run.err;
  EXPECT_EQ(run.status, differing > 0 ? 1 : 0);
}

struct Tampered {
  Json i8088 = Json::array();
  Json i386 = Json::array();

  Json& of(std::string_view cpu) { return cpu == "8088" ? i8088 : i386; }
  void expect_all_reported() const {
    expect_counts(i8088, "8088", 0);
    expect_counts(i386, "386", 0);
  }
  void expect_none_reported() const {
    expect_counts(i8088, "8088", i8088.size());
    expect_counts(i386, "386", i386.size());
  }
};

TEST(Tampered, OneBitOfAnyRegisterIsReported) {
  Tampered tampered;
  unsigned bit = 0;
  each_case([&](const Json& c, std::string_view cpu) {
    for (const auto* name :
         {"ax", "bx", "cx", "dx", "si", "di", "bp", "sp", "cs", "ds", "es", "ss"}) {
      const std::string in_set = vectors::name_in_set(name, cpu);
      const unsigned bits = in_set.starts_with("e") && in_set != "es" ? 32 : 16;
      tampered.of(cpu).push_back(flipped(c, in_set, ++bit % bits));
    }
  });
  tampered.expect_all_reported();
}

TEST(Tampered, OneDefinedFlagIsReported) {
  Tampered tampered;
  each_case([&](const Json& c, std::string_view cpu) {
    if (vectors::is_fault(c)) return;
    for (unsigned bit = 0; bit < (cpu == "386" ? 32U : 16U); ++bit) {
      if ((vectors::undefined_flags(c) >> bit & 1U) != 0) continue;
      tampered.of(cpu).push_back(flipped(c, vectors::name_in_set("flags", cpu), bit));
    }
  });
  tampered.expect_all_reported();
}

TEST(Tampered, AnUndefinedFlagIsNotReported) {
  Tampered tampered;
  each_case([&](const Json& c, std::string_view cpu) {
    if (vectors::is_fault(c)) return;
    for (unsigned bit = 0; bit < 16; ++bit) {
      if ((vectors::undefined_flags(c) >> bit & 1U) == 0) continue;
      tampered.of(cpu).push_back(flipped(c, vectors::name_in_set("flags", cpu), bit));
    }
  });
  tampered.expect_none_reported();
}

TEST(Tampered, TheInstructionPointerIsReported) {
  Tampered tampered;
  unsigned bit = 0;
  each_case([&](const Json& c, std::string_view cpu) {
    tampered.of(cpu).push_back(flipped(c, vectors::name_in_set("ip", cpu), ++bit % 16));
  });
  tampered.expect_all_reported();
}

/// The first byte on the stack is the low byte of the flags.
Json with_pushed_flags_flipped(Json c, unsigned bit) {
  Json& byte = c["final"]["ram"][bit / 8][1];
  byte = byte.get<unsigned>() ^ 1U << bit % 8;
  return c;
}

TEST(Tampered, FlagsAfterAFaultAreThoseThatItPushes) {
  Tampered one;
  Tampered both;
  each_case([&](const Json& c, std::string_view cpu) {
    if (!vectors::is_fault(c)) return;
    const std::string flags = vectors::name_in_set("flags", cpu);
    for (unsigned bit = 0; bit < 16; ++bit) {
      one.of(cpu).push_back(flipped(c, flags, bit));
      one.of(cpu).push_back(with_pushed_flags_flipped(c, bit));
      const Json twice = with_pushed_flags_flipped(flipped(c, flags, bit), bit);
      const bool undefined = (bitwise::all_six >> bit & 1U) != 0;
      (undefined ? both : one).of(cpu).push_back(twice);
    }
  });
  one.expect_all_reported();
  both.expect_none_reported();
}

TEST(Tampered, AByteThatTheInstructionDoesNotWriteIsReported) {
  Tampered tampered;
  each_case([&](Json c, std::string_view cpu) {
    Json byte = c["initial"]["ram"].back();
    byte[1] = byte[1].get<unsigned>() ^ 0x20U;
    c["final"]["ram"].push_back(byte);
    tampered.of(cpu).push_back(c);
  });
  tampered.expect_all_reported();
}

TEST(Tampered, AFaultTurnedIntoAValueIsReported) {
  Tampered tampered;
  each_case([&](Json c, std::string_view cpu) {
    if (!vectors::is_fault(c)) return;
    const std::string ip = vectors::name_in_set("ip", cpu);
    const auto next = c["initial"]["regs"][ip].get<std::uint32_t>() + c["bytes"].size();
    c["final"] = {{"regs", {{ip, next}}}, {"ram", Json::array()}};
    tampered.of(cpu).push_back(c);
  });
  tampered.expect_all_reported();
  const auto run = vectors::judge(Json::array({tampered.i8088[0]}), "8088");
  EXPECT_NE(run.out.find("FILE: case 0 'div bx': divide error: model yes, file no\n"),
            std::string::npos)
      << run.out;
}

/// Faults with one wrong byte of the pushed state or one wrong part of the jump.
TEST(Tampered, AFaultThatIsNotWholeIsReported) {
  Tampered tampered;
  each_case([&](const Json& c, std::string_view cpu) {
    if (!vectors::is_fault(c)) return;
    for (std::size_t byte = 0; byte < 6; ++byte) {
      Json wrong = c;
      wrong["final"]["ram"][byte][1] = wrong["final"]["ram"][byte][1].get<unsigned>() ^ 1U;
      tampered.of(cpu).push_back(wrong);
    }
    for (std::size_t byte = 0; byte < 4; ++byte) {
      Json wrong = c;
      wrong["initial"]["ram"][byte][1] = wrong["initial"]["ram"][byte][1].get<unsigned>() ^ 4U;
      tampered.of(cpu).push_back(wrong);
    }
    tampered.of(cpu).push_back(flipped(c, vectors::name_in_set("ip", cpu), 7));
    Json unwritten = c;
    unwritten["final"]["ram"] = Json::array();
    tampered.of(cpu).push_back(unwritten);
  });
  tampered.expect_all_reported();
}

/// Faults with the stack at the top of memory, and where SP wraps around.
TEST(Tampered, TheReturnAddressIsFoundWhereTheStackWraps) {
  Json sound;
  each_case([&](const Json& c, std::string_view cpu) {
    if (cpu == "8088" && vectors::is_fault(c)) sound = c;
  });
  struct Stack {
    std::uint32_t ss;
    std::uint32_t sp;
  };
  Tampered moved;
  Tampered wrong;
  for (const Stack stack : {Stack{0xFFFF, 0x1000}, {0xFFFF, 0x14}, {0x9000, 4}, {0x9000, 5}}) {
    Json c = sound;
    c["initial"]["regs"]["ss"] = stack.ss;
    c["initial"]["regs"]["sp"] = stack.sp;
    c["final"]["regs"]["sp"] = (stack.sp - 6) & 0xFFFFU;
    // Flags, CS and IP, each with its low byte first.
    const std::array<std::uint32_t, 6> below{2, 1, 4, 3, 6, 5};
    for (std::size_t i = 0; i < below.size(); ++i) {
      const std::uint32_t offset = (stack.sp - below.at(i)) & 0xFFFFU;
      c["final"]["ram"][i][0] = (stack.ss * 16 + offset) & 0xFFFFFU;
    }
    moved.i8088.push_back(c);
    for (std::size_t i = 0; i < below.size(); ++i) {
      Json bad = c;
      bad["final"]["ram"][i][1] = bad["final"]["ram"][i][1].get<unsigned>() ^ 0x10U;
      wrong.i8088.push_back(bad);
    }
  }
  expect_counts(moved.i8088, "8088", moved.i8088.size());
  expect_counts(wrong.i8088, "8088", 0);
}

TEST(Tampered, AValueTurnedIntoAFaultIsReported) {
  Tampered tampered;
  Json fault_of_8088;
  Json fault_of_386;
  each_case([&](const Json& c, std::string_view cpu) {
    if (vectors::is_fault(c)) (cpu == "8088" ? fault_of_8088 : fault_of_386) = c;
  });
  // Enlarges the divisor of a faulting case so that the quotient fits.
  for (auto* fault : {&fault_of_8088, &fault_of_386}) {
    const std::string_view cpu = fault == &fault_of_8088 ? "8088" : "386";
    Json& before = (*fault)["initial"]["regs"];
    before[vectors::name_in_set("dx", cpu)] = 0;
    before[vectors::name_in_set("ax", cpu)] = 1;
    before[vectors::name_in_set("bx", cpu)] = 1;
    tampered.of(cpu).push_back(*fault);
  }
  tampered.expect_all_reported();
  EXPECT_NE(vectors::judge(tampered.i386, "386").out.find("divide error: model no, file yes\n"),
            std::string::npos);
}

TEST(Tampered, AReportSaysWhatDiffersAndIsCutShort) {
  Json cases = Json::array();
  Json first;
  each_case([&](const Json& c, std::string_view cpu) {
    if (first.is_null() && cpu == "8088") first = c;
  });
  first["name"] = "\x1b[31m add";
  first["final"]["regs"]["ds"] = first["initial"]["regs"]["ds"].get<unsigned>() ^ 0x8000U;
  first["final"]["regs"]["flags"] = vectors::final_value(first, "flags") ^ 0x401U;
  for (int i = 0; i < 25; ++i) cases.push_back(first);
  const auto run = vectors::judge(cases, "8088");
  const auto lines = command::split(run.out, '\n');
  ASSERT_EQ(lines.size(), 23U) << run.out;
  EXPECT_EQ(lines[19].rfind("FILE: case 19 '?[31m add': ds: model ", 0), 0) << lines[19];
  EXPECT_NE(lines[19].find("; CF: model "), std::string::npos) << lines[19];
  EXPECT_NE(lines[19].find("; other flags: model f"), std::string::npos) << lines[19];
  EXPECT_EQ(lines[20], "FILE: 5 more");
  EXPECT_EQ(lines[21], "FILE: 25 cases, 25 run, 0 equal, 25 differing; 0 skipped");
  EXPECT_EQ(run.status, 1);
}

}  // namespace
