#include "cli/report/make_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <optional>
#include <sstream>
#include <string_view>
#include <system_error>

#include "cli/command_line.hpp"
#include "cli/report/page.hpp"
#include "player/outputs.hpp"
#include "support/file.hpp"
#include "support/folder_lock.hpp"
#include "support/interrupt.hpp"
#include "support/json.hpp"
#include "support/plain_text.hpp"
#include "support/usage_error.hpp"
#include "trade/host/provenance.hpp"
#include "xsharp/files/scene_json.hpp"

namespace fixproof::cli {

namespace {

using support::Json;

/// What stands behind `start` in the line that begins with it; empty where none does.
std::string line_of(const std::string& text, std::string_view start) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(start)) return line.substr(start.size());
  }
  return {};
}

class ReportRun {
 public:
  explicit ReportRun(const ReportRequest& request) : request_(request) {
    for (const std::string& file : request.scenes) scenes_.push_back(xsharp::read_scene(file));
    refuse_one_name_for_two();
    // The drift of the first is measured, after all that takes long.
    if (scenes_.front().objects.empty())
      throw support::UsageError(scenes_.front().name + " has no objects");
    std::error_code error;
    std::filesystem::create_directories(request.folder + "/data", error);
    if (error) {
      throw support::UsageError(
          fmt::format("--out {}: cannot be made a folder: {}", request.folder, error.message()));
    }
    lock_.emplace("--out", request.folder);
    steps_ = report_steps(request, scenes_);
    for (const char* name : {"/report.html", "/report.json", "/data/steps.json"}) {
      check(request.folder + name);
    }
    for (const ReportStep& step : steps_) {
      for (const std::string& file : step.files) check(file);
      check(text_file(step));
    }
    made_from_ = fingerprint(scenes_, trade::processor_name());
    if (request.resume) earlier_ = read_records(records_file());
  }

  /// @return 0, or the exit status where a step ended it
  int run_steps() {
    for (const ReportStep& step : steps_) {
      const std::string command = command_line_of(step);
      std::cout << fmt::format("{} of {}: {}", records_.size() + 1, steps_.size(),
                               support::printable(command));
      if (const StepRecord* kept = kept_record(step, command)) {
        records_.push_back(*kept);
        std::cout << fmt::format(": kept, of {}\n", kept->date);
        continue;
      }
      // Progress and errors have lines of their own.
      std::cout << '\n' << std::flush;
      const auto begin = std::chrono::steady_clock::now();
      Captured captured = run_captured(step.arguments);
      const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
      const bool shows = page_shows(step, captured.status);
      std::cout << fmt::format("  {}\n", shows ? support::duration(passed.count()) : "not done");
      if (!shows) {
        std::cout << stopped_text(step, captured.status, records_.size(), steps_.size());
        return report_status(captured.status);
      }
      refuse_changed_scenes();
      support::replace_file(text_file(step), captured.out);
      records_.push_back({step.name, command, made_from_, trade::date_now(), passed.count(),
                          captured.status, sum_of_files(left_by(step))});
      write_records(records_file(), records_);
    }
    return 0;
  }

  void write_page() {
    Json report{{"made", made()}, {"commands", commands()}};
    for (const char* part : {"verify", "accuracy", "clocks", "host", "drift", "stepping"}) {
      report[part] = data_of(part);
    }

    std::vector<PagePicture> pictures;
    for (std::size_t i = 0; i < scenes_.size(); ++i) {
      const std::string stem = fmt::format("{}/data/scene_{}", request_.folder, i + 1);
      pictures.push_back({scenes_[i].name, support::read_file(stem + ".png"), "", ""});
      if (!has_beside(scenes_[i])) continue;
      pictures.back().beside = support::read_file(stem + "_beside.png");
      pictures.back().beside_text = line_of(support::read_file(stem + ".txt"), "Beside exact: ");
    }
    const std::string page = assemble_page(page_parts(), report, pictures,
                                           support::read_file(request_.folder + "/data/drift.svg"));
    support::replace_file(request_.folder + "/report.json", support::json_text(report));
    support::replace_file(request_.folder + "/report.html", page);
  }

  /// 1 where parties differ.
  [[nodiscard]] int status() const { return records_.front().status; }

 private:
  void check(const std::string& file) const {
    for (const xsharp::Scene& scene : scenes_) player::refuse_inputs("--out", file, scene.files);
    support::check_replaceable(file);
  }

  /// Figures and pictures go by the names of the scenes.
  void refuse_one_name_for_two() const {
    for (std::size_t i = 0; i < scenes_.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (scenes_[i].name != scenes_[j].name) continue;
        throw support::UsageError(fmt::format("{} and {} are both named {}: give one another name",
                                              request_.scenes[j], request_.scenes[i],
                                              scenes_[i].name));
      }
    }
  }

  void refuse_changed_scenes() const {
    std::vector<xsharp::Scene> now;
    for (const std::string& file : request_.scenes) now.push_back(xsharp::read_scene(file));
    if (fingerprint(now, trade::processor_name()) != made_from_) {
      throw support::UsageError(
          "report: a scene has changed while it was measured; no page is written");
    }
  }

  [[nodiscard]] std::string records_file() const { return request_.folder + "/data/steps.json"; }
  [[nodiscard]] std::string text_file(const ReportStep& step) const {
    return fmt::format("{}/data/{}.txt", request_.folder, step.name);
  }

  [[nodiscard]] std::vector<std::string> left_by(const ReportStep& step) const {
    std::vector<std::string> files = step.files;
    files.push_back(text_file(step));
    return files;
  }

  /// What an earlier run has done of the step, if it is what this one would do.
  [[nodiscard]] const StepRecord* kept_record(const ReportStep& step,
                                              const std::string& command) const {
    const auto fits = [&](const StepRecord& r) {
      return r.name == step.name && r.command == as_recorded(command) && r.made_from == made_from_;
    };
    const auto found = std::find_if(earlier_.begin(), earlier_.end(), fits);
    if (found == earlier_.end()) return nullptr;
    const std::string sum = sum_of_files(left_by(step));
    return !sum.empty() && sum == found->left ? &*found : nullptr;
  }

  [[nodiscard]] Json made() const {
    Json names = Json::array();
    for (const xsharp::Scene& scene : scenes_) names.push_back(scene.name);
    return {{"version", program_version()},       {"seed", request_.seed},
            {"compiler", trade::compiler_name()}, {"processor", trade::processor_name()},
            {"date", trade::date_now()},          {"quick", request_.quick},
            {"scenes", std::move(names)}};
  }

  [[nodiscard]] Json commands() const {
    Json list = Json::array();
    for (const StepRecord& r : records_) {
      list.push_back({{"command", r.command}, {"date", r.date}, {"seconds", r.seconds}});
    }
    return list;
  }

  /// The file of that step; null where this build, or a quick report, does not have it.
  [[nodiscard]] Json data_of(const std::string& part) const {
    for (const ReportStep& step : steps_) {
      if (step.name == part) return Json::parse(support::read_file(step.files.front()));
    }
    return {};
  }

  const ReportRequest& request_;
  std::vector<xsharp::Scene> scenes_;
  std::optional<support::FolderLock> lock_;
  std::vector<ReportStep> steps_;
  std::string made_from_;
  std::vector<StepRecord> earlier_;
  std::vector<StepRecord> records_;
};

}  // namespace

int make_report(const ReportRequest& request) {
  ReportRun run(request);
  const int failed = run.run_steps();
  if (failed != 0) return failed;
  run.write_page();
  std::cout << fmt::format(
      "{0}/report.html is the page; {0}/report.json and the files in {0}/data have its figures\n",
      support::printable(request.folder));
  return run.status();
}

}  // namespace fixproof::cli
