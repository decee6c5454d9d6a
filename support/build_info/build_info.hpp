/// @file
/// What this program was built from, and with which compiler.
#pragma once

#include <string>
#include <string_view>

namespace fixproof::support {

/// The version of the project, for example `1.0.0`.
std::string_view program_version();

/// The commit of the source tree at build time in hex digits, followed by ` with changes` if a
/// tracked file differs from it; `unknown` outside git. In a generated source.
std::string_view source_commit();

/// The build type of CMake, for example `Release`; `none` if it has none.
std::string_view build_type();

/// The compiler of this program, for example `g++ 12.2.0`.
std::string compiler_name();

/// The SHA-256 of the running executable in hex digits, computed in the first call; `unknown` if
/// the system does not provide the file.
const std::string& executable_digest();

}  // namespace fixproof::support
