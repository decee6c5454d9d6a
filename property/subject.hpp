/// @file
/// A function under test, and the rules that it must satisfy.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "cases/plan.hpp"
#include "cases/streams.hpp"
#include "check/judged_case.hpp"
#include "check/rules.hpp"
#include "check/verdict_text.hpp"

namespace fixproof::property {

/// A function under test, on words.
struct Subject {
  std::string name;
  check::Rules rules;
  std::function<check::Said(std::span<const std::uint32_t>)> ask;
};

namespace detail {

template <class Result>
check::Said answer_of(Result result) {
  if constexpr (std::is_same_v<Result, std::optional<std::int32_t>>) {
    if (!result) return std::nullopt;
    return static_cast<std::uint32_t>(*result);
  } else {
    return static_cast<std::uint32_t>(std::int32_t{result});
  }
}

inline std::int32_t operand(std::uint32_t word) { return static_cast<std::int32_t>(word); }

}  // namespace detail

/// Wraps any callable that takes one or two std::int32_t and returns one, or an optional one that
/// is empty for a divide error.
template <class Function>
Subject subject(std::string name, const check::Rules& rules, Function function) {
  using detail::operand;
  Subject one{std::move(name), rules, {}};
  if constexpr (std::is_invocable_v<Function, std::int32_t, std::int32_t>) {
    one.ask = [function](std::span<const std::uint32_t> words) {
      return detail::answer_of(function(operand(words[0]), operand(words[1])));
    };
  } else {
    one.ask = [function](std::span<const std::uint32_t> words) {
      return detail::answer_of(function(operand(words[0])));
    };
  }
  return one;
}

/// Whether the function satisfies the rules for the case. Does not call it if the rules accept any
/// result.
inline bool holds(const Subject& subject, std::span<const std::uint32_t> words) {
  return !check::expected_of(subject.rules, words).judged ||
         check::keeps(subject.rules, words, subject.ask(words));
}

/// The level 1 streams of the operation, and the number of cases in each.
inline std::vector<std::pair<cases::Stream, std::uint64_t>> streams_of(cases::Operation operation) {
  const cases::Variant variant{.operation = operation,
                               .build = {.target = cases::Target::standard}};
  // Two parties, because a plan has no cases if there is nothing to compare.
  const cases::Plan plan(1, 1994, {{variant, {"a", "b"}}});
  std::vector<std::pair<cases::Stream, std::uint64_t>> streams;
  for (const cases::Job& job : plan.jobs()) streams.emplace_back(job.stream, job.cases);
  return streams;
}

/// Describes the failures in a stream of cases, listing only the first ones; empty if there are
/// none.
inline std::string failures_in(const Subject& subject, cases::Stream stream, std::uint64_t cases) {
  const cases::Variant variant{.operation = subject.rules.operation,
                               .build = {.target = cases::Target::standard}};
  const std::size_t arity = cases::words_in(subject.rules.operation);
  std::array<std::uint32_t, 2048> room{};
  check::FirstCases wrong;
  for (std::uint64_t first = 0; first < cases; first += room.size() / arity) {
    const auto batch = std::min<std::uint64_t>(room.size() / arity, cases - first);
    const auto words = std::span(room).first(batch * arity);
    cases::make_cases(stream, variant, 1994, first, words);
    for (std::uint64_t i = 0; i < batch; ++i) {
      const auto one = words.subspan(i * arity, arity);
      if (holds(subject, one)) continue;
      check::JudgedCase kept{first + i + 1, cases::name_of(stream), {}, subject.ask(one)};
      std::copy(one.begin(), one.end(), kept.words.begin());
      wrong.add(kept);
    }
  }
  if (wrong.count() == 0) return "";
  std::string text =
      std::to_string(wrong.count()) + " of " + std::to_string(cases) + " cases are wrong:\n";
  for (const check::JudgedCase& one : wrong.shown())
    text += check::text_of(one, subject.rules) + '\n';
  return text;
}

}  // namespace fixproof::property
