#include "xsharp/files/parse_json.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "support/strict_json.hpp"
#include "xsharp/scene_error.hpp"

namespace xsharp {

nlohmann::json parse_json(std::string_view text) {
  try {
    return fixproof::support::parse_strictly(text, true);
  } catch (const nlohmann::json::exception& error) {
    // Removes the library's label, "[json.exception...] ".
    const std::string what = error.what();
    throw SceneError("not JSON: " + what.substr(std::min(what.find("] ") + 2, what.size())));
  } catch (const std::runtime_error& error) {
    throw SceneError(error.what());
  }
}

}  // namespace xsharp
