#include "support/output_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>

namespace fixproof::support {

OutputFile::OutputFile(const std::string& path, Use use) : place_(path) {
  const std::optional<struct stat> file = place_.check_writable();
  if (!place_.open_descriptor() && (!file || S_ISREG(file->st_mode))) {
    lock_.emplace(place_);
    const PartFile can_be_made(place_);
  } else if (use == Use::overwriting) {
    place_.refuse("not a regular file");
  }
}

void OutputFile::begin() {
  if (part_ || special_.is_open()) return;
  if (lock_) {
    part_.emplace(place_);
    return;
  }
  // NOLINTBEGIN(cppcoreguidelines-pro-type-vararg): fcntl() and openat() are variadic
  special_ =
      Descriptor(place_.open_descriptor() ? ::fcntl(*place_.open_descriptor(), F_DUPFD_CLOEXEC, 0)
                                          : ::openat(place_.folder(), place_.name().c_str(),
                                                     O_WRONLY | O_NOFOLLOW | O_NOCTTY | O_CLOEXEC));
  // NOLINTEND(cppcoreguidelines-pro-type-vararg)
  if (!special_.is_open()) place_.refuse(errno);
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
