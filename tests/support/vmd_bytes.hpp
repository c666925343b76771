// SPDX-License-Identifier: MIT
// Bytes of a VMD.
#ifndef SINEW_TESTS_VMD_BYTES_HPP
#define SINEW_TESTS_VMD_BYTES_HPP

#include <array>
#include <cstring>
#include <string>
#include <vector>

namespace sinew::test {

struct VmdKey {
  std::string name;  // Shift-JIS
  uint32_t frame = 0;
  std::array<float, 3> translation = {};
  std::array<float, 4> rotation = {0, 0, 0, 1};
  std::array<uint8_t, 4> curve = {20, 20, 107, 107};  // x1 y1 x2 y2 of all four
};

// From a frame on an IK bone leads, or does not.
struct VmdSwitch {
  uint32_t frame;
  std::string name;  // Shift-JIS
  bool on;
};

inline std::string vmd_of(const std::vector<VmdKey>& keys, const std::vector<VmdSwitch>& switches = {}) {
  const auto padded = [](std::string text, size_t size) {
    text.resize(size, '\0');
    return text;
  };
  const auto raw = [](const auto& value) {
    std::string out(sizeof value, '\0');
    std::memcpy(out.data(), &value, sizeof value);
    return out;
  };
  std::string bytes =
      padded("Vocaloid Motion Data 0002", 30) + padded("model", 20) + raw(static_cast<uint32_t>(keys.size()));
  for (const VmdKey& key : keys) {
    std::string curves(64, '\0');
    for (size_t c = 0; c < 4; ++c)
      for (size_t i = 0; i < 4; ++i) curves[16 * c + 4 * i] = static_cast<char>(key.curve[i]);
    bytes += padded(key.name, 15) + raw(key.frame) + raw(key.translation) + raw(key.rotation) + curves;
  }
  if (switches.empty()) return bytes + std::string(8, '\0');
  bytes += std::string(16, '\0') + raw(static_cast<uint32_t>(switches.size()));
  for (const VmdSwitch& one : switches)
    bytes += raw(one.frame) + '\1' + raw(uint32_t{1}) + padded(one.name, 20) + static_cast<char>(one.on);
  return bytes;
}

}  // namespace sinew::test
#endif
