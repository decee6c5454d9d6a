/// @file
/// Decompresses gzip data.
#pragma once

#include <string>

namespace fixproof::singlestep {

/// Decompresses `contents` if it begins with the gzip magic number (RFC 1952); otherwise returns it
/// unchanged. Several gzip members are concatenated.
/// @throws support::UsageError if the data is damaged, truncated, followed by other data, or larger
/// than 256 MiB when decompressed
std::string gunzip(std::string contents);

}  // namespace fixproof::singlestep
