// SPDX-License-Identifier: MIT
// Numbers in the bytes of a file, and the checksum of such bytes. All numbers are little-endian, on every host.
#ifndef SINEW_CORE_BYTES_HPP
#define SINEW_CORE_BYTES_HPP

#include <stddef.h>
#include <stdint.h>

// 1 where an int16 of the file may be read by a plain load. SINEW_PORTABLE_BYTES forces 0, for tests.
#if defined(SINEW_PORTABLE_BYTES)
#define SINEW_PLAIN_INT16 0
#elif defined(__BYTE_ORDER__) && defined(__ORDER_LITTLE_ENDIAN__) && __BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__
#define SINEW_PLAIN_INT16 1
#elif defined(_MSC_VER)
#define SINEW_PLAIN_INT16 1
#else
#define SINEW_PLAIN_INT16 0
#endif

namespace sinew {

inline uint16_t load_u16(const uint8_t* p) { return static_cast<uint16_t>(p[0] | (p[1] << 8)); }
inline uint32_t load_u32(const uint8_t* p) {
  return static_cast<uint32_t>(p[0]) | (static_cast<uint32_t>(p[1]) << 8) | (static_cast<uint32_t>(p[2]) << 16) |
         (static_cast<uint32_t>(p[3]) << 24);
}
inline uint64_t load_u64(const uint8_t* p) {
  return static_cast<uint64_t>(load_u32(p)) | (static_cast<uint64_t>(load_u32(p + 4)) << 32);
}
inline int64_t load_i64(const uint8_t* p) { return static_cast<int64_t>(load_u64(p)); }
inline void store_u16(uint8_t* p, uint16_t v) {
  p[0] = static_cast<uint8_t>(v);
  p[1] = static_cast<uint8_t>(v >> 8);
}
inline void store_u32(uint8_t* p, uint32_t v) {
  store_u16(p, static_cast<uint16_t>(v));
  store_u16(p + 2, static_cast<uint16_t>(v >> 16));
}
inline void store_u64(uint8_t* p, uint64_t v) {
  store_u32(p, static_cast<uint32_t>(v));
  store_u32(p + 4, static_cast<uint32_t>(v >> 32));
}

// Element i of an int16 array that lies in the file.
inline int16_t file_int16(const int16_t* values, size_t i) {
#if SINEW_PLAIN_INT16
  return values[i];
#else
  return static_cast<int16_t>(load_u16(reinterpret_cast<const uint8_t*>(values) + 2 * i));
#endif
}

// CRC-32 (IEEE 802.3, reflected polynomial EDB88320). Start with crc = 0; pieces may be chained.
inline uint32_t crc32(uint32_t crc, const uint8_t* bytes, size_t count) {
  // table[i] = i shifted through four steps of the polynomial.
  static constexpr uint32_t kNibble[16] = {0x00000000u, 0x1DB71064u, 0x3B6E20C8u, 0x26D930ACu, 0x76DC4190u, 0x6B6B51F4u,
                                           0x4DB26158u, 0x5005713Cu, 0xEDB88320u, 0xF00F9344u, 0xD6D6A3E8u, 0xCB61B38Cu,
                                           0x9B64C2B0u, 0x86D3D2D4u, 0xA00AE278u, 0xBDBDF21Cu};
  crc = ~crc;
  for (size_t i = 0; i < count; ++i) {
    crc ^= bytes[i];
    crc = (crc >> 4) ^ kNibble[crc & 15u];
    crc = (crc >> 4) ^ kNibble[crc & 15u];
  }
  return ~crc;
}

}  // namespace sinew
#endif
