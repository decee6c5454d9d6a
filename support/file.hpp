/// @file
/// Reads files, and replaces them so that a crash leaves the old or the new version.
#pragma once

#include <string>
#include <string_view>

namespace fixproof::support {

/// Replaces the contents of `path` as OutputFile does.
/// @throws std::runtime_error naming the file and the reason
void replace_file(const std::string& path, std::string_view contents);

/// Returns whether two paths lead to the same file, through symbolic or hard links.
bool same_file(const std::string& a, const std::string& b);

/// Reads a file of at most 256 MiB. The limit stops endless inputs such as devices.
/// @throws std::runtime_error naming the file and the reason
std::string read_file(const std::string& path);

}  // namespace fixproof::support
