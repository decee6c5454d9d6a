/// \file
/// The version of this library: the one place where it is written; CMake reads it here.
///
/// Semantic versioning, with the bits of every result as part of the interface: docs/import.md.
#pragma once

// Macros, so that #if can ask for a version.
// NOLINTBEGIN(cppcoreguidelines-macro-usage)
#define FIXED_VERSION_MAJOR 0  ///< Incompatible changes; those of results, to the bit, among them.
#define FIXED_VERSION_MINOR 1  ///< Additions; while the major version is 0, incompatible changes.
#define FIXED_VERSION_PATCH 0  ///< Mends that change no result.
// NOLINTEND(cppcoreguidelines-macro-usage)
