// SPDX-License-Identifier: MIT
// A mesh that is a hand and nothing else gets a hand's skeleton, whichever way it lies; a body and a block get none.
#include "sinew_character/predict/lone_hand.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <set>
#include <string>

#include "hand_scene.hpp"
#include "sinew_character/jobs/rig_job.hpp"
#include "sinew_character/models/models.hpp"
#include "sinew_character/predict/predict_details.hpp"

namespace sinew {
namespace {

using sinew_test::add_cube;
using sinew_test::add_hand;
using sinew_test::add_limb;
using sinew_test::MeshScene;

using Turn = std::function<Vec3(const Vec3&)>;

Character mesh_of(
    const MeshScene& scene, const Turn& turn = [](const Vec3& p) { return p; }) {
  Character mesh;
  mesh.name = "hand";
  for (size_t v = 0; v < scene.positions.size(); v += 3)
    mesh.vertices.push_back(turn({scene.positions[v], scene.positions[v + 1], scene.positions[v + 2]}));
  mesh.face_vertices = scene.corners;
  mesh.face_offsets = scene.offsets;
  return mesh;
}

MeshScene hand(double side) {
  MeshScene scene;
  add_limb(&scene, {0.56, 1.4, 0}, {0.63, 1.4, 0}, 0.032, 0.028, side);
  add_hand(&scene, side);
  return scene;
}

class LoneHands : public ::testing::Test {
 protected:
  std::unique_ptr<LoadedModel> hands_ = load_model("", ModelUse::kHands);
  std::optional<LoneHand> find(const Character& mesh) { return find_lone_hand(mesh, hands_->model, {}); }
};

std::set<uint8_t> fingers(const PredictedSkeleton& skeleton) {
  std::set<uint8_t> found;
  for (const uint8_t c : skeleton.classes)
    if (is_finger_class(c)) found.insert(c);
  return found;
}

TEST_F(LoneHands, AreToldWithTheirFingers) {
  for (const double side : {1.0, -1.0}) {
    const std::optional<LoneHand> found = find(mesh_of(hand(side)));
    ASSERT_TRUE(found) << side;
    EXPECT_TRUE(found->thumb);
    EXPECT_EQ(fingers(found->skeleton).size(), 5u);
    EXPECT_EQ(found->skeleton.joints[0].parent, -1);
    for (size_t j = 0; j < found->skeleton.joints.size(); ++j) {
      const Joint& joint = found->skeleton.joints[j];
      EXPECT_EQ(joint.name.rfind(found->right ? "RightHand" : "LeftHand", 0), 0u) << joint.name;
      EXPECT_LT(joint.parent, static_cast<int>(j));
      EXPECT_GT(side * joint.position.x, 0.54) << joint.name;
      EXPECT_LT(side * joint.position.x, 0.80) << joint.name;
    }
  }
}

// Turned over, a flat hand is one of the other side.
TEST_F(LoneHands, AFlatOneMayBeOfEitherSide) {
  const std::optional<LoneHand> found = find(mesh_of(hand(-1)));
  ASSERT_TRUE(found);
  EXPECT_FALSE(found->side_known);
}

// Palm up, fingers to the sky, larger: the same joints there.
TEST_F(LoneHands, MayLieAnyWay) {
  const std::optional<LoneHand> flat = find(mesh_of(hand(1)));
  ASSERT_TRUE(flat);
  const std::array<Turn, 3> turns = {Turn([](const Vec3& p) {
                                       return Vec3{p.x, -p.y, -p.z};
                                     }),
                                     Turn([](const Vec3& p) {
                                       return Vec3{-p.y, p.x, p.z};
                                     }),
                                     Turn([](const Vec3& p) {
                                       return Vec3{100 * p.z, 100 * p.x, 100 * p.y};
                                     })};
  for (const Turn& turn : turns) {
    const std::optional<LoneHand> found = find(mesh_of(hand(1), turn));
    ASSERT_TRUE(found);
    ASSERT_EQ(found->skeleton.joints.size(), flat->skeleton.joints.size());
    const Vec3 unit = turn({1, 0, 0});
    const float size = std::hypot(unit.x, unit.y, unit.z);
    for (size_t j = 0; j < found->skeleton.joints.size(); ++j) {
      const Vec3 wanted = turn(flat->skeleton.joints[j].position), is = found->skeleton.joints[j].position;
      EXPECT_NEAR(std::hypot(is.x - wanted.x, is.y - wanted.y, is.z - wanted.z) / size, 0, 0.02)
          << found->skeleton.joints[j].name;
    }
  }
}

TEST_F(LoneHands, BodiesAndBlocksAreNone) {
  EXPECT_FALSE(find(mesh_of(sinew_test::two_arms(true))));
  MeshScene block;
  add_cube(&block, 0, 0, 0);
  EXPECT_FALSE(find(mesh_of(block)));
}

TEST_F(LoneHands, TakeATemplateOfAHand) {
  const std::unique_ptr<LoadedModel> rig = load_model("", ModelUse::kRig);
  const RigModels models = {&rig->model, nullptr, &hands_->model, nullptr};
  RigJobOptions job;
  job.bind = false;
  job.skeleton = "template:hand";
  const RiggedCharacter rigged = rig_character(mesh_of(hand(1)), job, models);
  ASSERT_TRUE(rigged.fitted);
  for (const Joint& joint : rigged.character.joints) {
    EXPECT_GT(joint.position.x, 0.54f) << joint.name;
    EXPECT_LT(joint.position.x, 0.80f) << joint.name;
    if (joint.name == "middle_tip") {
      EXPECT_GT(joint.position.x, 0.74f);
    }
  }
}

// The job takes it where votes know little, and says so; with --method votes it looks for a body.
TEST_F(LoneHands, TheRigJobSaysThatItGuesses) {
  const std::unique_ptr<LoadedModel> rig = load_model("", ModelUse::kRig), front = load_front_model();
  const RigModels models = {&rig->model, nullptr, &hands_->model, front ? &front->model : nullptr};
  RigJobOptions job;
  job.bind = false;
  job.detail = SkeletonDetail::kHands;  // fingers are there already: nothing is said of lacking ones
  const RiggedCharacter rigged = rig_character(mesh_of(hand(-1)), job, models);
  EXPECT_EQ(fingers(rigged.skeleton).size(), 5u);
  ASSERT_EQ(rigged.character.notes.size(), 1u);
  EXPECT_NE(rigged.character.notes[0].find("hand without a body, and its side is uncertain"), std::string::npos)
      << rigged.character.notes[0];
  job.method = RigMethod::kVotes;
  job.detail = SkeletonDetail::kBody;
  EXPECT_TRUE(fingers(rig_character(mesh_of(hand(-1)), job, models).skeleton).empty());
}

}  // namespace
}  // namespace sinew
