/// @file
/// Assembles the page as one self-contained HTML file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cli/report/page_parts.hpp"
#include "support/json.hpp"

namespace fixproof::cli {

/// An animation of a scene.
struct PagePicture {
  std::string name;
  std::string png;     ///< the bytes of the file
  std::string beside;  ///< a PNG: stepped, exact, and their difference; may be empty
  std::string beside_text;
};

/// Text escaped for HTML, between tags or in double quotes.
std::string escaped_html(std::string_view text);

/// JSON for a script element: it cannot end the script or begin a comment.
std::string script_json(const support::Json& json);

/// Base64 of RFC 4648.
std::string base64(std::string_view bytes);

/// @param strip an SVG, or empty
/// @throws std::logic_error if a script contains its own end, or if the page does not have each
///         marker exactly once
std::string assemble_page(const PageParts& parts, const support::Json& report,
                          const std::vector<PagePicture>& pictures, std::string_view strip);

}  // namespace fixproof::cli
