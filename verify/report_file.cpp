#include "verify/report_file.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "support/file.hpp"
#include "verify/parties/party.hpp"

namespace fixproof::verify {

Report read_report(const std::string& path) {
  const std::string text = support::read_file(path);
  try {
    Report report = from_json(text);
    for (const cases::Row& row : report.plan.rows()) {
      if (!row.compared()) {
        throw std::runtime_error(fmt::format("{} is not compared", cases::name_of(row.variant)));
      }
      for (const std::string& name : row.parties) {
        if (!parties::party_named(name).answers(row.variant)) {
          throw std::runtime_error(
              fmt::format("{} does not answer {}", name, cases::name_of(row.variant)));
        }
      }
    }
    return report;
  } catch (const std::exception& error) {
    throw std::runtime_error(fmt::format("{}: {}", path, error.what()));
  }
}

}  // namespace fixproof::verify
