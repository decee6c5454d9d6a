/// @file
/// Replies of a confined process as initial inputs.
#pragma once

#include <filesystem>

namespace fixproof::fuzz {

/// Writes right, forged and cut replies; see judge_reply.cpp.
void write_replies(const std::filesystem::path& root);

}  // namespace fixproof::fuzz
