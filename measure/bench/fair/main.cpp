// Verifies all contenders, times those that take part, and prints one line of JSON for each time.
// `fair --help` says how it is called.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "measure/bench/fair/contender.hpp"
#include "measure/bench/fair/groups.hpp"

namespace {

using namespace fair;

struct Settings {
  std::size_t most = std::numeric_limits<std::size_t>::max();
  int rounds = 25;
  bool time = true;
  std::string only;
};

/// Returns the largest error over the edges.
Ulp edge_error(const Contender& who, const std::vector<Words>& edges) {
  Ulp largest = 0;
  for (const Words& words : edges) {
    const auto run = who.make(words, words.size(), 0);
    run->run(1);
    largest = std::max(largest, run->error());
  }
  return largest;
}

double seconds(Run& run, std::size_t times) {
  using clock = std::chrono::steady_clock;
  const auto start = clock::now();
  run.run(times);
  return std::chrono::duration<double>(clock::now() - start).count();
}

/// The calls that one round times: enough for 40 microseconds.
std::size_t calls(Run& run) {
  constexpr double enough = 40e-6;
  std::size_t times = 1;
  while (times < (std::size_t{1} << 20)) {
    const double taken = seconds(run, times);
    if (taken >= enough) break;
    times = taken < enough / 8 ? 4 * times : times * 2;
  }
  return times;
}

struct Entry {
  const Contender* who;
  std::unique_ptr<Run> run;
  Ulp error;
  std::size_t times = 1;
  double best = std::numeric_limits<double>::infinity();
};

/// Every contender takes its turn in each round; the least time counts. Each call that is timed
/// follows one that is not, so that the contender's own arrays are in the caches that hold them.
void time_all(std::vector<Entry>& all, int rounds, bool large) {
  for (Entry& e : all) e.times = large ? 1 : calls(*e.run);
  for (int round = 0; round < rounds; ++round) {
    for (Entry& e : all) {
      e.run->run(1);
      e.best = std::min(e.best, seconds(*e.run, e.times) / static_cast<double>(e.times));
    }
  }
}

void compete(Group& group, const Settings& settings) {
  std::size_t largest = 0;
  for (const auto& [count, offset] : group.sizes) {
    if (count <= settings.most) largest = std::max(largest, count);
  }
  const Words words = group.draw(largest);
  const std::vector<Words> edges = group.edges();
  for (Contender& who : group.contenders) who.edge_error = edge_error(who, edges);
  for (const auto& [count, offset] : group.sizes) {
    if (count > settings.most) continue;
    std::vector<Entry> all;
    for (const Contender& who : group.contenders) {
      auto run = who.make(words, count, offset);
      run->run(1);
      const Ulp error = std::max(who.edge_error, run->error());
      all.push_back({&who, std::move(run), error});
    }
    const bool large = count >= 1'000'000;
    if (settings.time) time_all(all, large ? std::min(settings.rounds, 6) : settings.rounds, large);
    for (const Entry& e : all) {
      std::printf(
          R"({"operation": "%s", "shape": "%s", "elements": %zu, "offset": %zu, "name": "%s", )"
          R"("ours": %s, "error": %.6Lg, "ns": %.5g})"
          "\n",
          group.operation.c_str(), group.shape.c_str(), count, offset, e.who->name.c_str(),
          e.who->role == Role::ours ? "true" : "false", std::min(e.error, 1e30L),
          settings.time ? e.best * 1e9 / static_cast<double>(count) : 0);
    }
  }
}

constexpr const char* help = R"(usage: fair [--verify] [--most N] [--rounds N] [--only OPERATION]
Prints a line of JSON for each contender, with its largest error in ulp and its least time per element.
  --verify   does not time
  --most N   leaves out spans of more than N elements
  --rounds N takes the least of N times (25)
)";

Settings settings_of(int argc, char** argv) {
  Settings settings;
  for (int i = 1; i < argc; ++i) {
    const std::string_view option = argv[i];
    if (option == "--verify") {
      settings.time = false;
      continue;
    }
    if (option == "--help" || i + 1 == argc) {
      std::fputs(help, option == "--help" ? stdout : stderr);
      std::exit(option == "--help" ? 0 : 2);
    }
    const char* const value = argv[++i];
    if (option == "--most") {
      settings.most = std::strtoull(value, nullptr, 10);
    } else if (option == "--rounds") {
      settings.rounds = static_cast<int>(std::strtol(value, nullptr, 10));
    } else if (option == "--only") {
      settings.only = value;
    } else {
      std::fputs(help, stderr);
      std::exit(2);
    }
  }
  return settings;
}

}  // namespace

int main(int argc, char** argv) {
  const Settings settings = settings_of(argc, argv);
  std::vector<Group> groups;
  add_arithmetic(groups);
  add_angles(groups);
  add_sums(groups);
  for (Group& group : groups) {
    if (!settings.only.empty() && group.operation != settings.only) continue;
    std::fprintf(stderr, "%s, %s\n", group.operation.c_str(), group.shape.c_str());
    compete(group, settings);
  }
  return 0;
}
