/// @file
/// Cases of our own in the format of SingleStepTests, their states taken from the processor.
#pragma once

#include <string>
#include <vector>

namespace vectors {

struct File {
  std::string name;
  std::string text;  ///< JSON, one case a line
  bool compressed;   ///< whether it is kept as gzip
};

/// All files, the same every time but for flags that are undefined: those are the processor's own.
/// Every encoding that `fixproof step --singlestep` takes, each processor's divide error, and every
/// reason to skip are among the cases.
std::vector<File> make_files();

/// Writes a file as it is kept.
/// @throws std::runtime_error where it cannot be written
void write(const std::string& path, const File& file);

}  // namespace vectors
