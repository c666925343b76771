// SPDX-License-Identifier: MIT
// Linear blend and dual quaternion skinning on floats, after the bind and outside its bit-exact path.
#include "deform/skinning.hpp"

#include <string.h>

#include "deform/rotation_quaternion.hpp"

namespace sinew::deform {
namespace {

constexpr float kUnorm16 = 1.0f / 65535.0f;

bool joints_exist(const uint16_t* joints, size_t count, uint32_t joint_count) {
  for (size_t i = 0; i < count; ++i) {
    if (joints[i] >= joint_count) return false;
  }
  return true;
}

// 1 / sqrt(x) for normal x > 0 without the maths library: a guess that halves the exponent, then four Newton steps,
// which bring its 3.5 % error below float precision.
float reciprocal_sqrt(float x) {
  uint32_t word;
  memcpy(&word, &x, sizeof(word));
  word = 0x5F3759DFu - (word >> 1);
  float y;
  memcpy(&y, &word, sizeof(y));
  for (int i = 0; i < 4; ++i) y = y * (1.5f - 0.5f * x * y * y);
  return y;
}

using FloatQuaternion = QuaternionOf<float>;
FloatQuaternion scaled(const FloatQuaternion& q, float s) { return {q.w * s, q.x * s, q.y * s, q.z * s}; }
void add_scaled(FloatQuaternion* sum, const FloatQuaternion& q, float s) {
  sum->w += q.w * s;
  sum->x += q.x * s;
  sum->y += q.y * s;
  sum->z += q.z * s;
}
float dot(const FloatQuaternion& a, const FloatQuaternion& b) { return a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z; }

// Unit quaternion of a rotation matrix.
FloatQuaternion rotation_quaternion(const float* m) {
  const FloatQuaternion q = long_rotation_quaternion(m);
  return scaled(q, reciprocal_sqrt(dot(q, q)));
}

// Dual part of a rigid motion: half of (0, translation) times the rotation.
FloatQuaternion dual_part(const FloatQuaternion& q, float tx, float ty, float tz) {
  return scaled({-tx * q.x - ty * q.y - tz * q.z, tx * q.w + ty * q.z - tz * q.y, -tx * q.z + ty * q.w + tz * q.x,
                 tx * q.y - ty * q.x + tz * q.w},
                0.5f);
}

}  // namespace

sinew_status skin_linear(const float* positions, uint32_t vertex_count, const uint16_t* joints, const uint16_t* weights,
                         uint32_t influence_count, const float* palette, uint32_t joint_count, float* out) {
  const size_t n = influence_count;
  if (!joints_exist(joints, vertex_count * n, joint_count)) return SINEW_ERROR_RANGE;
  for (size_t v = 0; v < vertex_count; ++v) {
    float m[12] = {};
    for (size_t i = 0; i < n; ++i) {
      const float weight = static_cast<float>(weights[v * n + i]) * kUnorm16;
      const float* joint = palette + static_cast<size_t>(joints[v * n + i]) * 12;
      for (int e = 0; e < 12; ++e) m[e] += joint[e] * weight;
    }
    const float x = positions[3 * v], y = positions[3 * v + 1], z = positions[3 * v + 2];
    for (size_t row = 0; row < 3; ++row) {
      out[3 * v + row] = m[4 * row] * x + m[4 * row + 1] * y + m[4 * row + 2] * z + m[4 * row + 3];
    }
  }
  return SINEW_OK;
}

sinew_status skin_dual_quaternion(const float* positions, uint32_t vertex_count, const uint16_t* joints,
                                  const uint16_t* weights, uint32_t influence_count, const float* palette,
                                  uint32_t joint_count, float* out) {
  const size_t n = influence_count;
  if (!joints_exist(joints, vertex_count * n, joint_count)) return SINEW_ERROR_RANGE;
  for (size_t v = 0; v < vertex_count; ++v) {
    FloatQuaternion real = {0, 0, 0, 0}, dual = {0, 0, 0, 0}, pivot = {1, 0, 0, 0};
    for (size_t i = 0; i < n; ++i) {
      const float* m = palette + static_cast<size_t>(joints[v * n + i]) * 12;
      const FloatQuaternion q = rotation_quaternion(m);
      if (i == 0) pivot = q;
      // q and -q are the same rotation; blending takes the one on the pivot's side.
      float weight = static_cast<float>(weights[v * n + i]) * kUnorm16;
      if (dot(q, pivot) < 0.0f) weight = -weight;
      add_scaled(&real, q, weight);
      add_scaled(&dual, dual_part(q, m[3], m[7], m[11]), weight);
    }
    // All parts lie on the pivot's side, so the sum is at least as long as the first weight: no division by 0.
    const float inverse = reciprocal_sqrt(dot(real, real));
    const FloatQuaternion r = scaled(real, inverse), d = scaled(dual, inverse);
    const float tx = 2.0f * (r.w * d.x - d.w * r.x + r.y * d.z - r.z * d.y);
    const float ty = 2.0f * (r.w * d.y - d.w * r.y + r.z * d.x - r.x * d.z);
    const float tz = 2.0f * (r.w * d.z - d.w * r.z + r.x * d.y - r.y * d.x);
    const float x = positions[3 * v], y = positions[3 * v + 1], z = positions[3 * v + 2];
    // p + 2 r x (r x p + w p)
    const float cx = r.y * z - r.z * y + r.w * x, cy = r.z * x - r.x * z + r.w * y, cz = r.x * y - r.y * x + r.w * z;
    out[3 * v] = x + 2.0f * (r.y * cz - r.z * cy) + tx;
    out[3 * v + 1] = y + 2.0f * (r.z * cx - r.x * cz) + ty;
    out[3 * v + 2] = z + 2.0f * (r.x * cy - r.y * cx) + tz;
  }
  return SINEW_OK;
}

}  // namespace sinew::deform
