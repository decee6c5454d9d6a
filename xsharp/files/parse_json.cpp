#include "xsharp/files/parse_json.hpp"

#include <stdexcept>

#include "support/strict_json.hpp"
#include "xsharp/scene_error.hpp"

namespace xsharp {

nlohmann::json parse_json(std::string_view text) {
  try {
    return fixproof::support::parse_strictly(text, true);
  } catch (const nlohmann::json::exception& error) {
    throw SceneError("not JSON: " + fixproof::support::json_message(error));
  } catch (const std::runtime_error& error) {
    throw SceneError(error.what());
  }
}

}  // namespace xsharp
