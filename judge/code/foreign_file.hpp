/// @file
/// Files that are not machine code which judge runs.
#pragma once

#include <string>

namespace fixproof::judge {

/// Refuses sources, text and files of other systems, so that they are not taken for a flat binary.
/// @throws support::UsageError saying what to give in place of the file
void expect_machine_code(const std::string& path, const std::string& bytes);

/// Refuses programs and libraries of Windows, which begin like those of DOS.
/// @throws support::UsageError as above
void expect_no_windows(const std::string& bytes);

}  // namespace fixproof::judge
