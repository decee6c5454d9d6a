/// @file
/// The operands of hard_words.txt, whose results are nearest to a tie.
#pragma once

#include <fstream>
#include <functional>
#include <map>
#include <sstream>
#include <string>

#include "fixed/formats.hpp"
#include "tests/support/test.hpp"

namespace functions {

struct HardWord {
  std::string function;
  std::int64_t operand;  ///< stored integers
  std::int64_t result;
};

/// Calls check.operator()<N>(word) for each line, with the format N that it names.
template <class Check>
void for_each_hard_word(const std::string& path, const Check& check) {
  const std::map<std::string, std::function<void(const HardWord&)>> formats{
      {"q8_8", [&](const HardWord& word) { check.template operator()<fixproof::q8_8>(word); }},
      {"q24_8", [&](const HardWord& word) { check.template operator()<fixproof::q24_8>(word); }},
      {"q16_16", [&](const HardWord& word) { check.template operator()<fixproof::q16_16>(word); }},
      {"q8_24", [&](const HardWord& word) { check.template operator()<fixproof::q8_24>(word); }},
      {"q2_30", [&](const HardWord& word) { check.template operator()<fixproof::q2_30>(word); }}};
  std::ifstream file(path);
  std::size_t words = 0;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with('#')) continue;
    std::istringstream parts(line);
    HardWord word;
    std::string format;
    ASSERT_TRUE(parts >> word.function >> format >> word.operand >> word.result) << line;
    const auto found = formats.find(format);
    ASSERT_NE(found, formats.end()) << "no format " << format << " here: " << line;
    found->second(word);
    ++words;
  }
  EXPECT_EQ(words, 432U) << path;
}

/// The function of that name among `all`, which have a member `name`.
template <class Functions>
const auto& named(const Functions& all, const std::string& name) {
  for (const auto& f : all) {
    if (name == f.name) return f;
  }
  throw std::invalid_argument("no function " + name);
}

}  // namespace functions
