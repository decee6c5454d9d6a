#include "xsharp/files/json_node.hpp"

#include <algorithm>

#include "xsharp/scene_error.hpp"

namespace xsharp {

bool JsonNode::flag() const {
  if (!value_->is_boolean()) must_be("true or false");
  return value_->get<bool>();
}

std::int32_t JsonNode::whole(std::int32_t least, std::int32_t most) const {
  const auto allowed = [&](auto n) {
    return std::cmp_less_equal(least, n) && std::cmp_less_equal(n, most);
  };
  const bool fits = value_->is_number_unsigned()  ? allowed(value_->get<std::uint64_t>())
                    : value_->is_number_integer() ? allowed(value_->get<std::int64_t>())
                                                  : false;
  if (!fits)
    must_be("a whole number from " + std::to_string(least) + " to " + std::to_string(most));
  return value_->get<std::int32_t>();
}

double JsonNode::number() const {
  if (!value_->is_number()) must_be("a number");
  return value_->get<double>();
}

std::string JsonNode::text() const {
  if (!value_->is_string()) must_be("a text");
  return value_->get<std::string>();
}

Triple JsonNode::triple() const {
  const auto numbers = list_of(3);
  return {numbers[0].number(), numbers[1].number(), numbers[2].number()};
}

std::vector<JsonNode> JsonNode::list() const {
  if (!value_->is_array()) must_be("a list");
  std::vector<JsonNode> nodes;
  for (const Json& element : *value_) {
    nodes.emplace_back(element, place_ + '[' + std::to_string(nodes.size()) + ']');
  }
  return nodes;
}

std::vector<JsonNode> JsonNode::list_of(std::size_t count) const {
  if (!value_->is_array() || value_->size() != count) {
    must_be("a list of " + std::to_string(count));
  }
  return list();
}

std::size_t JsonNode::word(std::span<const std::string_view> words) const {
  const auto found =
      value_->is_string() ? std::ranges::find(words, value_->get<std::string>()) : words.end();
  if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  std::string demand = "one of";
  for (const auto word : words) demand.append(" \"").append(word).append("\"");
  must_be(demand);
}

void JsonNode::object(std::initializer_list<Key> keys) const {
  if (!value_->is_object()) must_be("an object {…}");
  for (const auto& [name, value] : value_->items()) {
    if (std::ranges::find(keys, name, &Key::name) != keys.end()) continue;
    std::string known;
    for (const Key& key : keys) known.append(known.empty() ? "" : ", ").append(key.name);
    refuse("unknown key \"" + name + "\"; choose one of " + known);
  }
  for (const Key& key : keys) {
    const auto found = value_->find(key.name);
    if (found == value_->end()) continue;
    key.read({*found, (place_.empty() ? "" : place_ + '.').append(key.name)});
  }
}

void JsonNode::require(std::string_view key) const {
  if (!value_->is_object()) must_be("an object {…}");
  if (!has(key)) refuse("must have the key \"" + std::string(key) + '"');
}

void JsonNode::refuse(const std::string& wrong) const {
  throw SceneError(place_.empty() ? wrong : place_ + ": " + wrong);
}

void JsonNode::must_be(const std::string& demand) const {
  std::string shown = value_->dump(-1, ' ', true);
  if (shown.size() > 40) shown = shown.substr(0, 37) + "...";
  refuse("must be " + demand + ", not " + shown);
}

}  // namespace xsharp
