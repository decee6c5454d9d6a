#include "app/web/trace.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <span>
#include <utility>

#include "app/input/number.hpp"
#include "app/web/json.hpp"
#include "app/web/operand.hpp"
#include "app/web/recorder.hpp"
#include "app/web/words.hpp"
#include "oracle/format.hpp"
#include "verify/singlestep/shown.hpp"
#include "x86model/text.hpp"

namespace fixproof::web {

namespace {

namespace x86 = x86model;

constexpr std::array<std::string_view, x86::routine_count> routine_names{"mul", "div", "cossin",
                                                                         "xformvec", "concat"};

// The page asks for state after state.
// NOLINTNEXTLINE(cppcoreguidelines-avoid-non-const-global-variables)
std::vector<Run> runs;

/// Returns how a run ended, as a sentence.
std::string ending_of(const Run& run) {
  const std::string place = "instruction " + std::to_string(run.ending.position);
  if (run.lacks_instruction) return "Stops at " + place + ", which an 8088 does not have.";
  switch (run.ending.outcome) {
    case x86::Outcome::returned:
      return "Returns.";
    case x86::Outcome::divide_error:
      return "Ends with a divide error (#DE) at " + place + ".";
    case x86::Outcome::undefined_flag:
      return "Stops: " + place + " reads a flag that Intel leaves undefined.";
    case x86::Outcome::step_limit:
      static_assert(most_instructions == 1000);
      static_assert(most_of_routine == 10'000);
      return run.is_loop ? "Still draws after 1,000 instructions."
                         : "Still runs after 10,000 instructions.";
    default:
      return "Stops: " + place + " accesses memory outside its segment.";
  }
}

std::string text_of(const x86::Range& clocks) {
  const std::string least = std::to_string(clocks.min);
  return clocks.min == clocks.max ? least : least + "\u2013" + std::to_string(clocks.max);
}

/// Returns a whole number, or nothing if it is none or does not fit the format.
std::optional<std::uint32_t> whole_of(std::string_view text, const cases::Format& format) {
  const input::Number number = input::number_of(text, format, input::Bare::decimal);
  const auto f = format.as<oracle::Format>();
  const oracle::Integer whole = number.exact.numerator / number.exact.denominator;
  if (!number.error.empty() || whole * number.exact.denominator != number.exact.numerator ||
      !oracle::fits(whole, f)) {
    return std::nullopt;
  }
  return static_cast<std::uint32_t>(oracle::wrap(whole, f));
}

std::string wrong_number(std::string_view name, std::size_t wanted, std::size_t given) {
  return std::string(name) + " takes " + std::to_string(wanted) +
         (wanted == 1 ? " number, not " : " numbers, not ") + std::to_string(given) + ".";
}

/// Returns an operand as a word of a format, or 0.
/// @param error receives what is wrong with it; unchanged if it is right
std::uint32_t word_of(std::string_view part, std::string_view format_name, std::string& error) {
  const WordOperand operand = word_operand_of(part, *format_named(format_name));
  if (!operand.error.empty()) error = std::string(part) + ": " + operand.error;
  return static_cast<std::uint32_t>(operand.word);
}

/// Returns the operands as words.
/// @param error receives what is wrong with them; unchanged if they are right
std::vector<std::uint32_t> operands_of(x86::Routine routine, std::string_view text,
                                       std::string& error) {
  const auto parts = input::parts_of(text);
  const auto wanted = static_cast<std::size_t>(x86::arity(routine).in);
  std::vector<std::uint32_t> words;
  if (parts.size() != wanted) {
    error = wrong_number(routine_names.at(static_cast<std::size_t>(routine)), wanted, parts.size());
    return words;
  }
  for (const std::string_view part : parts) {
    if (routine == x86::Routine::cossin) {
      const auto angle = whole_of(part, {.word_bits = 16, .fraction_bits = 0});
      if (!angle)
        error = "The angle must be a whole number of tenths of a degree, from -32768 to 32767.";
      words.push_back(angle.value_or(0));
      continue;
    }
    words.push_back(word_of(part, "q16_16", error));
  }
  return words;
}

/// Returns the operands of an inner loop.
/// @param error receives what is wrong with them; unchanged if they are right
x86::LoopCall loop_operands_of(std::string_view loop, std::string_view text, std::string& error) {
  const auto parts = input::parts_of(text);
  const std::size_t wanted = loop == "texture" ? 5 : 3;
  x86::LoopCall call;
  if (parts.size() != wanted) {
    error = wrong_number(loop, wanted, parts.size());
    return call;
  }
  const auto pixels = whole_of(parts[0], {.word_bits = 32, .fraction_bits = 0, .is_signed = false});
  if (!pixels || *pixels > most_pixels) {
    error = "The number of pixels must be a whole number, from 0 to " +
            std::to_string(most_pixels) + ".";
    return call;
  }
  call.pixels = *pixels;
  const std::array into{&call.value, &call.step, &call.row, &call.row_step};
  for (std::size_t i = 1; i < wanted; ++i) *into.at(i - 1) = word_of(parts[i], "q24_8", error);
  return call;
}

/// What a request for a trace asks for.
struct Wanted {
  std::string error{};   ///< what is wrong with the request; empty if it is right
  bool is_loop = false;  ///< an inner loop, which takes `call`; a routine takes `words`
  x86::Routine routine{};
  std::vector<std::uint32_t> words{};
  x86::LoopCall call{};
  Edit edit{};  ///< of the first build
};

Wanted wanted_by(std::span<const std::string_view> lines) {
  if (lines.size() < 4) return {.error = "Choose a routine, builds and operands."};
  const auto* const named = std::find(routine_names.begin(), routine_names.end(), lines[0]);
  const bool is_routine = named != routine_names.end();
  Wanted wanted{.is_loop =
                    std::find(loop_names.begin(), loop_names.end(), lines[0]) != loop_names.end()};
  if (!is_routine && !wanted.is_loop) return {.error = "Choose one of the routines."};
  if (is_routine) wanted.routine = static_cast<x86::Routine>(named - routine_names.begin());
  const auto builds = is_routine ? builds_of(wanted.routine) : builds_of_loop(lines[0]);
  const auto is_known = [&](std::string_view name) {
    return std::find(builds.begin(), builds.end(), name) != builds.end();
  };
  if (is_routine) {
    wanted.words = operands_of(wanted.routine, lines[3], wanted.error);
  } else {
    wanted.call = loop_operands_of(lines[0], lines[3], wanted.error);
  }
  if (wanted.error.empty() &&
      (!is_known(lines[1]) || (lines[2] != "none" && !is_known(lines[2])))) {
    wanted.error = "The routine has no such build. Choose another.";
  }
  if (wanted.error.empty() && lines.size() > 4) {
    const bool i386 = lines[1].find("i386") != std::string_view::npos;
    wanted.edit =
        edit_of(lines[4], lines.subspan(5), i386 ? x86::Target::i386 : x86::Target::i8088);
    wanted.error = wanted.edit.error;
  }
  return wanted;
}

void write_run(Json& json, const Run& run) {
  const NumberFormat& format = *format_named("q16_16");
  json.field("name", run.name);
  json.field("loop", run.is_loop);
  json.array("listing", [&] {
    for (const x86::Instruction& instruction : run.code) {
      json.object([&] {
        json.field("text", x86::text_of(instruction));
        if (instruction.label != nullptr) json.field("label", instruction.label);
      });
    }
  });
  json.field("steps", run.snapshots.size() - 1);
  json.array("positions", [&] {
    for (const Snapshot& each : run.snapshots) json.element(each.position);
  });
  json.field("returns", !run.lacks_instruction && run.ending.outcome == x86::Outcome::returned);
  json.field("ending", ending_of(run));
  json.field("stopped", run.ending.position);
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
  for (std::size_t i = 0; i < now.memory.size(); ++i) {
    const auto& [address, kind] = run.cells[i];
    if (kind == Cell::Kind::word && address < lowest) continue;
    json.object([&, address = address, kind = kind] {
      json.field("address", hex(address, 16));
      json.field("value", hex(now.memory[i], kind == Cell::Kind::pixel ? 8 : 16));
      json.field("changed", now.memory[i] != before.memory[i]);
      json.field("sp", kind == Cell::Kind::word && address == at(now, x86::Register::sp));
      json.field("depth", kind == Cell::Kind::depth);
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
    for (const std::string_view loop : loop_names) {
      json.array(loop, [&] {
        for (const std::string& build : builds_of_loop(loop)) json.element(build);
      });
    }
  });
  return json.text();
}

std::string trace(std::string_view request) {
  const auto lines = lines_of(request);
  Wanted wanted = wanted_by(lines);
  Json json;
  json.object([&] {
    if (!wanted.error.empty()) {
      json.field("error", wanted.error);
      return;
    }
    runs.clear();
    for (const std::string_view build : {lines[1], lines[2]}) {
      if (build == "none") continue;
      Edit edit = runs.empty() ? std::move(wanted.edit) : Edit();
      runs.push_back(wanted.is_loop ? record_loop(lines[0], build, wanted.call, std::move(edit))
                                    : record(wanted.routine, build, wanted.words, std::move(edit)));
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
