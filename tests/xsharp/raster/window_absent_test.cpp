#include "tests/support/test.hpp"
#include "xsharp/window/window.hpp"

namespace xsharp {
namespace {

TEST(AbsentWindow, IsNotAvailableAndSaysSo) {
  EXPECT_FALSE(window_available());
  EXPECT_THROW(Window("test", 32, 24), std::runtime_error);
}

}  // namespace
}  // namespace xsharp
