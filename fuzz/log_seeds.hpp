/// @file
/// Logs of the recorder as initial inputs.
#pragma once

#include <filesystem>

namespace fixproof::fuzz {

/// Writes pairs of logs, sealed or not; see recorder_log.cpp.
void write_logs(const std::filesystem::path& root);

}  // namespace fixproof::fuzz
