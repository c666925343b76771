// SPDX-License-Identifier: MIT
// A zip by its directory at the end: files that are stored or deflated (zlib).
#include <cstring>

#include "motion/npy.hpp"
#include "sinew_formats/error.hpp"
#include "text/text_lines.hpp"
#ifdef SINEW_HAS_ZLIB
#include <zlib.h>
#endif

namespace sinew {
namespace {

constexpr size_t kMostBytes = size_t{1} << 30, kMostRatio = 1100;  // deflate makes a byte of 1032 at best
constexpr size_t kEnd = 22, kEntry = 46, kLocal = 30;              // lengths of records without their names

class Unzipper {
 public:
  Unzipper(const std::string& path, const std::vector<uint8_t>& bytes) : path_(path), bytes_(bytes) {}

  std::map<std::string, std::vector<uint8_t>> read() {
    const size_t end = find_end();
    size_t at = number(end + 16, 4);
    std::map<std::string, std::vector<uint8_t>> files;
    for (size_t left = number(end + 10, 2); left > 0; --left) {
      if (number(at, 4) != 0x02014b50) fail("an entry of the directory", "other bytes");
      const size_t name_length = number(at + 28, 2);
      need(at + kEntry, name_length);
      const std::string name(reinterpret_cast<const char*>(&bytes_[at + kEntry]), name_length);
      files[name] = content(at, name);
      at += kEntry + name_length + number(at + 30, 2) + number(at + 32, 2);
    }
    return files;
  }

 private:
  [[noreturn]] void fail(const std::string& expected, const std::string& found) const {
    throw Error(path_ + ": expected " + expected + ", found " + found);
  }
  void need(size_t at, size_t count) const {
    if (at > bytes_.size() || count > bytes_.size() - at)
      throw Error(path_ + ": truncated zip, expected " + std::to_string(count) + " bytes at " + std::to_string(at) +
                  ", found the end of the file");
  }
  size_t number(size_t at, size_t count) const {
    need(at, count);
    size_t value = 0;
    for (size_t i = 0; i < count; ++i) value |= static_cast<size_t>(bytes_[at + i]) << (8 * i);
    return value;
  }

  size_t find_end() const {
    for (size_t i = kEnd; i <= bytes_.size() && i <= kEnd + 65535; ++i)
      if (number(bytes_.size() - i, 4) == 0x06054b50) return bytes_.size() - i;
    fail("a zip with its directory at the end", "none");
  }

  std::vector<uint8_t> content(size_t entry, const std::string& name) const {
    const size_t method = number(entry + 10, 2), packed = number(entry + 20, 4), size = number(entry + 24, 4);
    const size_t local = number(entry + 42, 4);
    if (number(local, 4) != 0x04034b50)
      fail("the file " + in_quotes(name) + " where the directory says", "other bytes");
    if (packed == 0xffffffff || size > kMostBytes || size > kMostRatio * packed + 64)
      fail("at most " + std::to_string(kMostBytes) + " bytes in " + in_quotes(name),
           std::to_string(size) + " of " + std::to_string(packed));
    const size_t begin = local + kLocal + number(local + 26, 2) + number(local + 28, 2);
    need(begin, packed);
    if (method == 8) return inflated(name, begin, packed, size);
    if (method != 0 || packed != size)
      fail("files that are stored or deflated", "method " + std::to_string(method) + " in " + in_quotes(name));
    return {bytes_.begin() + static_cast<std::ptrdiff_t>(begin),
            bytes_.begin() + static_cast<std::ptrdiff_t>(begin + size)};
  }

#ifdef SINEW_HAS_ZLIB
  std::vector<uint8_t> inflated(const std::string& name, size_t begin, size_t packed, size_t size) const {
    std::vector<uint8_t> out(size + 1);  // one more, to see that there is none
    z_stream stream = {};
    stream.next_in = const_cast<Bytef*>(bytes_.data() + begin);
    stream.avail_in = static_cast<uInt>(packed);
    stream.next_out = out.data();
    stream.avail_out = static_cast<uInt>(out.size());
    const bool begun = inflateInit2(&stream, -MAX_WBITS) == Z_OK;
    const bool whole = begun && inflate(&stream, Z_FINISH) == Z_STREAM_END && stream.total_out == size;
    inflateEnd(&stream);
    if (!whole) fail(std::to_string(size) + " bytes in " + in_quotes(name), "broken or other data");
    out.resize(size);
    return out;
  }
#else
  std::vector<uint8_t> inflated(const std::string& name, size_t, size_t, size_t) const {
    throw Error(
        path_ + ": cannot read " + in_quotes(name) +
        ", which is compressed: this sinew was built without zlib (SINEW_WITH_ZLIB); save it with numpy.savez()");
  }
#endif

  const std::string path_;
  const std::vector<uint8_t>& bytes_;
};

}  // namespace

std::map<std::string, std::vector<uint8_t>> unzip(const std::string& path, const std::vector<uint8_t>& bytes) {
  return Unzipper(path, bytes).read();
}

}  // namespace sinew
