#include "app/cli/arguments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <filesystem>
#include <iostream>
#include <limits>
#include <string>

#include "support/edits.hpp"
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

CLI::Validator one_of(const std::vector<std::string>& words) {
  const std::string all = fmt::format("{{{}}}", fmt::join(words, ","));
  return {[words, all](const std::string& text) -> std::string {
            if (std::find(words.begin(), words.end(), text) != words.end()) return "";
            return fmt::format("{} not in {}{}", fixproof::support::printable(text), all,
                               fixproof::support::suggestion(text, words));
          },
          all};
}

CLI::Validator not_empty() {
  return {[](const std::string& text) { return text.empty() ? "the value is empty" : ""; }, ""};
}

CLI::Validator output_file() {
  return {[](std::string& text) -> std::string {
            if (text.empty()) return "the value is empty";
            if (text == "-") {
              text = "/dev/stdout";
              std::cout.flush();
              std::cout.rdbuf(std::cerr.rdbuf());
            }
            return "";
          },
          ""};
}

CLI::Validator picture_file(std::string_view ending) {
  return {[ending](const std::string& text) -> std::string {
            if (text.empty()) return "the value is empty";
            constexpr std::array others{".png",  ".apng", ".svg", ".jpg", ".jpeg", ".gif",
                                        ".webp", ".bmp",  ".tif", ".pdf", ".tiff", ".pcx",
                                        ".mp4",  ".webm", ".avi", ".mov", ".mkv",  ".mpg"};
            std::string name = std::filesystem::path(text).extension().string();
            for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
            const bool is_other = std::find(others.begin(), others.end(), name) != others.end();
            if (!is_other || name == ending || (name == ".apng" && ending == ".png")) return "";
            return fmt::format("{}: this option writes no {} file; end the name in {}",
                               support::printable(text), name, ending);
          },
          ""};
}

}  // namespace fixproof::cli
