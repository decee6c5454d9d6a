#include "web/trace.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

#include "singlestep/shown.hpp"
#include "web/json.hpp"
#include "web/operand.hpp"
#include "web/recorder.hpp"
#include "web/words.hpp"
#include "x86model/text.hpp"

namespace fixproof::web {

namespace {

namespace x86 = x86model;

constexpr std::array<std::string_view, x86::routine_count> routine_names{"mul", "div", "cossin",
                                                                         "xformvec", "concat"};

// NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables): the page asks for state
// after state
std::vector<Run> runs;

std::string_view ending_of(const Run& run) {
  if (run.lacks_instruction) return "an 8088 does not have this instruction";
  switch (run.ending.outcome) {
    case x86::Outcome::returned:
      return "returns";
    case x86::Outcome::divide_error:
      return "#DE: divide error";
    case x86::Outcome::undefined_flag:
      return "reads a flag that Intel leaves undefined";
    case x86::Outcome::step_limit:
      return "does not end";
    default:
      return "accesses memory outside its segment";
  }
}

std::string text_of(const x86::Range& clocks) {
  const std::string least = std::to_string(clocks.min);
  return clocks.min == clocks.max ? least : least + "\u2013" + std::to_string(clocks.max);
}

std::vector<std::string_view> parts_of(std::string_view text) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t start = text.find_first_not_of(" ,;\t");
    if (start == std::string_view::npos) return parts;
    text.remove_prefix(start);
    parts.push_back(text.substr(0, text.find_first_of(" ,;\t")));
    text.remove_prefix(parts.back().size());
  }
}

/// Returns a whole number of tenths of a degree as a word of 16 bits.
std::optional<std::uint32_t> angle_of(std::string_view text) {
  int tenths = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, tenths);
  if (error != std::errc() || stop != end || tenths < -32768 || tenths > 32767) return std::nullopt;
  return static_cast<std::uint32_t>(tenths) & 0xFFFFU;
}

/// Returns the operands as words.
/// @param error receives what is wrong with them; unchanged if they are right
std::vector<std::uint32_t> operands_of(x86::Routine routine, std::string_view text,
                                       std::string& error) {
  const auto parts = parts_of(text);
  const auto wanted = static_cast<std::size_t>(x86::arity(routine).in);
  std::vector<std::uint32_t> words;
  if (parts.size() != wanted) {
    error = std::string(routine_names.at(static_cast<std::size_t>(routine))) + " takes " +
            std::to_string(wanted) + (wanted == 1 ? " number, not " : " numbers, not ") +
            std::to_string(parts.size()) + ".";
    return words;
  }
  const NumberFormat& format = *format_named("q16_16");
  for (const std::string_view part : parts) {
    if (routine == x86::Routine::cossin) {
      const auto angle = angle_of(part);
      if (!angle) error = "The angle is a whole number of tenths of a degree, -32768 to 32767.";
      words.push_back(angle.value_or(0));
      continue;
    }
    const Operand operand = operand_of(part, format);
    const auto word = operand.error.empty() ? format.read(operand.decimal).word : std::nullopt;
    if (!word) {
      error = std::string(part) + ": " +
              (operand.error.empty() ? "out of the range of q16_16, " + range_of(format) + "."
                                     : operand.error);
    }
    words.push_back(static_cast<std::uint32_t>(word.value_or(0)));
  }
  return words;
}

void write_run(Json& json, const Run& run) {
  const NumberFormat& format = *format_named("q16_16");
  json.field("name", run.name);
  json.array("listing", [&] {
    for (const x86::Instruction& instruction : run.program.instructions()) {
      json.object([&] {
        json.field("text", x86::text_of(instruction));
        if (instruction.label != nullptr) json.field("label", instruction.label);
      });
    }
  });
  json.field("steps", run.snapshots.size() - 1);
  json.field("returns", !run.lacks_instruction && run.ending.outcome == x86::Outcome::returned);
  json.field("ending", ending_of(run));
  json.field("stopped", run.ending.position);
  json.field("clocks", text_of(run.snapshots.back().clocks));
  json.array("result", [&] {
    for (const std::uint32_t word : run.result) {
      json.object([&] {
        json.field("word", hex(word, 32));
        json.field("value", format.write(word));
      });
    }
  });
}

void write_registers(Json& json, const Run& run, const Snapshot& now, const Snapshot& before) {
  const bool i386 = run.target == x86::Target::i386;
  const auto size = i386 ? x86::Size::dword : x86::Size::word;
  for (const x86::Register r : singlestep::shown_registers) {
    const std::uint32_t mask = i386 ? ~0U : 0xFFFFU;
    const std::uint32_t value = now.registers.at(static_cast<std::size_t>(r)) & mask;
    json.object([&] {
      json.field("name", x86::name_of(r, size));
      json.field("value", hex(value, i386 ? 32 : 16));
      json.field("changed", value != (before.registers.at(static_cast<std::size_t>(r)) & mask));
    });
  }
}

void write_flags(Json& json, const Snapshot& now, const Snapshot& before) {
  const auto value_of = [](const x86::Flags& flags, x86::Flag flag) {
    if ((flags.undefined & flag) != 0) return "?";
    return (flags.value & flag) != 0 ? "1" : "0";
  };
  for (const auto& [flag, name] : singlestep::shown_flags) {
    json.object([&, flag = flag, name = name] {
      const std::string_view value = value_of(now.flags, flag);
      json.field("name", name);
      json.field("value", value);
      json.field("changed", value != value_of(before.flags, flag));
    });
  }
}

void write_memory(Json& json, const Run& run, const Snapshot& now, const Snapshot& before) {
  const auto at = [](const Snapshot& s, x86::Register r) {
    return s.registers.at(static_cast<std::size_t>(r)) & 0xFFFFU;
  };
  std::uint32_t lowest = at(now, x86::Register::sp);
  for (const Snapshot& each : run.snapshots) lowest = std::min(lowest, at(each, x86::Register::sp));
  for (std::size_t i = lowest / 2; i < now.memory.size(); ++i) {
    json.object([&] {
      json.field("address", hex(2 * i, 16));
      json.field("value", hex(now.memory[i], 16));
      json.field("changed", now.memory[i] != before.memory[i]);
      json.field("sp", 2 * i == at(now, x86::Register::sp));
    });
  }
}

}  // namespace

std::string routines() {
  Json json;
  json.object([&] {
    for (std::size_t i = 0; i < routine_names.size(); ++i) {
      json.array(routine_names.at(i), [&] {
        for (const std::string& build : builds_of(static_cast<x86::Routine>(i)))
          json.element(build);
      });
    }
  });
  return json.text();
}

std::string trace(std::string_view request) {
  const auto lines = lines_of(request);
  std::string error;
  std::vector<std::uint32_t> words;
  x86::Routine routine{};
  if (lines.size() != 4) error = "Choose a routine, builds and operands.";
  for (std::size_t i = 0; error.empty() && routine_names.at(i) != lines[0]; ++i) {
    if (i + 1 == routine_names.size()) error = "Choose one of the routines.";
    routine = static_cast<x86::Routine>(i + 1);
  }
  if (error.empty()) words = operands_of(routine, lines[3], error);
  if (error.empty()) {
    const auto builds = builds_of(routine);
    const auto is_known = [&](std::string_view name) {
      return std::find(builds.begin(), builds.end(), name) != builds.end();
    };
    if (!is_known(lines[1]) || (lines[2] != "none" && !is_known(lines[2]))) {
      error = "The routine has no such build. Choose another.";
    }
  }
  Json json;
  json.object([&] {
    if (!error.empty()) {
      json.field("error", error);
      return;
    }
    runs.clear();
    for (const std::string_view build : {lines[1], lines[2]}) {
      if (build != "none") runs.push_back(record(routine, build, words));
    }
    json.array("runs", [&] {
      for (const Run& run : runs) json.object([&] { write_run(json, run); });
    });
    json.field("differs", runs.size() == 2 ? first_difference(runs[0], runs[1]) : 0);
  });
  return json.text();
}

std::string state(std::string_view request) {
  const auto lines = lines_of(request);
  Json json;
  json.object([&] {
    const std::size_t which = lines[0] == "1" ? 1 : 0;
    if (which >= runs.size() || lines.size() != 2) {
      json.field("error", "Trace a routine first.");
      return;
    }
    const Run& run = runs[which];
    std::size_t step = 0;
    std::from_chars(lines[1].data(), lines[1].data() + lines[1].size(), step);
    step = std::min(step, run.snapshots.size() - 1);
    const Snapshot& now = run.snapshots[step];
    const Snapshot& before = run.snapshots[step == 0 ? 0 : step - 1];
    json.field("step", step);
    json.field("position", now.position);
    json.field("clocks", text_of(now.clocks));
    json.array("registers", [&] { write_registers(json, run, now, before); });
    json.array("flags", [&] { write_flags(json, now, before); });
    json.array("memory", [&] { write_memory(json, run, now, before); });
  });
  return json.text();
}

}  // namespace fixproof::web
