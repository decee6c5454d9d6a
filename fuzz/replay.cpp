// Runs a target without a fuzzer on the named files and on all files in the named folders. Exits
// with status 0 if all pass, and with status 2 if a file is missing or unreadable.
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

void replay(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) {
    throw std::runtime_error("cannot read " + file.string() + ": " +
                             std::generic_category().message(errno));
  }
  const std::vector<char> bytes{std::istreambuf_iterator<char>(in), {}};
  const std::vector<std::uint8_t> input(bytes.begin(), bytes.end());
  std::fprintf(stderr, "%s\n", file.c_str());
  LLVMFuzzerTestOneInput(input.data(), input.size());
}

std::size_t replay_all(const std::filesystem::path& place) {
  if (!std::filesystem::is_directory(place)) {
    replay(place);
    return 1;
  }
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(place)) {
    if (!entry.is_regular_file()) continue;
    replay(entry.path());
    ++files;
  }
  return files;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2 || std::string_view(argv[1]).starts_with('-')) {
    std::fprintf(stderr,
                 "usage: %s FILE|FOLDER...\nGives the target every file, and all in a folder.\n",
                 argv[0]);
    return 2;
  }
  std::size_t files = 0;
  try {
    for (int i = 1; i < argc; ++i) files += replay_all(argv[i]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "replay: %s\n", error.what());
    return 2;
  }
  std::printf("%zu inputs\n", files);
  return files > 0 ? 0 : 2;
}
