/// @file
/// The folder of the initial inputs of a target.
#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <string_view>

#include "support/file.hpp"

namespace fixproof::fuzz {

class Corpus {
 public:
  Corpus(const std::filesystem::path& root, std::string_view target) : folder_(root / target) {
    std::filesystem::create_directories(folder_);
  }

  void add(std::string_view bytes) {
    const std::filesystem::path path = folder_ / fmt::format("seed-{:04}", files_++);
    std::ofstream file;
    file.exceptions(std::ios::failbit | std::ios::badbit);
    file.open(path, std::ios::binary);
    file << bytes;
  }
  void add(std::span<const std::uint8_t> bytes) { add(std::string(bytes.begin(), bytes.end())); }

  void add_file(const std::filesystem::path& path, std::string_view before = "") {
    add(std::string(before) + support::read_file(path));
  }

 private:
  std::filesystem::path folder_;
  int files_ = 0;
};

}  // namespace fixproof::fuzz
