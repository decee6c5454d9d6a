#include "fuzz/reply_seeds.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <vector>

#include "fuzz/corpus.hpp"
#include "judge/code/message.hpp"
#include "tests/judge/code/replies.hpp"

namespace fixproof::fuzz {

namespace {

/// A number, highest byte first.
std::string number(std::uint64_t value, unsigned bytes) {
  std::string text;
  for (unsigned i = bytes; i-- > 0;) text += static_cast<char>(value >> (8 * i) & 0xFFU);
  return text;
}

std::string reply(const std::string& bytes, std::uint64_t steps, judge::Downfall downfall = {}) {
  return fmt::format("{}{}{}{}", number(static_cast<std::uint64_t>(downfall), 1), number(steps, 8),
                     number(bytes.size(), 3), bytes);
}

}  // namespace

void write_replies(const std::filesystem::path& root) {
  Corpus corpus(root, "judge_reply");
  const std::vector<judge::Answer> two(2);
  auto stuck = two;
  stuck[1].ending.end = judge::End::endless;
  constexpr std::uint64_t forged = 1'000'000;
  for (const auto& first :
       {reply(replies::bytes_of(two), 2), reply(replies::bytes_of(stuck), 2),
        reply("", 1, judge::Downfall::crashed), reply("", forged, judge::Downfall::out_of_time)}) {
    for (const std::uint64_t cases : {1U, 2U, 3U, 4097U}) {
      corpus.add(
          fmt::format("a{}{}{}", number(cases - 1, 2), first, reply(replies::bytes_of({{}}), 1)));
    }
  }
  const std::vector<judge::Step> steps(2);
  const std::vector<judge::Access> accesses{{.step = 1, .bytes = 4}};
  for (const std::uint32_t claimed : {0U, 1U, 2U, 3U, 0xFFFFFFFFU}) {
    corpus.add(fmt::format("t{}{}{}{}", replies::bytes_of({{}}),
                           replies::bytes_of_all(std::vector{claimed}),
                           replies::bytes_of_all(steps), replies::bytes_of_all(accesses)));
  }
  for (const std::uint64_t longest : {0U, 3U, 4U, 255U}) {
    const std::string message = judge::length_of("text") + "text";
    corpus.add(fmt::format("m{}{}{}{}{}", number(longest, 1), number(2, 1), message.substr(0, 3),
                           number(4, 1), message.substr(3)));
  }
}

}  // namespace fixproof::fuzz
