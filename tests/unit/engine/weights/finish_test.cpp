// SPDX-License-Identifier: MIT
// Predictions to the caller's rows: formats and order, rows that the caller gave, and the edits between the two.
#include "weights/finish.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <vector>

#include "hand_rows.hpp"
#include "heat_scene.hpp"

namespace sinew {
namespace {

using sinew_test::HeatRun;
using sinew_test::run_measured;

// Three vertices of the caller, the first two at one position, whose rows come from logits for joints 5, 2 and 7.
struct Predicted {
  Mesh mesh;
  Skeleton skeleton;
  Reduction reduction;
  HeatField heat;
  std::vector<uint32_t> vertex_to_welded = {1, 1, 0};
  std::vector<uint16_t> joints = {5, 2, 7, 5, 2, kNoJoint};
  std::vector<int16_t> logits = {3072, 2048, 1024, 0, 0, 9999};  // shares 4 : 2 : 1, and 1 : 1
  Prediction prediction{mesh,          mesh,          reduction, skeleton,        heat,
                        logits.data(), joints.data(), 3,         softmax_s16_ref, nullptr};
  RowOptions options;
  uint8_t* confidence = nullptr;

  Predicted() {
    mesh.vertex_count = 3;
    mesh.welded_count = 2;
    mesh.vertex_to_welded = vertex_to_welded.data();
    options.influence_count = 2;
  }
  template <class Weight>
  void write(std::vector<uint16_t>* out_joints, std::vector<Weight>* weights) {
    out_joints->resize(6, 99);
    weights->resize(6, Weight(77));
    sinew_bind_outputs outputs = SINEW_INIT(sinew_bind_outputs);
    outputs.joint_indices = out_joints->data();
    outputs.weights = weights->data();
    outputs.confidence = confidence;
    write_rows(prediction, options, EditedRows(), Threads(), &outputs);
  }
};

TEST(WriteRows, RowsStandInTheCallersOrderAndSumExactly) {
  Predicted p;
  std::vector<uint16_t> joints, weights;
  p.write(&joints, &weights);
  EXPECT_EQ(joints, (std::vector<uint16_t>{2, 5, 2, 5, 5, 2}));  // ties go to the lower joint
  EXPECT_EQ(weights[0] + weights[1], 65535);
  EXPECT_EQ(weights[0], 32768);
  EXPECT_EQ(weights[4] + weights[5], 65535);
  EXPECT_NEAR(weights[4], 65535 * 2 / 3, 4);
}

TEST(WriteRows, EveryFormatHoldsTheSameRows) {
  Predicted p;
  std::vector<uint16_t> joints, wide;
  p.write(&joints, &wide);
  std::vector<uint8_t> narrow;
  p.options.weight_format = SINEW_WEIGHT_UNORM8;
  p.write(&joints, &narrow);
  EXPECT_EQ(narrow[0] + narrow[1], 255);
  EXPECT_EQ(narrow[4] + narrow[5], 255);
  std::vector<float> real;
  p.options.weight_format = SINEW_WEIGHT_FLOAT;
  p.write(&joints, &real);
  for (size_t i = 0; i < real.size(); ++i) {
    EXPECT_EQ(real[i], static_cast<float>(wide[i]) / 65535.0f);
    EXPECT_NEAR(narrow[i], wide[i] / 257.0, 1);
  }
}

TEST(WriteRows, SoftnessBringsLogitsCloser) {
  Predicted p;
  std::vector<uint16_t> joints, weights, softer;
  p.write(&joints, &weights);
  p.options.softness_percent = 200;
  p.write(&joints, &softer);
  EXPECT_LT(softer[4], weights[4]);
  EXPECT_NEAR(softer[4], 65535 * std::sqrt(2.0) / (std::sqrt(2.0) + 1), 40);
}

TEST(WriteRows, GivenRowsStayAndAreSure) {
  Predicted p;
  std::vector<uint8_t> locked = {0, 1, 0}, confidence(3, 0);
  p.options.locked = locked.data();
  p.confidence = confidence.data();
  std::vector<uint16_t> joints, weights;
  p.write(&joints, &weights);
  EXPECT_EQ(joints[2], 99);
  EXPECT_EQ(weights[3], 77);
  EXPECT_EQ(joints[0], 2);
  EXPECT_EQ(confidence[1], 255);
  EXPECT_EQ(confidence[0], 128);               // half of the weight
  EXPECT_NEAR(confidence[2], 255 * 4 / 7, 1);  // of all candidates, however many the row keeps
}

TEST(WriteRows, WithoutLogitsRowsAreTheHeatFields) {
  Predicted p;
  std::vector<uint16_t> heat_joints(2 * kHeatSlots, kNoJoint), heat_weights(2 * kHeatSlots, 0), nearest = {4, 4};
  heat_joints[0] = 6;
  heat_joints[1] = 3;
  heat_weights[0] = 24576;
  heat_weights[1] = 8192;
  p.heat.joints = heat_joints.data();
  p.heat.weights = heat_weights.data();
  p.heat.nearest = nearest.data();
  const Prediction prediction{p.mesh,  p.mesh,  p.reduction, p.skeleton,      p.heat,
                              nullptr, nullptr, 0,           softmax_s16_ref, nullptr};
  std::vector<uint16_t> joints(6), weights(6);
  sinew_bind_outputs outputs = SINEW_INIT(sinew_bind_outputs);
  outputs.joint_indices = joints.data();
  outputs.weights = weights.data();
  write_rows(prediction, p.options, EditedRows(), Threads(), &outputs);
  EXPECT_EQ(joints, (std::vector<uint16_t>{4, 0, 4, 0, 6, 3}));  // the second row is empty: its nearest joint
  EXPECT_EQ(weights, (std::vector<uint16_t>{65535, 0, 65535, 0, 49152, 16383}));
}

TEST(WriteRows, APartThatAJointOwnsIsItsAlone) {
  Predicted p;
  const std::vector<uint32_t> part = {0, 1};
  const std::vector<uint16_t> owners = {kNoJoint, 3};
  p.mesh.part = const_cast<uint32_t*>(part.data());
  p.prediction.owners = owners.data();
  std::vector<uint8_t> confidence(3, 0);
  p.confidence = confidence.data();
  std::vector<uint16_t> joints, weights, before;
  p.write(&joints, &weights);
  for (uint32_t v = 0; v < 3; ++v) {
    EXPECT_EQ(joints[2 * v] == 3, p.vertex_to_welded[v] == 1);
    if (p.vertex_to_welded[v] != 1) continue;
    EXPECT_EQ(weights[2 * v], 65535);
    EXPECT_EQ(confidence[v], 255);
  }
}

TEST(CheckGivenRows, LooksAtGivenRowsAlone) {
  RowOptions options;
  options.influence_count = 2;
  std::vector<uint16_t> joints = {9, 9, 1, 0, 2, 9}, weights = {0, 0, 65535, 0, 1, 0};
  const auto check = [&] { return check_given_rows(options, 3, 3, joints.data(), weights.data()); };
  EXPECT_EQ(check(), SINEW_OK);  // nobody gave anything
  std::vector<uint8_t> flags = {0, 1, 0};
  options.hints = flags.data();
  EXPECT_EQ(check(), SINEW_OK);
  flags = {0, 0, 1};
  EXPECT_EQ(check(), SINEW_ERROR_RANGE);  // joint 9 of 3
  joints[5] = 0;
  EXPECT_EQ(check(), SINEW_OK);
  weights[4] = 0;
  EXPECT_EQ(check(), SINEW_ERROR_RANGE);  // a hint without weight
  options.locked = flags.data();
  options.hints = nullptr;
  EXPECT_EQ(check(), SINEW_OK);  // a locked row may be empty
}

// Heat rows of a capsule with two joints on its axis, one on either side, and a sleeve around it.
class Edited {
 public:
  explicit Edited(uint32_t influence_count = 4) : run_(scene()) {
    EXPECT_EQ(run_.status, SINEW_OK);
    options.influence_count = influence_count;
    joints.resize(size_t{run_.mesh.vertex_count} * influence_count, 0);
    weights.resize(joints.size(), 0);
  }
  static sinew_test::HeatScene scene() {
    sinew_test::HeatScene scene = sinew_test::capsule(9, 12, 2);
    scene.add_joint(0.3, 2.0, 0, 0);
    scene.add_joint(-0.3, 2.0, 0, 0);
    sinew_test::add_sleeve(&scene, 0.6, 1.0, 2.0, 4, 12);
    return scene;
  }
  sinew_status bind(size_t missing = 0) {
    const Mesh& mesh = run_.mesh;
    const Prediction prediction{mesh,    mesh,    reduction_, run_.skeleton,   run_.fields.field[kFieldRule],
                                nullptr, nullptr, 0,          softmax_s16_ref, nullptr};
    return run_measured(
        [&](Arena& arena) {
          EditedRows edited;
          if (!edited.allocate(arena, run_.counts, options)) return SINEW_ERROR_WORKSPACE;
          const sinew_status status =
              edit_rows(prediction, options, run_.counts, joints.data(), weights.data(), {}, arena, &edited);
          if (status != SINEW_OK || arena.measuring()) return status;
          sinew_bind_outputs outputs = SINEW_INIT(sinew_bind_outputs);
          outputs.joint_indices = joints.data();
          outputs.weights = weights.data();
          write_rows(prediction, options, edited, Threads(), &outputs);
          symmetric_vertices = outputs.symmetric_vertices;
          return SINEW_OK;
        },
        missing);
  }
  uint32_t vertices() const { return run_.mesh.vertex_count; }
  uint32_t part(uint32_t vertex) const { return run_.mesh.part[run_.mesh.vertex_to_welded[vertex]]; }
  const uint16_t* joints_of(uint32_t vertex) const { return joints.data() + size_t{vertex} * options.influence_count; }
  const uint16_t* weights_of(uint32_t vertex) const {
    return weights.data() + size_t{vertex} * options.influence_count;
  }

  uint32_t weight(uint32_t vertex, uint16_t joint) const {
    for (uint32_t i = 0; i < options.influence_count; ++i) {
      if (joints_of(vertex)[i] == joint) return weights_of(vertex)[i];
    }
    return 0;
  }

  RowOptions options;
  std::vector<uint16_t> joints, weights;
  uint32_t symmetric_vertices = 0;

 private:
  HeatRun run_;
  Reduction reduction_;
};

TEST(EditRows, RigidPartsHaveOneJointEach) {
  Edited edited;
  edited.options.rigid_parts = SINEW_RIGID_PARTS_ALWAYS;
  ASSERT_TRUE(edited.options.edits_rows());
  ASSERT_EQ(edited.bind(), SINEW_OK);
  uint32_t joint_of[2] = {kNoJoint, kNoJoint};
  for (uint32_t v = 0; v < edited.vertices(); ++v) {
    uint32_t& joint = joint_of[edited.part(v)];
    if (joint == kNoJoint) joint = edited.joints_of(v)[0];
    EXPECT_EQ(edited.joints_of(v)[0], joint);
    EXPECT_EQ(edited.weights_of(v)[0], 65535);
  }
}

TEST(EditRows, SymmetricRowsAreCountedAndSumExactly) {
  Edited edited;
  edited.options.symmetric = true;
  ASSERT_EQ(edited.bind(), SINEW_OK);
  EXPECT_GE(edited.symmetric_vertices, 9u * 12u);  // the capsule's rings; the sleeve's are turned
  for (uint32_t v = 0; v < edited.vertices(); ++v) {
    EXPECT_EQ(std::accumulate(edited.weights_of(v), edited.weights_of(v) + 4, 0), 65535) << v;
  }
  // Vertex s of a ring lies opposite to vertex 6 - s. The ring in the middle is nearest to the joints at the sides.
  for (const uint32_t ring : {2u, 4u}) {
    const uint32_t right = 12 * ring + 1, left = 12 * ring + 5;
    const uint16_t joint = edited.joints_of(right)[0];
    EXPECT_EQ(edited.joints_of(left)[0], joint < 2 ? joint : 5 - joint);
    EXPECT_EQ(joint == 2, ring == 4);
    for (uint32_t i = 0; i < 4; ++i) EXPECT_EQ(edited.weights_of(right)[i], edited.weights_of(left)[i]);
  }
}

TEST(EditRows, HintsStayAndSteer) {
  Edited plain, edited;
  std::vector<uint8_t> hints(edited.vertices(), 0), none(edited.vertices(), 0);
  hints[50] = 1;
  plain.options.hints = none.data();
  edited.options.hints = hints.data();
  edited.joints[200] = 3;
  edited.weights[200] = 65535;
  ASSERT_EQ(plain.bind(), SINEW_OK);
  ASSERT_EQ(edited.bind(), SINEW_OK);
  EXPECT_EQ(edited.joints_of(50)[0], 3);
  EXPECT_EQ(edited.weights_of(50)[0], 65535);
  EXPECT_GT(edited.weight(49, 3), plain.weight(49, 3) + 1000);  // beside it on the ring
}

TEST(EditRows, TooSmallABlockIsAStatus) {
  Edited edited;
  edited.options.rigid_parts = SINEW_RIGID_PARTS_ALWAYS;
  edited.options.symmetric = true;
  std::vector<uint8_t> hints(edited.vertices(), 0);
  edited.options.hints = hints.data();
  EXPECT_EQ(edited.bind(64), SINEW_ERROR_WORKSPACE);
}

TEST(RowOptions, NothingIsEditedUnlessAsked) {
  RowOptions options;
  EXPECT_FALSE(options.edits_rows());
  EXPECT_FALSE(options.reads_heat());
  options.rigid_parts = SINEW_RIGID_PARTS_NEVER;
  EXPECT_TRUE(options.edits_rows());
  EXPECT_TRUE(options.reads_heat());
}

}  // namespace
}  // namespace sinew
