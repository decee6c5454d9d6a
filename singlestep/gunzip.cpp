#include "singlestep/gunzip.hpp"

#include <zlib.h>

#include <array>
#include <new>
#include <string_view>

#include "support/usage_error.hpp"

namespace fixproof::singlestep {

namespace {

constexpr std::size_t most_decompressed = std::size_t{256} << 20U;
constexpr std::string_view magic = "\x1f\x8b";

/// zlib's state for reading gzip members, one after the other.
class Inflater {
 public:
  explicit Inflater(std::string_view compressed) {
    constexpr int gzip_only = 16;
    if (inflateInit2(&stream_, MAX_WBITS + gzip_only) != Z_OK) throw std::bad_alloc();
    // The input is a file of at most 256 MiB: its size fits.
    stream_.next_in = reinterpret_cast<const Bytef*>(  // NOLINT(*-reinterpret-cast): zlib's bytes
        compressed.data());
    stream_.avail_in = static_cast<uInt>(compressed.size());
  }
  ~Inflater() { inflateEnd(&stream_); }
  Inflater(const Inflater&) = delete;
  Inflater(Inflater&&) = delete;
  Inflater& operator=(const Inflater&) = delete;
  Inflater& operator=(Inflater&&) = delete;

  std::string all() {
    std::string text;
    while (true) {
      stream_.next_out = buffer_.data();
      stream_.avail_out = static_cast<uInt>(buffer_.size());
      const int status = inflate(&stream_, Z_NO_FLUSH);
      const std::size_t made = buffer_.size() - stream_.avail_out;
      text.append(buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(made));
      if (text.size() > most_decompressed)
        throw support::UsageError("decompressed, more than 256 MiB");
      if (status == Z_STREAM_END) {
        if (stream_.avail_in == 0) return text;
        // Another member may follow; anything else is refused there.
        if (inflateReset(&stream_) != Z_OK) throw support::UsageError("damaged gzip data");
      } else if (status == Z_BUF_ERROR || (status == Z_OK && stream_.avail_in == 0 && made == 0)) {
        throw support::UsageError("gzip data cut short");
      } else if (status != Z_OK) {
        throw support::UsageError("damaged gzip data");
      }
    }
  }

 private:
  z_stream stream_{};
  std::array<Bytef, 65536> buffer_{};
};

}  // namespace

std::string gunzip(std::string contents) {
  if (!contents.starts_with(magic)) return contents;
  return Inflater(contents).all();
}

}  // namespace fixproof::singlestep
