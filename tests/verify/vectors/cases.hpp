/// @file
/// Loads the committed cases and runs the command on modified ones.
#pragma once

#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "tests/support/command.hpp"

namespace vectors {

using Json = nlohmann::json;

struct Committed {
  std::string_view name;
  std::string_view cpu;  ///< value for --cpu
  std::string_view summary;
};
inline constexpr std::array<Committed, 3> committed{{
    {"8088.json", "8088",
     "58 cases, 52 run, 52 equal, 0 differing; 6 skipped: 1 prefix in no listing, 5 form in no "
     "listing"},
    {"386.json", "386",
     "68 cases, 62 run, 62 equal, 0 differing; 6 skipped: 1 prefix in no listing, 5 form in no "
     "listing"},
    {"386-divide.json.gz", "386", "23 cases, 23 run, 23 equal, 0 differing; 0 skipped"},
}};

std::string path_of(const Committed& file);
Json load(const Committed& file);
/// Whether the case is run and not skipped, and whether it ends in a divide error.
bool is_run(const Json& c);
bool is_fault(const Json& c);

/// The name of a register in the sets of a processor, such as eax for ax or eflags for flags.
std::string name_in_set(std::string_view name, std::string_view cpu);
/// A register after the case, even if the case does not list it as changed.
std::uint32_t final_value(const Json& c, const std::string& name);

/// The six flags that are undefined after the case, according to tests/app/cli/bitwise.hpp.
std::uint16_t undefined_flags(const Json& c);

/// Writes the text to a file in the test's own folder and runs the command on it. FILE replaces the
/// path in the output.
command::Run judge_text(const std::string& text, std::string_view cpu);
command::Run judge(const Json& cases, std::string_view cpu);

}  // namespace vectors
