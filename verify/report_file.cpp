#include "verify/report_file.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "verify/file.hpp"
#include "verify/party.hpp"
#include "verify/text.hpp"

namespace fixproof {

Report read_report(const std::string& path) {
  const std::string text = read_file(path);
  try {
    Report report = from_json(text);
    for (const Row& row : report.plan.rows()) {
      if (!row.compared()) {
        throw std::runtime_error(fmt::format("{} is not compared", name_of(row.variant)));
      }
      for (const std::string& name : row.parties) {
        if (!party_named(name).answers(row.variant)) {
          throw std::runtime_error(
              fmt::format("{} does not answer {}", name, name_of(row.variant)));
        }
      }
    }
    return report;
  } catch (const std::exception& error) {
    throw std::runtime_error(fmt::format("{}: {}", path, error.what()));
  }
}

}  // namespace fixproof
