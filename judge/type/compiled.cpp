#include "judge/type/compiled.hpp"

#include <fmt/format.h>
#include <stdlib.h>  // NOLINT(modernize-deprecated-headers): mkdtemp() is POSIX's

#include <boost/noncopyable.hpp>
#include <chrono>
#include <filesystem>
#include <system_error>

#include "support/bounded_file.hpp"
#include "support/usage_error.hpp"
#include "verify/proof/process.hpp"

namespace fixproof::judge {

namespace {

using support::UsageError;

/// All goals take some 10 s.
constexpr std::chrono::minutes most_time{10};
constexpr std::size_t most_bytes = std::size_t{16} << 20U;

/// A folder for the object; it goes when this ends.
class Folder : private boost::noncopyable {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "fixproof.XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) {
      throw UsageError(fmt::format("no folder can be created in {}",
                                   std::filesystem::temp_directory_path().string()));
    }
    path_ = name;
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  [[nodiscard]] std::string file(const char* name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

proof::Output output_of(const std::vector<std::string>& command, const std::string& input) {
  try {
    proof::Output output = proof::run_program(command, input, most_time);
    if (output.in_time && output.status == 0) return output;
    // The first message: the others follow from it.
    throw UsageError(fmt::format("{} {} {}", command.front(),
                                 output.in_time ? "fails:" : "does not end",
                                 output.err.substr(0, output.err.find('\n'))));
  } catch (const std::system_error& error) {
    throw UsageError(fmt::format("{} cannot be run: {}", command.front(), error.code().message()));
  } catch (const proof::Killed& killed) {
    throw UsageError(fmt::format("{}: {}", command.front(), killed.what()));
  }
}

}  // namespace

std::string compiled(const Compilation& how, std::span<const Goal> goals) {
  const Folder folder;
  const std::string object = folder.file("type.o");
  // Freestanding, an error is UD2 and no code of the C++ library. The arithmetic is the same.
  output_of({how.compiler, "-std=c++20", "-ffreestanding", "-fno-exceptions", how.level, "-I",
             how.headers, "-c", "-x", "c++", "-", "-o", object},
            source_of(goals));
  return support::read_bounded(object, most_bytes);
}

std::string version_of(const std::string& compiler) {
  const std::string text = output_of({compiler, "--version"}, "").out;
  return text.substr(0, text.find('\n'));
}

}  // namespace fixproof::judge
