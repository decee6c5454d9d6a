#include "verify/singlestep/gunzip.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <memory>
#include <new>
#include <string_view>
#include <vector>

#include "support/usage_error.hpp"

namespace fixproof::singlestep {

std::string gunzip(std::string contents) {
  constexpr std::string_view magic = "\x1f\x8b";
  constexpr std::size_t max_size = std::size_t{256} << 20U;
  if (!contents.starts_with(magic)) return contents;

  // gzread() would ignore data after the last member.
  z_stream stream{};
  constexpr int gzip_only = 16;
  if (inflateInit2(&stream, MAX_WBITS + gzip_only) != Z_OK) throw std::bad_alloc();
  const std::unique_ptr<z_stream, int (*)(z_stream*)> owner(&stream, inflateEnd);
  // read_file() returns at most 256 MiB, so the size fits.
  stream.next_in = reinterpret_cast<const Bytef*>(  // NOLINT(*-reinterpret-cast): zlib's bytes
      contents.data());
  stream.avail_in = static_cast<uInt>(contents.size());

  std::string text;
  std::vector<Bytef> buffer(65536);
  while (true) {
    stream.next_out = buffer.data();
    stream.avail_out = static_cast<uInt>(buffer.size());
    const int status = inflate(&stream, Z_NO_FLUSH);
    const bool no_output = stream.next_out == buffer.data();
    text.append(buffer.data(), stream.next_out);
    if (text.size() > max_size) throw support::UsageError("more than 256 MiB when decompressed");
    if (status == Z_STREAM_END) {
      if (stream.avail_in == 0) return text;
      inflateReset(&stream);  // Starts the next member. inflate() reports anything else.
    } else if (status == Z_BUF_ERROR || (status == Z_OK && stream.avail_in == 0 && no_output)) {
      throw support::UsageError(fmt::format("gzip data cut short at byte {}", contents.size()));
    } else if (status != Z_OK) {
      throw support::UsageError(
          fmt::format("damaged gzip data at byte {}", contents.size() - stream.avail_in));
    }
  }
}

}  // namespace fixproof::singlestep
