// Target `input_lines`: the first byte chooses a command, the rest is its input. Bad lines must
// raise a UsageError. Also checks answers: eval must agree for model and oracle, step for an 8088
// and a 386, and check must pass the oracle's results.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <iostream>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "check/cases.hpp"
#include "check/results.hpp"
#include "cli/commands.hpp"
#include "fuzz/finding.hpp"
#include "fuzz/memory_file.hpp"
#include "oracle/exact.hpp"
#include "support/usage_error.hpp"

using namespace fixproof;

namespace {

struct Answer {
  std::string out;
  int status = 0;
  std::string refused;

  friend bool operator==(const Answer&, const Answer&) = default;
};

/// One command of `fixproof`. Parsing the whole command line would dominate the time.
class Command {
 public:
  explicit Command(void (*add)(CLI::App&, int&)) { add(app_, status_); }

  Answer run(const std::string& arguments, const std::string& input) {
    std::istringstream in(input);
    std::ostringstream out;
    std::streambuf* const cin = std::cin.rdbuf(in.rdbuf());
    std::streambuf* const cout = std::cout.rdbuf(out.rdbuf());
    Answer said;
    try {
      app_.parse(arguments);
      said.status = status_;
    } catch (const support::UsageError& error) {
      said.refused = error.what();
    } catch (const std::exception& error) {
      std::cin.rdbuf(cin);
      std::cout.rdbuf(cout);
      fuzz::report_finding(
          fmt::format("fixproof {}: not a UsageError: {}", arguments, error.what()));
    }
    std::cin.rdbuf(cin);
    std::cout.rdbuf(cout);
    said.out = out.str();
    return said;
  }

 private:
  CLI::App app_;
  int status_ = 0;
};

[[noreturn]] void report(const std::string& command, const std::string& other,
                         const std::string& input, const std::string& what) {
  fuzz::report_finding(fmt::format("{}\n  replay: fixproof {} <INPUT, against: {}; INPUT is\n{}",
                                   what, command, other, input));
}

void eval(const std::string& options, const std::string& input) {
  static Command command(cli::add_eval);
  const std::string by_model = "eval " + options + " --by model";
  const std::string by_oracle = "eval " + options + " --by oracle";
  if (command.run(by_model, input) != command.run(by_oracle, input)) {
    report(by_model, "fixproof " + by_oracle, input, "model and oracle are not of one mind");
  }
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

void step(const std::string& input) {
  static Command command(cli::add_step);
  const Answer narrow = command.run("step --cpu 8088", input);
  const Answer wide = command.run("step --cpu 386", input);
  command.run("step --cpu 386 --clocks 486", input);
  const auto narrow_lines = lines_of(narrow.out);
  const auto wide_lines = lines_of(wide.out);
  if (wide_lines.size() < narrow_lines.size()) {
    report("step --cpu 386", "--cpu 8088", input, "the 386 refuses what the 8088 takes");
  }
  for (std::size_t i = 0; i < narrow_lines.size(); ++i) {
    if (narrow_lines[i] != "unmodelled" && narrow_lines[i] != wide_lines[i]) {
      report("step --cpu 386", "--cpu 8088", input, "the 386 answers otherwise: " + wide_lines[i]);
    }
  }
}

/// The result by half up and wrapping; #DE for a zero divisor or a negative radicand.
std::optional<std::uint32_t> right(cases::Operation operation,
                                   std::span<const std::uint32_t> words) {
  constexpr auto rule = oracle::Rounding::half_up;
  if (operation == cases::Operation::mul) return oracle::mul(words[0], words[1], rule, 16);
  if (operation == cases::Operation::div) return oracle::quotient(words[0], words[1], rule, 16);
  return oracle::sqrt(words[0], 16);
}

/// Whether every result is correct; nothing if a line is invalid or one input ends early.
std::optional<bool> all_correct(cases::Operation operation, const std::string& cases,
                                const std::string& results) {
  const fuzz::MemoryFile file(cases);
  check::FileCases source(check::variant_of(operation), file.path());
  std::istringstream in(results);
  check::Results said(in, "results", cases::q16_16);
  std::array<std::uint32_t, 2> words{};
  const auto one_case = std::span(words).first(cases::words_in(operation));
  bool all = true;
  bool any = false;
  try {
    while (source.next(one_case)) {
      const auto result = said.next();
      if (!result) return std::nullopt;
      all = all && *result == right(operation, one_case);
      any = true;
    }
    if (!any || said.next()) return std::nullopt;
  } catch (const support::UsageError&) {
    return std::nullopt;
  }
  return all;
}

/// The input is cases, a line `--`, and results.
void check(cases::Operation operation, const std::string& input) {
  static Command command(cli::add_check);
  constexpr std::string_view bar = "\n--\n";
  const auto at = input.find(bar);
  const std::string cases = at == std::string::npos ? input : input.substr(0, at + 1);
  const std::string results = at == std::string::npos ? "" : input.substr(at + bar.size());
  const fuzz::MemoryFile file(cases);
  const std::string arguments =
      fmt::format("check {} --rounding half-up --from {}", cases::name_of(operation), file.path());
  const Answer said = command.run(arguments, results);
  const auto expected = all_correct(operation, cases, results);
  const bool refused = !said.refused.empty();
  if (refused == expected.has_value() || (expected && (said.status == 0) != *expected)) {
    report(arguments, "the oracle", input,
           fmt::format("status {}, {}; expected {}", said.status, said.refused,
                       !expected   ? "a refusal"
                       : *expected ? "0"
                                   : "1"));
  }
}

using Try = std::function<void(const std::string& input)>;

const std::vector<Try>& tries() {
  static const auto all = [] {
    std::vector<Try> made;
    for (const char* options : {"mul", "mul --target i8088", "div", "div --target i8088",
                                "div --round off", "cossin", "xformvec", "concat --chapter 52"}) {
      made.emplace_back([options](const std::string& input) { eval(options, input); });
    }
    made.emplace_back(step);
    for (const cases::Operation operation :
         {cases::Operation::mul, cases::Operation::div, cases::Operation::sqrt}) {
      made.emplace_back([operation](const std::string& input) { check(operation, input); });
    }
    return made;
  }();
  return all;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  // Letters number the commands, from `a`.
  const std::size_t chosen = (data[0] - std::size_t{'a'}) % tries().size();
  tries()[chosen](std::string(data + 1, data + size));
  return 0;
}
