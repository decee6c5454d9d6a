/// @file
/// The committed cases, and the command's judgement of cases made from them.
#pragma once

#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "tests/cli/command.hpp"

namespace vectors {

using Json = nlohmann::json;

struct Committed {
  std::string_view name;
  std::string_view cpu;  ///< as --cpu takes it
  std::string_view summary;
};
inline constexpr std::array<Committed, 3> committed{{
    {"8088.json", "8088",
     "58 cases, 49 run, 49 equal, 0 differing; 9 skipped: 1 prefix, 1 control flow, 3 not "
     "modelled, "
     "2 8-bit operand, 2 memory operand"},
    {"386.json", "386",
     "68 cases, 59 run, 59 equal, 0 differing; 9 skipped: 1 prefix, 1 control flow, 3 not "
     "modelled, "
     "2 8-bit operand, 2 memory operand"},
    {"386-divide.json.gz", "386", "23 cases, 23 run, 23 equal, 0 differing; 0 skipped"},
}};

std::string path_of(const Committed& file);
/// All cases of a file.
Json load(const Committed& file);
/// Whether the case is one that is run, and whether it ends in a divide error.
bool is_run(const Json& c);
bool is_fault(const Json& c);

/// The name of a register in the sets of that processor: eax of ax, eflags of flags.
std::string name_in_set(std::string_view name, std::string_view cpu);
/// A register after the case, whether or not the case says that it changed.
std::uint32_t final_value(const Json& c, const std::string& name);

/// The six flags that are undefined after the case, by the definitions of tests/cli/bitwise.hpp.
std::uint16_t undefined_flags(const Json& c);

/// The file with that text, in the test's own folder; judged by the command. In what the command
/// says, the path is replaced by FILE.
command::Run judge_text(const std::string& text, std::string_view cpu);
command::Run judge(const Json& cases, std::string_view cpu);

}  // namespace vectors
