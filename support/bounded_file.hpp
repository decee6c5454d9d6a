/// @file
/// Reads files that others have named: regular ones only, of bounded size.
#pragma once

#include <cstddef>
#include <string>

#include "support/descriptor.hpp"

namespace fixproof::support {

/// Returns the contents of a file.
/// @throws std::runtime_error with the reason, without the file name, if it is not a regular file,
/// cannot be read, is longer than `max_bytes`, or is empty. A file of /proc seems empty, and
/// reading it might never end
std::string read_bounded(const std::string& file, std::size_t max_bytes);

/// The same for a file in or below a folder, named relative to it. Neither `..` nor a symbolic link
/// may lead out of the folder.
/// @throws std::runtime_error also if it does
std::string read_beneath(const std::string& folder, const std::string& file, std::size_t max_bytes);

/// Opens a file for read_beneath(). open_beneath_by_names() does without openat2(), which kernels
/// before 5.6 and some sandboxes lack. It is safe only if nobody replaces a folder of the path
/// while it runs.
/// @throws std::runtime_error with the reason
Descriptor open_beneath(const std::string& folder, const std::string& file);
Descriptor open_beneath_by_names(const std::string& folder, const std::string& file);

}  // namespace fixproof::support
