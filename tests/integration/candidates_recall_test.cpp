// SPDX-License-Identifier: MIT
// How much of the reference weight lies on the candidates: what the search misses, no network can give back.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <string>

#include "mesh_scene.hpp"
#include "shared_data.hpp"
#include "sinew_formats/io.hpp"

namespace {

// Mean over bound vertices of the reference weight on the vertex's candidates.
double recall(const sinew::Character& character, uint32_t k) {
  sinew_test::MeshScene scene;
  for (const sinew::Vec3& p : character.vertices) scene.add_vertex(p.x, p.y, p.z);
  scene.offsets = character.face_offsets;
  scene.corners = character.face_vertices;
  for (const sinew::Joint& j : character.joints) scene.add_joint(j.position.x, j.position.y, j.position.z, j.parent);
  const sinew_test::MeshRun run(scene, 0, k, 64, true);
  EXPECT_EQ(run.status, SINEW_OK) << character.name;
  double hit = 0, bound = 0;
  for (size_t v = 0; v < character.influences.size(); ++v) {
    double sum = 0, found = 0;
    const uint16_t* row = run.candidates.joints + static_cast<size_t>(run.mesh.vertex_to_welded[v]) * k;
    for (const sinew::Influence& influence : character.influences[v]) {
      sum += influence.weight;
      if (std::find(row, row + k, influence.joint) != row + k) found += influence.weight;
    }
    if (sum <= 0) continue;
    hit += found / sum;
    bound += 1;
  }
  return hit / bound;
}

TEST(CandidatesRecall, EightCandidatesHoldTheReferenceWeightOfVal) {
  if (shared_folder().empty())
    GTEST_SKIP() << "*** NOT CHECKED: recall of the candidates needs ../shared/data/characters/val ***";
  double sum = 0;
  double worst = 1;
  std::string worst_name;
  const auto paths = sinew::list_characters((shared_folder() / "data" / "characters" / "val").string());
  ASSERT_GT(paths.size(), 30u);
  for (const std::string& path : paths) {
    const sinew::Character character = sinew::read_character(path);
    const double value = recall(character, 8);
    sum += value;
    if (value < worst) {
      worst = value;
      worst_name = character.name;
    }
  }
  const double mean = sum / static_cast<double>(paths.size());
  std::printf("recall at K = 8: %.5f, worst %.4f %s\n", mean, worst, worst_name.c_str());
  EXPECT_GE(mean, 0.995);
  EXPECT_GE(worst, 0.93) << worst_name;
}

}  // namespace
