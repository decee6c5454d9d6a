// usage: make_vectors FOLDER
// Writes the files of tests/vectors again, from the processor it runs on.
#include <fmt/format.h>

#include <exception>

#include "tests/vectors/files.hpp"

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "usage: make_vectors FOLDER\n");
    return 2;
  }
  try {
    for (const vectors::File& file : vectors::make_files()) {
      vectors::write(fmt::format("{}/{}", argv[1], file.name), file);
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "make_vectors: {}\n", error.what());
    return 2;
  }
}
