#include "verify/machine_code/low_memory.hpp"

#if defined(__linux__) && defined(__x86_64__) && !defined(__ILP32__)

#include <asm/ldt.h>
#include <sys/mman.h>
#include <sys/random.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <bitset>
#include <cerrno>
#include <mutex>

#include "verify/machine_code/enter_segment.hpp"
#include "verify/machine_code/faults.hpp"
#include "verify/machine_code/segment.hpp"

namespace fixproof::machine_code {

std::system_error refused(const char* what) { return {errno, std::generic_category(), what}; }

bool has_shadow_stack() {
  constexpr int arch_shstk_status = 0x5005;
  std::uint64_t features = 0;
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): the C library has no function for it
  return syscall(SYS_arch_prctl, arch_shstk_status, &features) == 0 && features != 0;
}

void put(std::uint8_t* to, std::uint32_t value, int bytes) {
  for (int i = 0; i < bytes; ++i) to[i] = static_cast<std::uint8_t>(value >> (8 * i) & 0xFFU);
}

void put_far_jump(std::uint8_t* to, std::uint32_t offset, std::uint16_t selector, int bits) {
  *to++ = 0xEA;
  put(to, offset, bits / 8);
  put(to + bits / 8, selector, 2);
}

namespace {

/// @return false if the system rejects the descriptor
bool write_descriptor(user_desc description) {
  constexpr int write_in_new_format = 0x11;
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): as above
  return syscall(SYS_modify_ldt, write_in_new_format, &description, sizeof description) == 0;
}

/// The entries of the process's descriptor table, allocated to its threads.
class Entries {
 public:
  unsigned take() {
    const std::lock_guard lock(mutex_);
    for (unsigned i = 0; i < used_.size(); ++i) {
      if (used_[i]) continue;
      used_[i] = true;
      return i;
    }
    throw std::system_error(ENOSPC, std::generic_category(), "descriptors");
  }
  void give_back(unsigned entry) {
    const std::lock_guard lock(mutex_);
    used_[entry] = false;
  }

 private:
  std::mutex mutex_;
  std::bitset<LDT_ENTRIES> used_;
};

Entries& entries() {
  static Entries all;
  return all;
}

/// Maps memory at a random page. MAP_32BIT would choose among 13 bits of addresses, which code in
/// the memory could guess.
void* map_low(std::size_t bytes) {
  constexpr std::uint32_t least_page = 0x10;  // the system reserves what is below 64 KiB
  constexpr std::uint32_t pages = 1U << 20U;
  const auto end = pages - static_cast<std::uint32_t>((bytes + page_size - 1) / page_size);
  constexpr int most_tries = 100;  // AddressSanitizer keeps half of the pages
  for (int i = 0; i < most_tries; ++i) {
    std::uint32_t random = 0;
    if (getrandom(&random, sizeof random, 0) != sizeof random) throw refused("getrandom");
    const std::uintptr_t first = (least_page + random % (end - least_page)) * page_size;
    // NOLINTNEXTLINE(*-reinterpret-cast,performance-no-int-to-ptr): mmap() takes addresses so
    void* const wanted = reinterpret_cast<void*>(first);
    void* const got = mmap(wanted, bytes, PROT_READ | PROT_WRITE,
                           MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED_NOREPLACE, -1, 0);
    if (got == wanted) return got;
    if (got != MAP_FAILED) munmap(got, bytes);  // Linux before 4.17 takes the address as a hint
  }
  throw refused("mmap");
}

/// Whether the processor has the segment of a selector, now: not before the call that makes it.
bool is_there(std::uint16_t selector) {
  bool found = false;
  asm volatile("lar %1, %%eax" : "=@ccz"(found) : "r"(std::uint32_t{selector}) : "eax", "memory");
  return found;
}

}  // namespace

Descriptor::Descriptor(std::uint32_t base, SegmentUse use, std::size_t bytes, int bits)
    : entry_(entries().take()) {
  user_desc d{};
  d.entry_number = entry_;
  d.base_addr = base;
  d.limit = static_cast<unsigned>(bytes - 1);
  d.contents = use == SegmentUse::data ? MODIFY_LDT_CONTENTS_DATA : MODIFY_LDT_CONTENTS_CODE;
  d.read_exec_only = use == SegmentUse::unreadable_code ? 1 : 0;
  d.seg_32bit = bits == 32 ? 1 : 0;
  d.useable = 1;
  if (!write_descriptor(d)) {
    const int reason = errno;
    entries().give_back(entry_);
    throw std::system_error(reason, std::generic_category(), "modify_ldt");
  }
  // Some virtual machines keep a table that the processor never gets.
  if (!is_there(selector())) {
    entries().give_back(entry_);
    throw std::system_error(ENOTSUP, std::generic_category(),
                            "modify_ldt makes segments that the processor does not have");
  }
}

Descriptor::~Descriptor() {
  // An entry that cannot be cleared stays allocated.
  user_desc empty{};
  empty.entry_number = entry_;
  empty.read_exec_only = 1;
  empty.seg_not_present = 1;
  if (write_descriptor(empty)) entries().give_back(entry_);
}

std::uint16_t Descriptor::selector() const { return static_cast<std::uint16_t>(entry_ << 3U | 7U); }

LowMemory::LowMemory(std::size_t segment_bytes)
    : segment_bytes_(segment_bytes), first_(map_low(bytes())) {}

LowMemory::~LowMemory() { munmap(first_, bytes()); }

std::uint8_t* LowMemory::at(std::size_t offset) const {
  return static_cast<std::uint8_t*>(first_) + offset;
}

std::uint32_t LowMemory::address_of(std::size_t offset) const {
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): what a descriptor holds
  return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(at(offset)));
}

void LowMemory::protect(std::size_t offset, std::size_t size, int rights) const {
  if (mprotect(at(offset), size, rights) != 0) throw refused("mprotect");
}

void LowMemory::put_landing_code() const {
  std::copy(fixproof_landing, fixproof_landing_end, at(landing_code()));
  put_far_jump(at(exit_jump()), address_of(landing_code()), code_selector_of_64_bits());
  protect(landing_code(), page_size, PROT_READ | PROT_EXEC);
}

std::size_t LowMemory::exit_jump() const { return landing_code() + page_size / 2; }

std::size_t LowMemory::landing() const { return landing_code() + landing_distance; }

std::size_t LowMemory::bytes() const { return landing() + page_size; }

}  // namespace fixproof::machine_code

#endif
