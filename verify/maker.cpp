#include "verify/maker.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "support/build_info/build_info.hpp"
#include "support/plain_text.hpp"

namespace fixproof::verify {

Maker this_build() {
  return {.version = support::printable_ascii(support::program_version()),
          .commit = support::printable_ascii(support::source_commit()),
          .build_type = support::printable_ascii(support::build_type()),
          .compiler = support::printable_ascii(support::compiler_name()),
          .executable = support::executable_digest(),
          .parties = {}};
}

Maker this_maker(const cases::Plan& plan, std::span<const parties::Party* const> parties) {
  Maker maker = this_build();
  for (const parties::Party* party : parties) {
    const auto names_it = [party](const cases::Row& row) {
      return std::find(row.parties.begin(), row.parties.end(), party->name()) != row.parties.end();
    };
    if (std::any_of(plan.rows().begin(), plan.rows().end(), names_it)) {
      maker.parties.emplace(party->name(), support::printable_ascii(party->identity()));
    }
  }
  return maker;
}

std::string difference(const Maker& a, const Maker& b) {
  std::string text;
  const auto compare = [&](std::string_view what, const std::string& of_a,
                           const std::string& of_b) {
    if (of_a == of_b) return;
    text += fmt::format("{}{} {}, not {}", text.empty() ? "" : "; ", what, of_a, of_b);
  };
  compare("version", a.version, b.version);
  compare("commit", a.commit, b.commit);
  compare("build type", a.build_type, b.build_type);
  compare("compiler", a.compiler, b.compiler);
  compare("executable", a.executable, b.executable);
  for (const auto& [name, identity] : a.parties) {
    const auto other = b.parties.find(name);
    compare(name, identity, other == b.parties.end() ? "absent" : other->second);
  }
  for (const auto& [name, identity] : b.parties) {
    if (!a.parties.contains(name)) compare(name, "absent", identity);
  }
  return text;
}

std::string other_build(std::string_view file, std::string_view differs) {
  return fmt::format(
      "{} is from another build: {}; run all parts with one build and the same parties, or give "
      "--accept-other-builds",
      file, differs);
}

}  // namespace fixproof::verify
