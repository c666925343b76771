// SPDX-License-Identifier: MIT
#include "core/bytes.hpp"
#include "sinew_formats/error.hpp"
#include "usd/usd_write.hpp"

namespace sinew {
namespace {

constexpr size_t kAlign = 64, kLocal = 30;
constexpr uint32_t kDay = 0x0021;  // 1980-01-01, the first that there is

class Bytes {
 public:
  void number(uint64_t value, size_t count) {
    for (size_t i = 0; i < count; ++i) bytes.push_back(static_cast<uint8_t>(value >> (8 * i)));
  }
  void text(const std::string& text) { bytes.insert(bytes.end(), text.begin(), text.end()); }

  std::vector<uint8_t> bytes;
};

// Common fields of the header of a file and its directory entry.
void add_common(const NamedBytes& file, size_t extra, Bytes* out) {
  out->number(10, 2);  // version to extract
  out->number(0, 2);   // flags
  out->number(0, 2);   // stored
  out->number(0, 2);   // time
  out->number(kDay, 2);
  out->number(crc32(0, file.bytes.data(), file.bytes.size()), 4);
  out->number(file.bytes.size(), 4);
  out->number(file.bytes.size(), 4);
  out->number(file.path.size(), 2);
  out->number(extra, 2);
}

}  // namespace

std::vector<uint8_t> usd_package(const std::string& path, const std::vector<NamedBytes>& files) {
  Bytes out, directory;
  for (const NamedBytes& file : files) {
    const size_t at = out.bytes.size();
    // An extra field has a header of 4 bytes of its own.
    size_t extra = (kAlign - (at + kLocal + file.path.size()) % kAlign) % kAlign;
    if (extra > 0 && extra < 4) extra += kAlign;
    out.number(0x04034b50, 4);
    add_common(file, extra, &out);
    out.text(file.path);
    if (extra > 0) {
      out.number(0x1986, 2);
      out.number(extra - 4, 2);
      out.bytes.resize(out.bytes.size() + extra - 4);
    }
    out.bytes.insert(out.bytes.end(), file.bytes.begin(), file.bytes.end());
    directory.number(0x02014b50, 4);
    directory.number(10, 2);  // version made by
    add_common(file, 0, &directory);
    directory.number(0, 2);  // comment
    directory.number(0, 2);  // disk
    directory.number(0, 2);  // internal attributes
    directory.number(0, 4);  // external attributes
    directory.number(at, 4);
    directory.text(file.path);
  }
  const size_t start = out.bytes.size();
  if (start + directory.bytes.size() > 0xffffffffu || files.size() > 0xffffu)
    throw Error(path + ": cannot write, expected at most 4 GiB of a zip, found " + std::to_string(start) + " bytes");
  out.bytes.insert(out.bytes.end(), directory.bytes.begin(), directory.bytes.end());
  out.number(0x06054b50, 4);
  out.number(0, 4);  // disks
  out.number(files.size(), 2);
  out.number(files.size(), 2);
  out.number(directory.bytes.size(), 4);
  out.number(start, 4);
  out.number(0, 2);  // comment
  return std::move(out.bytes);
}

}  // namespace sinew
