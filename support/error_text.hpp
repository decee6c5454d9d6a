/// @file
/// Output to stderr that cannot fail.
#pragma once

#include <string_view>

namespace fixproof::support {

/// Writes `text` to stderr in one call. If stderr is full, closed or a pipe without a reader, the
/// text is lost and the program goes on: its exit status does not change.
void write_error(std::string_view text) noexcept;

/// Opens the null device on every descriptor of stdin, stdout and stderr that is closed. Otherwise
/// the next file that the program opens would get that descriptor, and messages would go into the
/// file. Reading stdin and writing stdout and stderr still fail.
void occupy_closed_descriptors() noexcept;

}  // namespace fixproof::support
