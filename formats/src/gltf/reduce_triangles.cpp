// SPDX-License-Identifier: MIT
// Triangles of all primitives through one simplifier, and the vertices that are left picked from every accessor.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
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

// Corners at one position of a primitive are one vertex for the simplifier if they differ by no more than this. What
// differs more is a seam.
constexpr float kNormalCosine = 0.94f;  // 20 degrees
constexpr float kNear = 1e-3f;          // of texture coordinates and colors
// A level with more triangles than this many times the wanted is made again without seams.
constexpr double kMissed = 1.1;

// A primitive's vertices among those of all, and what they have, tightly packed; empty: nothing.
struct Range {
  size_t part, mesh, first, count;
  std::vector<float> places, normals, uvs, colors;  // 3, 3, 2 and `color_width` a vertex
  size_t color_width = 4;
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
      ranges_.push_back(range_of(p, static_cast<size_t>(mesh), first, primitive));
      for (const uint32_t v : part.vertex_of) {
        positions_.insert(positions_.end(), {positions[v].x, positions[v].y, positions[v].z});
        welded_.push_back(v);
      }
      for (const auto& triangle : primitive_triangles(name_, read_.model, primitive, part.vertex_of.size()))
        for (const uint32_t v : triangle) indices_.push_back(static_cast<unsigned>(first + v));
    }
  }

  std::vector<uint8_t> reduce(double share) {
    const size_t wanted = static_cast<size_t>(share * static_cast<double>(indices_.size() / 3)) * 3;
    std::vector<unsigned> left = simplified(same_vertices(false), wanted);
    // Seams everywhere, as of flat shading: the simplifier finds nothing that it may take.
    if (static_cast<double>(left.size()) > kMissed * static_cast<double>(wanted)) {
      std::vector<unsigned> without = simplified(same_vertices(true), wanted);
      if (without.size() < left.size()) {
        choose_copies(&without);
        left = std::move(without);
      }
    }
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

  Range range_of(size_t part, size_t mesh, size_t first, const tinygltf::Primitive& primitive) const {
    Range range = {part, mesh, first, read_.parts[part].vertex_of.size(), {}, {}, {}, {}, 4};
    const auto values = [&](const char* key, size_t width) {
      const auto found = primitive.attributes.find(key);
      if (found == primitive.attributes.end()) return std::vector<float>();
      std::vector<float> all = accessor_floats(name_, read_.model, found->second, static_cast<int>(width));
      return all.size() == range.count * width ? all : std::vector<float>();
    };
    range.places = values("POSITION", 3);
    range.normals = values("NORMAL", 3);
    range.uvs = values("TEXCOORD_0", 2);
    if (const auto found = primitive.attributes.find("COLOR_0"); found != primitive.attributes.end()) {
      range.color_width =
          read_.model.accessors.at(static_cast<size_t>(found->second)).type == TINYGLTF_TYPE_VEC3 ? 3 : 4;
      range.colors = values("COLOR_0", range.color_width);
    }
    return range;
  }

  static bool near(const std::vector<float>& values, size_t width, size_t a, size_t b) {
    for (size_t i = 0; i < width && !values.empty(); ++i)
      if (std::abs(values[width * a + i] - values[width * b + i]) > kNear) return false;
    return true;
  }

  static float cosine(const std::vector<float>& vectors, size_t a, const float* b) {
    if (vectors.empty()) return 1;
    return vectors[3 * a] * b[0] + vectors[3 * a + 1] * b[1] + vectors[3 * a + 2] * b[2];
  }

  // [all vertices] the first vertex of its primitive with the same position and weights, and either with the same
  // other attributes or with any.
  std::vector<unsigned> same_vertices(bool whatever) {
    std::vector<unsigned> same(welded_.size());
    copies_.assign(welded_.size(), {});
    for (const Range& range : ranges_) {
      std::map<uint32_t, std::vector<size_t>>
          known;  // by the character's vertex: first vertices, in the range's numbers
      for (size_t v = 0; v < range.count; ++v) {
        std::vector<size_t>& firsts = known[welded_[range.first + v]];
        const auto found = std::find_if(firsts.begin(), firsts.end(), [&](size_t first) {
          return whatever ||
                 (near(range.uvs, 2, first, v) && near(range.colors, range.color_width, first, v) &&
                  (range.normals.empty() || cosine(range.normals, first, &range.normals[3 * v]) > kNormalCosine));
        });
        const size_t first = found == firsts.end() ? v : *found;
        if (found == firsts.end()) firsts.push_back(v);
        same[range.first + v] = static_cast<unsigned>(range.first + first);
        copies_[range.first + first].push_back(static_cast<unsigned>(range.first + v));
      }
    }
    return same;
  }

  // Corners of the triangles that are left, first vertices alone: the simplifier treats others at the same position
  // as a seam, used or not.
  std::vector<unsigned> simplified(const std::vector<unsigned>& same, size_t wanted) const {
    std::vector<unsigned> firsts, number(same.size(), 0), joined;
    std::vector<float> positions;
    for (unsigned v = 0; v < same.size(); ++v) {
      if (same[v] != v) continue;
      number[v] = static_cast<unsigned>(firsts.size());
      firsts.push_back(v);
      positions.insert(positions.end(), &positions_[3 * size_t{v}], &positions_[3 * size_t{v}] + 3);
    }
    for (const unsigned v : indices_) joined.push_back(number[same[v]]);
    std::vector<unsigned> left(joined.size());
    left.resize(meshopt_simplify(left.data(), joined.data(), joined.size(), positions.data(), firsts.size(),
                                 3 * sizeof(float), wanted, 1.0f, 0, nullptr));
    for (unsigned& corner : left) corner = firsts[corner];
    return left;
  }

  // For each corner the copy whose normal fits the triangle and whose texture coordinates continue those of the other
  // corners.
  void choose_copies(std::vector<unsigned>* corners) const {
    for (size_t i = 0; i + 2 < corners->size(); i += 3) {
      const auto range = std::find_if(ranges_.begin(), ranges_.end(), [&](const Range& one) {
        return (*corners)[i] >= one.first && (*corners)[i] < one.first + one.count;
      });
      std::array<unsigned, 3> best{};
      float least = 1e30f;
      const std::array<float, 3> normal = normal_of(*range, &(*corners)[i]);
      for (const unsigned start : copies_[(*corners)[i]]) {
        std::array<unsigned, 3> chosen = {start, 0, 0};
        float cost = 1 - cosine(range->normals, start - range->first, normal.data());
        for (size_t c = 1; c < 3; ++c) cost += cheapest(*range, (*corners)[i + c], start, normal, &chosen[c]);
        if (cost < least) least = cost, best = chosen;
      }
      std::copy(best.begin(), best.end(), corners->begin() + static_cast<std::ptrdiff_t>(i));
    }
  }

  float cheapest(const Range& range, unsigned first, unsigned start, const std::array<float, 3>& normal,
                 unsigned* chosen) const {
    constexpr float kTexture = 4;  // what the width of a texture weighs against a right angle between normals
    float least = 1e30f;
    for (const unsigned copy : copies_[first]) {
      const size_t v = copy - range.first, from = start - range.first;
      float cost = 1 - cosine(range.normals, v, normal.data());
      for (size_t k = 0; k < 2 && !range.uvs.empty(); ++k)
        cost += kTexture * std::abs(range.uvs[2 * v + k] - range.uvs[2 * from + k]);
      if (cost < least) least = cost, *chosen = copy;
    }
    return least;
  }

  static std::array<float, 3> normal_of(const Range& range, const unsigned* corners) {
    const auto place = [&](size_t c) { return &range.places[3 * (corners[c] - range.first)]; };
    std::array<float, 3> u{}, v{}, n{};
    for (size_t k = 0; k < 3; ++k) u[k] = place(1)[k] - place(0)[k], v[k] = place(2)[k] - place(0)[k];
    for (size_t k = 0; k < 3; ++k) n[k] = u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3];
    const float length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    for (float& value : n) value = length > 0 ? value / length : 0;
    return n;
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
  std::vector<uint32_t> welded_;   // [all vertices] the character's vertex
  std::vector<unsigned> indices_;  // [all corners]
  std::vector<std::vector<unsigned>>
      copies_;  // [all vertices] of a first vertex all that are the same, see same_vertices()
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
  throw Error(name +
              ": cannot reduce triangles, this sinew was built without meshoptimizer; install libmeshoptimizer-dev and "
              "build again");
#endif
}

}  // namespace sinew
