// The register-level model: the compiled run beside the plain interpreter, in calls a second.
#include <benchmark/benchmark.h>

#include <random>
#include <vector>

#include "parties/party.hpp"

namespace {

using namespace fixproof;

/// Asks `party` the same uniform cases over and over, once it agrees with the oracle on them.
void calls(benchmark::State& state, const char* party, cases::Variant variant) {
  constexpr std::size_t cases = 1024;
  std::mt19937 random(54);
  std::vector<std::uint32_t> in(cases * cases::words_in(variant.operation));
  for (std::uint32_t& word : in) word = static_cast<std::uint32_t>(random());
  std::vector<std::uint32_t> out(cases * cases::words_out(variant.operation));
  std::vector<std::uint32_t> expected(out.size());
  std::vector<parties::Ending> endings(cases);
  std::vector<parties::Ending> expected_endings(cases);
  parties::party_named("oracle").answer(variant, {in, expected, expected_endings});
  const parties::Party& asked = parties::party_named(party);
  asked.answer(variant, {in, out, endings});
  bool right = endings == expected_endings;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const bool valued =
        expected_endings[i / cases::words_out(variant.operation)] == parties::Ending::value;
    right = right && (!valued || out[i] == expected[i]);
  }
  if (!right) {
    state.SkipWithError("wrong result");
    return;
  }
  for ([[maybe_unused]] auto _ : state) {
    asked.answer(variant, {in, out, endings});
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(cases));
}

constexpr cases::Variant mul_i8088{.operation = cases::Operation::mul,
                                   .target = cases::Target::i8088};
constexpr cases::Variant mul_i386{.operation = cases::Operation::mul,
                                  .target = cases::Target::i386};
constexpr cases::Variant div_i8088{.operation = cases::Operation::div,
                                   .target = cases::Target::i8088};
constexpr cases::Variant div_i386{.operation = cases::Operation::div,
                                  .target = cases::Target::i386};
constexpr cases::Variant xformvec_i8088{.operation = cases::Operation::xformvec,
                                        .target = cases::Target::i8088};
constexpr cases::Variant xformvec_i386{.operation = cases::Operation::xformvec,
                                       .target = cases::Target::i386};

BENCHMARK_CAPTURE(calls, mul_i8088_compiled, "model", mul_i8088);
BENCHMARK_CAPTURE(calls, mul_i8088_interpreted, "interpreter", mul_i8088);
BENCHMARK_CAPTURE(calls, mul_i386_compiled, "model", mul_i386);
BENCHMARK_CAPTURE(calls, mul_i386_interpreted, "interpreter", mul_i386);
BENCHMARK_CAPTURE(calls, div_i8088_compiled, "model", div_i8088);
BENCHMARK_CAPTURE(calls, div_i8088_interpreted, "interpreter", div_i8088);
BENCHMARK_CAPTURE(calls, div_i386_compiled, "model", div_i386);
BENCHMARK_CAPTURE(calls, div_i386_interpreted, "interpreter", div_i386);
BENCHMARK_CAPTURE(calls, xformvec_i8088_compiled, "model", xformvec_i8088);
BENCHMARK_CAPTURE(calls, xformvec_i386_compiled, "model", xformvec_i386);

}  // namespace
