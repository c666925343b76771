// SPDX-License-Identifier: MIT
// A nameless human and a nameless dog, y up, facing +z, with x > 0 on the left.
#ifndef SINEW_TESTS_MAPPING_HUMAN_RIG_HPP
#define SINEW_TESTS_MAPPING_HUMAN_RIG_HPP

#include "mapping/anatomy.hpp"
#include "small_rig.hpp"

namespace sinew::mapping {

struct HumanRig : SmallRig {
  enum {
    kHips,
    kSpine,
    kChest,
    kNeck,
    kHead,
    kUpperArm,
    kForearm,
    kHand,
    kThigh = 11,
    kCalf,
    kFoot,
    kToe,
    kCount = 19
  };
  static constexpr int kRightArm = 3, kRightLeg = 4;  // from a joint of the left side to its mirror image

  HumanRig() {
    positions = {0, 1, 0, 0, 1.2f, 0, 0, 1.4f, 0, 0, 1.55f, 0, 0, 1.7f, 0.02f};
    parents = {-1, 0, 1, 2, 3};
    for (const float x : {1.0f, -1.0f}) {
      const int32_t first = static_cast<int32_t>(parents.size());
      positions.insert(positions.end(), {x * 0.2f, 1.45f, 0, x * 0.45f, 1.45f, -0.01f, x * 0.7f, 1.45f, 0});
      parents.insert(parents.end(), {kChest, first, first + 1});
    }
    for (const float x : {1.0f, -1.0f}) {
      const int32_t first = static_cast<int32_t>(parents.size());
      positions.insert(positions.end(),
                       {x * 0.1f, 0.95f, 0, x * 0.1f, 0.5f, 0.02f, x * 0.1f, 0.08f, 0, x * 0.1f, 0.02f, 0.15f});
      parents.insert(parents.end(), {kHips, first, first + 1, first + 2});
    }
  }
};

// Hips behind, chest before, neck, head, a tail of two; forelegs from the chest, hind legs from the hips.
struct DogRig : SmallRig {
  enum { kHips, kSpine, kChest, kNeck, kHead, kTail, kTailEnd, kHindLeg, kForeLeg = 13 };

  DogRig() {
    positions = {0,     0.6f, -0.4f, 0,     0.62f, 0,    0,      0.6f, 0.4f, 0,    0.75f,
                 0.55f, 0,    0.85f, 0.75f, 0,     0.6f, -0.55f, 0,    0.5f, -0.8f};
    parents = {-1, 0, 1, 2, 3, 0, 5};
    for (const float z : {-0.4f, 0.4f}) {
      for (const float x : {1.0f, -1.0f}) {
        const int32_t first = static_cast<int32_t>(parents.size());
        positions.insert(positions.end(), {x * 0.12f, 0.55f, z, x * 0.12f, 0.3f, z - 0.03f, x * 0.12f, 0.02f, z});
        parents.insert(parents.end(), {z < 0 ? int32_t{kHips} : int32_t{kChest}, first, first + 1});
      }
    }
  }
};

// A body with a head before it and a longer abdomen behind it, jaws on the head, three pairs of legs whose knees are high.
struct InsectRig : SmallRig {
  enum { kBody, kHead, kMouth, kAbdomen, kAbdomenEnd, kJaws, kLegs = 9 };  // legs from the rear, left and right in turn

  InsectRig() {
    positions = {0,     0.3f, 0,     0,     0.3f, 0.3f,  0,     0.25f, 0.5f,  0,     0.35f, -0.4f, 0,    0.45f,
                 -0.9f, 0.1f, 0.25f, 0.45f, 0.1f, 0.15f, 0.55f, -0.1f, 0.25f, 0.45f, -0.1f, 0.15f, 0.55f};
    parents = {-1, 0, 1, 0, 3, kHead, kJaws, kHead, kJaws + 2};
    for (const float z : {-0.5f, 0.0f, 0.5f}) {
      for (const float x : {1.0f, -1.0f}) {
        const int32_t first = static_cast<int32_t>(parents.size());
        positions.insert(positions.end(), {x * 0.1f, 0.13f, 0, x * 0.5f, 0.5f, 0.5f * z, x * 0.9f, 0.1f, z});
        parents.insert(parents.end(), {kBody, first, first + 1});
      }
    }
  }
};

// A rig read as the matcher reads it.
struct Read {
  explicit Read(SmallRig* small, bool flip = false) {
    EXPECT_EQ(small->build(), SINEW_OK);
    EXPECT_TRUE(anatomy.allocate(small->arena, static_cast<uint32_t>(small->parents.size())));
    const Point up = {0, 1, 0};
    EXPECT_TRUE(anatomy.build(small->rig, &up, flip, small->arena));
  }
  int32_t first(int32_t limb) const { return limb < 0 ? -1 : anatomy.limbs.joint(anatomy.limb(limb), 0); }
  Anatomy anatomy;
};

}  // namespace sinew::mapping
#endif
