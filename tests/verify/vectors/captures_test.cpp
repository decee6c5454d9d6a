// Judges captures written by hand, as they are and with one bit changed. What the model would do
// with a defect is what the file has with that bit changed.
#include <fmt/format.h>

#include "tests/support/test.hpp"
#include "tests/verify/vectors/capture.hpp"

namespace {

using vectors::Json;

constexpr std::array<std::string_view, 3> processors{"8088", "286", "386"};

Json all_cases(std::string_view cpu) {
  Json cases = Json::array();
  for (const auto& capture : vectors::captures(cpu)) {
    cases.push_back(vectors::json_of(capture, cpu));
  }
  return cases;
}

/// Expects that each case is run, differs, and is reported by what `words` gives for it.
void expect_named(const Json& cases, const std::vector<std::string>& words, std::string_view cpu) {
  ASSERT_EQ(cases.size(), words.size());
  ASSERT_FALSE(cases.empty());
  // The command prints 20 cases of each file.
  for (std::size_t first = 0; first < cases.size(); first += 20) {
    const std::size_t count = std::min<std::size_t>(20, cases.size() - first);
    const Json part(cases.begin() + static_cast<std::ptrdiff_t>(first),
                    cases.begin() + static_cast<std::ptrdiff_t>(first + count));
    const auto run = vectors::judge(part, cpu);
    EXPECT_EQ(run.status, 1);
    const auto lines = command::split(run.out, '\n');
    ASSERT_EQ(lines.size(), count + 2) << run.out << run.err;
    for (std::size_t i = 0; i < count; ++i) {
      const std::string name =
          fmt::format("FILE: case {} '{}': ", i, part[i]["name"].get<std::string>());
      EXPECT_TRUE(lines[i].starts_with(name)) << lines[i];
      EXPECT_NE(lines[i].find(words[first + i]), std::string::npos)
          << lines[i] << "\n expected: " << words[first + i];
    }
  }
}

TEST(Captures, TheModelAgreesWithEachForm) {
  for (const std::string_view cpu : processors) {
    const auto run = vectors::judge(all_cases(cpu), cpu);
    const std::size_t count = vectors::captures(cpu).size();
    EXPECT_EQ(run.out,
              fmt::format("FILE: {0} cases, {0} run, {0} equal, 0 differing; 0 skipped\n", count))
        << cpu;
    EXPECT_EQ(run.status, 0);
  }
}

TEST(Captures, OneBitOfEachWrittenByteIsNamed) {
  for (const std::string_view cpu : processors) {
    Json cases = Json::array();
    std::vector<std::string> words;
    unsigned bit = 0;
    for (const Json& sound : all_cases(cpu)) {
      for (std::size_t i = 0; i < sound["final"]["ram"].size(); ++i) {
        Json c = sound;
        Json& byte = c["final"]["ram"][i];
        const auto right = byte[1].get<unsigned>();
        const unsigned wrong = right ^ 1U << ++bit % 8;
        byte[1] = wrong;
        cases.push_back(c);
        // Of the pushed flags, the arithmetic ones are compared with the register.
        words.push_back(fmt::format("memory {:05x}: model {:02x}, file {:02x}",
                                    byte[0].get<unsigned>(), right, wrong));
      }
    }
    expect_named(cases, words, cpu);
  }
}

TEST(Captures, AWriteThatIsMissingIsNamed) {
  for (const std::string_view cpu : processors) {
    Json cases = Json::array();
    std::vector<std::string> words;
    for (const Json& sound : all_cases(cpu)) {
      for (std::size_t i = 0; i < sound["final"]["ram"].size(); ++i) {
        Json c = sound;
        const Json byte = c["final"]["ram"][i];
        c["final"]["ram"].erase(i);
        std::string before = "nothing";
        bool changes = true;
        for (const Json& initial : sound["initial"]["ram"]) {
          if (initial[0] != byte[0]) continue;
          before = fmt::format("{:02x}", initial[1].get<unsigned>());
          changes = initial[1] != byte[1];
        }
        if (!changes) continue;
        cases.push_back(c);
        words.push_back(fmt::format("memory {:05x}: model {:02x}, file {}", byte[0].get<unsigned>(),
                                    byte[1].get<unsigned>(), before));
      }
    }
    expect_named(cases, words, cpu);
  }
}

TEST(Captures, AnotherWriteIsNamed) {
  for (const std::string_view cpu : processors) {
    Json cases = Json::array();
    std::vector<std::string> words;
    for (Json c : all_cases(cpu)) {
      c["final"]["ram"].push_back({0x7FFFF, 0x5A});
      cases.push_back(c);
      words.emplace_back("memory 7ffff: model nothing, file 5a");
    }
    expect_named(cases, words, cpu);
  }
}

/// Bits of the address or of an operand in memory lead the model elsewhere.
TEST(Captures, AReadOfAnotherByteIsNamed) {
  for (const std::string_view cpu : processors) {
    Json c = vectors::json_of(vectors::captures(cpu)[0], cpu);
    const std::string bx = vectors::name_in_set("bx", cpu);
    c["initial"]["regs"][bx] = 0x0180;
    expect_named(Json::array({c}), {"memory 30180: model reads it, file does not list it"}, cpu);
    c["initial"]["regs"][bx] = 0x0100;
    c["initial"]["ram"][2][1] = c["initial"]["ram"][2][1].get<unsigned>() ^ 1U;
    c["initial"]["ram"][3][1] = c["initial"]["ram"][3][1].get<unsigned>() ^ 1U;
    expect_named(Json::array({c}), {"ax: model "}, cpu);
  }
}

TEST(Captures, OneBitOfEachRegisterIsNamed) {
  for (const std::string_view cpu : processors) {
    Json cases = Json::array();
    std::vector<std::string> words;
    unsigned bit = 0;
    for (const Json& sound : all_cases(cpu)) {
      for (const auto& [name, before] : sound["initial"]["regs"].items()) {
        if (name == vectors::name_in_set("flags", cpu)) continue;
        // A fault is recognised by where it leads.
        if (vectors::is_fault(sound) && (name == "cs" || name.ends_with("ip"))) continue;
        Json c = sound;
        const std::uint32_t right = vectors::final_value(c, name);
        const std::uint32_t wrong = right ^ 1U << ++bit % 16;
        c["final"]["regs"][name] = wrong;
        cases.push_back(c);
        const bool wide = cpu == "386" && name.size() == 3;
        words.push_back(
            fmt::format("{0}: model {1:0{3}x}, file {2:0{3}x}", name, right, wrong, wide ? 8 : 4));
      }
    }
    expect_named(cases, words, cpu);
  }
}

/// The 8088 pushes the address of the next instruction, later processors that of the divide.
TEST(Captures, TheReturnAddressOfAFaultBelongsToTheProcessor) {
  for (const auto& [of, by] : {std::pair{"8088", "286"}, {"286", "8088"}}) {
    for (const auto& capture : vectors::captures(of)) {
      if (!capture.name.starts_with("div")) continue;
      expect_named(Json::array({vectors::json_of(capture, by)}), {"memory 201fa: model 1"}, by);
    }
  }
}

TEST(Captures, PartsThatNoListingUsesAreCountedByReason) {
  const auto skipped = [](std::vector<int> code, vectors::Values before, std::string_view cpu) {
    const vectors::Capture capture{"x", std::move(code), std::move(before), {}, {}, {}};
    const auto run = vectors::judge(Json::array({vectors::json_of(capture, cpu)}), cpu);
    const auto at = run.out.find("1 skipped: 1 ");
    return at == std::string::npos ? run.out + run.err : run.out.substr(at + 13);
  };
  EXPECT_EQ(skipped({0xF3, 0xAA}, {}, "8088"), "prefix in no listing\n");
  EXPECT_EQ(skipped({0x26, 0x8B, 0x07}, {}, "8088"), "prefix in no listing\n");
  EXPECT_EQ(skipped({0x8B, 0x00}, {}, "8088"), "addressing in no listing\n");
  EXPECT_EQ(skipped({0x87, 0x07}, {}, "8088"), "form in no listing\n");
  EXPECT_EQ(skipped({0x2E, 0x89, 0x07}, {}, "8088"), "form in no listing\n") << "a write to CS";
  EXPECT_EQ(skipped({0xAB}, {{"flags", 0x402}}, "8088"), "direction flag set\n");
}

/// Since the 286 an operand that crosses the end of its segment is a fault, interrupt 12 or 13,
/// which the model does not have.
TEST(Captures, AnOperandAcrossTheEndOfASegmentIsSkippedIfTheProcessorFaults) {
  struct Crossing {
    std::vector<int> code;
    vectors::Values before;
    std::uint32_t interrupt;
  };
  const Crossing read{{0x8B, 0x07}, {{"bx", 0xFFFF}}, 13};
  const Crossing push{{0x50}, {{"sp", 1}}, 12};
  const Crossing wide{{0x66, 0x8B, 0x07}, {{"bx", 0xFFFD}}, 13};
  for (const auto& [crossing, cpu] :
       {std::pair{read, "286"}, {read, "386"}, {push, "286"}, {wide, "386"}}) {
    const std::uint32_t at = 4 * crossing.interrupt;
    vectors::Capture capture{"x", crossing.code, crossing.before, {}, {}, {}};
    capture.memory = {{at, 0}, {at + 1, 6}, {at + 2, 0}, {at + 3, 0x50}};
    const Json none = Json::array({vectors::json_of(capture, cpu)});
    expect_named(none, {"end of a segment: model crosses it, file has no fault"}, cpu);
    capture.after = {{"cs", 0x5000}, {"ip", 0x0600}};
    const auto run = vectors::judge(Json::array({vectors::json_of(capture, cpu)}), cpu);
    EXPECT_NE(run.out.find("1 skipped: 1 end of a segment\n"), std::string::npos) << run.out;
  }
}

TEST(Captures, ManyDifferentBytesAreCounted) {
  Json c = vectors::json_of(vectors::captures("8088")[0], "8088");
  for (unsigned i = 0; i < 100; ++i) c["final"]["ram"].push_back({0x70000 + i, 1});
  expect_named(Json::array({c}), {"memory 7000f: model nothing, file 01; memory: 84 more bytes"},
               "8088");
}

TEST(Captures, LinesRunOnThe8088AndThe386Only) {
  const auto run = command::fixproof("step --cpu 286");
  EXPECT_EQ(run.status, 2);
  EXPECT_NE(run.err.find("--cpu 286 needs --singlestep"), std::string::npos) << run.err;
}

}  // namespace
