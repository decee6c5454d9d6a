/// @file
/// The printed source of each listing, and the digest of the author's assembled routine.
/// docs/originals.md defines the digest.
#pragma once

#include <string>
#include <string_view>

#include "x86model/routine.hpp"

namespace x86model {

/// The length and the digest of a routine's canonical text.
struct Digest {
  int instructions;
  std::string_view sha256;
};

/// The source of a listing.
struct Source {
  /// The printed listing, and the differences of ours.
  std::string_view printed;
  /// 0 instructions if no digest is recorded.
  Digest digest;
  /// Whether the digest is of the author's routine; otherwise it is of our own variant.
  bool is_original = false;
};

Source source_of(Routine routine, Target target, const Build& build);

/// The same, as two comment lines of assembler source.
std::string source_comment(Routine routine, Target target, const Build& build);

}  // namespace x86model
