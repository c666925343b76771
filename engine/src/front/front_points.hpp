// SPDX-License-Identifier: MIT
// Input of the front's network: points of the surface in a frame of their own, in which a mesh looks the same however
// it is rotated about the upright axis.
#ifndef SINEW_FRONT_FRONT_POINTS_HPP
#define SINEW_FRONT_FRONT_POINTS_HPP

#include "front/surface_points.hpp"
#include "model/task.hpp"

namespace sinew::rigging {

constexpr uint32_t kFrontFeatureSet = 5;  // of the rig task
constexpr uint32_t kFrontPoints = kSetPoints;
// The network sees a mesh along both directions of the points' long axis in the plane of the floor, and across it.
// The four answers are added, so that the direction of the axis does not matter.
constexpr uint32_t kFrontFrames = 4;

// Channels of a point, Q13. Lengths are shares of the longest side. "Along" is along the frame's axis, "across" is counted away
// from it, so that a mesh and its mirror image look the same.
enum FrontChannel : uint32_t {
  kFrontHeight = 0,  // 2 (y - middle of the box)
  kFrontAlong = 1,   // 2 from the mean
  kFrontAcross = 2,  // 2
  kFrontNormal = 3,  // 3: up, along, across
  kFrontRadius = 6,  // 2 from the upright axis through the mean
  kFrontRaised = 7,  // 2 (y - mean y)
  kFrontBody = 8,    // 3: 3 rms radius, 1.5 box height, how much longer than wide; the same for all points
  kFrontChannels = 11
};

// The network's output for a point, Q10: how much its position in the floor's plane counts, how much its normal, and
// how much the mesh looks upright (logit, base e).
enum FrontOutput : uint32_t { kFrontPosition = 0, kFrontNormalShare = 1, kFrontUpright = 2, kFrontOutputs = 3 };
// front = mean of kFrontPositionScale position x + kFrontNormalScale normal x; shares of the side.
constexpr int kFrontPositionScale = 8, kFrontNormalScale = 2;

bool front_task(uint32_t feature_set, ModelTask* task);

struct FrontPoint {
  Vec3i position;  // grid units, y up
  Vec3i normal;    // Q14
};

struct FrontView {
  FrontPoint* points = nullptr;  // [kFrontPoints]
  Vec3i mean = {0, 0, 0};
  int32_t middle = 0, height = 0;        // of the box, upright
  int32_t radius = 0;                    // rms, in the plane
  int32_t axis_x = 1 << 14, axis_z = 0;  // unit vector along the points, Q14
  int32_t elongation = 0;                // 0 round .. 2^13 a line

  bool allocate(Arena& arena) {
    points = arena.alloc<FrontPoint>(kFrontPoints);
    return arena.ok();
  }
};

// Points of a mesh with another axis up: `up_axis` 1 takes the grid's z as up, (x, y, z) becomes (x, z, -y).
void view_points(const SurfacePoint* points, uint32_t up_axis, FrontView* view);

// Offsets of a point in the floor's plane from the mean.
struct FrontOffset {
  int64_t x, z;
};
inline FrontOffset front_offset(const FrontView& view, uint32_t i) {
  return {view.points[i].position.x - view.mean.x, view.points[i].position.z - view.mean.z};
}

// The frame's axis, Q14: the long axis rotated by `frame` quarters.
inline FrontOffset frame_axis(const FrontView& view, uint32_t frame) {
  const int64_t x = view.axis_x, z = view.axis_z;
  return frame == 0   ? FrontOffset{x, z}
         : frame == 1 ? FrontOffset{-z, x}
         : frame == 2 ? FrontOffset{-x, -z}
                      : FrontOffset{z, -x};
}

//   rows  out  [kFrontPoints x kFrontChannels]
void front_rows(const FrontView& view, uint32_t frame, int16_t* rows);

}  // namespace sinew::rigging
#endif
