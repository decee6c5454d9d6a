#include "measure/player/dump.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace fixproof::player {

std::string dump_frame(const xsharp::Player& player, std::uint64_t frame) {
  const auto order = player.order();
  std::vector<std::size_t> places(order.size());
  for (std::size_t place = 0; place < order.size(); ++place) places[order[place]] = place;

  std::string lines;
  for (std::size_t object = 0; object < order.size(); ++object) {
    const xsharp::ObjectState state = player.state(object);
    lines += fmt::format(R"({{"frame":{},"object":{},"order":{},"xform":[{}],"view":[)", frame,
                         object, places[object], fmt::join(state.xform, ","));
    const char* between = "";
    for (const auto& vertex : state.view) {
      lines += fmt::format("{}[{}]", between, fmt::join(vertex, ","));
      between = ",";
    }
    lines += R"(],"screen":[)";
    between = "";
    for (const auto& point : state.screen) {
      lines += point ? fmt::format("{}[{},{}]", between, point->x, point->y)
                     : fmt::format("{}null", between);
      between = ",";
    }
    lines += fmt::format(R"(],"visible":[{}]}})", fmt::join(state.visible, ","));
    lines += '\n';
  }
  return lines;
}

}  // namespace fixproof::player
