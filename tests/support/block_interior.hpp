// SPDX-License-Identifier: MIT
// Bodies of blocks, and what is inside them.
#ifndef SINEW_TESTS_BLOCK_INTERIOR_HPP
#define SINEW_TESTS_BLOCK_INTERIOR_HPP

#include <gtest/gtest.h>

#include <vector>

#include "mesh_scene.hpp"
#include "votes/interior.hpp"

namespace sinew_test {

// Along the axes.
struct Block3 {
  sinew::Vec3i low, high;
};

// In the grid the middle of all blocks is at x = z = 0 and their floor at y = 0; their longest side is kSide.
struct BlockInterior {
  sinew::Workspace memory;
  sinew::rigging::Interior interior;

  explicit BlockInterior(const std::vector<Block3>& blocks) {
    MeshScene scene;
    for (const Block3& block : blocks) add(&scene, block);
    scene.add_joint(0, 0, 0, -1);
    const MeshRun run(scene);
    EXPECT_EQ(run.status, SINEW_OK);
    sinew::Arena measuring;
    (void)interior.allocate(measuring);
    EXPECT_TRUE(sinew::rigging::build_interior(run.mesh, measuring, &interior));
    memory = sinew::Workspace(measuring.high_water());
    sinew::Arena arena(memory.data(), measuring.high_water());
    EXPECT_TRUE(interior.allocate(arena));
    EXPECT_TRUE(sinew::rigging::build_interior(run.mesh, arena, &interior));
  }

 private:
  static void add(MeshScene* scene, const Block3& block) {
    const sinew::Vec3i low = block.low, high = block.high;
    const uint32_t first = scene->vertex_count();
    for (uint32_t i = 0; i < 8; ++i)
      scene->add_vertex((i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y, (i & 4) != 0 ? high.z : low.z);
    const uint32_t faces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    for (const auto& f : faces) scene->add_face({first + f[0], first + f[1], first + f[2], first + f[3]});
  }
};

}  // namespace sinew_test
#endif
