/// Checks batch::dot of more than 2^30 terms, after which exact sums of products begin anew.
#include <sys/mman.h>

#include "tests/fixed/batch/expected.hpp"
#include "tests/support/test.hpp"

namespace batch_test {
namespace {

// Almost all pages are the zero page, so they take no memory.
TEST(LongDots, OfMoreThanTwoToThe30Terms) {
  using N = fixproof::number<std::int16_t, 8, fixproof::policies::saturating>;
  constexpr std::size_t chunk = std::size_t{1} << 30;
  constexpr std::size_t count = chunk + 37;
  void* const memory = mmap(nullptr, count * sizeof(N), PROT_READ | PROT_WRITE,
                            MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  ASSERT_NE(memory, MAP_FAILED);
  const std::span x(static_cast<N*>(memory), count);
  for (const std::size_t i : {std::size_t{0}, chunk - 1, chunk, chunk + 1, count - 6, count - 1}) {
    x[i] = N(3);
  }
  for (const auto path : paths()) {
    EXPECT_EQ(fixproof::batch::dot(x, x, path), N(54)) << "path " << static_cast<int>(path);
  }
  munmap(memory, count * sizeof(N));
}

}  // namespace
}  // namespace batch_test
