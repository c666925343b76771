// SPDX-License-Identifier: MIT
// Sided names to a front, posed meshes to points.
#include "data/front_sample.hpp"

#include <cmath>

#include "core/random.hpp"
#include "sinew/names.h"
#include "sinew_formats/error.hpp"

namespace sinew {
namespace {

using namespace rigging;

constexpr double kLeastSideways = 0.7;  // horizontal share of the distance from right to left
constexpr uint32_t kLeastSided = 2;     // joints of each side
constexpr double kLeastAlong = 0.75;    // share along the floor of the distance from pelvis and tail to the head
constexpr double kLeastTrunk = 0.15;    // of the longest side
constexpr double kAlongAxis = 0.6;      // share of tilted meshes that face along an axis
constexpr uint32_t kTilted = 2;         // samples of a copy

// In a body along the floor, a quadruped's or a fish's, the head is in front of pelvis and tail.
std::array<double, 2> front_by_head(const RigSource& source, const RigSource::PosedMesh& posed_mesh) {
  std::array<double, 3> sums[2] = {};  // of heads, of what is behind
  uint32_t counts[2] = {0, 0};
  for (size_t j = 0; j < posed_mesh.joints.size(); ++j) {
    const uint8_t c = source.target().joints[j].joint_class;
    const bool head = c == kClassHead, behind = c == kClassPelvis || c == kClassTail;
    if (!head && !behind) continue;
    for (size_t axis = 0; axis < 3; ++axis) sums[head ? 0 : 1][axis] += posed_mesh.joints[j][axis];
    ++counts[head ? 0 : 1];
  }
  if (counts[0] == 0 || counts[1] == 0)
    throw Error(source.name() + ": its front is unknown; name its joints by side, or a head and a pelvis");
  std::array<double, 3> along{};
  for (size_t axis = 0; axis < 3; ++axis) along[axis] = sums[0][axis] / counts[0] - sums[1][axis] / counts[1];
  const double size = std::hypot(along[0], along[1], along[2]);
  if (std::fabs(along[2]) < kLeastAlong * size || size < kLeastTrunk)
    throw Error(source.name() +
                ": its joints' names do not tell left from right, and it is not horizontal; rename its joints");
  return {0, along[2] > 0 ? 1.0 : -1.0};  // in its mirror frame
}

// A direction of the floor's plane from the mean of the right joints to that of the left ones, rotated to the front.
std::array<double, 2> front_of(const RigSource& source) {
  const RigSource::PosedMesh posed_mesh = source.make_mesh(0, {});
  std::array<double, 3> sums[2] = {};
  uint32_t counts[2] = {0, 0};
  for (size_t j = 0; j < posed_mesh.joints.size(); ++j) {
    const TargetJoint& joint = source.target().joints[j];
    const int side = joint.tip ? 0 : sinew_joint_side(joint.name.c_str());
    if (side == 0) continue;
    for (size_t axis = 0; axis < 3; ++axis) sums[side > 0 ? 0 : 1][axis] += posed_mesh.joints[j][axis];
    ++counts[side > 0 ? 0 : 1];
  }
  if (counts[0] < kLeastSided || counts[1] < kLeastSided) return front_by_head(source, posed_mesh);
  std::array<double, 3> left{};
  double squared = 0;
  for (size_t axis = 0; axis < 3; ++axis) {
    left[axis] = sums[0][axis] / counts[0] - sums[1][axis] / counts[1];
    squared += left[axis] * left[axis];
  }
  const double flat = std::hypot(left[0], left[2]);
  if (flat < kLeastSideways * std::sqrt(squared) || flat < 1e-6)
    throw Error(source.name() + ": its left and right joints are above each other");
  return {-left[2] / flat, left[0] / flat};
}

int32_t rounded(double x) { return static_cast<int32_t>(std::lround(x)); }

// Tilts a mesh as if its other axis was taken for up: it lies, most often on its back or its face, as bodies that
// face along an axis do.
void tilt(Random* random, std::vector<SurfacePoint>* points) {
  constexpr double kHalfTurn = 3.141592653589793;
  const double angle = random->uniform() < kAlongAxis ? kHalfTurn * random->below(2) + 0.1 * random->normal()
                                                      : random->uniform(0, 2 * kHalfTurn);
  const double c = std::cos(angle), s = std::sin(angle);
  const auto tilted = [&](Vec3i v) -> Vec3i { return {rounded(c * v.x + s * v.z), -rounded(c * v.z - s * v.x), v.y}; };
  for (SurfacePoint& p : *points) {
    p.position = tilted(p.position);
    p.normal = tilted(p.normal);
  }
}

std::vector<SurfacePoint> points_of(const RigSource::PosedMesh& posed_mesh, uint64_t seed) {
  std::vector<SurfacePoint> points(kFrontPoints);
  spread_points(posed_mesh.engine.mesh, kFrontPoints, seed, points.data());
  return points;
}

}  // namespace

FrontSource::FrontSource(const Character& character) : source_(character), front_(front_of(source_)) {}

FrontSample FrontSource::sample(const std::vector<SurfacePoint>& points, uint32_t frame, bool upright) const {
  FrontSample s;
  s.name = source_.name();
  s.family = source_.family();
  s.upright = upright;
  s.front = {static_cast<float>(front_[0]), static_cast<float>(front_[1])};
  s.vertices = kFrontPoints;
  s.candidates = s.part_count = s.joints = 1;
  s.inputs.resize(1);
  s.inputs[0].channels = kFrontChannels;
  s.inputs[0].rows.resize(size_t{kFrontPoints} * kFrontChannels);
  s.candidate.assign(kFrontPoints, 0xFFFF);
  s.row_offsets.assign(kFrontPoints + 1, 0);
  s.part.assign(kFrontPoints, 0);
  s.part_offsets = {0, kFrontPoints};
  std::vector<FrontPoint> room(kFrontPoints);
  FrontView view;
  view.points = room.data();
  view_points(points.data(), 0, &view);
  front_rows(view, frame, s.inputs[0].rows.data());
  constexpr float kUnit = 1.0f / (1 << kNormalBits);
  for (uint32_t i = 0; i < kFrontPoints; ++i) {
    s.part_vertices.push_back(i);
    const FrontOffset d = front_offset(view, i);
    s.positions.push_back(static_cast<float>(d.x) / kSide);
    s.positions.push_back(static_cast<float>(d.z) / kSide);
    s.normals.push_back(static_cast<float>(room[i].normal.x) * kUnit);
    s.normals.push_back(static_cast<float>(room[i].normal.z) * kUnit);
  }
  return s;
}

std::vector<FrontSample> FrontSource::make(uint64_t seed, const RigVariant& variant, uint32_t upright) const {
  const RigSource::PosedMesh posed_mesh = source_.make_mesh(mix_seeds(seed, 1), variant);
  Random random(mix_seeds(seed, 2));
  const uint32_t first = random.below(kFrontFrames), turn = 1 + random.below(kFrontFrames - 1);
  std::vector<FrontSample> samples;
  for (uint32_t i = 0; i < upright; ++i)
    samples.push_back(sample(points_of(posed_mesh, random.next()), (first + i * turn) % kFrontFrames, true));
  for (uint32_t i = 0; i < kTilted; ++i) {
    std::vector<SurfacePoint> points = points_of(posed_mesh, random.next());
    tilt(&random, &points);
    samples.push_back(sample(points, random.below(kFrontFrames), false));
  }
  return samples;
}

FrontSample FrontSource::original(uint64_t seed) const {
  return sample(points_of(source_.make_mesh(seed, {}), seed), 0, true);
}

}  // namespace sinew
