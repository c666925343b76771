// SPDX-License-Identifier: MIT
// Training samples of skeleton prediction: points of a character's surface with the bones that move them.
#ifndef SINEW_TRAINER_DATA_RIG_SAMPLE_HPP
#define SINEW_TRAINER_DATA_RIG_SAMPLE_HPP

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "data/engine_mesh.hpp"
#include "data/rig_pose.hpp"
#include "data/sourced_surface.hpp"
#include "sinew_data_sets/target_skeleton.hpp"
#include "sinew_formats/base/point.hpp"
#include "sinew_formats/character.hpp"
#include "sinew_trainer/sample.hpp"
#include "votes/rig_points.hpp"

namespace sinew {

// One set of N = kSetPoints points (votes/rig_points.hpp of the engine). Lengths are shares of the longest side, x is folded:
// counted away from the mirror plane on the point's side.
struct RigSample : NetworkSample {
  std::vector<float> medial;                    // [N x 3] what offsets are counted from
  std::vector<float> start, end;                // [N x 3] of the bone that moves the point
  std::vector<float> weight;                    // [N] how much the loss cares
  std::vector<float> class_weight;              // [N] the same for classes; empty: as weight
  std::vector<uint8_t> start_class, end_class;  // [N] JointClass; of ends also kClassTip
};

// Makes a set of points of a mesh that is in its mirror frame, with the interior behind them, and hands it to `use`.
void with_point_set(const EngineMesh& engine, uint64_t seed, const std::function<void(const rigging::PointSet&)>& use);

// How a copy of a character differs from it.
struct RigVariant {
  double strength =
      0;  // 0: not at all, if the rest says nothing else; 1: joints rotate by up to a radian, bones and the whole are
          // stretched, small parts vanish
  bool wide = false;   // wide_pose() (rig_pose.hpp), not mild_pose()
  uint32_t cells = 0;  // fused: a shell of so many cells (grown_shell.hpp)
  bool wall = false;   // double (sourced_surface.hpp)
  bool specks = false;
  bool picture =
      false;  // as a picture of it would be, without the three above: mostly of its broad side (sourced_surface.hpp)
};

// A character in its mirror frame, ready to be posed, stretched and sampled. What a point learns follows its joints, so that
// labels stay exact.
class RigSource {
 public:
  // Throws Error where target_skeleton() does, and for a mesh that the engine refuses.
  explicit RigSource(const Character& character);

  // The same seed gives the same sample.
  RigSample make(uint64_t seed, const RigVariant& variant) const;

  // The mesh of such a sample, U welded vertices in their mirror frame.
  struct PosedMesh {
    EngineMesh engine;
    std::vector<Point3> joints;    // [target] shares of the longest side, not folded
    std::vector<uint32_t> source;  // [U] vertex of the surface that a welded vertex has its weights from
  };
  PosedMesh make_mesh(uint64_t seed, const RigVariant& variant) const;

  const std::string& name() const { return name_; }
  const std::string& family() const { return family_; }
  const TargetSkeleton& target() const { return body_.target; }

 private:
  // Where the character's own joints went: a vertex p of joint j goes to origin + linear (p - joint).
  struct Palette {
    std::vector<Eigen::Vector3d> origin;  // [J]
    std::vector<Eigen::Matrix3d> linear;  // [J]
  };
  struct Posed {
    SourcedSurface surface;
    std::vector<Point3> joints;  // of the target
    bool symmetric = true;
  };
  void find_partners();
  void find_parts();
  Posed pose(uint64_t seed, const RigVariant& variant) const;
  void draw(Random* random, Posed* posed) const;
  Palette palette(const RigPose& pose) const;
  // Moves a point of joint j with it, in the mirror frame.
  Eigen::Vector3d follow(const Palette& palette, uint32_t j, const Point3& p) const;
  // The vertices of faces by their own weights, in the mirror frame.
  std::vector<Point3> skin(const Palette& palette) const;
  std::vector<uint8_t> vanish(Random* random) const;  // [T] triangles that are gone
  SourcedSurface surface(const std::vector<Point3>& vertices, const std::vector<uint8_t>& gone) const;
  PosedMesh to_mesh(const Posed& posed, uint64_t seed) const;
  RigSample label(const PosedMesh& posed_mesh, const rigging::PointSet& set) const;

  std::string name_, family_;
  std::vector<Point3> vertices_;  // [V] mirror frame, side 1
  std::vector<std::array<uint32_t, 3>> triangles_;
  std::vector<std::vector<Influence>> influences_;  // [V] of the character's joints
  std::vector<Point3> joints_;                      // [J] of the character
  std::vector<int> parents_;                        // [J]
  std::vector<uint32_t> order_;                     // [J] parents first
  PoseBody body_;
  std::vector<uint32_t> part_;  // [T]
  std::vector<double> area_;    // [T] doubled
  uint32_t parts_ = 0;
};

// A set of points as a network's sample: what it reads, without what it should say.
inline RigSample point_sample(const rigging::PointSet& set) {
  using namespace rigging;
  RigSample s;
  s.vertices = kSetPoints;
  s.candidates = 1;
  s.part_count = 1;
  s.joints = 1;
  s.inputs.resize(1);
  s.inputs[0].channels = kRigChannels;
  s.inputs[0].rows.assign(set.features, set.features + size_t{kSetPoints} * kRigChannels);
  s.candidate.assign(kSetPoints, 0xFFFF);
  s.part.assign(kSetPoints, 0);
  s.part_offsets = {0, kSetPoints};
  for (uint32_t i = 0; i <= kSetPoints; ++i) {
    if (i < kSetPoints) s.part_vertices.push_back(i);
    s.row_offsets.push_back(i * kNeighbors);
  }
  s.far_offsets = s.row_offsets;
  s.col_indices.assign(set.near_neighbors, set.near_neighbors + size_t{kSetPoints} * kNeighbors);
  s.far_indices.assign(set.far_neighbors, set.far_neighbors + size_t{kSetPoints} * kNeighbors);
  return s;
}

}  // namespace sinew
#endif
