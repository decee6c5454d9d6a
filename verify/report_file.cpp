#include "verify/report_file.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "verify/file.hpp"

namespace fixproof {

Report read_report(const std::string& path) {
  const std::string text = read_file(path);
  try {
    return from_json(text);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(fmt::format("{}: {}", path, error.what()));
  }
}

}  // namespace fixproof
