// SPDX-License-Identifier: MIT
// Inverse bind matrices and scales of a glTF's joints; the mesh as the file shows it.
#include <algorithm>
#include <cmath>

#include "check/findings.hpp"
#include "sinew_character/pose/pose.hpp"
#include "sinew_formats/base/box.hpp"
#include "sinew_formats/base/point.hpp"
#include "sinew_formats/gltf_summary.hpp"
#include "sinew_formats/print.hpp"

namespace sinew {
namespace {

// How far a matrix moves the middle of what the joint moves, of the size.
double moved_by(const RigFacts& facts, const Affine& matrix, size_t joint) {
  double most = 0;
  for (const uint32_t v : facts.moves[joint]) {
    const Point3 p = point(facts.character.vertices[v]);
    const std::array<double, 3> q = transform_point(matrix, p[0], p[1], p[2]);
    most = std::max(most, length(Point3{q[0], q[1], q[2]} - p));
  }
  return most / facts.size;
}

// Joints whose matrix does something else than most others: with a file at rest all do nothing.
void odd_matrices(const RigFacts& facts, const GltfRest& rest, Findings* findings) {
  constexpr double kFew = 0.2;  // of the joints; more of them are a pose that the file was saved in
  std::vector<size_t> odd;
  size_t moving = 0;
  const double bound = findings->bound("bind-matrices");
  for (size_t j = 0; j < rest.shown.size(); ++j) {
    if (facts.moves[j].empty()) continue;
    ++moving;
    if (moved_by(facts, rest.shown[j], j) > bound) odd.push_back(j);
  }
  if (odd.empty() || static_cast<double>(odd.size()) > kFew * static_cast<double>(moving)) return;
  for (const size_t j : odd) {
    RigFinding finding;
    finding.joint = static_cast<int>(j);
    finding.value = moved_by(facts, rest.shown[j], j);
    finding.what =
        "the inverse bind matrix of " + findings->quoted(finding.joint) +
        print(" moves its vertices by %.2f of the size at rest, unlike those of other joints", finding.value);
    findings->add("bind-matrices", std::move(finding));
  }
}

void scales(const RigFacts& facts, const GltfRest& rest, Findings* findings) {
  RigFinding mirrored, uneven;
  for (size_t j = 0; j < rest.mirrored.size(); ++j) {
    const bool moves = !facts.moves[j].empty();
    if (moves && rest.mirrored[j] != 0) {
      if (mirrored.joint < 0) mirrored.joint = static_cast<int>(j);
      mirrored.value += 1;
    }
    if (moves && rest.uneven[j] > uneven.value) uneven.value = rest.uneven[j], uneven.joint = static_cast<int>(j);
  }
  if (mirrored.joint >= 0) {
    mirrored.what =
        print("%.0f joints have a negative scale, ", mirrored.value) + findings->quoted(mirrored.joint) + " first";
    findings->add("mirrored-scale", std::move(mirrored));
  }
  if (uneven.joint >= 0) {
    uneven.what = findings->quoted(uneven.joint) +
                  print(" is scaled %.2f times as much along one axis as along another", uneven.value);
    findings->add("uneven-scale", std::move(uneven));
  }
}

// "'a', 'b', ...", of five at most.
std::string quoted_names(const std::vector<std::string>& names) {
  std::string text;
  for (size_t i = 0; i < names.size() && i < 5; ++i) text += (i == 0 ? "'" : ", '") + names[i] + "'";
  return text + (names.size() > 5 ? ", ..." : "");
}

// Contents of a file beside its character: a scale above the skeleton, skins that no mesh has, meshes that stay
// behind.
void beside(const RigFacts& facts, const GltfRest& rest, Findings* findings) {
  RigFinding scaled, skins, meshes;
  scaled.value = std::max(rest.scale, 1 / rest.scale);
  scaled.what = "node '" + rest.scaled_by + print("' above the skeleton has scale %g", rest.scale);
  findings->add("scaled-skin", std::move(scaled));
  skins.value = static_cast<double>(rest.unused_skins.size());
  skins.what = print("%zu skins without a mesh: ", rest.unused_skins.size()) + quoted_names(rest.unused_skins);
  findings->add("unused-skin", std::move(skins));
  std::vector<std::string> names;
  const Character& c = facts.character;
  std::vector<uint8_t> stray(c.meshes.size(), 0);
  for (size_t m = 0; m < c.meshes.size(); ++m) {
    if (c.meshes[m].skinned || c.meshes[m].carrier >= 0) continue;
    stray[m] = 1;
    names.push_back(c.meshes[m].name);
  }
  if (names.size() == c.meshes.size()) return;
  for (uint32_t v = 0; v < c.vertex_meshes.size(); ++v)
    if (stray[c.vertex_meshes[v]] != 0) meshes.vertices.push_back(v);
  meshes.value = static_cast<double>(names.size());
  meshes.what =
      print("%zu meshes have no skin and no parent joint, so they do not move with the character: ", names.size()) +
      quoted_names(names);
  findings->add("stray-mesh", std::move(meshes));
}

// Share of the edges that are more than twice or less than half as long: a pose bends far fewer.
double changed_edges(const Character& rest, const Character& shown) {
  size_t changed = 0;
  for (size_t f = 0; f < rest.face_count(); ++f) {
    const uint32_t first = rest.face_offsets[f], last = rest.face_offsets[f + 1];
    for (uint32_t c = first; c < last; ++c) {
      const uint32_t a = rest.face_vertices[c], b = rest.face_vertices[c + 1 < last ? c + 1 : first];
      const double before = length(point(rest.vertices[a]) - point(rest.vertices[b])),
                   after = length(point(shown.vertices[a]) - point(shown.vertices[b]));
      changed += after > 2 * before || 2 * after < before ? 1 : 0;
    }
  }
  return static_cast<double>(changed) / static_cast<double>(rest.face_vertices.size());
}

}  // namespace

void check_matrices(const RigFacts& facts, Findings* findings) {
  if (!facts.bound) return;
  const std::optional<GltfRest> rest = gltf_rest(facts.character);
  if (!rest) return;
  scales(facts, *rest, findings);
  beside(facts, *rest, findings);
  if (!rest->agrees) {
    RigFinding finding;
    finding.value = 1;
    finding.what = "the inverse bind matrices share no pose";
    findings->add("bind-matrices", std::move(finding));
    return;
  }
  odd_matrices(facts, *rest, findings);
  constexpr double kGrown = 2;  // times the size at rest
  if (facts.character.face_vertices.empty()) return;
  RigFinding finding;
  const Character shown = apply_pose(facts.character, rest->shown);
  finding.value = changed_edges(facts.character, shown);
  // Rigid parts have no edges between them that could tell.
  const double grown = static_cast<double>(box_of(shown.vertices).longest_side()) / facts.size;
  if (grown > kGrown || grown * kGrown < 1) finding.value = 1;
  finding.what = print("%.0f %% of the edges are twice or half as long as in the mesh", 100 * finding.value);
  findings->add("exploded-rest", std::move(finding));
}

}  // namespace sinew
