// SPDX-License-Identifier: MIT
// Bytes of the model file: the one definition that the reader (engine) and the writer (quant) share. All numbers are
// little-endian. formats/spec/model.md describes the same in words.
#ifndef SINEW_MODEL_LAYOUT_HPP
#define SINEW_MODEL_LAYOUT_HPP

#include <stddef.h>
#include <stdint.h>

#include "core/bytes.hpp"
#include "model/layers.hpp"

namespace sinew {

constexpr uint8_t kModelMagic[8] = {'S', 'I', 'N', 'E', 'W', '\r', '\n', 0x1A};
constexpr uint32_t kModelFormat = 1;

// Header: byte offsets of its fields. Bytes 56 to 63 are reserved and 0.
constexpr size_t kHeaderBytes = 64;
constexpr size_t kHeaderFormat = 8;       // uint32 kModelFormat
constexpr size_t kHeaderChecksum = 12;    // uint32 CRC-32 of the whole file with these four bytes taken as 0
constexpr size_t kHeaderSize = 16;        // uint64 bytes of the file
constexpr size_t kHeaderCandidates = 24;  // uint32 K, 1..16
constexpr size_t kHeaderGrid = 28;        // uint32 voxel cells, 16..128; 0 = they follow the vertices
constexpr size_t kHeaderFeatureSet = 32;  // uint32 version in the low 16 bits, feature flags in the high ones
constexpr size_t kHeaderBuffers = 36;     // uint32 buffer count, 2..kMaxBuffers
constexpr size_t kHeaderLayers = 40;      // uint32 layer count, 1..kMaxLayers
constexpr size_t kHeaderLinears = 44;     // uint32 linear layers among them
constexpr size_t kHeaderTask = 48;        // uint32 what the network is for (model/task.hpp)
constexpr size_t kHeaderInputs = 52;  // uint32 input buffers, 1..kMaxInputs; 0 = as many as the task has, without names
constexpr size_t kHeaderReserved = 56;

// Tables follow the header without gaps: buffers, layers, linears. Then the parameter data.
constexpr size_t kBufferBytes = 8;   // uint8 domain, uint8 0, uint16 channels, uint32 name of an input (else 0)
constexpr size_t kLayerBytes = 32;   // uint8 kind, uint8 flags, uint16 0, regions in, out, residual (3 x uint16
                                     // buffer, offset, channels), uint16 0, uint32 parameters, uint32 0
constexpr size_t kLinearBytes = 32;  // see LinearRecord
constexpr uint32_t kMaxShiftNarrow = 31;
constexpr uint32_t kMaxShiftWide = 47;

// Values a region can hold; every one includes 0, and each includes the one before it.
enum class ValueRange : uint8_t { kPositive = 0, kSigned = 1, kLogits = 2 };
constexpr int32_t range_low(ValueRange range) {
  return range == ValueRange::kPositive ? 0 : range == ValueRange::kSigned ? -16384 : -32767;
}
constexpr int32_t range_high(ValueRange range) { return range == ValueRange::kLogits ? 32767 : 16383; }

enum class AccumulatorClass : uint8_t { kNarrow = 0, kWide = 1 };  // N: int32. W: int64 over blocks of int32

// Checksum of a file of at least kHeaderBytes.
inline uint32_t model_checksum(const uint8_t* bytes, size_t size_bytes) {
  const uint8_t zero[4] = {0, 0, 0, 0};
  uint32_t crc = crc32(0, bytes, kHeaderChecksum);
  crc = crc32(crc, zero, 4);
  return crc32(crc, bytes + kHeaderChecksum + 4, size_bytes - kHeaderChecksum - 4);
}

constexpr uint64_t padded8(uint64_t bytes) { return (bytes + 7u) & ~static_cast<uint64_t>(7u); }

// One row of the linear table. Offsets are from the start of the file, multiples of 8. The data of all linear layers
// lies behind the tables in order, without gaps: bias, weights, residual (only with kLayerResidual), shifts, each
// zero-padded to 8 bytes; the file ends there.
struct LinearRecord {
  uint16_t in = 0, out = 0;                                  // 0, 2
  AccumulatorClass accumulator = AccumulatorClass::kNarrow;  // 4
  ValueRange range = ValueRange::kPositive;                  // 5: what the output is clamped to
  uint16_t block = 0;                                        // 6: columns whose sum fits int32; = in for class N
  uint32_t bias = 0;                                         // 8: int64 [out], holding 1 << (shift - 1)
  uint32_t weights = 0;                                      // 12: int16 [out x in]
  uint32_t residual = 0;                                     // 16: int16 [out] factor of the residual; 0 = none
  uint32_t shifts = 0;                                       // 20: uint8 [out]
                                                             // 24: uint64 0
};
inline uint64_t bias_bytes(const LinearRecord& r) { return static_cast<uint64_t>(r.out) * 8; }
inline uint64_t weight_bytes(const LinearRecord& r) { return padded8(static_cast<uint64_t>(r.in) * r.out * 2); }
inline uint64_t residual_bytes(const LinearRecord& r) { return padded8(static_cast<uint64_t>(r.out) * 2); }
inline uint64_t shift_bytes(const LinearRecord& r) { return padded8(r.out); }

// Optional section behind the parameters: confidence. uint32 tag, uint32 bytes of the section (a multiple of 8), uint32
// entries, uint32 0, then entries of uint16 share of the strongest joint (65535 = 1, rising) and uint16 share of hits
// (65535 = 1, not falling), zeros up to the end.
constexpr uint32_t kConfidenceTag = 0x464E4F43u;  // "CONF"
constexpr size_t kConfidenceHeader = 16;
constexpr uint32_t kMinConfidenceEntries = 2, kMaxConfidenceEntries = 64;
inline uint64_t confidence_bytes(uint32_t entries) {
  return kConfidenceHeader + padded8(static_cast<uint64_t>(entries) * 4);
}

// Optional section at the same position, in a file with a second network: uint32 tag, uint32 bytes of the section,
// uint64 0, then the whole file of that network, which has no section itself.
constexpr uint32_t kSecondTag = 0x444E4F43u;  // "COND"
constexpr size_t kSecondHeader = 16;

inline uint64_t tables_bytes(uint32_t buffers, uint32_t layers, uint32_t linears) {
  return kHeaderBytes + static_cast<uint64_t>(buffers) * kBufferBytes + static_cast<uint64_t>(layers) * kLayerBytes +
         static_cast<uint64_t>(linears) * kLinearBytes;
}

inline Region load_region(const uint8_t* p) { return {load_u16(p), load_u16(p + 2), load_u16(p + 4)}; }
inline void store_region(uint8_t* p, const Region& region) {
  store_u16(p, region.buffer);
  store_u16(p + 2, region.offset);
  store_u16(p + 4, region.channels);
}

// Decoding of the tables. Holds the caller's bytes and the counts; nothing is checked here.
class ModelTables {
 public:
  explicit ModelTables(const uint8_t* bytes)
      : bytes_(bytes),
        buffer_count_(load_u32(bytes + kHeaderBuffers)),
        layer_count_(load_u32(bytes + kHeaderLayers)),
        linear_count_(load_u32(bytes + kHeaderLinears)) {}
  uint32_t buffer_count() const { return buffer_count_; }
  uint32_t layer_count() const { return layer_count_; }
  uint32_t linear_count() const { return linear_count_; }
  const uint8_t* buffer_row(uint32_t i) const { return bytes_ + kHeaderBytes + i * kBufferBytes; }
  const uint8_t* layer_row(uint32_t i) const { return buffer_row(buffer_count_) + i * kLayerBytes; }
  const uint8_t* linear_row(uint32_t i) const { return layer_row(layer_count_) + i * kLinearBytes; }

  // Input buffers, which come first; 0 where the file does not say.
  uint32_t input_count() const { return load_u32(bytes_ + kHeaderInputs); }
  uint32_t buffer_name(uint32_t i) const { return load_u32(buffer_row(i) + 4); }
  Buffer buffer(uint32_t i) const {
    const uint8_t* row = buffer_row(i);
    return {static_cast<Domain>(row[0]), load_u16(row + 2)};
  }
  Layer layer(uint32_t i) const {
    const uint8_t* row = layer_row(i);
    Layer layer;
    layer.kind = static_cast<LayerKind>(row[0]);
    layer.flags = row[1];
    layer.in = load_region(row + 4);
    layer.out = load_region(row + 10);
    layer.residual = load_region(row + 16);
    layer.parameters = load_u32(row + 24);
    return layer;
  }
  LinearRecord linear(uint32_t i) const {
    const uint8_t* row = linear_row(i);
    LinearRecord record;
    record.in = load_u16(row);
    record.out = load_u16(row + 2);
    record.accumulator = static_cast<AccumulatorClass>(row[4]);
    record.range = static_cast<ValueRange>(row[5]);
    record.block = load_u16(row + 6);
    record.bias = load_u32(row + 8);
    record.weights = load_u32(row + 12);
    record.residual = load_u32(row + 16);
    record.shifts = load_u32(row + 20);
    return record;
  }
  // Int16 arrays of the file: offsets are multiples of 8 and the file is 8-byte aligned, so the pointer is aligned.
  const int16_t* int16_at(uint32_t offset) const {
    return static_cast<const int16_t*>(static_cast<const void*>(bytes_ + offset));
  }
  const uint8_t* bytes() const { return bytes_; }

 private:
  const uint8_t* bytes_;
  uint32_t buffer_count_, layer_count_, linear_count_;
};

}  // namespace sinew
#endif
