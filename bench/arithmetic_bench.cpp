// Times the contenders of `fixproof measure --host`: the type, the plain idiom, installed
// libraries, float and double. Runs single operations over arrays in the first-level cache and in
// dependency chains. Checks every result against its contender's rounding before timing.
#include <benchmark/benchmark.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "measure/host/host.hpp"

namespace {

using namespace fixproof;

constexpr std::uint64_t seed = 54;

void time_loop(benchmark::State& state, const measure::HostOperation& operation,
               const measure::HostContender& contender, bool chain) {
  try {
    measure::judge_contender(operation, contender);
  } catch (const measure::WrongContender& wrong) {
    state.SkipWithError(wrong.what());
    return;
  }
  measure::HostLoop& loop = *contender.loop;
  for ([[maybe_unused]] auto _ : state) {
    chain ? loop.apply_in_chain() : loop.apply_all();
    benchmark::ClobberMemory();
  }
  const std::size_t operations =
      chain ? operation.operands.taken.size() : operation.operands.block / operation.words;
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(operations));
}

/// Registers `mul/q16_16` and `mul/q16_16/chain`, for example.
void register_all(const std::vector<measure::HostOperation>& operations) {
  for (const measure::HostOperation& o : operations) {
    for (const measure::HostContender& contender : o.contenders) {
      const auto timed = [&o, &contender](bool chain) {
        return [&o, &contender, chain](benchmark::State& state) {
          time_loop(state, o, contender, chain);
        };
      };
      const std::string name = o.name + '/' + contender.name;
      benchmark::RegisterBenchmark(name.c_str(), timed(false));
      if (o.chain_is.empty()) continue;
      benchmark::RegisterBenchmark((name + "/chain").c_str(), timed(true));
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  const auto operations = measure::host_operations(seed, 1);
  register_all(operations);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
