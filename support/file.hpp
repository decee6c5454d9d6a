/// @file
/// Files that are either the old or the new version, whenever the machine stops.
#pragma once

#include <string>
#include <string_view>

namespace fixproof::support {

/// Replaces the contents of `path`: written beside it, flushed to the disk, then renamed. What is
/// not a regular file (a device, a pipe) is written to as it stands.
/// @throws std::runtime_error naming the file and the reason
void replace_file(const std::string& path, std::string_view contents);

/// Finds out before a long run whether replace_file() will be able to write.
/// @throws std::runtime_error naming the file and the reason
void check_replaceable(const std::string& path);

/// Whether writing to one would change the other, by whatever links and names.
bool same_file(const std::string& a, const std::string& b);

/// The contents of a file of at most 256 MiB: what has no end, like a device, is refused there.
/// @throws std::runtime_error naming the file and the reason
std::string read_file(const std::string& path);

}  // namespace fixproof::support
