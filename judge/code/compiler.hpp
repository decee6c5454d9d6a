/// @file
/// Compiles C and C++, and links objects of other processors with what compilers add.
#pragma once

#include <boost/noncopyable.hpp>
#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "judge/code/image.hpp"
#include "verify/proof/process.hpp"

namespace fixproof::judge {

/// A folder for temporary files; it goes with this object.
class TemporaryFolder : private boost::noncopyable {
 public:
  /// @throws support::UsageError if there is no room for it
  TemporaryFolder();
  ~TemporaryFolder();
  [[nodiscard]] std::string file(const char* name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

/// Runs a compiler and returns what it wrote.
/// @throws support::UsageError with its first message if it cannot be run or fails
proof::Output run_compiler(const std::vector<std::string>& command, const std::string& input,
                           std::chrono::milliseconds most_time);

/// Tells whether a file is C or C++ by its name.
bool is_c_source(const std::string& path);

/// Compiles a file as `$CC $CFLAGS -c` or, for C++, `$CXX $CXXFLAGS -c` would; the flags are `-O2`
/// unless the variable is set. The source is the user's own: the compiler is not confined.
/// @throws support::UsageError with the compiler's first message
std::string compiled_source(const std::string& path);

/// Links an object of a processor other than x86 with the functions that its compiler calls, such
/// as __aeabi_ldivmod. Names that no library has become names that the image lacks.
/// @throws support::UsageError naming the package that has the linker, or what the linker says
std::string linked_object(Image& image, const std::string& object);

/// Returns an object of x86 with the functions that its compiler calls, such as __divdi3, or the
/// object itself if it needs none or no library is installed.
std::string with_library_functions(const std::string& object, int bits);

/// Leaves only the names of an object's own functions.
void keep_symbols_of(Image& image, const std::string& object);

}  // namespace fixproof::judge
