// SPDX-License-Identifier: MIT
// Bytes as text: base64 of RFC 4648, with padding.
#ifndef SINEW_FORMATS_BASE64_HPP
#define SINEW_FORMATS_BASE64_HPP

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

namespace sinew {

inline std::string base64(std::string_view bytes) {
  constexpr const char* kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const auto byte = [&](size_t i) { return static_cast<uint32_t>(static_cast<unsigned char>(bytes[i])); };
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (size_t i = 0; i < bytes.size(); i += 3) {
    const size_t left = std::min<size_t>(3, bytes.size() - i);
    uint32_t word = byte(i) << 16;
    if (left > 1) word |= byte(i + 1) << 8;
    if (left > 2) word |= byte(i + 2);
    for (size_t k = 0; k < 4; ++k) out += k <= left ? kLetters[(word >> (18 - 6 * k)) & 63] : '=';
  }
  return out;
}

}  // namespace sinew
#endif
