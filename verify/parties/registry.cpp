#include <fmt/format.h>

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "support/edits.hpp"
#include "verify/parties/library.hpp"
#include "verify/parties/parties.hpp"

namespace fixproof::parties {

const std::vector<std::unique_ptr<Party>>& parties() {
  static const auto all = [] {
    std::vector<std::unique_ptr<Party>> made;
    made.push_back(make_model());
    made.push_back(make_interpreter());
    made.push_back(make_oracle());
    made.push_back(make_fast_oracle());
    made.push_back(make_type());
    for (auto& party : make_batch_parties()) made.push_back(std::move(party));
    made.push_back(make_silicon());
    made.push_back(make_unicorn());
    return made;
  }();
  return all;
}

const Party& party_named(std::string_view name) {
  if (names_function(name)) return party_of_function(name);
  std::string known;
  std::vector<std::string> names;
  for (const auto& party : parties()) {
    if (party->name() == name) {
      const std::string absence = party->absence();
      if (absence.empty()) return *party;
      throw std::invalid_argument(fmt::format("party '{}' is not available: {}", name, absence));
    }
    known += known.empty() ? "" : ", ";
    known += party->name();
    names.emplace_back(party->name());
  }
  throw std::invalid_argument(
      fmt::format("unknown party '{}'; choose one of {}, or a function of a shared "
                  "library as in ./libmine.so:my_mul{}",
                  name, known, support::suggestion(name, names)));
}

}  // namespace fixproof::parties
