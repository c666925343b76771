// SPDX-License-Identifier: MIT
// Chains that nothing spoke for stay in the mesh; what does already, and what something spoke for, stays where it is.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "predict/fit_details.hpp"

namespace sinew {
namespace {

// A block of 2 x 1 x 1 with its middle at (1, 0.5, 0.5).
Character block() {
  Character mesh;
  for (uint32_t c = 0; c < 8; ++c)
    mesh.vertices.push_back({c & 1 ? 2.0f : 0.0f, c & 2 ? 1.0f : 0.0f, c & 4 ? 1.0f : 0.0f});
  constexpr uint32_t kQuads[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                     {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  for (const auto& q : kQuads) {
    mesh.face_vertices.insert(mesh.face_vertices.end(), q, q + 4);
    mesh.face_offsets.push_back(static_cast<uint32_t>(mesh.face_vertices.size()));
  }
  return mesh;
}

// A root that was found, and a chain of two along x with steps of that length.
FittedSkeleton skeleton(float step, FitHow how) {
  FittedSkeleton fitted;
  fitted.joints = {{"root", {0.8f, 0.5f, 0.5f}, -1, true},
                   {"a", {0.8f + step, 0.5f, 0.5f}, 0, true},
                   {"b", {0.8f + 2 * step, 0.5f, 0.5f}, 1, true}};
  fitted.how = {FitHow::kMatched, how, how};
  return fitted;
}

TEST(KeepInside, ShortensWhatLeavesTheMesh) {
  FittedSkeleton fitted = skeleton(1, FitHow::kCarried);
  EXPECT_EQ(keep_inside(block(), &fitted), 1u);
  EXPECT_FLOAT_EQ(fitted.joints[1].position.x, 1.8f);  // is in it
  EXPECT_LE(fitted.joints[2].position.x, 2.04f);
  EXPECT_GT(fitted.joints[2].position.x, 1.85f);
  EXPECT_FLOAT_EQ(fitted.joints[0].position.x, 0.8f);
}

TEST(KeepInside, LeavesWhatIsInItAndWhatWasFound) {
  FittedSkeleton inside = skeleton(0.5f, FitHow::kCarried), found = skeleton(1, FitHow::kMatched);
  EXPECT_EQ(keep_inside(block(), &inside), 0u);
  EXPECT_FLOAT_EQ(inside.joints[2].position.x, 1.8f);
  EXPECT_EQ(keep_inside(block(), &found), 0u);
  EXPECT_FLOAT_EQ(found.joints[2].position.x, 2.8f);
}

// A root on the floor is carried, too, but what was found hangs on it.
TEST(KeepInside, LeavesWhatFoundJointsHangOn) {
  FittedSkeleton fitted = skeleton(0.5f, FitHow::kMatched);
  fitted.joints[0].position = {0.8f, -3, 0.5f};
  fitted.how[0] = FitHow::kCarried;
  EXPECT_EQ(keep_inside(block(), &fitted), 0u);
  EXPECT_FLOAT_EQ(fitted.joints[0].position.y, -3);
}

TEST(KeepInside, BothOfAPairAlike) {
  Character mesh = block();
  mesh.vertices[1].x = mesh.vertices[3].x = mesh.vertices[5].x = mesh.vertices[7].x =
      1.6f;  // the right half is shorter
  FittedSkeleton fitted;
  fitted.symmetric = true;
  fitted.joints = {{"hips", {1, 0.5f, 0.5f}, -1, true},
                   {"neck", {1, 0.8f, 0.5f}, 0, true},
                   {"l", {1.9f, 0.5f, 0.5f}, 0, true},
                   {"r", {0.1f, 0.5f, 0.5f}, 0, true}};
  fitted.how = {FitHow::kMatched, FitHow::kMatched, FitHow::kCarried, FitHow::kCarried};
  EXPECT_EQ(keep_inside(mesh, &fitted), 2u);
  EXPECT_LT(fitted.joints[2].position.x, 1.65f);
  EXPECT_FLOAT_EQ(fitted.joints[2].position.x - 1, 1 - fitted.joints[3].position.x);
}

}  // namespace
}  // namespace sinew
