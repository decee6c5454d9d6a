#include "support/output_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <thread>

#include "support/interrupt.hpp"

namespace fixproof::support {

namespace {

constexpr int write_flags = O_WRONLY | O_NOFOLLOW | O_NOCTTY | O_CLOEXEC;

// NOLINTBEGIN(cppcoreguidelines-pro-type-vararg): fcntl() and openat() are variadic
/// Opens a pipe when it has a reader, or a device. A plain open would wait through an interrupt.
Descriptor open_special(const Place& place) {
  Descriptor opened(::openat(place.folder(), place.name().c_str(), write_flags | O_NONBLOCK));
  while (!opened.is_open() && errno == ENXIO && !Interrupt::flag()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    opened = Descriptor(::openat(place.folder(), place.name().c_str(), write_flags | O_NONBLOCK));
  }
  if (opened.is_open()) ::fcntl(opened.number(), F_SETFL, 0);
  return opened;
}

}  // namespace

OutputFile::OutputFile(const std::string& path, Use use) : place_(path) {
  const std::optional<struct stat> file = place_.check_writable();
  if (!place_.open_descriptor() && (!file || S_ISREG(file->st_mode))) {
    lock_.emplace(place_);
    const PartFile can_be_made(place_);
  } else if (use == Use::overwriting) {
    place_.refuse("this is not a regular file; name another");
  }
}

void OutputFile::begin() {
  if (part_ || special_.is_open()) return;
  if (lock_) {
    part_.emplace(place_);
    return;
  }
  special_ = place_.open_descriptor()
                 ? Descriptor(::fcntl(*place_.open_descriptor(), F_DUPFD_CLOEXEC, 0))
                 : open_special(place_);
  // NOLINTEND(cppcoreguidelines-pro-type-vararg)
  if (special_.is_open()) return;
  if (errno == ENXIO) place_.refuse("interrupted before a reader opened the pipe");
  place_.refuse(errno);
}

void OutputFile::append(std::string_view bytes) {
  begin();
  if (part_) return part_->append(bytes);
  if (const int error = special_.append(bytes)) place_.refuse(error);
}

void OutputFile::overwrite(std::uint32_t offset, std::string_view bytes) {
  begin();
  part_.value().overwrite(offset, bytes);
}

void OutputFile::finish() {
  begin();
  if (part_) {
    part_->finish();
    part_.reset();
    return;
  }
  if (const int error = special_.flush()) place_.refuse(error);
  special_ = Descriptor();
}

void OutputFile::replace(std::string_view contents) {
  part_.reset();  // what an earlier replacement that failed has written
  append(contents);
  finish();
}

}  // namespace fixproof::support
