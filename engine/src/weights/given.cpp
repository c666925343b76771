// SPDX-License-Identifier: MIT
// Decodes the caller's rows and takes their mean on welded vertices (stage 9).
#include <string.h>

#include "weights/users_say.hpp"

namespace sinew {
namespace {

// Rows of unorm16 and of unorm8 are scaled to this sum and back without loss, so that a mirrored row is the given one.
constexpr uint32_t kGivenSum = 65535;

// round_half_up(value * 2^16) of an IEEE float from its bits, 2^16 from 1 on. False for negative values and NaN.
bool float_q16(float value, uint32_t* out) {
  uint32_t bits;
  memcpy(&bits, &value, sizeof(bits));
  if (bits > 0x7F800000u) {
    *out = 0;
    return bits == 0x80000000u;
  }
  const int exponent = static_cast<int>(bits >> 23) - 127;
  if (exponent >= 0) {
    *out = kWholeRow;
    return true;
  }
  const int shift = 23 - 16 - exponent;  // 8 and more: the result is below 2^16, or 2^16 by rounding
  const uint32_t mantissa = (bits & 0x7FFFFFu) | 0x800000u;
  *out = shift > 25 ? 0 : (mantissa + (1u << (shift - 1))) >> shift;
  return true;
}

void add_row(const uint16_t* joints, const uint32_t* weights, uint32_t count, uint32_t vertex, const Rows& rows) {
  uint64_t sum = 0;
  for (uint32_t i = 0; i < count; ++i) sum += weights[i];
  // A point with thousands of vertices is not a valid mesh; the sums stop before they overflow.
  constexpr uint32_t kFull = 1u << 30;
  for (uint32_t i = 0; i < count; ++i) {
    const uint32_t share = static_cast<uint32_t>((static_cast<uint64_t>(weights[i]) * kGivenSum + sum / 2) / sum);
    if (share > 0 && rows.weight(vertex, joints[i]) < kFull) rows.add(vertex, joints[i], share);
  }
}

void normalize(uint32_t vertex, const Rows& rows) {
  uint32_t* weights = rows.weights_of(vertex);
  uint64_t sum = 0;
  for (uint32_t i = 0; i < kRowSlots; ++i) sum += weights[i];
  for (uint32_t i = 0; i < kRowSlots; ++i)
    weights[i] = static_cast<uint32_t>((static_cast<uint64_t>(weights[i]) * kGivenSum + sum / 2) / sum);
}

}  // namespace

bool read_row(const void* weights, uint32_t format, size_t first, uint32_t count, uint32_t* out) {
  uint32_t any = 0;
  for (uint32_t i = 0; i < count; ++i) {
    if (format == SINEW_WEIGHT_UNORM8) {
      out[i] = static_cast<const uint8_t*>(weights)[first + i];
    } else if (format == SINEW_WEIGHT_UNORM16) {
      out[i] = static_cast<const uint16_t*>(weights)[first + i];
    } else if (!float_q16(static_cast<const float*>(weights)[first + i], out + i)) {
      return false;
    }
    any |= out[i];
  }
  return any != 0;
}

void gather_given_rows(const Mesh& mesh, const uint8_t* locked, const uint8_t* hints, const uint16_t* joints,
                       const void* weights, uint32_t format, uint32_t influence_count, GivenRows* out) {
  for (uint32_t u = 0; u < mesh.welded_count; ++u) {
    out->kind[u] = GivenKind::kFree;
    out->rows.clear(u);
  }
  const GivenKind kinds[2] = {GivenKind::kSteers, GivenKind::kKept};
  for (const GivenKind kind : kinds) {
    const uint8_t* flags = kind == GivenKind::kSteers ? hints : locked;
    if (flags == nullptr) continue;
    for (uint32_t v = 0; v < mesh.vertex_count; ++v) {
      const uint32_t u = mesh.vertex_to_welded[v];
      if (flags[v] == 0 || (kind == GivenKind::kKept && out->kind[u] == GivenKind::kSteers)) continue;
      uint32_t row[SINEW_MAX_INFLUENCES];
      const size_t first = static_cast<size_t>(v) * influence_count;
      if (!read_row(weights, format, first, influence_count, row)) continue;
      out->kind[u] = kind;
      add_row(joints + first, row, influence_count, u, out->rows);
    }
  }
  for (uint32_t u = 0; u < mesh.welded_count; ++u) {
    if (out->kind[u] != GivenKind::kFree) normalize(u, out->rows);
  }
}

}  // namespace sinew
