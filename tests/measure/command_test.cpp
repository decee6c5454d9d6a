// Tests `fixproof measure` as a user runs it.
#include "tests/support/command.hpp"

#include <nlohmann/json.hpp>

#include "tests/support/paths.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/test.hpp"

namespace {

TEST(MeasureCommand, WantsOneThingToMeasure) {
  const std::vector<std::string> refused{
      "measure",
      "measure --accuracy --clocks",
      "measure --accuracy --cases 0",
      "measure --accuracy --seed -1",
      "measure --clocks no/such/scene.json",
      "measure --host --accuracy",
      "measure --host " + paths::scene("solid.json"),
      "measure --clocks --rounds 3",
      "measure --host --rounds 0",
      "measure --host --json /no/such/folder/file",
      "measure --stepping --clocks",
      "measure --stepping " + paths::scene("solid.json"),
      "measure --accuracy --rounds 3",
      "measure --stepping --cases 0",
      "measure --stepping --json /no/such/folder/file",
      "measure --accuracy --json /no/such/folder/file",
      "measure --host --format q2_30",
      "measure --format q2_30",
      "measure --accuracy --format q2_31",
      "measure --accuracy --format q5_3",
      "measure --accuracy --format q2_30 " + paths::scene("solid.json"),
      "measure --accuracy " + paths::scene("solid.json") + " --json " +
          paths::scene("dodecahedron.obj")};
  for (const std::string& arguments : refused) {
    command::expect_refused(arguments, "");
  }
}

struct Measured {
  std::string out;
  nlohmann::json json;
};

/// Runs `fixproof measure` with seed 5.
Measured measured(const std::string& options) {
  const ScratchFolder folder;
  const auto run =
      command::fixproof("measure " + options + " --seed 5 --json " + folder.path("json"));
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.out.substr(0, 8), "seed 5, ");
  Measured both{run.out, nlohmann::json::parse(folder.read("json"))};
  EXPECT_EQ(both.json.at("made").at("seed"), 5);
  return both;
}

TEST(MeasureCommand, SaysWhatMadeItAndWritesTheSameAsJson) {
  const auto json = measured("--accuracy --cases 200").json;
  EXPECT_EQ(json.at("made").at("date").get<std::string>().size(), 20U);
  for (const auto& row : json.at("accuracy")) {
    const auto& counts = row.at("histogram").at("counts");
    EXPECT_EQ(counts.size(), 16U);
    std::uint64_t all = 0;
    for (const auto& count : counts) all += count.get<std::uint64_t>();
    EXPECT_EQ(row.at("cases"), all);
    EXPECT_NEAR(row.at("mean_error").get<double>() * std::sqrt(static_cast<double>(all)),
                row.at("rms"), 1e-9 * row.at("rms").get<double>());
    if (row.at("operands") == "every angle") continue;
    EXPECT_EQ(all + row.at("left_out").get<std::uint64_t>() + row.at("faults").get<std::uint64_t>(),
              200U);
  }
  EXPECT_EQ(json.at("pixels").at("variants").size(), 4U);
}

TEST(MeasureCommand, MeasuresAFormat) {
  const auto [out, json] = measured("--accuracy --format q2_30 --cases 200");
  EXPECT_EQ(json.at("format"), "q2_30");
  std::map<std::string, int> found;
  for (const auto& row : json.at("accuracy")) {
    ++found[row.at("variant")];
    EXPECT_EQ(row.at("cases").get<std::uint64_t>() + row.at("left_out").get<std::uint64_t>(), 200U);
  }
  EXPECT_EQ(found, (std::map<std::string, int>{{"double", 6},
                                               {"float", 6},
                                               {"q2_30", 2},
                                               {"q2_30, floor", 4},
                                               {"q2_30, half away", 4},
                                               {"q2_30, half even", 4},
                                               {"q2_30, half up", 4},
                                               {"q2_30, truncate", 4}}));
  EXPECT_NE(out.find("mul, log-uniform"), std::string::npos);
}

/// Whether the times are positive and ordered.
bool is_time(const nlohmann::json& times) {
  return times.at("min") > 0 && times.at("median") >= times.at("min") && times.at("spread") >= 0;
}

TEST(MeasureCommand, TimesEveryContenderAndSaysWhatIsLeftOut) {
  const auto [out, json] = measured("--host --rounds 1 --cases 1");
  EXPECT_NE(json.at("made").at("processor"), "");
  EXPECT_EQ(json.at("rounds"), 1);
  EXPECT_EQ(json.at("operands").at("arrays").at("div"), 1024);
  EXPECT_EQ(json.at("operands").at("arrays").at("vertex"), 512);
  EXPECT_EQ(json.at("operands").at("chains"),
            nlohmann::json::parse(R"({"mul": 1024, "div": 256, "sqrt": 1024})"));
  std::map<std::string, int> found;
  for (const auto& row : json.at("host")) {
    ++found[row.at("contender")];
    EXPECT_TRUE(is_time(row.at("throughput_ns"))) << row;
    EXPECT_EQ(row.at("chain_ns").is_null(), row.at("operation") == "cos") << row;
    EXPECT_TRUE(row.at("chain_ns").is_null() || is_time(row.at("chain_ns"))) << row;
    EXPECT_GE(row.at("accuracy").at("max"), 0);
  }
  EXPECT_EQ(found["q16_16"], 4);
  EXPECT_EQ(found["double"], 4);
  for (const auto& row : json.at("vertices")) {
    EXPECT_TRUE(is_time(row.at("ns"))) << row;
    EXPECT_EQ(row.at("cases"), 3 * 512);
  }
  for (const char* library : {"libfixmath", "FreeType"}) {
    const bool built_in = json.at("libraries").at(library);
    EXPECT_EQ(found[library] > 0, built_in) << library;
    const std::string line =
        std::string(library) + " is left out, because it was not found when this program was built";
    EXPECT_EQ(out.find(line) == std::string::npos, built_in) << library;
  }
}

TEST(MeasureCommand, StepsEveryVariantWithinItsBound) {
  const auto json = measured("--stepping --cases 2 --rounds 1").json;
  EXPECT_EQ(json.at("lengths").at("most"), 320);
  std::map<std::string, int> found;
  for (const auto& row : json.at("stepping")) {
    ++found[row.at("value")];
    EXPECT_EQ(row.at("spans"), 2 * 320);
    EXPECT_EQ(row.at("beyond"), "");
    EXPECT_LE(row.at("max"), row.at("bound"));
    EXPECT_EQ(row.at("along").front().at("pixel"), 0);
    EXPECT_EQ(row.at("along").back().at("pixel"), 319);
    EXPECT_EQ(row.at("last_of").back().at("pixels"), 320);
  }
  EXPECT_EQ(found, (std::map<std::string, int>{{"intensity 8.8", 5},
                                               {"intensity 16.16", 5},
                                               {"depth 16.8", 5},
                                               {"depth 14.8, not cleared", 5},
                                               {"texture 8.8, affine", 5},
                                               {"texture, perspective", 4},
                                               {"texture, perspective, cut", 3},
                                               {"Phong", 4},
                                               {"Phong, cut", 3}}));
  EXPECT_EQ(json.at("setups").size(), 4U);
  EXPECT_EQ(json.at("claims").size(), 3U);
  for (const auto& loop : json.at("times").at("loops")) EXPECT_TRUE(is_time(loop.at("ns"))) << loop;
}

}  // namespace
