#include "xsharp/files/read_text.hpp"

#include <fstream>
#include <system_error>

#include "xsharp/scene_error.hpp"

namespace xsharp {

std::string read_text(const std::filesystem::path& file, std::size_t most) {
  // Reading a pipe or a device might never end.
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) throw SceneError("there is no such file");
  if (!std::filesystem::is_regular_file(status)) throw SceneError("not a regular file");
  std::ifstream stream(file, std::ios::binary);
  // Reads one byte more than allowed to detect a longer file.
  std::string text(most + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (stream.bad() || (stream.fail() && !stream.eof())) throw SceneError("cannot be read");
  text.resize(static_cast<std::size_t>(stream.gcount()));
  if (text.size() > most) {
    throw SceneError("longer than " + std::to_string(most >> 20U) + " MiB");
  }
  return text;
}

}  // namespace xsharp
