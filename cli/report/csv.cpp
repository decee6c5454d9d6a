#include "cli/report/csv.hpp"

#include <cstdint>

#include "support/json.hpp"

namespace fixproof::cli {

namespace {

using support::Json;

std::string field(const Json& value) {
  if (value.is_null()) return {};
  if (!value.is_string()) return value.dump();
  auto text = value.get<std::string>();
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

Json accuracy_rows(const Json& accuracy) {
  Json rows = Json::array();
  for (Json row : accuracy.at("accuracy")) {
    const Json histogram = row.at("histogram");
    row.erase("histogram");
    row["span"] = histogram.at("span");
    std::size_t bucket = 0;
    for (const Json& count : histogram.at("counts")) {
      row["bucket_" + std::to_string(++bucket)] = count;
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

Json pixel_rows(const Json& accuracy) {
  Json rows = Json::array();
  for (const Json& variant : accuracy.at("pixels").at("variants")) {
    for (const Json& octave : variant.at("octaves")) {
      Json row{{"variant", variant.at("variant")}};
      row.update(octave);
      row["safe_from"] = variant.at("safe_from");
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

void add_spread(Json& row, const std::string& name, const Json& spread) {
  row[name + "_least"] = spread.at("least");
  const bool mean = spread.contains("mean");
  row[name + "_mean_min"] = mean ? spread.at("mean").at("min") : Json();
  row[name + "_mean_max"] = mean ? spread.at("mean").at("max") : Json();
  row[name + "_most"] = spread.at("most");
}

Json clock_rows(const Json& clocks) {
  Json rows = Json::array();
  for (const Json& call : clocks.at("clocks")) {
    for (const Json& on : call.at("processors")) {
      Json row{{"routine", call.at("routine")},
               {"target", call.at("target")},
               {"chapter", call.at("chapter")},
               {"rounds", call.at("rounds")},
               {"cpu", on.at("cpu")}};
      add_spread(row, "instructions", call.at("instructions"));
      add_spread(row, "clocks", on.at("clocks"));
      // Only an 8088 has bus time.
      const bool bus = on.contains("bus") && on.at("bus").contains("mean");
      row["bus_mean"] = bus ? on.at("bus").at("mean").at("max") : Json();
      row["limit"] = bus ? on.at("limit") : Json();
      row["calls"] = on.at("clocks").at("calls");
      row["faults"] = call.at("faults");
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

Json claim_rows(const Json& clocks) {
  Json rows = Json::array();
  for (const Json& claim : clocks.at("claims")) {
    for (const Json& figure : claim.at("figures")) {
      rows.push_back({{"claim", claim.at("claim")},
                      {"place", claim.at("place")},
                      {"means", claim.at("means")},
                      {"verdict", claim.at("verdict")},
                      {"where", figure.at("where")},
                      {"measured_min", figure.at("measured").at("min")},
                      {"measured_max", figure.at("measured").at("max")},
                      {"unit", claim.at("unit")},
                      {"allowed_min", claim.at("allowed").at("min")},
                      {"allowed_max", claim.at("allowed").at("max")},
                      {"figure_verdict", figure.at("verdict")}});
    }
  }
  return rows;
}

/// Fields of an object in the object become columns, the two names joined.
Json flat(const Json& object) {
  Json row;
  for (const auto& [key, value] : object.items()) {
    if (!value.is_object()) {
      row[key] = value;
      continue;
    }
    for (const auto& [inner, figure] : value.items()) row[key + '_' + inner] = figure;
  }
  return row;
}

/// Columns that only some rows have, such as those of a chain, are empty in the others.
Json flat_rows(const Json& list) {
  Json rows = Json::array();
  Json columns = Json::object();
  for (const Json& item : list) {
    Json row = flat(item);
    for (const auto& [key, value] : row.items()) {
      if (!item.contains(key) || !item.at(key).is_null()) columns[key] = nullptr;
    }
    rows.push_back(std::move(row));
  }
  Json even = Json::array();
  for (const Json& row : rows) {
    Json whole = columns;
    for (const auto& [key, value] : row.items()) {
      if (columns.contains(key)) whole[key] = value;
    }
    even.push_back(std::move(whole));
  }
  return even;
}

Json drift_rows(const Json& drift) {
  Json rows = Json::array();
  const auto step = drift.at("frames_a_point").get<std::uint64_t>();
  for (const Json& c : drift.at("cases")) {
    const Json& length = c.at("series").at("length");
    const Json& pixels = c.at("series").at("pixels");
    for (std::size_t i = 0; i < length.size(); ++i) {
      rows.push_back({{"case", c.at("name")},
                      {"from_frame", i * step},
                      {"length", length[i]},
                      {"pixels", pixels.at(i)}});
    }
  }
  return rows;
}

/// A row for each way of stepping, without its lists.
Json stepping_rows(const Json& stepping) {
  Json rows = Json::array();
  for (Json row : stepping.at("stepping")) {
    row.erase("along");
    row.erase("last_of");
    rows.push_back(flat(row));
  }
  return rows;
}

Json along_rows(const Json& stepping) {
  Json rows = Json::array();
  for (const Json& row : stepping.at("stepping")) {
    for (const Json& place : row.at("along")) {
      Json at{{"value", row.at("value")}, {"rule", row.at("rule")}};
      at.update(place);
      rows.push_back(std::move(at));
    }
  }
  return rows;
}

}  // namespace

std::string csv_text(const support::Json& rows) {
  if (rows.empty()) return {};
  std::string text;
  const auto line = [&text](const auto& each) {
    bool first = true;
    for (const auto& [key, value] : each.items()) {
      if (!first) text += ',';
      first = false;
      text += field(value);
    }
    text += "\r\n";
  };
  Json names = Json::object();
  for (const auto& [key, value] : rows.front().items()) names[key] = key;
  line(names);
  for (const Json& row : rows) line(row);
  return text;
}

std::vector<std::pair<std::string, std::string>> csv_files(const support::Json& report) {
  std::vector<std::pair<std::string, std::string>> files;
  const auto has = [&report](const char* part) {
    return report.contains(part) && !report.at(part).is_null();
  };
  if (has("accuracy")) {
    files.emplace_back("accuracy.csv", csv_text(accuracy_rows(report.at("accuracy"))));
    files.emplace_back("pixels.csv", csv_text(pixel_rows(report.at("accuracy"))));
  }
  if (has("clocks")) {
    files.emplace_back("clocks.csv", csv_text(clock_rows(report.at("clocks"))));
    files.emplace_back("claims.csv", csv_text(claim_rows(report.at("clocks"))));
  }
  if (has("host")) {
    files.emplace_back("host.csv", csv_text(flat_rows(report.at("host").at("host"))));
    files.emplace_back("vertices.csv", csv_text(flat_rows(report.at("host").at("vertices"))));
  }
  if (has("stepping")) {
    files.emplace_back("stepping.csv", csv_text(stepping_rows(report.at("stepping"))));
    files.emplace_back("along.csv", csv_text(along_rows(report.at("stepping"))));
  }
  if (has("drift")) files.emplace_back("drift.csv", csv_text(drift_rows(report.at("drift"))));
  return files;
}

}  // namespace fixproof::cli
