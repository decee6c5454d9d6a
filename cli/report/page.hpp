/// @file
/// The page: its parts, the figures and the pictures in one file that needs no other.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cli/report/page_parts.hpp"
#include "support/json.hpp"

namespace fixproof::cli {

/// An animation to show.
struct PagePicture {
  std::string name;
  std::string png;  ///< the bytes of the file
  /// As stepped, exact, and where they differ, in one picture, and what it says; or empty.
  std::string beside;
  std::string beside_text;
};

/// Text as it may stand in HTML, between tags or in quotes.
std::string escaped_html(std::string_view text);

/// JSON as it may stand in a script: nothing in it can end the script or begin a comment.
std::string script_json(const support::Json& json);

/// Bytes as RFC 4648 writes them.
std::string base64(std::string_view bytes);

/// @param strip an SVG, or empty
/// @throws std::logic_error for a part that would break the page: a script that ends early, a place
///         that is not there exactly once
std::string assemble_page(const PageParts& parts, const support::Json& report,
                          const std::vector<PagePicture>& pictures, std::string_view strip);

}  // namespace fixproof::cli
