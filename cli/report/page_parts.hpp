/// @file
/// The parts of the page, from `report/`, built into the program.
#pragma once

#include <string_view>

namespace fixproof::cli {

struct PageParts {
  std::string_view
      page;  ///< HTML with places for the others: <!--style-->, <!--libraries-->,
             ///< <!--pictures-->, <!--beside-->, <!--strip-->, <!--data-->, <!--charts-->
  std::string_view style;  ///< CSS
  std::string_view d3;
  std::string_view plot;
  std::string_view charts;  ///< what draws, one file after the other
};

PageParts page_parts();

}  // namespace fixproof::cli
