/// @file
/// Descriptors of the local table and memory below 4 GiB, for code of 16 and 32 bits. Linux on
/// x86-64 only.
#pragma once

#include <boost/noncopyable.hpp>
#include <cstddef>
#include <cstdint>
#include <system_error>

namespace fixproof::machine_code {

/// The error of the last system call.
std::system_error refused(const char* what);

/// Tells whether shadow stacks (arch_prctl(2), Linux 6.6) are switched on. They hold 64-bit return
/// addresses only.
bool has_shadow_stack();

/// Writes the low `bytes` bytes of a value, little-endian.
void put(std::uint8_t* to, std::uint32_t value, int bytes);
/// Writes a far jump for code of 16 or 32 bits, with an offset as wide as the code.
void put_far_jump(std::uint8_t* to, std::uint32_t offset, std::uint16_t selector, int bits = 32);

enum class SegmentUse : std::uint8_t {
  data,
  code,
  unreadable_code,  ///< may only be executed
};

/// An entry of the process's descriptor table, with user privilege.
class Descriptor : private boost::noncopyable {
 public:
  /// @param bytes the length of the segment, at most 1 MiB
  /// @param bits  16 or 32: the default operand size of code, and the width of the stack pointer
  /// @throws std::system_error if the system provides no entry, or one that is without effect
  Descriptor(std::uint32_t base, SegmentUse use, std::size_t bytes, int bits = 16);
  ~Descriptor();

  [[nodiscard]] std::uint16_t selector() const;

 private:
  unsigned entry_;
};

/// Memory at a random address below 4 GiB: a segment, then a page of landing code and a page for
/// the Landing.
class LowMemory : private boost::noncopyable {
 public:
  /// @param segment_bytes a multiple of the page size
  /// @throws std::system_error if the system provides no memory
  explicit LowMemory(std::size_t segment_bytes);
  ~LowMemory();

  [[nodiscard]] std::uint8_t* at(std::size_t offset) const;
  [[nodiscard]] std::uint32_t address_of(std::size_t offset) const;
  /// @param rights as for mprotect(2)
  /// @throws std::system_error if the system rejects them
  void protect(std::size_t offset, std::size_t size, int rights) const;
  /// Copies the landing code to its page, with a far jump to it at exit_jump(). The page then is
  /// read-only.
  void put_landing_code() const;

  [[nodiscard]] std::size_t landing_code() const { return segment_bytes_; }
  /// Returns where 32-bit code starts that jumps to the landing code: exit_jump_bytes bytes.
  [[nodiscard]] std::size_t exit_jump() const;
  static constexpr std::size_t exit_jump_bytes = 7;
  [[nodiscard]] std::size_t landing() const;

 private:
  [[nodiscard]] std::size_t bytes() const;

  std::size_t segment_bytes_;
  void* first_;
};

}  // namespace fixproof::machine_code
