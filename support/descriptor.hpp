/// @file
/// Owns a file descriptor, and closes those of others.
#pragma once

#include <cstdint>
#include <string_view>
#include <utility>

namespace fixproof::support {

/// Closes its descriptor when it ends. A negative number means none.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor();

  [[nodiscard]] bool is_open() const { return number_ >= 0; }
  [[nodiscard]] int number() const { return number_; }

  /// Writes all bytes at the current position. @return 0, or the error number
  [[nodiscard]] int append(std::string_view bytes) const;

  /// Writes all bytes at `offset`. @return 0, or the error number
  [[nodiscard]] int overwrite(std::uint32_t offset, std::string_view bytes) const;

  /// Flushes to disk. File systems that cannot flush are no error. @return 0, or the error number
  [[nodiscard]] int flush() const;

 private:
  int number_;
};

enum class Closing {
  now,
  at_exec,  ///< when this process becomes another program
};

/// Closes the open descriptors from `first` to `last`; up to 4095 on a system without
/// close_range(). May be called between fork() and exec(): it allocates no memory.
void close_descriptors(unsigned first, unsigned last, Closing when);

}  // namespace fixproof::support
