#include "app/cli/arguments.hpp"

#include <fmt/format.h>

#include <charconv>
#include <limits>
#include <string>

#include "support/plain_text.hpp"

namespace fixproof::cli {

CLI::Validator whole_number(std::uint64_t first, std::uint64_t last) {
  return {[first, last](std::string& text) -> std::string {
            std::uint64_t value = 0;
            const char* end = text.data() + text.size();
            const auto [read, error] = std::from_chars(text.data(), end, value);
            if (error != std::errc{} || read != end || value < first || value > last) {
              return fmt::format("{} is not a whole number from {} to {}",
                                 fixproof::support::quoted(text), first, last);
            }
            text = std::to_string(value);
            return "";
          },
          "", "whole number"};
}

void add_seed(CLI::App& command, std::uint64_t& seed) {
  command.add_option("--seed", seed, "seed of the random cases")
      ->transform(whole_number(0, std::numeric_limits<std::uint64_t>::max()))
      ->capture_default_str();
}

CLI::Validator not_empty() {
  return {[](const std::string& text) { return text.empty() ? "the value is empty" : ""; }, ""};
}

}  // namespace fixproof::cli
