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

#include "fixed/formats.hpp"
#include "judge/check/judged_case.hpp"
#include "judge/check/rules.hpp"
#include "judge/check/verdict_text.hpp"
#include "verify/cases/plan.hpp"
#include "verify/cases/streams.hpp"

namespace fixproof::property {

/// A function under test, on words.
struct Subject {
  std::string name;
  check::Rules rules;
  std::function<check::Said(std::span<const std::uint64_t>)> ask;
};

/// Rules in 16.16, which subject() takes to the format of its type.
inline check::Rules rules_of(cases::Operation operation, oracle::Rounding rounding,
                             check::Overflow overflow, check::NoResult no_result) {
  return {.variant = {.operation = operation},
          .rounding = rounding,
          .overflow = overflow,
          .no_result = no_result};
}

namespace detail {

template <class Raw>
check::Said word_of(Raw raw) {
  return static_cast<std::make_unsigned_t<Raw>>(raw);
}

template <class Raw, class Result>
check::Said answer_of(Result result) {
  if constexpr (std::is_same_v<Result, std::optional<Raw>>) {
    if (!result) return std::nullopt;
    return word_of<Raw>(*result);
  } else {
    return word_of<Raw>(Raw{result});
  }
}

}  // namespace detail

/// The format of a type's raw integers.
template <class Number>
constexpr cases::Format format_of() {
  return {.word_bits = ::fixproof::detail::bits_of<typename Number::raw_type>,
          .fraction_bits = Number::fraction_bits,
          .is_signed = std::is_signed_v<typename Number::raw_type>};
}

/// Wraps any callable that takes one or two raw integers of Number and returns one, or an optional
/// one that is empty for a divide error. The rules are judged in the format of Number.
template <class Number = fixproof::q16_16, class Function>
Subject subject(std::string name, const check::Rules& rules, Function function) {
  using Raw = typename Number::raw_type;
  const auto raw = [](std::uint64_t word) { return static_cast<Raw>(word); };
  Subject one{std::move(name), rules, {}};
  one.rules.variant.format = format_of<Number>();
  if constexpr (std::is_invocable_v<Function, Raw, Raw>) {
    one.ask = [function, raw](std::span<const std::uint64_t> words) {
      return detail::answer_of<Raw>(function(raw(words[0]), raw(words[1])));
    };
  } else {
    one.ask = [function, raw](std::span<const std::uint64_t> words) {
      return detail::answer_of<Raw>(function(raw(words[0])));
    };
  }
  return one;
}

/// Whether the function satisfies the rules for the case. Does not call it if the rules accept any
/// result.
inline bool holds(const Subject& subject, std::span<const std::uint64_t> words) {
  return !check::expected_of(subject.rules, words).judged ||
         check::keeps(subject.rules, words, subject.ask(words));
}

/// The level 1 streams of the operation, and the number of cases in each.
inline std::vector<std::pair<cases::Stream, std::uint64_t>> streams_of(
    cases::Operation operation, const cases::Format& format = cases::q16_16) {
  // Two parties, because a plan has no cases if there is nothing to compare.
  const cases::Plan plan(1, 1994, {{cases::variant_of(operation, format), {"a", "b"}}});
  std::vector<std::pair<cases::Stream, std::uint64_t>> streams;
  for (const cases::Job& job : plan.jobs()) streams.emplace_back(job.stream, job.cases);
  return streams;
}

/// Describes the failures in a stream of cases, listing only the first ones; empty if there are
/// none.
inline std::string failures_in(const Subject& subject, cases::Stream stream, std::uint64_t cases) {
  const cases::Format& format = subject.rules.variant.format;
  const cases::Variant variant = cases::variant_of(subject.rules.variant.operation, format);
  const std::size_t arity = cases::words_in(subject.rules.variant.operation);
  const std::size_t parts = cases::words_in(variant);
  std::array<std::uint32_t, 2048> room{};
  check::FirstCases wrong;
  for (std::uint64_t first = 0; first < cases; first += room.size() / parts) {
    const auto batch = std::min<std::uint64_t>(room.size() / parts, cases - first);
    const auto made = std::span(room).first(batch * parts);
    cases::make_cases(stream, variant, 1994, first, made);
    for (std::uint64_t i = 0; i < batch; ++i) {
      check::JudgedCase one{first + i + 1, cases::name_of(stream), {}, {}};
      const auto words = std::span(one.words).first(arity);
      check::join_words(made.subspan(i * parts, parts), format, words);
      if (holds(subject, words)) continue;
      one.said = subject.ask(words);
      wrong.add(one);
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
