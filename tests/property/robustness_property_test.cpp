// SPDX-License-Identifier: MIT
// The same character moved, scaled, renumbered or unwelded gets the same weights to the last bit, and the measure of it
// sees a binder that does not.
#include <gtest/gtest.h>

#include <string>

#include "open_bundled_model.hpp"
#include "robustness.hpp"
#include "sinew_character/bind/bind.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"

namespace sinew {
namespace {

using Rows = std::vector<std::vector<Influence>>;

class RobustnessProperty : public ::testing::TestWithParam<const char*> {
 protected:
  static Character character() { return read_character(std::string(SINEW_SOURCE_DIR) + "/samples/data/" + GetParam()); }
  static Rows bound(const Character& c, const sinew_model* model) {
    BindOptions options;
    options.method = model == nullptr ? SINEW_METHOD_HEAT : SINEW_METHOD_MODEL;
    options.model = model;
    return bind(c, options).influences;
  }
};

TEST_P(RobustnessProperty, WhatSaysTheSameGetsTheSameWeights) {
  const Character c = character();
  for (const sinew_model* model : {static_cast<const sinew_model*>(nullptr), bundled_model()}) {
    size_t equal = 0, rounding = 0;
    for (const RobustnessFigure& figure :
         measure_robustness(c, [&](const Character& changed) { return bound(changed, model); })) {
      SCOPED_TRACE(figure.change + (model != nullptr ? ", model" : ", heat"));
      if (figure.demand != Demand::kClose) {
        EXPECT_GE(figure.compared, c.vertices.size());
      }
      EXPECT_GT(figure.compared, c.vertices.size() / 4);
      if (figure.demand == Demand::kEqual) {
        EXPECT_EQ(figure.largest, 0);
        ++equal;
      }
      if (figure.demand == Demand::kRounding) {
        EXPECT_LT(figure.mean, 0.01);
        ++rounding;
      }
    }
    EXPECT_EQ(equal, 4u);
    EXPECT_EQ(rounding, 2u);
  }
}
INSTANTIATE_TEST_SUITE_P(Samples, RobustnessProperty, ::testing::Values("snake__long.obj", "biped__robot.obj"));

// Rows that depend on one thing only, and the changes that show it.
Rows rows_by(const Character& c, const std::function<size_t(size_t)>& joint_of_vertex) {
  Rows rows;
  for (size_t v = 0; v < c.vertices.size(); ++v)
    rows.push_back({{static_cast<uint32_t>(joint_of_vertex(v) % c.joints.size()), 1.0f}});
  return rows;
}
double mean_of(const std::vector<RobustnessFigure>& figures, const std::string& change) {
  for (const RobustnessFigure& figure : figures) {
    if (figure.change.rfind(change, 0) == 0) return figure.mean;
  }
  ADD_FAILURE() << "no change " << change;
  return 0;
}

TEST(RobustnessMeasure, SeesWhatABinderHangsOn) {
  const Character c = read_character(SINEW_SOURCE_DIR "/samples/data/snake__long.obj");
  const auto by_index =
      measure_robustness(c, [](const Character& x) { return rows_by(x, [](size_t v) { return v; }); });
  EXPECT_EQ(mean_of(by_index, "moved"), 0);
  EXPECT_GT(mean_of(by_index, "vertices and faces renumbered"), 1.5);
  EXPECT_GT(mean_of(by_index, "joints renumbered"), 1);
  EXPECT_GT(mean_of(by_index, "unwelded"), 1);

  const auto by_position = measure_robustness(c, [](const Character& x) {
    return rows_by(x, [&](size_t v) { return static_cast<size_t>(x.vertices[v].x > 0); });
  });
  EXPECT_EQ(mean_of(by_position, "vertices and faces renumbered"), 0);
  EXPECT_EQ(mean_of(by_position, "scaled by a half"), 0);
  EXPECT_GT(mean_of(by_position, "moved, nothing rounded"), 0.5);
  EXPECT_GT(mean_of(by_position, "mirrored"), 0.5);

  const auto by_size = measure_robustness(c, [](const Character& x) {
    return rows_by(x,
                   [&](size_t v) { return static_cast<size_t>(x.vertices[v].x != x.vertices[0].x) + x.face_count(); });
  });
  EXPECT_GT(mean_of(by_size, "faces split") + mean_of(by_size, "faces merged"), 0);
  EXPECT_GT(mean_of(by_size, "subdivided"), 0);
}

TEST(RobustnessMeasure, APointCloudIsRefused) {
  Character c = read_character(SINEW_SOURCE_DIR "/samples/data/snake__long.obj");
  c.face_vertices.clear();
  c.face_offsets = {0};
  EXPECT_THROW(measure_robustness(c, [](const Character& x) { return Rows(x.vertices.size()); }), Error);
}

}  // namespace
}  // namespace sinew
