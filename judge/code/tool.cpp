#include "judge/code/tool.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <stdlib.h>  // NOLINT(modernize-deprecated-headers): mkstemp() is POSIX's
#include <sys/mman.h>
#include <unistd.h>
#ifdef __linux__
#include <linux/landlock.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#endif

#include <array>
#include <boost/process/search_path.hpp>
#include <cerrno>
#include <chrono>
#include <memory>
#include <system_error>

#include "judge/code/resource_limit.hpp"
#include "support/usage_error.hpp"

namespace fixproof::judge {

namespace {

using support::UsageError;

constexpr std::chrono::seconds most_time{20};
constexpr rlim_t most_processor_time = 5;
constexpr rlim_t most_memory = rlim_t{512} << 20U;
/// Of each file that the program writes, also of its messages. The code has at most 1 MiB.
constexpr rlim_t most_output = rlim_t{4} << 20U;

#ifdef __linux__

long version_of_landlock() {
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): the C library has no function for it
  return syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
}

/// The rights that a version knows. Later ones add a right each, with the next bit.
std::uint64_t all_rights(long version) {
  std::uint64_t rights = (LANDLOCK_ACCESS_FS_MAKE_SYM << 1U) - 1;
  if (version >= 2) rights |= rights + 1;  // files may be moved to another folder
  if (version >= 3) rights |= rights + 1;  // and cut off
  return rights;
}

/// What a program may do with files, as a descriptor of the kernel's.
class Rules {
 public:
  explicit Rules(const std::string& program, const std::string& folder) {
    const landlock_ruleset_attr handled{.handled_access_fs = all_rights(version_of_landlock())};
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): as above
    rules_ = support::Descriptor(static_cast<int>(
        syscall(SYS_landlock_create_ruleset, &handled, sizeof handled.handled_access_fs, 0)));
    if (!rules_.is_open()) throw std::system_error(errno, std::generic_category(), "landlock");
    constexpr std::uint64_t read = LANDLOCK_ACCESS_FS_READ_FILE;
    for (const char* libraries : {"/lib", "/lib64", "/usr/lib", "/usr/lib64", "/usr/local/lib"}) {
      allow(libraries, read | LANDLOCK_ACCESS_FS_EXECUTE);
    }
    allow("/etc/ld.so.cache", read);
    allow(program, read | LANDLOCK_ACCESS_FS_EXECUTE);
    if (!folder.empty()) allow(folder, read);
  }

  /// In the child. @return false if the kernel refuses
  [[nodiscard]] bool apply() const {
    // NOLINTBEGIN(cppcoreguidelines-pro-type-vararg): as above
    return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
           syscall(SYS_landlock_restrict_self, rules_.number(), 0) == 0;
    // NOLINTEND(cppcoreguidelines-pro-type-vararg)
  }

 private:
  /// Does nothing if there is no such file: not every system has each folder of libraries.
  void allow(const std::string& path, std::uint64_t rights) const {
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): open() is POSIX's
    const support::Descriptor file(open(path.c_str(), O_PATH | O_CLOEXEC));
    if (!file.is_open()) return;
    const landlock_path_beneath_attr beneath{.allowed_access = rights, .parent_fd = file.number()};
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): as above
    if (syscall(SYS_landlock_add_rule, rules_.number(), LANDLOCK_RULE_PATH_BENEATH, &beneath, 0) !=
        0) {
      throw std::system_error(errno, std::generic_category(), "landlock");
    }
  }

  support::Descriptor rules_;
};

int open_nameless() { return memfd_create("fixproof", MFD_CLOEXEC); }

#else

long version_of_landlock() { return -1; }

struct Rules {
  Rules(const std::string& /*program*/, const std::string& /*folder*/) {}
  [[nodiscard]] bool apply() const { return true; }
};

int open_nameless() {
  std::string name = "/tmp/fixproof.XXXXXX";
  const int number = mkstemp(name.data());
  if (number >= 0) unlink(name.c_str());
  return number;
}

#endif

}  // namespace

ToolFile::ToolFile(std::string_view contents) : file_(open_nameless()) {
  const int error = file_.is_open() ? file_.append(contents) : errno;
  if (error != 0) throw std::system_error(error, std::generic_category(), "a file in memory");
}

std::string ToolFile::name() const { return fmt::format("/dev/fd/{}", number()); }

std::string ToolFile::contents(std::size_t most) const {
  std::string bytes;
  std::array<char, 0x4000> room{};
  lseek(number(), 0, SEEK_SET);
  while (const ssize_t count = read(number(), room.data(), room.size())) {
    if (count < 0) throw std::system_error(errno, std::generic_category(), "a file in memory");
    bytes.append(room.data(), static_cast<std::size_t>(count));
    if (bytes.size() > most) throw UsageError(fmt::format("the output exceeds {} bytes", most));
  }
  return bytes;
}

bool confines_tools() { return version_of_landlock() > 0; }

proof::Output run_tool(const std::vector<std::string>& arguments, const std::string& input,
                       const std::string& folder, const std::vector<const ToolFile*>& files) {
  const std::string& name = arguments.front();
  try {
    std::unique_ptr<Rules> rules;
    if (confines_tools()) {
      rules = std::make_unique<Rules>(boost::process::search_path(name).string(), folder);
    }
    // Between fork() and exec(): no memory may be allocated.
    const auto confine = [&] {
      // Descriptors that this process inherited must not reach the program.
      support::close_descriptors(3, ~0U, support::Closing::at_exec);
      for (const ToolFile* file : files) fcntl(file->number(), F_SETFD, 0);
      limit(RLIMIT_CORE, 0);
      limit(RLIMIT_AS, most_memory);
      limit(RLIMIT_FSIZE, most_output);
      limit(RLIMIT_CPU, most_processor_time);
      if (rules && !rules->apply()) _exit(126);
    };
    proof::Output output = proof::run_program(arguments, input, most_time, confine);
    if (output.in_time) return output;
    throw UsageError(fmt::format("{} does not end within {} s", name, most_time.count()));
  } catch (const std::system_error& error) {
    throw UsageError(fmt::format("{} cannot be run: {}; install Debian's package nasm", name,
                                 error.code().message()));
  } catch (const proof::Killed&) {
    throw UsageError(fmt::format(
        "{} exceeds its limits: {} MiB of memory, {} MiB of output, {} s of processor time", name,
        most_memory >> 20U, most_output >> 20U, most_processor_time));
  }
}

}  // namespace fixproof::judge
