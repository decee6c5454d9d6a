/// @file
/// Files that may be compressed.
#pragma once

#include <string>

namespace fixproof::singlestep {

/// `contents` as it is, or decompressed where it begins as gzip data does (RFC 1952), whatever the
/// file is called. At most 256 MiB come out of it.
/// @throws UsageError where the data is damaged, cut short or too large
std::string gunzip(std::string contents);

}  // namespace fixproof::singlestep
