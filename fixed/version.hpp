/// @file
/// The version of this library, stated only here; CMake reads it from this file.
///
/// Semantic versioning; the bits of every result are part of the interface (docs/import.md).
#pragma once

// Macros, so that #if can test the version.
// NOLINTBEGIN(cppcoreguidelines-macro-usage)
#define FIXED_VERSION_MAJOR 1  ///< Incompatible changes, including any change of a result.
#define FIXED_VERSION_MINOR 0  ///< Additions.
#define FIXED_VERSION_PATCH 0  ///< Fixes that change no result.
// NOLINTEND(cppcoreguidelines-macro-usage)
