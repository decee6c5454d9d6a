// Without FIXPROOF_RECORD, the recorded type is the type itself, and a log is no file.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <type_traits>

#include "tests/fixed/record/either.hpp"
#include "tests/support/scratch_folder.hpp"

namespace {

using namespace fixproof;

static_assert(std::is_same_v<recorded<q16_16>, q16_16>);
static_assert(std::is_empty_v<record::log>);

TEST(RecordingThatIsOff, GivesTheSameResultAndWritesNothing) {
  const ScratchFolder folder;
  const std::string path = folder.path("off.log");
  EXPECT_EQ(recorder_test::run_either(path), q16_16(6.5).raw());
  EXPECT_FALSE(std::filesystem::exists(path));
  EXPECT_EQ(record::where(), record::position());
}

}  // namespace
