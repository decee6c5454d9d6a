#include "app/cli/print_error.hpp"

#include <fmt/format.h>

#include <exception>

#include "support/error_text.hpp"
#include "support/plain_text.hpp"

namespace fixproof::cli {

void print_error(std::string_view message) noexcept {
  try {
    support::write_error(fmt::format("fixproof: {}\n", support::printable(message)));
  } catch (const std::exception&) {
    support::write_error("fixproof: out of memory\n");
  }
}

}  // namespace fixproof::cli
