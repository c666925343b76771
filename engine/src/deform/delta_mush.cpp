// SPDX-License-Identifier: MIT
// Delta mush: J. Mancewicz, M. Derksen, H. Rijpkema, C. Wilson, "Delta Mush: Smoothing Deformations While Preserving Detail", 2014.
// The frame of a vertex is the rotation nearest to how its smoothed neighbors moved.
#include "deform/correction.hpp"
#include "deform/rest.hpp"

namespace sinew::deform {
namespace {

constexpr int kRotationSteps = 12;

// Rotation nearest to a matrix, from a start: M. Mueller, J. Bender, N. Chentanez, M. Macklin, "A Robust Method to Extract the
// Rotational Part of Deformations", 2016; a step's rotation is (1, w / 2) normalized, so that no sine is needed.
Quaternion nearest_rotation(const Vec3d* columns, Quaternion q) {
  for (int step = 0; step < kRotationSteps; ++step) {
    const Vec3d x = rotate(q, {1, 0, 0}), y = rotate(q, {0, 1, 0}), z = rotate(q, {0, 0, 1});
    const Vec3d rotation = cross(x, columns[0]) + cross(y, columns[1]) + cross(z, columns[2]);
    const double along = dot(x, columns[0]) + dot(y, columns[1]) + dot(z, columns[2]);
    const double scale = (along < 0 ? -along : along) + 1e-30;
    const Vec3d w = (1 / scale) * rotation;
    if (dot(w, w) < 1e-18) break;
    q = Quaternion{1, 0.5 * w.x, 0.5 * w.y, 0.5 * w.z} * q;
    q = reciprocal_root(dot(q, q)) * q;
  }
  return q;
}

// sum of b a^T, by columns
void add_product(double weight, Vec3d a, Vec3d b, Vec3d* columns) {
  columns[0] = columns[0] + (weight * a.x) * b;
  columns[1] = columns[1] + (weight * a.y) * b;
  columns[2] = columns[2] + (weight * a.z) * b;
}

}  // namespace

sinew_status pose_delta_mush(const PosedJoints& posed, Arena& arena, Vec3d* positions) {
  const DeformRest& rest = *posed.rest;
  const ArenaScope scope(arena);
  Vec3d* const smoothed = arena.alloc<Vec3d>(rest.welded_count);
  Vec3d* const rest_normals = arena.alloc<Vec3d>(rest.welded_count);
  Vec3d* const normals = arena.alloc<Vec3d>(rest.welded_count);
  Quaternion* const rotations = arena.alloc<Quaternion>(rest.welded_count);
  if (!arena.ok()) return SINEW_ERROR_WORKSPACE;
  if (arena.measuring()) return SINEW_OK;
  const uint32_t n = rest.influence_count;
  for (uint32_t v = 0; v < rest.vertex_count; ++v) {
    const size_t at = static_cast<size_t>(v) * n;
    positions[v] = blend_linear(posed, rest.joints + at, rest.weights + at, n, rest.position(v));
  }
  for (uint32_t u = 0; u < rest.welded_count; ++u) smoothed[u] = positions[rest.first[u]];
  smooth(rest, rest.options.round_count, nullptr, normals, smoothed);
  for (uint32_t u = 0; u < rest.welded_count; ++u) rest_normals[u] = normals[u] = {0, 0, 0};
  for (uint32_t t = 0; t < rest.triangle_count; ++t) {
    const uint32_t* const at = rest.triangles + 3 * static_cast<size_t>(t);
    const Vec3d before = cross(rest.smooth[at[1]] - rest.smooth[at[0]], rest.smooth[at[2]] - rest.smooth[at[0]]);
    const Vec3d now = cross(smoothed[at[1]] - smoothed[at[0]], smoothed[at[2]] - smoothed[at[0]]);
    for (int k = 0; k < 3; ++k) {
      rest_normals[at[k]] = rest_normals[at[k]] + before;
      normals[at[k]] = normals[at[k]] + now;
    }
  }
  for (uint32_t u = 0; u < rest.welded_count; ++u) {
    const size_t at = static_cast<size_t>(rest.first[u]) * n;
    const DualQuaternion blended =
        blend_motions(posed, rest.joints + at, rest.weights + at, n, rest.position(rest.first[u]));
    rotations[u] = reciprocal_root(dot(blended.real, blended.real)) * blended.real;
    Vec3d columns[3] = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    double squares = 0;
    for (uint32_t r = rest.row_offsets[u]; r < rest.row_offsets[u + 1]; ++r) {
      const Vec3d a = rest.smooth[rest.col_indices[r]] - rest.smooth[u];
      add_product(1, a, smoothed[rest.col_indices[r]] - smoothed[u], columns);
      squares += dot(a, a);
    }
    if (!(squares > 0)) continue;
    add_product(0.5 * squares, unit(rest_normals[u]), unit(normals[u]), columns);  // closes the rank
    rotations[u] = nearest_rotation(columns, rotations[u]);
  }
  for (uint32_t v = 0; v < rest.vertex_count; ++v) {
    const uint32_t u = rest.welded[v];
    if (rest.row_offsets[u] == rest.row_offsets[u + 1])
      continue;  // a vertex without a triangle keeps its skinned position
    positions[v] = smoothed[u] + rotate(rotations[u], rest.position(v) - rest.smooth[u]);
  }
  return SINEW_OK;
}

}  // namespace sinew::deform
