/// @file
/// What computed the answers of a report: a build of the project, and what its parties were.
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>

#include "verify/cases/plan.hpp"
#include "verify/parties/party.hpp"

namespace fixproof::verify {

/// The texts are those of support/build_info/build_info.hpp and of Party::identity(), in
/// printable ASCII, so that a report can hold them.
struct Maker {
  std::string version;
  std::string commit;
  std::string build_type;
  std::string compiler;
  std::string executable;                      ///< SHA-256
  std::map<std::string, std::string> parties;  ///< identities by name

  friend bool operator==(const Maker&, const Maker&) = default;
};

/// Describes this program, without parties.
Maker this_build();

/// Describes this program and those of `parties` that the plan names.
Maker this_maker(const cases::Plan& plan, std::span<const parties::Party* const> parties);

/// Returns all differences, such as "commit 12ab, not 34cd; unicorn Unicorn 2.0.1, not Unicorn
/// 2.1.0", with the values of `a` first, or "" if there are none.
std::string difference(const Maker& a, const Maker& b);

/// Returns the message for a file that another build made. `differs` is what difference() returns.
std::string other_build(std::string_view file, std::string_view differs);

}  // namespace fixproof::verify
