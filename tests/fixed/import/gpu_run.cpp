// Compares the kernels, translated to C++, with the type on this processor.
#include <array>
#include <cstdint>
#include <cstdio>

#include "tests/fixed/import/gpu.hpp"
#include "tests/fixed/import/ptx.hpp"

#define KERNEL(name, type, result)                                          \
  extern "C" void name##_kernel(const std::int64_t* in, std::int64_t* out); \
  static void name##_here(const std::int64_t* in, std::int64_t* out) {      \
    const auto x = number_of<type>(in[0]);                                  \
    [[maybe_unused]] const auto y = number_of<type>(in[1]);                 \
    [[maybe_unused]] const auto z = number_of<type>(in[2]);                 \
    *out = word(result);                                                    \
  }
#include "tests/fixed/import/gpu_kernels.hpp"

namespace {

using function = void (*)(const std::int64_t* in, std::int64_t* out);
struct kernel {
  const char* name;
  function there;
  function here;
};

constexpr kernel kernels[] = {
#define KERNEL(name, type, result) {#name, name##_kernel, name##_here},
#include "tests/fixed/import/gpu_kernels.hpp"
};

/// A result, or an error: a trap there, an exception here.
struct answer {
  std::int64_t word = 0;
  bool is_error = false;
  bool operator==(const answer&) const = default;
};

answer answer_of(function f, const std::array<std::int64_t, 3>& in) {
  answer result;
  try {
    f(in.data(), &result.word);
  } catch (const ptx::trapped&) {
    return {0, true};
  } catch (const std::logic_error&) {
    return {0, true};
  } catch (const std::runtime_error&) {
    return {0, true};
  }
  return result;
}

/// Words of all sizes, with many zeros and ones beside each other.
std::int64_t next_word(std::uint64_t& state) {
  state = state * 6364136223846793005 + 1442695040888963407;
  const std::uint64_t mixed = (state ^ state >> 33) * 0xff51afd7ed558ccd;
  const auto kept = static_cast<int>(mixed & 63);
  const auto word = static_cast<std::int64_t>(mixed << 1 ^ mixed >> 29) >> kept;
  return mixed >> 63 != 0 ? word : static_cast<std::int64_t>(std::uint64_t{1} << kept) - (word & 3);
}

}  // namespace

int main() {
  constexpr int cases = 3000;
  int wrong = 0;
  std::uint64_t state = 1994;
  for (const kernel& k : kernels) {
    for (int i = 0; i < cases; ++i) {
      const std::array in{next_word(state), next_word(state), next_word(state)};
      answer there;
      try {
        there = answer_of(k.there, in);
      } catch (std::uint64_t address) {
        std::printf("%s reads from address %llu, where the GPU has nothing\n", k.name,
                    static_cast<unsigned long long>(address));
        ++wrong;
        break;
      }
      const answer here = answer_of(k.here, in);
      if (there == here) continue;
      std::printf("%s of %llx, %llx, %llx is %llx%s on this processor, and %llx%s on the GPU\n",
                  k.name, static_cast<unsigned long long>(in[0]),
                  static_cast<unsigned long long>(in[1]), static_cast<unsigned long long>(in[2]),
                  static_cast<unsigned long long>(here.word), here.is_error ? " (an error)" : "",
                  static_cast<unsigned long long>(there.word), there.is_error ? " (a trap)" : "");
      ++wrong;
      break;
    }
  }
  if (wrong == 0) std::printf("%zu kernels agree on %d cases each\n", std::size(kernels), cases);
  return wrong == 0 ? 0 : 1;
}
