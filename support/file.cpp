#include "support/file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <system_error>

#include "support/descriptor.hpp"
#include "support/output_file.hpp"
#include "support/place.hpp"

namespace fixproof::support {

void replace_file(const std::string& path, std::string_view contents) {
  OutputFile(path).replace(contents);
}

bool same_file(const std::string& a, const std::string& b) {
  // Hard links have different paths.
  std::error_code error;
  if (std::filesystem::equivalent(a, b, error)) return true;
  const std::optional<Place> place_a = find_place(a);
  const std::optional<Place> place_b = find_place(b);
  // Of files that do not exist yet.
  return place_a && place_b && place_a->name() == place_b->name() &&
         std::filesystem::equivalent(place_a->folder_path(), place_b->folder_path(), error);
}

std::string read_file(const std::string& path) {
  constexpr std::size_t max_read = std::size_t{256} << 20U;
  const auto refuse = [&path](int error) {
    throw std::runtime_error(
        fmt::format("cannot read {}: {}", path, std::generic_category().message(error)));
  };
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): open() is variadic
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file.is_open()) refuse(errno);
  std::string contents;
  std::array<char, 65536> buffer{};
  for (;;) {
    const ssize_t got = ::read(file.number(), buffer.data(), buffer.size());
    if (got == 0) return contents;
    if (got > 0) {
      contents.append(buffer.data(), static_cast<std::size_t>(got));
      if (contents.size() > max_read) refuse(EFBIG);
    } else if (errno != EINTR) {
      refuse(errno);
    }
  }
}

}  // namespace fixproof::support
