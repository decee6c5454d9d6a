// Tests `fixproof report` as a user runs it.
#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "support/file.hpp"
#include "support/folder_lock.hpp"
#include "tests/support/command.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/test.hpp"

namespace {

namespace fs = std::filesystem;
using command::expect_contains;

const std::string cubes = paths::scene("twelve_cubes.json");

/// A folder that does not exist yet.
class Folder {
 public:
  explicit Folder(const std::string& name = "report") : path_(scratch_.path(name)) {}
  [[nodiscard]] std::string file(const std::string& name) const { return path_ + "/" + name; }
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  ScratchFolder scratch_;
  std::string path_;
};

/// The lines of a file, except for those that differ between runs.
std::string contents(const std::string& file) {
  std::string text;
  for (const std::string& line : command::split(fixproof::support::read_file(file), '\n')) {
    const bool varies =
        line.find("\"seconds\"") + 1 + line.find("\"date\"") + 1 + line.find("\"digest\"") + 1 > 0;
    if (!varies) text += line + '\n';
  }
  return text;
}

TEST(ReportCommand, WritesThePageAndItsData) {
  const Folder out;
  const auto run = command::fixproof("report " + cubes + " " + paths::scene("phong.json") +
                                     " --quick --out " + out.path());
  ASSERT_EQ(run.status, 0) << run.out << run.err;
  expect_contains(run.out, "report.html");

  const auto json = nlohmann::json::parse(fixproof::support::read_file(out.file("report.json")));
  EXPECT_TRUE(json.at("made").at("quick"));
  EXPECT_EQ(json.at("made").at("scenes"), nlohmann::json({"twelve cubes", "phong"}));
  EXPECT_FALSE(json.at("host").at("host").empty());
  EXPECT_GT(json.at("verify").at("cases").get<int>(), 65'536);
  EXPECT_EQ(json.at("verify").at("mismatches"), 0);
  EXPECT_EQ(json.at("verify").at("made_by").at(0).at("executable").get<std::string>().size(), 64U);
  for (const std::string part : {"verify", "accuracy", "clocks", "host", "drift", "stepping"}) {
    EXPECT_EQ(json.at(part), nlohmann::json::parse(
                                 fixproof::support::read_file(out.file("data/" + part + ".json"))))
        << part;
  }

  const std::string page = fixproof::support::read_file(out.file("report.html"));
  expect_contains(page, "alt=\"Animation: twelve cubes\"");
  // The page compares only interpolated scenes with the exact picture: three frames of 320 by 240.
  EXPECT_EQ(page.find("alt=\"twelve cubes: as stepped"), std::string::npos);
  expect_contains(page, "alt=\"phong: as stepped, exact");
  expect_contains(page, " of 230,400 pixels differ");
  expect_contains(page, "id=\"data\">{\"made\":{");
  EXPECT_EQ(page.find("src=\"http"), std::string::npos);

  // Each command that the page lists must write the files that the report wrote.
  const Folder again;
  fs::create_directories(again.file("data"));
  std::size_t compared = 0;
  for (const auto& step : json.at("commands")) {
    auto line = step.at("command").get<std::string>();
    ASSERT_EQ(line.substr(0, 9), "fixproof ");
    // Slow commands and timings.
    if (line.find("--clocks") + 1 + line.find("--host") + 1 + line.find("--stepping") + 1 > 0)
      continue;
    for (std::size_t at = line.find(out.path()); at != std::string::npos;
         at = line.find(out.path(), at)) {
      line.replace(at, out.path().size(), again.path());
    }
    const auto alone = command::fixproof(line.substr(9));
    EXPECT_EQ(alone.status, 0) << line << alone.err;
  }
  for (const auto& entry : fs::directory_iterator(again.file("data"))) {
    const std::string name = "data/" + entry.path().filename().string();
    EXPECT_TRUE(contents(out.file(name)) == contents(again.file(name))) << name;
    ++compared;
  }
  EXPECT_EQ(compared, 7U);
}

// Six steps, and one per default scene.
TEST(ReportCommand, FindsTheScenesOfTheCurrentFolder) {
  const Folder out;
  fs::create_directories(out.path());
  fs::create_directory_symlink(paths::source("xsharp"), out.file("xsharp"));
  const auto run = command::run({"sh", "-c",
                                 "cd '" + out.path() + "' && exec " +
                                     paths::source("tests/support/interrupted") + " INT 0.1 " +
                                     paths::command() + " report --out page"});
  EXPECT_EQ(run.status, 130) << run.err;
  expect_contains(run.out, "STOPPED after 0 of 12 ");
}

TEST(ReportCommand, KeepsASecondRunOutOfItsFolder) {
  const Folder out;
  fs::create_directories(out.path());
  const fixproof::support::FolderLock lock("--out", out.path());
  const auto run = command::fixproof("report " + cubes + " --quick --out " + out.path());
  EXPECT_EQ(run.status, 2);
  expect_contains(run.err, "another run writes to this folder");
}

TEST(ReportCommand, TellsScenesApartByTheirNames) {
  const Folder out;
  const auto run =
      command::fixproof("report " + cubes + " " + cubes + " --quick --out " + out.path());
  EXPECT_EQ(run.status, 2);
  expect_contains(run.err, "both named twelve cubes");
}

// A file name can contain any bytes.
TEST(ReportCommand, TakesNamesThatAreNoUtf8) {
  const Folder out("report_\xff");
  fs::create_directories(out.path());
  // A scene without a name takes its file's name.
  fixproof::support::replace_file(out.file("\xfe.json"),
                                  R"({"objects": [{"shape": {"cube": {"half_edge": 15}},
      "paint": 1, "position": [20, -30, -200], "spin": {"tenths": [0, 60, 60]}}]})");
  const auto run =
      command::fixproof("report " + out.file("\xfe.json") + " --quick --out " + out.path());
  ASSERT_EQ(run.status, 0) << run.out << run.err;
  EXPECT_TRUE(fs::exists(out.file("report.html")));
}

TEST(ReportCommand, MeasuresNothingOfASceneWithoutObjects) {
  const Folder out;
  fs::create_directories(out.path());
  fixproof::support::replace_file(out.file("empty.json"), R"({"name": "nothing", "objects": []})");
  const auto run =
      command::fixproof("report " + out.file("empty.json") + " --quick --out " + out.path());
  EXPECT_EQ(run.status, 2);
  EXPECT_EQ(run.out, "");
  expect_contains(run.err, "nothing has no objects");
}

// Changing a scene file after the first step must not affect the report.
TEST(ReportCommand, ReadsEachSceneOnce) {
  const Folder out;
  fs::create_directories(out.path());
  const std::string scene = out.file("scene.json");
  fs::copy_file(cubes, scene);
  const auto run = command::run({"bash", "-c", R"(
      "$1" report "$2" --quick --out "$3" &
      until [[ -s $3/data/verify.json ]]; do kill -0 $! || break; sleep 0.01; done
      [[ ! -e $3/report.html ]] || exit 3
      cp "$4" "$3/other" && mv "$3/other" "$2"
      wait $!)",
                                 "changing", paths::command(), scene, out.path(),
                                 paths::scene("shaded_ball.json")});
  EXPECT_EQ(run.status, 0) << run.out << run.err;
  const auto json = nlohmann::json::parse(fixproof::support::read_file(out.file("report.json")));
  EXPECT_EQ(json.at("made").at("scenes"), nlohmann::json({"twelve cubes"}));
  EXPECT_EQ(json.at("drift").at("scene"), "twelve cubes");
  EXPECT_EQ(json.at("accuracy").at("scenes"), nlohmann::json({"twelve cubes"}));
  expect_contains(fixproof::support::read_file(out.file("report.html")),
                  "alt=\"Animation: twelve cubes\"");
}

TEST(ReportCommand, LeavesNoPageWhenStopped) {
  const Folder out;
  // The first step of a full report takes seconds, so the signal arrives before it ends.
  const auto run = command::run({paths::source("tests/support/interrupted"), "INT", "0.1",
                                 paths::command(), "report", cubes, "--out", out.path()});
  EXPECT_EQ(run.status, 130) << run.err;
  expect_contains(run.out, "STOPPED after 0 of ");
  EXPECT_FALSE(fs::exists(out.file("report.html")));
}

TEST(ReportCommand, SaysWhatIsWrong) {
  const Folder out;
  for (const std::string& arguments :
       {std::string("report no_such_scene.json --out ") + out.path(),
        "report " + cubes + " --out /dev/null/x", "report " + cubes + " --seed -1",
        std::string("report --out ") + out.path(), "report " + cubes + " --out "}) {
    const auto run = command::fixproof(arguments);
    EXPECT_EQ(run.status, 2) << arguments;
    EXPECT_EQ(command::split(run.err, '\n').size(), 2U) << run.err;
  }
}

// An output path of the report may be the path of a scene.
TEST(ReportCommand, DoesNotOverwriteAScene) {
  const Folder out;
  fs::create_directories(out.file("data"));
  for (const std::string name : {"host.json", "drift.svg"}) {
    const std::string scene = out.file("data/" + name);
    fs::copy_file(cubes, scene);
    const auto run = command::fixproof("report " + scene + " --quick --out " + out.path());
    EXPECT_EQ(run.status, 2);
    expect_contains(run.err, name);
    EXPECT_TRUE(fixproof::support::read_file(scene) == fixproof::support::read_file(cubes));
    fs::remove(scene);
  }
}

}  // namespace
