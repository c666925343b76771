// SPDX-License-Identifier: MIT
// Bytes of NumPy files: arrays, and zips of them, stored or as a deflate stream of stored blocks.
#ifndef SINEW_TESTS_NUMPY_BYTES_HPP
#define SINEW_TESTS_NUMPY_BYTES_HPP

#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

namespace sinew::test {

inline std::string little(size_t value, size_t bytes) {
  std::string out;
  for (size_t i = 0; i < bytes; ++i, value >>= 8) out += static_cast<char>(value & 255);
  return out;
}

inline std::string npy_of(const std::string& type, const std::string& shape, const std::string& data) {
  std::string header = "{'descr': '" + type + "', 'fortran_order': False, 'shape': " + shape + ", }";
  while ((header.size() + 11) % 64 != 0) header += ' ';
  header += '\n';
  return std::string("\x93NUMPY\x01\x00", 8) + little(header.size(), 2) + header + data;
}
template <class T>
std::string npy_of(const std::string& shape, const std::vector<T>& values) {
  std::string data(values.size() * sizeof(T), '\0');
  if (!values.empty()) std::memcpy(data.data(), values.data(), data.size());
  return npy_of(sizeof(T) == 8 ? "<f8" : "<f4", shape, data);
}

using ZipFiles = std::vector<std::pair<std::string, std::string>>;
inline std::string zip_of(const ZipFiles& files, bool deflated = false) {
  std::string bytes, directory;
  for (const auto& [name, content] : files) {
    std::string packed = content;
    if (deflated) {
      packed.clear();
      for (size_t at = 0; at == 0 || at < content.size(); at += 65535) {
        const std::string block = content.substr(at, 65535);
        packed += std::string(1, at + 65535 >= content.size() ? '\1' : '\0') + little(block.size(), 2) +
                  little(~block.size() & 65535, 2) + block;
      }
    }
    const std::string common = little(0, 2) + little(deflated ? 8 : 0, 2) + little(0, 8) + little(packed.size(), 4) +
                               little(content.size(), 4) + little(name.size(), 2) + little(0, 2);
    directory += "PK\1\2" + little(20, 2) + little(20, 2) + common + little(0, 10) + little(bytes.size(), 4) + name;
    bytes += "PK\3\4" + little(20, 2) + common + name + packed;
  }
  return bytes + directory + "PK\5\6" + little(0, 4) + little(files.size(), 2) + little(files.size(), 2) +
         little(directory.size(), 4) + little(bytes.size(), 4) + little(0, 2);
}

}  // namespace sinew::test
#endif
