// SPDX-License-Identifier: MIT
// Triangles of all primitives through one simplifier, and the vertices that are left picked from every accessor.
#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "gltf/gltf_container.hpp"
#include "gltf/gltf_model.hpp"
#include "gltf/gltf_source.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/lod_document.hpp"
#ifdef SINEW_HAS_MESHOPT
#include <meshoptimizer.h>
#endif

namespace sinew {
namespace {

#ifdef SINEW_HAS_MESHOPT

// A primitive's vertices among those of all.
struct Range {
  size_t part, mesh, first, count;
};

class Reducer {
 public:
  Reducer(const std::string& name, const GltfSource& source, const std::vector<Vec3>& positions)
      : name_(name), read_(source), out_(source) {
    std::set<std::pair<int, int>> seen;
    for (size_t p = 0; p < read_.parts.size(); ++p) {
      const GltfPart& part = read_.parts[p];
      const int mesh = read_.model.nodes[static_cast<size_t>(part.node)].mesh;
      if (!seen.insert({mesh, part.primitive}).second) continue;  // a mesh that several nodes show
      const tinygltf::Primitive& primitive = primitive_of(p);
      if (primitive.mode >= 0 && primitive.mode < TINYGLTF_MODE_TRIANGLES) continue;
      const size_t first = positions_.size() / 3;
      ranges_.push_back({p, static_cast<size_t>(mesh), first, part.vertex_of.size()});
      for (const uint32_t v : part.vertex_of)
        positions_.insert(positions_.end(), {positions[v].x, positions[v].y, positions[v].z});
      for (const auto& triangle : primitive_triangles(name_, read_.model, primitive, part.vertex_of.size()))
        for (const uint32_t v : triangle) indices_.push_back(static_cast<unsigned>(first + v));
    }
  }

  std::vector<uint8_t> reduce(double share) {
    std::vector<unsigned> left(indices_.size());
    const size_t wanted = static_cast<size_t>(share * static_cast<double>(indices_.size() / 3)) * 3;
    left.resize(meshopt_simplify(left.data(), indices_.data(), indices_.size(), positions_.data(),
                                 positions_.size() / 3, 3 * sizeof(float), wanted, 1.0f, 0, nullptr));
    for (const Range& range : ranges_) write(range, triangles_in(range, left));
    drop_unused_accessors(orphans_, &out_);
    return pack_glb(name_, &out_.document, std::move(out_.bytes));
  }

 private:
  const tinygltf::Primitive& primitive_of(size_t part) const {
    const GltfPart& from = read_.parts[part];
    return read_.model.meshes[static_cast<size_t>(read_.model.nodes[static_cast<size_t>(from.node)].mesh)]
        .primitives[static_cast<size_t>(from.primitive)];
  }

  // Corners of a primitive's triangles, in its own numbers. A primitive needs one: of those that vanish the first triangle stays.
  std::vector<uint32_t> triangles_in(const Range& range, const std::vector<unsigned>& left) const {
    std::vector<uint32_t> corners;
    const auto take = [&](const std::vector<unsigned>& from, size_t most) {
      for (size_t i = 0; i + 2 < from.size() && corners.size() < most; i += 3) {
        const auto inside = [&](unsigned v) { return v >= range.first && v < range.first + range.count; };
        if (inside(from[i]) && inside(from[i + 1]) && inside(from[i + 2]))
          for (size_t c = 0; c < 3; ++c) corners.push_back(static_cast<uint32_t>(from[i + c] - range.first));
      }
    };
    take(left, SIZE_MAX);
    if (corners.empty()) take(indices_, 3);
    return corners;
  }

  void write(const Range& range, std::vector<uint32_t> corners) {
    if (corners.empty()) return;
    std::vector<uint32_t> vertices, number(range.count, UINT32_MAX);
    for (uint32_t& corner : corners) {
      if (number[corner] == UINT32_MAX) {
        number[corner] = static_cast<uint32_t>(vertices.size());
        vertices.push_back(corner);
      }
      corner = number[corner];
    }
    const tinygltf::Primitive& primitive = primitive_of(range.part);
    Json& json =
        out_.document["meshes"][range.mesh]["primitives"][static_cast<size_t>(read_.parts[range.part].primitive)];
    const auto pick = [&](int accessor) {
      orphans_.push_back(accessor);
      return pick_vertices(name_, read_, accessor, vertices, false, &out_);
    };
    for (const auto& [key, accessor] : primitive.attributes) json["attributes"][key] = pick(accessor);
    for (size_t t = 0; t < primitive.targets.size(); ++t)
      for (const auto& [key, accessor] : primitive.targets[t]) json["targets"][t][key] = pick(accessor);
    if (primitive.indices >= 0) orphans_.push_back(primitive.indices);
    json["indices"] = add_accessor(&out_, corners.data(), corners.size() * 4, "SCALAR",
                                   TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, corners.size(), false, false);
    out_.document["bufferViews"].back()["target"] = TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER;
    json["mode"] = TINYGLTF_MODE_TRIANGLES;
  }

  const std::string& name_;
  const GltfSource& read_;
  GltfSource out_;
  std::vector<Range> ranges_;
  std::vector<float> positions_;   // [all vertices x 3]
  std::vector<unsigned> indices_;  // [all corners]
  std::vector<int> orphans_;
};

#endif

}  // namespace

std::vector<uint8_t> reduced_glb(const std::string& name, const Character& character,
                                 const std::vector<Vec3>& positions, double share) {
  if (!character.gltf || character.gltf->vertex_count != positions.size())
    throw Error(name + ": expected a character with a glTF document");
#ifdef SINEW_HAS_MESHOPT
  return Reducer(name, *character.gltf, positions).reduce(share);
#else
  (void)share;
  throw Error(name + ": this build leaves out no triangles; build with meshoptimizer (libmeshoptimizer-dev)");
#endif
}

}  // namespace sinew
