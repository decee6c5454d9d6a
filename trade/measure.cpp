#include "trade/measure.hpp"

#include "player/outputs.hpp"
#include "support/file.hpp"
#include "xsharp/files/scene_json.hpp"

namespace fixproof::trade {

std::vector<xsharp::Scene> read_scenes(const MeasureRequest& request) {
  std::vector<xsharp::Scene> scenes;
  for (const std::string& file : request.scenes) {
    scenes.push_back(xsharp::read_scene(file));
    if (!request.json.empty()) player::refuse_inputs("--json", request.json, scenes.back().files);
  }
  if (!request.json.empty()) support::check_replaceable(request.json);
  return scenes;
}

}  // namespace fixproof::trade
