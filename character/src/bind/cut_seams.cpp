// SPDX-License-Identifier: MIT
// Vertices along seams doubled, faces given to one of their two parts.
#include <algorithm>
#include <map>
#include <utility>

#include "bind/seam_steps.hpp"
#include "gltf/changed_document.hpp"
#include "sinew_character/bind/bind.hpp"
#include "sinew_character/bind/seams.hpp"
#include "sinew_character/rig/mesh_surface.hpp"
#include "sinew_formats/base/box.hpp"
#include "sinew_formats/base/point.hpp"

namespace sinew {
namespace {

constexpr double kParted = 4e-6;  // of the longest side: four units of the engine's grid

class SeamCutter {
 public:
  SeamCutter(const Seams& seams, Character* character)
      : character_(*character), welded_(first_at_position(*character)), crossing_(seams.edges) {
    std::sort(crossing_.begin(), crossing_.end());
  }

  size_t run() {
    const size_t before = character_.vertices.size();
    const std::vector<char> inside_out = faces_inside_out(character_, welded_);
    reverse_faces(inside_out);
    stays_.assign(before, 0);
    for (size_t f = 0; f < character_.face_count(); ++f) {
      const std::vector<uint32_t> corners = corners_of(f);
      const Run own = longest_run(corners);
      for (size_t k = 0; k < own.count; ++k)
        stays_[character_.face_vertices[character_.face_offsets[f] + (own.begin + k) % corners.size()]] = 1;
    }
    for (size_t f = 0; f < character_.face_count(); ++f) cut_face(f);
    const size_t doubled = character_.vertices.size() - before;
    if (!character_.influences.empty()) weigh(before);
    part_copies(before);
    reverse_faces(inside_out);
    if (character_.gltf && doubled > 0)
      character_.gltf = cut_document(character_.name, *character_.gltf, character_.face_vertices, character_.vertices);
    return doubled;
  }

 private:
  // Which corners leave a face depends on its order of corners, which is that of a look from outside while seams are cut.
  void reverse_faces(const std::vector<char>& which) {
    const auto corner = [&](size_t f) { return character_.face_vertices.begin() + character_.face_offsets[f]; };
    for (size_t f = 0; f < which.size(); ++f)
      if (which[f] != 0) std::reverse(corner(f), corner(f + 1));
  }

  bool crosses(uint32_t a, uint32_t b) const {
    return std::binary_search(crossing_.begin(), crossing_.end(),
                              std::array<uint32_t, 2>{std::min(a, b), std::max(a, b)});
  }

  // Corners [begin, begin + count) around a face, from one edge that crosses to the next: the longest run keeps its vertices. A single
  // crossing edge, at an end of a seam, takes the corner behind it away.
  struct Run {
    size_t begin = 0, count = 0;
  };
  Run longest_run(const std::vector<uint32_t>& corners) const {
    std::vector<size_t> cuts;
    for (size_t i = 0; i < corners.size(); ++i)
      if (crosses(corners[i], corners[(i + 1) % corners.size()])) cuts.push_back(i);
    if (cuts.empty()) return {0, corners.size()};
    if (cuts.size() == 1) return {cuts[0] + 2, corners.size() - 1};
    Run longest;
    for (size_t k = 0; k < cuts.size(); ++k) {
      const size_t next = k + 1 < cuts.size() ? cuts[k + 1] : cuts[0] + corners.size();
      if (next - cuts[k] > longest.count) longest = {cuts[k] + 1, next - cuts[k]};
    }
    return longest;
  }

  std::vector<uint32_t> corners_of(size_t face) const {  // welded
    std::vector<uint32_t> corners;
    for (uint32_t c = character_.face_offsets[face]; c < character_.face_offsets[face + 1]; ++c)
      corners.push_back(welded_[character_.face_vertices[c]]);
    return corners;
  }

  void cut_face(size_t face) {
    const uint32_t first = character_.face_offsets[face];
    const std::vector<uint32_t> corners = corners_of(face);
    const Run own = longest_run(corners);
    for (size_t i = own.count; i < corners.size(); ++i) {
      const size_t across = (own.begin + i) % corners.size();
      std::vector<uint32_t>& beside = beside_[corners[across]];
      for (size_t k = 0; k < own.count; ++k)
        beside.push_back(character_.face_vertices[first + (own.begin + k) % corners.size()]);
      uint32_t& corner = character_.face_vertices[first + across];
      corner = doubled(corner);
    }
  }

  // A vertex that only this part uses, of a mesh that was cut before, stays one.
  uint32_t doubled(uint32_t vertex) {
    if (stays_[vertex] == 0) return doubles_[vertex] = vertex;
    const auto [at, is_new] = doubles_.try_emplace(vertex, static_cast<uint32_t>(character_.vertices.size()));
    if (!is_new) return at->second;
    const auto repeat = [vertex](auto* values) {
      if (values->empty()) return;
      const auto value = (*values)[vertex];
      values->push_back(value);
    };
    repeat(&character_.vertices);
    repeat(&character_.influences);
    repeat(&character_.confidence);
    repeat(&character_.vertex_meshes);
    repeat(&character_.vertex_colors);
    return at->second;
  }

  // Doubled vertices get the mean row of their new part.
  void weigh(size_t before) {
    for (const auto& [vertex, copy] : doubles_) {
      std::map<uint32_t, float> sums;
      size_t most = 0;
      for (const uint32_t v : beside_[welded_[vertex]]) {
        if (v >= before) continue;  // doubled itself
        most = std::max(most, character_.influences[v].size());
        for (const Influence& one : character_.influences[v]) sums[one.joint] += one.weight;
      }
      if (sums.empty()) continue;
      std::vector<Influence> row;
      for (const auto& [joint, weight] : sums) row.push_back({joint, weight});
      character_.influences[copy] = round_influences(row, static_cast<uint32_t>(most));
    }
  }

  // Engines merge vertices at one position, which would close the slit again: copies move a little towards their
  // part.
  void part_copies(size_t before) {
    const double step = kParted * static_cast<double>(box_of(character_.vertices).longest_side());
    for (const auto& [vertex, copy] : doubles_) {
      Point3 sum = {};
      double count = 0;
      for (const uint32_t v : beside_[welded_[vertex]]) {
        if (v >= before) continue;
        sum = sum + point(character_.vertices[v]);
        ++count;
      }
      if (copy < before || count == 0) continue;
      const Point3 from = point(character_.vertices[copy]);
      const Point3 to = from + step * unit((1 / count) * sum - from);
      character_.vertices[copy] = {static_cast<float>(to[0]), static_cast<float>(to[1]), static_cast<float>(to[2])};
    }
  }

  Character& character_;
  const std::vector<uint32_t> welded_;
  std::vector<std::array<uint32_t, 2>> crossing_;
  std::vector<char> stays_;                           // [V] a corner of a face of its own part
  std::map<uint32_t, uint32_t> doubles_;              // vertex -> its copy
  std::map<uint32_t, std::vector<uint32_t>> beside_;  // welded vertex -> vertices of the part that its copies belong to
};

}  // namespace

size_t cut_seams(const Seams& seams, Character* character) {
  if (seams.edges.empty()) return 0;
  Character cut = *character;  // as it was where a document is broken
  const size_t doubled = SeamCutter(seams, &cut).run();
  *character = std::move(cut);
  return doubled;
}

}  // namespace sinew
