#include "verify/measure/measure.hpp"

#include "verify/file.hpp"
#include "verify/scenes/outputs.hpp"
#include "xsharp/files/scene_json.hpp"

namespace fixproof {

std::vector<xsharp::Scene> read_scenes(const MeasureRequest& request) {
  std::vector<xsharp::Scene> scenes;
  for (const std::string& file : request.scenes) {
    scenes.push_back(xsharp::read_scene(file));
    if (!request.json.empty()) refuse_inputs("--json", request.json, scenes.back().files);
  }
  if (!request.json.empty()) check_replaceable(request.json);
  return scenes;
}

}  // namespace fixproof
