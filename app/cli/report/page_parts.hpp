/// @file
/// The files of `app/report/`, embedded in the program.
#pragma once

#include <string_view>

namespace fixproof::cli {

struct PageParts {
  /// HTML with the markers <!--script-hashes-->, <!--style-hash-->, <!--style-->, <!--libraries-->,
  /// <!--pictures-->, <!--beside-->, <!--strip-->, <!--data--> and <!--charts-->
  std::string_view page;
  std::string_view style;
  std::string_view d3;
  std::string_view plot;
  std::string_view charts;  ///< the project's scripts, concatenated
};

PageParts page_parts();

}  // namespace fixproof::cli
