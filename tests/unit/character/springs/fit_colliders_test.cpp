// SPDX-License-Identifier: MIT
// Shapes lie in the body, chains at rest touch none, and only what a chain reaches is there.
#include "sinew_character/springs/fit_colliders.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "hairy_person.hpp"
#include "springs/body_skin.hpp"

namespace sinew {
namespace {

using sinew_test::HairyPerson;

HairyPerson dressed() {
  HairyPerson person;
  const int head = static_cast<int>(person.index("Head")), hips = static_cast<int>(person.index("Hips"));
  person.chain("Hair", head, {0, 1.75, -0.12}, {0, -0.08, -0.01}, 4);
  for (int k = 0; k < 8; ++k) {
    const double x = 0.2 * std::cos(0.785 * k), z = 0.2 * std::sin(0.785 * k);
    person.chain("Skirt" + std::string(1, static_cast<char>('A' + k)), hips, {x, 1.02, z}, {0.15 * x, -0.14, 0.15 * z},
                 3);
  }
  return person;
}

TEST(FitColliders, FitTheTubesTheyAreMadeFrom) {
  const HairyPerson person = dressed();
  const BodyColliders body = fit_colliders(person.character, find_springs(person.character));
  EXPECT_LE(body.colliders.size(), kMostColliders);
  const auto named = [&](const std::string& name) {
    return static_cast<size_t>(std::find_if(body.colliders.begin(), body.colliders.end(),
                                            [&](const SpringCollider& c) { return c.name == name; }) -
                               body.colliders.begin());
  };
  for (const auto& [name, radius] : {std::pair<std::string, double>{"left thigh", 0.07},
                                     {"right calf", 0.05},
                                     {"left upper arm", 0.045},
                                     {"head", 0.1}}) {
    const size_t c = named(name);
    ASSERT_LT(c, body.colliders.size()) << name;
    EXPECT_NEAR(body.colliders[c].radius, radius, 0.25 * radius) << name;
    EXPECT_LT(body.errors[c], 0.25) << name;
  }
  const SpringCollider& thigh = body.colliders[named("left thigh")];
  EXPECT_EQ(thigh.shape, ColliderShape::kCapsule);
  EXPECT_EQ(person.character.joints[thigh.joint].name, "LeftUpLeg");
  EXPECT_GT(length(thigh.tail - thigh.offset), 0.2);
}

TEST(FitColliders, AtRestNothingIsPushed) {
  const HairyPerson person = dressed();
  const Character& c = person.character;
  std::vector<FoundChain> chains = find_springs(c);
  ASSERT_EQ(chains.size(), 9u);
  Springs springs;
  std::vector<double> errors;
  assign_colliders(c, fit_colliders(c, chains), &chains, &springs, &errors);
  EXPECT_EQ(errors.size(), springs.colliders.size());
  EXPECT_EQ(springs.groups.size(), springs.colliders.size());
  size_t of_hair = 0, of_skirts = 0;
  for (const FoundChain& found : chains) {
    (found.kind == SpringKind::kSkirt ? of_skirts : of_hair) += found.chain.groups.size();
    for (const size_t group : found.chain.groups)
      for (const size_t number : springs.groups[group].colliders) {
        const SpringCollider& one = springs.colliders[number];
        const Point3 origin = point(c.joints[one.joint].position);
        const Point3 end = one.shape == ColliderShape::kCapsule ? one.tail : one.offset;
        for (size_t i = 0; i < found.chain.turning_joints(); ++i) {
          const Point3 tail = i + 1 < found.chain.joints.size()
                                  ? point(c.joints[found.chain.joints[i + 1].joint].position)
                                  : point(c.joints[found.chain.joints[i].joint].position) + *found.chain.end;
          EXPECT_GE(segment_distance(tail, origin + one.offset, origin + end),
                    one.radius + found.chain.joints[i].hit_radius)
              << found.chain.name << " " << one.name;
        }
      }
  }
  EXPECT_GT(of_hair, 1u);
  EXPECT_GE(of_skirts, 8u);  // at least a leg each
  for (const SpringCollider& one : springs.colliders) {
    const bool used = std::any_of(chains.begin(), chains.end(), [&](const FoundChain& found) {
      return std::any_of(found.chain.groups.begin(), found.chain.groups.end(),
                         [&](size_t g) { return springs.groups[g].name == one.name; });
    });
    EXPECT_TRUE(used) << one.name;
  }
}

}  // namespace
}  // namespace sinew
