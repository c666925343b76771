// SPDX-License-Identifier: MIT
// Coarser and finer variants of a character for training at several densities: OpenMesh's decimater with quadrics, weights
// carried along; every triangle into four.
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>

#include "dataset/half_edge_mesh.hpp"
#include "sinew_data_sets/dataset.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {
namespace {

using TriMesh = OpenMesh::TriMesh_ArrayKernelT<HalfEdgeTraits>;
using Decimater = OpenMesh::Decimater::DecimaterT<TriMesh>;

// Holes and hems keep their outline: a boundary vertex may only go along the boundary, and only while the new straight
// edge passes it within a tolerance. Quadrics alone do not see a move within the plane of an open sheet.
template <class MeshT>
class ModOutlineT : public OpenMesh::Decimater::ModBaseT<MeshT> {
 public:
  DECIMATING_MODULE(ModOutlineT, MeshT, Outline);

  explicit ModOutlineT(MeshT& mesh) : Base(mesh, true) {}
  void set_tolerance(double tolerance) { tolerance_ = tolerance; }

  float collapse_priority(const CollapseInfo& collapse) override {
    MeshT& mesh = Base::mesh();
    if (!mesh.is_boundary(collapse.v0)) return Base::LEGAL_COLLAPSE;
    if (collapse.fl.is_valid() && collapse.fr.is_valid())
      return Base::ILLEGAL_COLLAPSE;  // would cut through the inside
    for (const auto out : mesh.voh_range(collapse.v0)) {
      const auto neighbor = mesh.to_vertex_handle(out);
      if (neighbor == collapse.v1 || !mesh.is_boundary(mesh.edge_handle(out))) continue;
      if (distance_to_segment(collapse.p0, mesh.point(neighbor), collapse.p1) > tolerance_)
        return Base::ILLEGAL_COLLAPSE;
    }
    return Base::LEGAL_COLLAPSE;
  }

 private:
  using Point = typename MeshT::Point;
  static double distance_to_segment(const Point& p, const Point& a, const Point& b) {
    const Point along = b - a;
    const double length2 = along.sqrnorm();
    const double t = length2 > 0 ? std::clamp(((p - a) | along) / length2, 0.0, 1.0) : 0.0;
    return (p - (a + along * t)).norm();
  }

  double tolerance_ = 0;
};

struct WeldedMesh {
  std::vector<Vec3> vertices;
  std::vector<uint32_t> origin;  // [vertices] first vertex of the Character that was merged into it
  std::vector<char> fixed;       // another vertex stands at the same position with other weights: a seam to keep closed
  std::vector<std::vector<uint32_t>> triangles;
  std::vector<size_t> face_of;  // [triangles] face of the Character
};

// Merges vertices with the same position and the same row, and cuts polygons into fans without degenerate or repeated
// triangles.
WeldedMesh weld(const Character& character) {
  WeldedMesh welded;
  std::unordered_map<std::string, uint32_t> by_row;
  std::map<std::array<float, 3>, uint32_t> by_position;
  std::vector<uint32_t> number(character.vertices.size());
  for (size_t v = 0; v < number.size(); ++v) {
    const Vec3& p = character.vertices[v];
    const std::array<float, 3> position = {p.x + 0.0f, p.y + 0.0f, p.z + 0.0f};
    std::string key(reinterpret_cast<const char*>(position.data()), sizeof position);
    if (!character.influences.empty())
      for (const Influence& influence : character.influences[v]) {
        key.append(reinterpret_cast<const char*>(&influence.joint), sizeof influence.joint);
        key.append(reinterpret_cast<const char*>(&influence.weight), sizeof influence.weight);
      }
    const auto [at, is_new] = by_row.emplace(std::move(key), static_cast<uint32_t>(welded.vertices.size()));
    number[v] = at->second;
    if (!is_new) continue;
    const auto [twin, first_here] = by_position.emplace(position, at->second);
    welded.vertices.push_back(p);
    welded.origin.push_back(static_cast<uint32_t>(v));
    welded.fixed.push_back(first_here ? 0 : 1);
    if (!first_here) welded.fixed[twin->second] = 1;
  }
  std::set<std::array<uint32_t, 3>> known;
  for (size_t f = 0; f < character.face_count(); ++f)
    for (size_t c = character.face_offsets[f] + 2; c < character.face_offsets[f + 1]; ++c) {
      const std::vector<uint32_t> triangle = {number[character.face_vertices[character.face_offsets[f]]],
                                              number[character.face_vertices[c - 1]],
                                              number[character.face_vertices[c]]};
      std::array<uint32_t, 3> sorted = {triangle[0], triangle[1], triangle[2]};
      std::sort(sorted.begin(), sorted.end());
      if (sorted[0] == sorted[1] || sorted[1] == sorted[2] || !known.insert(sorted).second) continue;
      welded.triangles.push_back(triangle);
      welded.face_of.push_back(f);
    }
  return welded;
}

// Locks what must stay, drops vertices without faces. Returns how many vertices there are but for copies, which are locked and stay.
size_t lock_and_count(const WeldedMesh& welded, const std::vector<uint32_t>& origin, TriMesh* mesh) {
  std::vector<uint32_t> copies(welded.vertices.size(), 0);
  for (const uint32_t from : origin) ++copies[from];
  size_t vertex_count = 0;
  std::vector<char> met(welded.vertices.size(), 0);
  for (const auto v : mesh->vertices()) {
    const uint32_t from = origin[static_cast<size_t>(v.idx())];
    // Copies of a vertex must meet again afterwards, and so must the two sides of a seam.
    if (copies[from] > 1 || welded.fixed[from] != 0) mesh->status(v).set_locked(true);
    if (mesh->is_isolated(v)) {
      mesh->delete_vertex(v, false);
    } else if (met[from] == 0) {
      ++vertex_count;
      met[from] = 1;
    }
  }
  return vertex_count;
}

double longest_side(const std::vector<Vec3>& vertices) {
  double low[3] = {}, high[3] = {}, longest = 0;
  for (size_t v = 0; v < vertices.size(); ++v) {
    const double p[3] = {static_cast<double>(vertices[v].x), static_cast<double>(vertices[v].y),
                         static_cast<double>(vertices[v].z)};
    for (size_t axis = 0; axis < 3; ++axis) {
      low[axis] = v == 0 ? p[axis] : std::min(low[axis], p[axis]);
      high[axis] = v == 0 ? p[axis] : std::max(high[axis], p[axis]);
      longest = std::max(longest, high[axis] - low[axis]);
    }
  }
  return longest;
}

void collapse(const std::string& name, size_t vertex_count, size_t target, double longest, TriMesh* mesh) {
  Decimater decimater(*mesh);
  OpenMesh::Decimater::ModQuadricT<TriMesh>::Handle quadric;
  OpenMesh::Decimater::ModNormalFlippingT<TriMesh>::Handle flipping;
  ModOutlineT<TriMesh>::Handle outline;
  decimater.add(quadric);
  decimater.module(quadric).unset_max_err();
  decimater.add(flipping);
  decimater.add(outline);
  if (!decimater.initialize()) throw Error(name + ": cannot decimate, OpenMesh refuses the mesh");
  // The outline is held as tightly as the target allows: hems of clothes are a large part of some characters. The
  // decimater is set up once, because the quadrics must not start again from a mesh with deleted faces.
  for (const double tolerance : {0.002, 0.01, 0.05, std::numeric_limits<double>::infinity()}) {
    if (vertex_count <= target) break;
    decimater.module(outline).set_tolerance(tolerance * longest);
    vertex_count -= decimater.decimate(vertex_count - target);
  }
}

// A character with these triangles of vertices, in the order of the faces they come from.
Character with_triangles(const Character& character,
                         const std::vector<std::pair<size_t, std::array<uint32_t, 3>>>& triangles) {
  Character out;
  out.name = character.name;
  out.joints = character.joints;
  out.material_names = character.material_names;
  out.group_names = character.group_names;
  std::vector<char> used(character.vertices.size(), 0);
  for (const auto& [face, corners] : triangles)
    for (const uint32_t v : corners) used[v] = 1;
  std::vector<uint32_t> new_number(character.vertices.size(), 0);
  for (size_t v = 0; v < used.size(); ++v) {
    if (used[v] == 0) continue;
    new_number[v] = static_cast<uint32_t>(out.vertices.size());
    out.vertices.push_back(character.vertices[v]);
    if (!character.influences.empty()) out.influences.push_back(character.influences[v]);
  }
  for (const auto& [face, corners] : triangles) {
    for (const uint32_t v : corners) out.face_vertices.push_back(new_number[v]);
    out.face_offsets.push_back(static_cast<uint32_t>(out.face_vertices.size()));
    if (!character.face_materials.empty()) out.face_materials.push_back(character.face_materials[face]);
    if (!character.face_groups.empty()) out.face_groups.push_back(character.face_groups[face]);
  }
  return out;
}

}  // namespace

Character decimate(const Character& character, double ratio) {
  if (!(ratio > 0 && ratio <= 1))
    throw Error(character.name + ": expected a decimation ratio above 0 and up to 1, found " + std::to_string(ratio));
  const WeldedMesh welded = weld(character);
  if (welded.triangles.empty()) throw Error(character.name + ": cannot decimate a mesh without faces");

  TriMesh mesh;
  mesh.request_vertex_status();
  mesh.request_edge_status();
  mesh.request_face_status();
  mesh.request_halfedge_status();
  mesh.request_face_normals();
  std::vector<size_t> face_origin;
  const std::vector<uint32_t> origin = fill_half_edges(welded.vertices, welded.triangles, &mesh, &face_origin);
  mesh.update_face_normals();
  const size_t vertex_count = lock_and_count(welded, origin, &mesh);
  const auto target = std::max<size_t>(4, static_cast<size_t>(std::lround(static_cast<double>(vertex_count) * ratio)));
  collapse(character.name, vertex_count, target, longest_side(welded.vertices), &mesh);

  std::vector<std::pair<size_t, std::array<uint32_t, 3>>> triangles;
  for (const auto face : mesh.faces()) {
    std::array<uint32_t, 3> corners{};
    size_t c = 0;
    for (const auto v : mesh.fv_range(face)) corners[c++] = welded.origin[origin[static_cast<size_t>(v.idx())]];
    triangles.emplace_back(welded.face_of[face_origin[static_cast<size_t>(face.idx())]], corners);
  }
  std::stable_sort(triangles.begin(), triangles.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  return with_triangles(character, triangles);
}

namespace {

// The mean of two rows, by descending weight, ties by the lower joint.
std::vector<Influence> mean_row(const std::vector<Influence>& a, const std::vector<Influence>& b) {
  std::map<uint32_t, float> sums;
  for (const Influence& i : a) sums[i.joint] += i.weight / 2;
  for (const Influence& i : b) sums[i.joint] += i.weight / 2;
  std::vector<Influence> row;
  for (const auto& [joint, weight] : sums) row.push_back({joint, weight});
  std::stable_sort(row.begin(), row.end(), [](const Influence& x, const Influence& y) { return x.weight > y.weight; });
  return row;
}

}  // namespace

Character subdivide(const Character& character) {
  Character out;
  out.name = character.name;
  out.vertices = character.vertices;
  out.joints = character.joints;
  out.influences = character.influences;
  std::map<std::pair<uint32_t, uint32_t>, uint32_t> middles;
  const auto middle = [&](uint32_t a, uint32_t b) {
    const auto [at, is_new] = middles.emplace(std::minmax(a, b), static_cast<uint32_t>(out.vertices.size()));
    if (is_new) {
      const Vec3 p = out.vertices[a], q = out.vertices[b];
      out.vertices.push_back({(p.x + q.x) / 2, (p.y + q.y) / 2, (p.z + q.z) / 2});
      if (!out.influences.empty()) out.influences.push_back(mean_row(out.influences[a], out.influences[b]));
    }
    return at->second;
  };
  for (size_t f = 0; f < character.face_count(); ++f) {
    for (uint32_t i = character.face_offsets[f] + 1; i + 1 < character.face_offsets[f + 1]; ++i) {
      const uint32_t p = character.face_vertices[character.face_offsets[f]], q = character.face_vertices[i],
                     r = character.face_vertices[i + 1];
      const uint32_t pq = middle(p, q), qr = middle(q, r), rp = middle(r, p);
      for (const uint32_t corner : {p, pq, rp, pq, q, qr, rp, qr, r, pq, qr, rp}) {
        out.face_vertices.push_back(corner);
        if (out.face_vertices.size() % 3 == 0)
          out.face_offsets.push_back(static_cast<uint32_t>(out.face_vertices.size()));
      }
    }
  }
  return out;
}

}  // namespace sinew
