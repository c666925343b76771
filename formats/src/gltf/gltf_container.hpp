// SPDX-License-Identifier: MIT
// A glTF file taken apart into its JSON and the bytes of its buffers, and put together again.
#ifndef SINEW_FORMATS_GLTF_GLTF_CONTAINER_HPP
#define SINEW_FORMATS_GLTF_GLTF_CONTAINER_HPP

#include <cstddef>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace sinew {

// The little-endian number at `at`.
inline uint32_t read_u32(const std::vector<uint8_t>& bytes, size_t at) {
  return static_cast<uint32_t>(bytes[at]) | static_cast<uint32_t>(bytes[at + 1]) << 8 |
         static_cast<uint32_t>(bytes[at + 2]) << 16 | static_cast<uint32_t>(bytes[at + 3]) << 24;
}

// The JSON text of a GLB or .gltf; empty when a GLB's header promises more than there is.
std::string_view gltf_text(const std::vector<uint8_t>& file);

// Bytes of every buffer of a parsed document: the GLB's chunk, data URIs, files beside `path`. Buffers for readers
// without a compression (`fallback` in its extension, no uri) are empty. Throws Error naming `path` and the buffer.
std::vector<std::vector<uint8_t>> load_buffers(const std::string& path, const std::vector<uint8_t>& file,
                                               const nlohmann::json& document);

// One GLB of a document whose buffer 0 holds `bytes`; sets that buffer's byteLength. Throws Error naming `path` above
// 4 GiB, json::exception when a name is not UTF-8.
std::vector<uint8_t> pack_glb(const std::string& path, nlohmann::json* document, std::vector<uint8_t> bytes);

// File names as glTF's URIs and back (RFC 3986: what is not unreserved is %HH).
inline std::string percent_encoded(const std::string& name) {
  static const char kHex[] = "0123456789ABCDEF";
  std::string out;
  for (const char c : name) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
                       c == '.' || c == '_' || c == '~';
    const unsigned char byte = static_cast<unsigned char>(c);
    if (plain)
      out += c;
    else
      out.append({'%', kHex[byte >> 4], kHex[byte & 15]});
  }
  return out;
}

// A '%' that no two digits follow stays.
inline std::string percent_decoded(const std::string& uri) {
  const auto digit = [&](size_t at) {
    const char c = at < uri.size() ? uri[at] : '\0';
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
  };
  std::string out;
  for (size_t i = 0; i < uri.size(); ++i) {
    if (uri[i] == '%' && digit(i + 1) >= 0 && digit(i + 2) >= 0) {
      out += static_cast<char>(digit(i + 1) * 16 + digit(i + 2));
      i += 2;
    } else {
      out += uri[i];
    }
  }
  return out;
}

}  // namespace sinew
#endif
