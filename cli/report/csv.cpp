#include "cli/report/csv.hpp"

#include <cstdint>

namespace fixproof::cli {

namespace {

using CsvJson = nlohmann::ordered_json;

std::string field(const CsvJson& value) {
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

CsvJson accuracy_rows(const CsvJson& accuracy) {
  CsvJson rows = CsvJson::array();
  for (CsvJson row : accuracy.at("accuracy")) {
    const CsvJson histogram = row.at("histogram");
    row.erase("histogram");
    row["span"] = histogram.at("span");
    std::size_t bucket = 0;
    for (const CsvJson& count : histogram.at("counts")) {
      row["bucket_" + std::to_string(++bucket)] = count;
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

CsvJson pixel_rows(const CsvJson& accuracy) {
  CsvJson rows = CsvJson::array();
  for (const CsvJson& variant : accuracy.at("pixels").at("variants")) {
    for (const CsvJson& octave : variant.at("octaves")) {
      CsvJson row{{"variant", variant.at("variant")}};
      row.update(octave);
      row["safe_from"] = variant.at("safe_from");
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

void add_spread(CsvJson& row, const std::string& name, const CsvJson& spread) {
  row[name + "_least"] = spread.at("least");
  const bool mean = spread.contains("mean");
  row[name + "_mean_min"] = mean ? spread.at("mean").at("min") : CsvJson();
  row[name + "_mean_max"] = mean ? spread.at("mean").at("max") : CsvJson();
  row[name + "_most"] = spread.at("most");
}

CsvJson clock_rows(const CsvJson& clocks) {
  CsvJson rows = CsvJson::array();
  for (const CsvJson& call : clocks.at("clocks")) {
    for (const CsvJson& on : call.at("processors")) {
      CsvJson row{{"routine", call.at("routine")},
                  {"target", call.at("target")},
                  {"chapter", call.at("chapter")},
                  {"rounds", call.at("rounds")},
                  {"cpu", on.at("cpu")}};
      add_spread(row, "instructions", call.at("instructions"));
      add_spread(row, "clocks", on.at("clocks"));
      // Only an 8088 has bus time.
      const bool bus = on.contains("bus") && on.at("bus").contains("mean");
      row["bus_mean"] = bus ? on.at("bus").at("mean").at("max") : CsvJson();
      row["limit"] = bus ? on.at("limit") : CsvJson();
      row["calls"] = on.at("clocks").at("calls");
      row["faults"] = call.at("faults");
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

CsvJson claim_rows(const CsvJson& clocks) {
  CsvJson rows = CsvJson::array();
  for (const CsvJson& claim : clocks.at("claims")) {
    for (const CsvJson& figure : claim.at("figures")) {
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
CsvJson flat(const CsvJson& object) {
  CsvJson row;
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
CsvJson flat_rows(const CsvJson& list) {
  CsvJson rows = CsvJson::array();
  CsvJson columns = CsvJson::object();
  for (const CsvJson& item : list) {
    CsvJson row = flat(item);
    for (const auto& [key, value] : row.items()) {
      if (!item.contains(key) || !item.at(key).is_null()) columns[key] = nullptr;
    }
    rows.push_back(std::move(row));
  }
  CsvJson even = CsvJson::array();
  for (const CsvJson& row : rows) {
    CsvJson whole = columns;
    for (const auto& [key, value] : row.items()) {
      if (columns.contains(key)) whole[key] = value;
    }
    even.push_back(std::move(whole));
  }
  return even;
}

CsvJson drift_rows(const CsvJson& drift) {
  CsvJson rows = CsvJson::array();
  const auto step = drift.at("frames_a_point").get<std::uint64_t>();
  for (const CsvJson& c : drift.at("cases")) {
    const CsvJson& length = c.at("series").at("length");
    const CsvJson& pixels = c.at("series").at("pixels");
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
CsvJson stepping_rows(const CsvJson& stepping) {
  CsvJson rows = CsvJson::array();
  for (CsvJson row : stepping.at("stepping")) {
    row.erase("along");
    row.erase("last_of");
    rows.push_back(flat(row));
  }
  return rows;
}

CsvJson along_rows(const CsvJson& stepping) {
  CsvJson rows = CsvJson::array();
  for (const CsvJson& row : stepping.at("stepping")) {
    for (const CsvJson& place : row.at("along")) {
      CsvJson at{{"value", row.at("value")}, {"rule", row.at("rule")}};
      at.update(place);
      rows.push_back(std::move(at));
    }
  }
  return rows;
}

}  // namespace

std::string csv_text(const nlohmann::ordered_json& rows) {
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
  CsvJson names = CsvJson::object();
  for (const auto& [key, value] : rows.front().items()) names[key] = key;
  line(names);
  for (const CsvJson& row : rows) line(row);
  return text;
}

std::vector<std::pair<std::string, std::string>> csv_files(const nlohmann::ordered_json& report) {
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
