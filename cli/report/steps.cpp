#include "cli/report/steps.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "cli/command_line.hpp"
#include "support/file.hpp"
#include "support/interrupt.hpp"
#include "support/json.hpp"
#include "support/plain_text.hpp"

namespace fixproof::cli {

namespace {

using support::Json;

/// Of --quick.
constexpr const char* few_operands = "300";
constexpr const char* few_frames = "3";
/// Two seconds of an animation.
constexpr const char* shown_frames = "120";

uLong sum_of(uLong sum, const std::string& text) {
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): zlib's bytes are unsigned
  return crc32_z(sum, reinterpret_cast<const Bytef*>(text.data()), text.size());
}

void append(std::vector<std::string>& to, const std::vector<std::string>& more) {
  to.insert(to.end(), more.begin(), more.end());
}

/// A word of a command line, in quotes where a shell would not take it as it stands.
std::string shell_word(const std::string& word) {
  const auto plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string_view("_-./=,+:@").find(c) != std::string_view::npos;
  };
  if (!word.empty() && std::all_of(word.begin(), word.end(), plain)) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

}  // namespace

bool has_beside(const xsharp::Scene& scene) {
  return xsharp::interpolates(scene) && scene.arithmetic.by != "double";
}

std::vector<ReportStep> report_steps(const ReportRequest& request,
                                     const std::vector<xsharp::Scene>& scenes) {
  const auto file = [&](const std::string& name) { return request.folder + "/data/" + name; };
  const std::string seed = fmt::to_string(request.seed);
  std::vector<ReportStep> steps;

  // The smallest routine alone for a quick page.
  steps.push_back({"verify", {"verify"}, {file("verify.json")}});
  if (request.quick) append(steps.back().arguments, {"cossin", "sqrt"});
  append(steps.back().arguments, {"--seed", seed, "--report", file("verify.json")});

  for (const std::string what : {"accuracy", "clocks"}) {
    steps.push_back({what, {"measure", "--" + what}, {file(what + ".json")}});
    // Clocks take seconds a scene.
    if (request.quick) {
      append(steps.back().arguments, {request.scenes.front(), "--cases", few_operands});
    } else {
      append(steps.back().arguments, request.scenes);
    }
    append(steps.back().arguments, {"--seed", seed, "--json", file(what + ".json")});
  }
  steps.push_back({"host", {"measure", "--host"}, {file("host.json")}});
  if (request.quick) append(steps.back().arguments, {"--cases", few_operands, "--rounds", "1"});
  append(steps.back().arguments, {"--seed", seed, "--json", file("host.json")});

  steps.push_back({"stepping", {"measure", "--stepping"}, {file("stepping.json")}});
  if (request.quick) append(steps.back().arguments, {"--cases", "4", "--rounds", "1"});
  append(steps.back().arguments, {"--seed", seed, "--json", file("stepping.json")});

  steps.push_back({"drift", {"drift", request.scenes.front()}, {file("drift.json")}});
  if (request.quick) append(steps.back().arguments, {"--minutes", "1"});
  append(steps.back().arguments, {"--json", file("drift.json"), "--strip", file("drift.svg")});
  steps.back().files.push_back(file("drift.svg"));

  for (std::size_t i = 0; i < request.scenes.size(); ++i) {
    const std::string name = fmt::format("scene_{}", i + 1);
    steps.push_back({name,
                     {"render", request.scenes[i], "--frames",
                      request.quick ? few_frames : shown_frames, "--animate", file(name + ".png")},
                     {file(name + ".png")}});
    if (!has_beside(scenes[i])) continue;
    append(steps.back().arguments, {"--beside", file(name + "_beside.png")});
    steps.back().files.push_back(file(name + "_beside.png"));
  }
  return steps;
}

std::string command_line_of(const ReportStep& step) {
  std::string line = "fixproof";
  for (const std::string& argument : step.arguments) line += ' ' + shell_word(argument);
  return line;
}

bool page_shows(const ReportStep& step, int status) {
  // verify has found a mismatch.
  return status == 0 || (step.name == "verify" && status == 1);
}

int report_status(int status) { return status == support::interrupted_status ? status : 2; }

std::string stopped_text(const ReportStep& step, int status, std::size_t done, std::size_t all) {
  std::string text = fmt::format("STOPPED after {} of {} steps; no page is written.", done, all);
  if (status == support::interrupted_status)
    return text + " With --resume the same command goes on.\n";
  text += fmt::format(" It ended with status {}: {}", status,
                      support::printable(command_line_of(step)));
  if (step.name == "host" && status == 1) text += "\nA number that it times breaks its own rule.";
  if (step.name == "stepping" && status == 1) text += "\nA stepped value is beyond its bound.";
  return text + '\n';
}

std::string sum_of_files(const std::vector<std::string>& files) {
  uLong sum = 0;
  for (const std::string& file : files) {
    if (!std::filesystem::is_regular_file(file)) return {};
    const std::string contents = support::read_file(file);
    sum = sum_of(sum, fmt::format("{} ", contents.size()) + contents);
  }
  return fmt::format("{:08x}", sum);
}

std::string fingerprint(const std::vector<xsharp::Scene>& scenes, const std::string& processor) {
  uLong sum = sum_of(0, std::string(program_version()));
  sum = sum_of(sum, processor);
  // Linux has the running program there; elsewhere the version has to do.
  const std::string program = "/proc/self/exe";
  if (std::filesystem::exists(program)) sum = sum_of(sum, support::read_file(program));
  for (const xsharp::Scene& scene : scenes) {
    for (const auto& read : scene.files) sum = sum_of(sum, support::read_file(read.string()));
  }
  return fmt::format("{:08x}", sum);
}

std::string as_recorded(const std::string& command) {
  return Json::parse(support::json_text(command)).get<std::string>();
}

std::vector<StepRecord> read_records(const std::string& file) {
  std::vector<StepRecord> records;
  if (!std::filesystem::is_regular_file(file)) return records;
  try {
    for (const Json& json : Json::parse(support::read_file(file))) {
      records.push_back({json.at("name").get<std::string>(), json.at("command").get<std::string>(),
                         json.at("made_from").get<std::string>(),
                         json.at("date").get<std::string>(), json.at("seconds").get<double>(),
                         json.at("status").get<int>(), json.at("left").get<std::string>()});
    }
  } catch (const Json::exception&) {
    records.clear();
  }
  return records;
}

void write_records(const std::string& file, const std::vector<StepRecord>& records) {
  Json json = Json::array();
  for (const StepRecord& r : records) {
    json.push_back({{"name", r.name},
                    {"command", r.command},
                    {"made_from", r.made_from},
                    {"date", r.date},
                    {"seconds", r.seconds},
                    {"status", r.status},
                    {"left", r.left}});
  }
  support::replace_file(file, support::json_text(json));
}

}  // namespace fixproof::cli
