/// @file
/// Assembles the page as one self-contained HTML file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/cli/report/page_parts.hpp"
#include "support/json.hpp"

namespace fixproof::cli {

struct PagePicture {
  std::string name;
  std::string png;     ///< contents of the PNG file
  std::string beside;  ///< PNG of stepped, exact and their difference; may be empty
  std::string beside_text;
};

/// Escapes text for HTML, between tags or in double quotes.
std::string escaped_html(std::string_view text);

/// Serializes JSON so that it cannot end a script element or begin a comment in it.
std::string script_json(const support::Json& json);

/// Encodes bytes in base64 (RFC 4648).
std::string base64(std::string_view bytes);

/// Fills the markers of the page. Its content policy allows the scripts and the style by their
/// SHA-256 only.
/// @param strip an SVG, or empty
/// @throws std::logic_error if a script contains its own end tag, or if a marker does not occur
///         exactly once
std::string assemble_page(const PageParts& parts, const support::Json& report,
                          const std::vector<PagePicture>& pictures, std::string_view strip);

}  // namespace fixproof::cli
