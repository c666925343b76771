// SPDX-License-Identifier: MIT
// Rows of the network of the front: the same however the mesh is turned, and of its mirror image.
#include "front/front_points.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace {

using namespace sinew;
using namespace sinew::rigging;

std::vector<SurfacePoint> points() {
  std::mt19937 random(2);
  std::vector<SurfacePoint> made(kFrontPoints);
  for (SurfacePoint& p : made) {
    const auto within = [&](int32_t size) {
      return static_cast<int32_t>(random() % (2 * static_cast<uint32_t>(size))) - size;
    };
    p.position = {within(200000), within(400000) + 400000, within(90000) + (p.position.y > 0 ? 1000 : 0)};
    p.normal = {within(9000), within(9000), within(9000)};
  }
  return made;
}

std::vector<SurfacePoint> turned(std::vector<SurfacePoint> all, double radians) {
  const double c = std::cos(radians), s = std::sin(radians);
  const auto turn = [&](Vec3i v) {
    return Vec3i{static_cast<int32_t>(std::lround(c * v.x + s * v.z)), v.y,
                 static_cast<int32_t>(std::lround(c * v.z - s * v.x))};
  };
  for (SurfacePoint& p : all) {
    p.position = turn(p.position);
    p.normal = turn(p.normal);
  }
  return all;
}

struct Rows {
  std::vector<FrontPoint> room = std::vector<FrontPoint>(kFrontPoints);
  FrontView view;
  std::vector<int16_t> frames[kFrontFrames];

  explicit Rows(const std::vector<SurfacePoint>& all, uint32_t up = 0) {
    view.points = room.data();
    view_points(all.data(), up, &view);
    for (uint32_t f = 0; f < kFrontFrames; ++f) {
      frames[f].resize(size_t{kFrontPoints} * kFrontChannels);
      front_rows(view, f, frames[f].data());
    }
  }
};

int largest_difference(const std::vector<int16_t>& a, const std::vector<int16_t>& b) {
  int most = 0;
  for (size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}

// The axis has no front end, so the frames of a turned mesh may come in another order.
TEST(FrontPoints, FramesOfATurnedMeshAreThoseOfTheMesh) {
  const Rows plain(points());
  for (const double radians : {0.3, 0.9, 2.0, 3.1}) {
    const Rows other(turned(points(), radians));
    int least = 1 << 20;
    for (const auto& frame : other.frames) least = std::min(least, largest_difference(plain.frames[0], frame));
    EXPECT_LE(least, 8) << radians;
  }
}

TEST(FrontPoints, AMirrorImageLooksTheSame) {
  std::vector<SurfacePoint> mirrored = points();
  for (SurfacePoint& p : mirrored) {
    p.position.x = -p.position.x;
    p.normal.x = -p.normal.x;
  }
  const Rows plain(points()), other(mirrored);
  int least = 1 << 20;
  for (const auto& frame : other.frames) least = std::min(least, largest_difference(plain.frames[0], frame));
  EXPECT_LE(least, 8);
}

TEST(FrontPoints, AnotherUpAxisIsTurnedToY) {
  std::vector<SurfacePoint> lying = points();
  for (SurfacePoint& p : lying) {  // z is up: y goes to z, z to -y
    p.position = {p.position.x, -p.position.z, p.position.y};
    p.normal = {p.normal.x, -p.normal.z, p.normal.y};
  }
  EXPECT_EQ(Rows(lying, 1).frames[0], Rows(points()).frames[0]);
}

TEST(FrontPoints, AxisIsALongOneAndAUnitVector) {
  std::vector<SurfacePoint> line = points();
  for (SurfacePoint& p : line) p.position.z = p.position.x / 2;
  const Rows rows(line);
  EXPECT_NEAR(rows.view.axis_x, 16384 * 2 / std::sqrt(5.0), 3);
  EXPECT_NEAR(rows.view.axis_z, 16384 / std::sqrt(5.0), 3);
  EXPECT_GT(rows.view.elongation, 8100);
  for (SurfacePoint& p : line) p.position = {7, 7, 7};
  const Rows none(line);
  EXPECT_EQ(none.view.axis_x, 1 << 14) << "a point has no axis; some is given";
}

}  // namespace
