// SPDX-License-Identifier: MIT
// Samples of characters with parts that a joint owns.
#include "sinew_trainer/sample.hpp"

#include <gtest/gtest.h>

#include "core/counts.hpp"
#include "sinew_character/bind/bind.hpp"

namespace sinew {
namespace {

void add_octahedron(Character* c, const Vec3& at, float x, float y, float z, uint32_t joint) {
  const uint32_t first = static_cast<uint32_t>(c->vertices.size());
  for (const float s : {1.0f, -1.0f}) {
    c->vertices.push_back({at.x + s * x, at.y, at.z});
    c->vertices.push_back({at.x, at.y + s * y, at.z});
    c->vertices.push_back({at.x, at.y, at.z + s * z});
  }
  for (const auto& f : {std::array<uint32_t, 3>{0, 1, 2},
                        {1, 3, 2},
                        {3, 4, 2},
                        {4, 0, 2},
                        {1, 0, 5},
                        {3, 1, 5},
                        {4, 3, 5},
                        {0, 4, 5}}) {
    for (const uint32_t corner : f) c->face_vertices.push_back(first + corner);
    c->face_offsets.push_back(static_cast<uint32_t>(c->face_vertices.size()));
  }
  for (int v = 0; v < 6; ++v) c->influences.push_back({{joint, 1.0f}});
}

TEST(SampleOwners, OwnedVerticesFollowTheirJointAndAreNotLearned) {
  Character c;
  c.name = "cyclops";
  c.joints = {{"root", {0, 0.2f, 0}, -1}, {"head", {0, 3.1f, 0.5f}, 0}, {"eye", {0, 3.5f, 0.5f}, 1}};
  add_octahedron(&c, {0, 2, 0}, 1, 2, 1, 1);
  add_octahedron(&c, {0, 3.5f, 0.5f}, 0.05f, 0.05f, 0.05f, 2);
  const Sample s = make_sample(c, 2, 32);
  ASSERT_EQ(s.owner.size(), s.vertices);
  const std::vector<float> head_alone(s.target.size(), 0.5f);
  const auto rows = sample_influences(s, head_alone, 4);
  for (size_t v = 0; v < c.vertices.size(); ++v) {
    const uint32_t u = s.vertex_to_welded[v];
    const bool of_the_eye = v >= 6;
    EXPECT_EQ(s.owner[u], of_the_eye ? 2 : kNoJoint) << v;
    EXPECT_EQ(s.importance[u], of_the_eye ? 0 : 1) << v;
    EXPECT_EQ(rows[v].size() == 1 && rows[v][0].joint == 2, of_the_eye) << v;
    EXPECT_EQ(bind(c, {}).influences[v][0].joint == 2, of_the_eye) << v;
  }
}

}  // namespace
}  // namespace sinew
