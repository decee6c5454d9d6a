// `fixproof measure` as a user runs it.
#include "tests/cli/command.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

#include "verify/file.hpp"

namespace {

TEST(MeasureCommand, WantsOneThingToMeasure) {
  for (const char* arguments :
       {"measure", "measure --accuracy --clocks", "measure --accuracy --cases 0",
        "measure --accuracy --seed -1", "measure --clocks no/such/scene.json",
        "measure --accuracy --json /no/such/folder/file",
        "measure --accuracy " SCENES "/solid.json --json " SCENES "/dodecahedron.obj"}) {
    const auto run = cli::fixproof(arguments);
    EXPECT_EQ(run.status, 2) << arguments;
    EXPECT_EQ(run.out, "") << arguments;
    EXPECT_EQ(cli::split(run.err, '\n').size(), 2U) << run.err;
  }
}

TEST(MeasureCommand, SaysWhatMadeItAndWritesTheSameAsJson) {
  const std::string file = testing::TempDir() + "measure_command_test.json";
  const auto run = cli::fixproof("measure --accuracy --cases 200 --seed 5 --json " + file);
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.out.substr(0, 8), "seed 5, ");
  const auto json = nlohmann::json::parse(fixproof::read_file(file));
  std::remove(file.c_str());
  EXPECT_EQ(json.at("made").at("seed"), 5);
  EXPECT_EQ(json.at("made").at("date").get<std::string>().size(), 20U);
  for (const auto& row : json.at("accuracy")) {
    const auto& counts = row.at("histogram").at("counts");
    EXPECT_EQ(counts.size(), 16U);
    std::uint64_t all = 0;
    for (const auto& count : counts) all += count.get<std::uint64_t>();
    EXPECT_EQ(row.at("cases"), all);
    if (row.at("operands") == "every angle") continue;
    EXPECT_EQ(all + row.at("left_out").get<std::uint64_t>() + row.at("faults").get<std::uint64_t>(),
              200U);
  }
  EXPECT_EQ(json.at("pixels").at("variants").size(), 4U);
}

}  // namespace
