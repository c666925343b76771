// SPDX-License-Identifier: MIT
// File names as glTF's URIs and back (RFC 3986: what is not unreserved is %HH).
#ifndef SINEW_FORMATS_GLTF_GLTF_URI_HPP
#define SINEW_FORMATS_GLTF_GLTF_URI_HPP

#include <cstddef>
#include <string>

namespace sinew {

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
