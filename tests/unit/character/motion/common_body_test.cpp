// SPDX-License-Identifier: MIT
// What two meshes begin with.
#include "motion/common_body.hpp"

#include <gtest/gtest.h>

#include "strip_of_quads.hpp"

namespace sinew {
namespace {

TEST(CommonBody, IsWhatTwoMeshesBeginWith) {
  const CommonBody body = common_body(strip(60, 4, 0, 1), strip(60, 0, 7, 2));
  EXPECT_EQ(body.triangles.size(), 3u * 120);
  EXPECT_EQ(body.first.size(), 122u);
  for (size_t v = 0; v < body.first.size(); ++v) EXPECT_EQ(body.first[v] + 7, body.second[v]);
  EXPECT_EQ(common_body(strip(60, 4, 0, 1), strip(60, 4, 0, 1)).triangles.size(), 3u * 124);
  Character other = strip(60, 0, 0, 1);
  other.face_vertices[40] = 0;  // a corner of the eleventh quad
  EXPECT_EQ(common_body(strip(60, 0, 0, 1), other).triangles.size(), 3u * 20);
}

TEST(CommonBody, OfAHandAndTheRestOnlyWhatHangsTogetherIsSkin) {
  Character skirt = strip(30, 0, 62, 3), body = strip(30, 0, 0, 1);
  for (size_t v = 62; v < skirt.vertices.size(); ++v) body.vertices.push_back(skirt.vertices[v]);
  for (const uint32_t v : skirt.face_vertices) body.face_vertices.push_back(v);
  for (size_t f = 1; f <= 30; ++f) body.face_offsets.push_back(static_cast<uint32_t>(120 + 4 * f));
  body.joints.push_back({"hand", {0, 0, 0}, 0});
  body.influences.assign(body.vertices.size(), {{0, 1.0f}});
  body.influences[60] = body.influences[61] = {{0, 0.4f}, {1, 0.6f}};
  CommonBody common = common_body(body, body);
  ASSERT_EQ(common.triangles.size(), 3u * 120);
  keep_skin(body, {false, true}, &common);
  EXPECT_EQ(common.triangles.size(), 3u * 60);
  for (const uint32_t v : common.triangles) EXPECT_LT(common.first[v], 62u);
  common = common_body(body, body);
  keep_skin(body, {false, false}, &common);
  EXPECT_EQ(common.triangles.size(), 3u * 120) << "no hand: all of it";
}

}  // namespace
}  // namespace sinew
