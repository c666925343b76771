// SPDX-License-Identifier: MIT
// Creases by a greedy pass over each vertex' faces: a face joins the first group whose summed normal is close enough.
#include "surface.hpp"

#include <cmath>

namespace sinew::web {
namespace {

struct Normal {
  float x = 0, y = 0, z = 0;
};

float dot(const Normal& a, const Normal& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

// Newell's: right for polygons that are not flat as well; its length is twice the area.
Normal face_normal(const Character& character, size_t face) {
  const uint32_t begin = character.face_offsets[face], end = character.face_offsets[face + 1];
  Normal n;
  for (uint32_t i = begin; i < end; ++i) {
    const Vec3& p = character.vertices[character.face_vertices[i]];
    const Vec3& q = character.vertices[character.face_vertices[i + 1 < end ? i + 1 : begin]];
    n.x += (p.y - q.y) * (p.z + q.z);
    n.y += (p.z - q.z) * (p.x + q.x);
    n.z += (p.x - q.x) * (p.y + q.y);
  }
  return n;
}

}  // namespace

Surface make_surface(const Character& character) {
  constexpr float kSmooth = 0.766f;  // cosine of 40 degrees
  constexpr uint32_t kNone = ~0u;
  Surface surface;
  std::vector<Normal> sums;                                             // [R]
  std::vector<uint32_t> first(character.vertices.size(), kNone), next;  // shown vertices of a vertex, as a list
  std::vector<uint32_t> corner(character.face_vertices.size());
  for (size_t face = 0; face < character.face_count(); ++face) {
    const Normal normal = face_normal(character, face);
    const float length = std::sqrt(dot(normal, normal));
    const uint32_t begin = character.face_offsets[face], end = character.face_offsets[face + 1];
    for (uint32_t i = begin; i < end; ++i) {
      const uint32_t vertex = character.face_vertices[i];
      uint32_t shown = first[vertex];
      while (shown != kNone) {
        const float both = length * std::sqrt(dot(sums[shown], sums[shown]));
        if (dot(sums[shown], normal) >= kSmooth * both) break;
        shown = next[shown];
      }
      if (shown == kNone) {
        shown = static_cast<uint32_t>(surface.vertex_of.size());
        surface.vertex_of.push_back(vertex);
        sums.emplace_back();
        next.push_back(first[vertex]);
        first[vertex] = shown;
      }
      sums[shown].x += normal.x;
      sums[shown].y += normal.y;
      sums[shown].z += normal.z;
      corner[i] = shown;
    }
    for (uint32_t i = begin + 2; i < end; ++i)
      surface.triangles.insert(surface.triangles.end(), {corner[begin], corner[i - 1], corner[i]});
  }
  return surface;
}

void surface_normals(const Surface& surface, const std::vector<float>& positions, std::vector<float>* normals) {
  normals->assign(surface.vertex_of.size() * 3, 0.0f);
  float* const out = normals->data();
  for (size_t t = 0; t < surface.triangles.size(); t += 3) {
    const uint32_t* const shown = &surface.triangles[t];
    const float* const a = &positions[size_t{surface.vertex_of[shown[0]]} * 3];
    const float* const b = &positions[size_t{surface.vertex_of[shown[1]]} * 3];
    const float* const c = &positions[size_t{surface.vertex_of[shown[2]]} * 3];
    const float u[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]}, v[3] = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    const float n[3] = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    for (int i = 0; i < 3; ++i) {
      for (int axis = 0; axis < 3; ++axis) out[size_t{shown[i]} * 3 + static_cast<size_t>(axis)] += n[axis];
    }
  }
  for (size_t i = 0; i < normals->size(); i += 3) {
    const float length = std::sqrt(out[i] * out[i] + out[i + 1] * out[i + 1] + out[i + 2] * out[i + 2]);
    for (size_t axis = 0; axis < 3; ++axis)
      out[i + axis] = length > 0 ? out[i + axis] / length : axis == 1 ? 1.0f : 0.0f;
  }
}

}  // namespace sinew::web
