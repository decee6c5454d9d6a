// Target `input_lines`: the first byte chooses a command, the rest is its input. Bad lines must
// raise a UsageError. Also checks answers: eval must agree for model and oracle, step for an 8088
// and a 386, and check must pass correct results only.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <iostream>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "app/cli/commands.hpp"
#include "fuzz/finding.hpp"
#include "fuzz/memory_file.hpp"
#include "judge/check/cases.hpp"
#include "judge/check/results.hpp"
#include "oracle/exact.hpp"
#include "support/hex.hpp"
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
check::Said right(cases::Operation operation, std::span<const std::uint32_t> words) {
  constexpr auto rule = oracle::Rounding::half_up;
  switch (operation) {
    case cases::Operation::mul:
      return oracle::mul(words[0], words[1], rule, 16);
    case cases::Operation::div:
      return oracle::quotient(words[0], words[1], rule, 16);
    case cases::Operation::sqrt:
      return oracle::sqrt(words[0], 16);
    case cases::Operation::add:
      return words[0] + words[1];
    default:
      return words[0] - words[1];
  }
}

/// The word of a double by floor and wrapping; #DE for NaN and the infinities. No step rounds.
check::Said right(double x) {
  if (!std::isfinite(x)) return std::nullopt;
  const double word = std::floor(std::ldexp(std::fmod(x, 65536), 16));
  return static_cast<std::uint64_t>(word < 0 ? word + std::ldexp(1.0, 32) : word);
}

/// Reads the next case and returns its result; nothing at the end.
std::optional<check::Said> next_right(check::FileCases& source, cases::Operation operation) {
  if (operation == cases::Operation::from_binary64) {
    const auto operand = source.next_valued();
    if (!operand) return std::nullopt;
    return right(std::bit_cast<double>(support::parse_long_hex(operand->text, 16)));
  }
  std::array<std::uint32_t, 2> words{};
  const auto one_case = std::span(words).first(cases::words_in(operation));
  if (!source.next(one_case)) return std::nullopt;
  return right(operation, one_case);
}

/// Whether every result is correct; nothing if a line is invalid or one input ends early.
std::optional<bool> all_correct(cases::Operation operation, const std::string& cases,
                                const std::string& results) {
  const fuzz::MemoryFile file(cases);
  check::FileCases source(cases::variant_of(operation, cases::q16_16), file.path());
  std::istringstream in(results);
  check::Results said(in, "results", cases::q16_16);
  bool all = true;
  bool any = false;
  try {
    while (const auto expected = next_right(source, operation)) {
      const auto result = said.next();
      if (!result) return std::nullopt;
      all = all && *result == *expected;
      any = true;
    }
    if (!any || said.next()) return std::nullopt;
  } catch (const support::UsageError&) {
    return std::nullopt;
  }
  return all;
}

/// Cases and results, separated by a line `--`.
struct Judged {
  std::string cases;
  std::string results;

  explicit Judged(const std::string& input) {
    constexpr std::string_view bar = "\n--\n";
    const auto at = input.find(bar);
    cases = at == std::string::npos ? input : input.substr(0, at + 1);
    results = at == std::string::npos ? "" : input.substr(at + bar.size());
  }
};

Answer check(const std::string& options, const Judged& judged) {
  // A command keeps the options of its last run.
  static std::map<std::string, Command> commands;
  Command& command = commands.try_emplace(options, cli::add_check).first->second;
  const fuzz::MemoryFile file(judged.cases);
  return command.run(fmt::format("check {} --from {}", options, file.path()), judged.results);
}

/// Compares the verdict with that of next_right().
void check(cases::Operation operation, std::string_view rounding, const std::string& input) {
  const Judged judged(input);
  const std::string options = fmt::format("{}{}", cases::name_of(operation), rounding);
  const Answer said = check(options, judged);
  const auto expected = all_correct(operation, judged.cases, judged.results);
  const bool refused = !said.refused.empty();
  if (refused == expected.has_value() || (expected && (said.status == 0) != *expected)) {
    report("check " + options + " --from CASES", "the oracle", input,
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
    const auto judge = [&made](cases::Operation operation, std::string_view rounding) {
      made.emplace_back([=](const std::string& input) { check(operation, rounding, input); });
    };
    using enum cases::Operation;
    for (const auto operation : {mul, div, sqrt}) judge(operation, " --rounding half-up");
    for (const auto operation : {add, sub}) judge(operation, "");
    judge(from_binary64, " --rounding floor");
    for (const char* options : {"convert --to q8_8 --rounding half-even",
                                "from_decimal --format q2_62 --rounding half-away", "to_decimal"}) {
      made.emplace_back([options](const std::string& input) { check(options, Judged(input)); });
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
