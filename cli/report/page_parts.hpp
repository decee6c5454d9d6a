/// @file
/// The files of `report/`, built into the program.
#pragma once

#include <string_view>

namespace fixproof::cli {

struct PageParts {
  /// HTML with the markers <!--style-->, <!--libraries-->, <!--pictures-->, <!--beside-->,
  /// <!--strip-->, <!--data--> and <!--charts-->
  std::string_view page;
  std::string_view style;  ///< CSS
  std::string_view d3;
  std::string_view plot;
  std::string_view charts;  ///< the project's scripts, concatenated
};

PageParts page_parts();

}  // namespace fixproof::cli
