// SPDX-License-Identifier: MIT
// Measures the mesh in test poses: edges that tear, bends that collapse, faces inside out, parts that go through each
// other.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "check/findings.hpp"
#include "check/rig_facts.hpp"
#include "sinew_character/check/surface_faults.hpp"
#include "sinew_character/pose/bend_volume.hpp"
#include "sinew_character/pose/pose.hpp"
#include "sinew_formats/base/point.hpp"
#include "sinew_formats/print.hpp"

namespace sinew {
namespace {

class PoseCheck {
 public:
  PoseCheck(const RigFacts& facts, Findings* findings)
      : facts_(facts), findings_(findings), volumes_(facts.character), edges_of_(facts.moves.size(), 0) {
    const Character& c = facts.character;
    for (const uint32_t v : c.face_vertices)
      if (facts.strongest[v] != kNoOne) ++edges_of_[facts.strongest[v]];
  }

  void look(const TestPose& pose) {
    const Character posed = apply_pose(facts_.character, pose.palette);
    tears(pose, posed);
    std::vector<float> positions;
    for (const Vec3& p : posed.vertices) positions.insert(positions.end(), {p.x, p.y, p.z});
    for (const size_t joint : pose.joints) volume(pose, joint, positions);
    flips(pose, posed);
    crossings(pose, posed);
  }

 private:
  // Pairs of joints on the two ends, the lower index first.
  void tears(const TestPose& pose, const Character& posed) {
    std::map<std::array<uint32_t, 2>, std::vector<uint32_t>> torn;
    for (const TornEdge& edge : torn_edges(facts_.character, posed)) {
      const uint32_t a = facts_.strongest[edge[0]], b = facts_.strongest[edge[1]];
      auto& vertices = torn[{std::min(a, b), std::max(a, b)}];
      vertices.insert(vertices.end(), {edge[0], edge[1]});
    }
    for (auto& [joints, vertices] : torn) {
      size_t all = 0;
      for (const uint32_t j : joints) all += j == kNoOne ? 0 : edges_of_[j];
      RigFinding finding;
      finding.joint = joints[0] == kNoOne ? -1 : static_cast<int>(joints[0]);
      finding.other = joints[1] == kNoOne || joints[1] == joints[0] ? -1 : static_cast<int>(joints[1]);
      finding.value = static_cast<double>(vertices.size()) / 2 / static_cast<double>(std::max<size_t>(all, 1));
      finding.what = print("%zu edges tear", vertices.size() / 2) + between(finding);
      unique(&vertices);
      finding.vertices = std::move(vertices);
      finding.pose = pose.name;
      findings_->add("tear", std::move(finding));
    }
  }

  void volume(const TestPose& pose, size_t joint, const std::vector<float>& positions) {
    const std::optional<double> kept = volumes_.kept(joint, positions);
    if (!kept) return;
    RigFinding finding;
    finding.joint = static_cast<int>(joint);
    finding.value = 1 - *kept;
    finding.what =
        "the bend of " + findings_->quoted(finding.joint) + print(" keeps %.0f %% of its volume", 100 * *kept);
    finding.pose = pose.name;
    findings_->add("lost-volume", std::move(finding));
  }

  // Counts faces whose normal points away from the rest normal rotated by the mean of their corners' rotations, by
  // the strongest joint of their corners.
  void flips(const TestPose& pose, const Character& posed) {
    const Character& c = facts_.character;
    std::map<uint32_t, std::vector<uint32_t>> turned;
    std::map<uint32_t, double> area, all;
    for (size_t f = 0; f < c.face_count(); ++f) {
      const uint32_t begin = c.face_offsets[f], end = c.face_offsets[f + 1];
      for (uint32_t k = begin + 2; k < end; ++k) {
        const std::array<uint32_t, 3> t = {c.face_vertices[begin], c.face_vertices[k - 1], c.face_vertices[k]};
        const uint32_t joint = facts_.strongest[t[0]];
        if (joint == kNoOne) continue;
        const Point3 before = normal(c, t), after = normal(posed, t);
        Point3 expected = {};
        for (const uint32_t v : t) {
          const uint32_t j = facts_.strongest[v];
          if (j == kNoOne) continue;
          const std::array<double, 3> n = transform_normal(pose.palette[j], before[0], before[1], before[2]);
          expected = expected + Point3{n[0], n[1], n[2]};
        }
        // Bends in which the joint itself does not rotate are ignored for it.
        all[joint] += length(before);
        if (dot(after, expected) >= 0) continue;
        area[joint] += length(before);
        turned[joint].insert(turned[joint].end(), t.begin(), t.end());
      }
    }
    for (auto& [joint, vertices] : turned) {
      RigFinding finding;
      finding.joint = static_cast<int>(joint);
      finding.value = area[joint] / all[joint];
      finding.what = print("%zu faces of ", vertices.size() / 3) + findings_->quoted(finding.joint) + " are inverted";
      unique(&vertices);
      finding.vertices = std::move(vertices);
      finding.pose = pose.name;
      findings_->add("flip", std::move(finding));
    }
  }

  // Intersections of the descendants of each rotating joint with everything that does not follow its parent.
  void crossings(const TestPose& pose, const Character& posed) {
    for (const size_t joint : pose.joints) {
      const int parent = facts_.character.joints[joint].parent;
      if (parent < 0 || facts_.verdicts.classes[joint] == SINEW_CLASS_SPINE) continue;
      const auto part = [&](const Character& of, bool own) {
        Character out;
        out.vertices = of.vertices;
        for (size_t f = 0; f < of.face_count(); ++f) {
          const uint32_t strongest = facts_.strongest[of.face_vertices[of.face_offsets[f]]];
          if (strongest == kNoOne) continue;
          const bool below = facts_.is_below(strongest, joint),
                     near = facts_.is_below(strongest, static_cast<size_t>(parent));
          if (own ? !below : near) continue;
          for (uint32_t k = of.face_offsets[f]; k < of.face_offsets[f + 1]; ++k)
            out.face_vertices.push_back(of.face_vertices[k]);
          out.face_offsets.push_back(static_cast<uint32_t>(out.face_vertices.size()));
        }
        return out;
      };
      Character limb = part(posed, true), rest = part(posed, false);
      if (limb.face_count() == 0 || rest.face_count() == 0) continue;
      const auto now = crossing_pairs(limb, rest);
      if (now.empty()) continue;
      limb.vertices = rest.vertices = facts_.character.vertices;
      RigFinding finding;
      finding.joint = static_cast<int>(joint);
      const size_t added = new_crossings(crossing_pairs(limb, rest), now);
      finding.value = static_cast<double>(added) / static_cast<double>(limb.face_count());
      finding.what = "a child of " + findings_->quoted(finding.joint) +
                     print(" passes through other parts, %zu pairs of faces", added);
      finding.pose = pose.name;
      findings_->add("crossing", std::move(finding));
    }
  }

  std::string between(const RigFinding& finding) const {
    if (finding.joint < 0) return " beside vertices without weight";
    if (finding.other < 0) return " on " + findings_->quoted(finding.joint);
    return " between " + findings_->quoted(finding.joint) + " and " + findings_->quoted(finding.other);
  }

  static void unique(std::vector<uint32_t>* vertices) {
    std::sort(vertices->begin(), vertices->end());
    vertices->erase(std::unique(vertices->begin(), vertices->end()), vertices->end());
  }

  static Point3 normal(const Character& c, const std::array<uint32_t, 3>& t) {
    const Point3 a = point(c.vertices[t[0]]);
    return cross(point(c.vertices[t[1]]) - a, point(c.vertices[t[2]]) - a);
  }

  const RigFacts& facts_;
  Findings* findings_;
  BendVolumes volumes_;
  std::vector<size_t> edges_of_;  // [J] corners that it is the strongest of
};

}  // namespace

void check_poses(const RigFacts& facts, Findings* findings) {
  if (facts.character.face_count() == 0) return;
  PoseCheck check(facts, findings);
  for (const TestPose& pose : test_poses(facts)) check.look(pose);
}

}  // namespace sinew
