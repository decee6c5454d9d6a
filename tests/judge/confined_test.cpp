// The process that runs a user's code, tested with hostile native code.
#include "judge/confined.hpp"

#include <fcntl.h>
#include <unistd.h>

#include "tests/support/test.hpp"

namespace {

using fixproof::judge::Allowance;
using fixproof::judge::Calls;
using fixproof::judge::Confined;
using fixproof::judge::Downfall;
using std::chrono::milliseconds;

constexpr std::size_t memory = std::size_t{1} << 26U;

// A busy machine may not run the child for seconds.
Downfall downfall_of(const Confined::Serve& serve, milliseconds time = milliseconds(30'000)) {
  Confined child([&serve](Confined::Steps&) { return serve; }, memory);
  return child.ask("request", time).downfall;
}

TEST(Confined, ServesRequestAfterRequest) {
  Confined child(
      [](Confined::Steps& steps) {
        return [&steps](std::string_view request) {
          ++steps;
          return std::string(request) + "!";
        };
      },
      memory);
  for (const char* text : {"one", "two"}) {
    EXPECT_EQ(child.ask(text, milliseconds(30'000)).bytes, std::string(text) + "!");
    EXPECT_EQ(child.steps(), 1U);
  }
  EXPECT_TRUE(child.is_alive());
}

TEST(Confined, OpensNoFile) {
  EXPECT_EQ(
      downfall_of([](std::string_view) { return std::to_string(open("/dev/null", O_RDONLY)); }),
      Downfall::system_call);
}

TEST(Confined, StartsNoProcess) {
  EXPECT_EQ(downfall_of([](std::string_view) { return std::to_string(fork()); }),
            Downfall::system_call);
}

TEST(Confined, HasLittleMemory) {
#ifdef JUDGE_SANITIZED
  GTEST_SKIP() << "AddressSanitizer ends the process before it throws";
#endif
  EXPECT_EQ(downfall_of([](std::string_view) { return std::string(16 * memory, 'x'); }),
            Downfall::out_of_memory);
}

TEST(Confined, HasLittleTime) {
  const auto serve = [](std::string_view) {
    // Volatile, because the compiler may assume that a loop without effects ends.
    for (volatile bool goes_on = true; goes_on;) {
    }
    return std::string();
  };
  EXPECT_EQ(downfall_of(serve, milliseconds(500)), Downfall::out_of_time);
}

TEST(Confined, ACrashIsNoReply) {
  EXPECT_EQ(downfall_of([](std::string_view) -> std::string { __builtin_trap(); }),
            Downfall::crashed);
}

}  // namespace
