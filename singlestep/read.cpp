#include "singlestep/read.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <nlohmann/json.hpp>

#include "singlestep/gunzip.hpp"
#include "support/file.hpp"
#include "support/plain_text.hpp"
#include "support/usage_error.hpp"

namespace fixproof::singlestep {

namespace {

using Json = nlohmann::json;

constexpr std::array<std::string_view, place_count> names_386{
    "eax", "ecx", "edx",    "ebx", "esp", "ebp", "esi", "edi", "cs",  "ss", "ds",
    "es",  "eip", "eflags", "fs",  "gs",  "cr0", "cr2", "cr3", "dr6", "dr7"};

constexpr std::size_t required_count = static_cast<std::size_t>(Place::flags) + 1;

/// Returns whether the model is compared with this member (of a case at depth 2, of a state at
/// depth 3).
bool is_judged(int depth, const Json& key) {
  static constexpr std::array<std::string_view, 4> of_case{"name", "bytes", "initial", "final"};
  static constexpr std::array<std::string_view, 2> of_state{"regs", "ram"};
  const auto names = [&](const auto& known) {
    return std::find(known.begin(), known.end(), key.get_ref<const std::string&>()) != known.end();
  };
  return depth == 2 ? names(of_case) : depth != 3 || names(of_state);
}

const Json& member(const Json& object, const char* name, std::string_view path) {
  const auto found = object.find(name);
  if (found == object.end()) throw support::UsageError(fmt::format("{}{} is missing", path, name));
  return *found;
}

void expect_type(const Json& value, Json::value_t type, std::string_view path) {
  if (value.type() == type) return;
  throw support::UsageError(
      fmt::format("{} is {} instead of {}", path, value.type_name(), Json(type).type_name()));
}

std::uint32_t number(const Json& value, std::uint32_t most, std::string_view path) {
  const bool fits = value.is_number_unsigned() && value.get<std::uint64_t>() <= most;
  if (!fits) throw support::UsageError(fmt::format("{} is not a number from 0 to {}", path, most));
  return value.get<std::uint32_t>();
}

std::uint32_t largest(int bits) { return 0xFFFFFFFFU >> (32 - bits); }

std::optional<Place> place_named(std::string_view name, x86model::Target cpu) {
  for (std::size_t i = 0; i < place_count; ++i) {
    const auto place = static_cast<Place>(i);
    if (name_of(place, cpu) == name) return place;
  }
  return std::nullopt;
}

void read_registers(const Json& json, x86model::Target cpu, std::string_view path, State& state) {
  expect_type(json, Json::value_t::object, path);
  for (const auto& [name, value] : json.items()) {
    const auto place = place_named(name, cpu);
    if (!place) {
      throw support::UsageError(fmt::format("{}: {} is not a register of the {}", path,
                                            fixproof::support::quoted(name),
                                            cpu == x86model::Target::i386 ? "386" : "8088"));
    }
    state.registers[static_cast<std::size_t>(*place)] =
        number(value, largest(bits_of(*place, cpu)), fmt::format("{}.{}", path, name));
  }
}

void read_ram(const Json& json, x86model::Target cpu, std::string_view path, State& state) {
  expect_type(json, Json::value_t::array, path);
  const std::uint32_t last = largest(cpu == x86model::Target::i386 ? 32 : 20);
  for (std::size_t i = 0; i < json.size(); ++i) {
    const Json& entry = json[i];
    const std::string here = fmt::format("{}[{}]", path, i);
    if (!entry.is_array() || entry.size() != 2) {
      throw support::UsageError(here + " is not an address and a byte");
    }
    state.ram[number(entry[0], last, here + "[0]")] =
        static_cast<std::uint8_t>(number(entry[1], 0xFF, here + "[1]"));
  }
}

/// `path` is "initial" or "final".
State state_in(const Json& json, x86model::Target cpu, const std::string& path) {
  State state;
  expect_type(json, Json::value_t::object, path);
  read_registers(member(json, "regs", path + '.'), cpu, path + ".regs", state);
  read_ram(member(json, "ram", path + '.'), cpu, path + ".ram", state);
  return state;
}

Case case_in(const Json& json, x86model::Target cpu, std::size_t index) {
  Case result;
  result.index = index;
  result.name = member(json, "name", "").get<std::string>();
  const Json& bytes = member(json, "bytes", "");
  expect_type(bytes, Json::value_t::array, "bytes");
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    result.bytes.push_back(
        static_cast<std::uint8_t>(number(bytes[i], 0xFF, fmt::format("bytes[{}]", i))));
  }
  result.initial = state_in(member(json, "initial", ""), cpu, "initial");
  result.final = state_in(member(json, "final", ""), cpu, "final");
  for (std::size_t i = 0; i < place_count; ++i) {
    const auto& before = result.initial.registers[i];
    auto& after = result.final.registers[i];
    if (!before && (after || i < required_count)) {
      throw support::UsageError(
          fmt::format("initial.regs.{} is missing", name_of(static_cast<Place>(i), cpu)));
    }
    if (!after) after = before;
  }
  return result;
}

/// The name of the case at `index` in messages.
std::string label_of(const Json& json, std::size_t index) {
  const auto name = json.find("name");
  if (name == json.end()) return fmt::format("case {}", index);
  expect_type(*name, Json::value_t::string, fmt::format("case {}: name", index));
  return fmt::format("case {} {}", index,
                     fixproof::support::quoted(name->get_ref<const std::string&>()));
}

/// Receives each case when the parser completes it, so that no more than one stays in memory.
class Sink {
 public:
  Sink(x86model::Target cpu, const std::function<void(const Case&)>& use) : cpu_(cpu), use_(use) {}

  /// @return whether the parser should keep the value
  bool operator()(int depth, Json::parse_event_t event, Json& parsed) {
    // The format has four levels below the outermost array. The longest case, a repeated string
    // instruction, has about ten thousand cycles.
    constexpr int deepest = 16;
    constexpr std::size_t max_events = std::size_t{1} << 20U;
    if (depth > deepest)
      throw support::UsageError(fmt::format("case {} is nested too deeply", cases_));
    if (++events_ > max_events)
      throw support::UsageError(fmt::format("case {} is too long", cases_));
    if (event == Json::parse_event_t::key) return is_judged(depth, parsed);
    if (depth == 0 && event != Json::parse_event_t::array_end) {
      if (event != Json::parse_event_t::array_start)
        throw support::UsageError("not an array of cases");
    }
    if (depth != 1) return true;
    switch (event) {
      case Json::parse_event_t::object_end:
        take(parsed);
        return false;
      case Json::parse_event_t::array_start:
      case Json::parse_event_t::value:
        throw support::UsageError(fmt::format("case {} is not an object", cases_));
      default:
        return true;
    }
  }

  [[nodiscard]] std::size_t cases() const { return cases_; }

 private:
  void take(const Json& json) {
    const std::string label = label_of(json, cases_);
    try {
      use_(case_in(json, cpu_, cases_));
    } catch (const support::UsageError& error) {
      throw support::UsageError(fmt::format("{}: {}", label, error.what()));
    }
    ++cases_;
    events_ = 0;
  }

  x86model::Target cpu_;
  const std::function<void(const Case&)>& use_;
  std::size_t cases_ = 0;
  std::size_t events_ = 0;
};

}  // namespace

std::string_view name_of(Place place, x86model::Target cpu) {
  const std::string_view name = names_386.at(static_cast<std::size_t>(place));
  if (cpu == x86model::Target::i386) return name;
  if (place > Place::flags) return {};
  return name.starts_with('e') && name != "es" ? name.substr(1) : name;
}

int bits_of(Place place, x86model::Target cpu) {
  static constexpr std::array segments{Place::cs, Place::ss, Place::ds,
                                       Place::es, Place::fs, Place::gs};
  const bool segment = std::find(segments.begin(), segments.end(), place) != segments.end();
  return cpu == x86model::Target::i386 && !segment ? 32 : 16;
}

void read_cases(const std::string& path, x86model::Target cpu,
                const std::function<void(const Case&)>& use) {
  Sink sink(cpu, use);
  try {
    const std::string text = gunzip(support::read_file(path));
    if (text.empty()) throw support::UsageError("empty");
    // The library would take one for the end. A binary MOO has many.
    const std::size_t zero = text.starts_with("MOO ") ? std::string::npos : text.find('\0');
    if (zero != std::string::npos) {
      throw support::UsageError(fmt::format("no JSON: a zero byte, at byte {}", zero + 1));
    }
    if (text.starts_with("MOO "))
      throw support::UsageError("a binary MOO file; convert it to JSON with moo2json.py");
    // The array is empty because the sink discards every case.
    const Json rest = Json::parse(text, std::ref(sink));
    if (!rest.empty() || sink.cases() == 0) throw support::UsageError("the array has no cases");
  } catch (const Json::parse_error& error) {
    throw support::UsageError(fmt::format("{}: not JSON, or cut short, at byte {}, after {} cases",
                                          path, error.byte, sink.cases()));
  } catch (const Json::out_of_range&) {
    throw support::UsageError(
        fmt::format("{}: a number is too large for any field, after {} cases", path, sink.cases()));
  } catch (const support::UsageError& error) {
    throw support::UsageError(fmt::format("{}: {}", path, error.what()));
  }
}

}  // namespace fixproof::singlestep
