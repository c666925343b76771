// SPDX-License-Identifier: MIT
// sinew_map() on known bodies: what belongs together, pins, other poses and axes, and every refusal.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "map_rig.hpp"
#include "sinew/published.h"

namespace {

using sinew_test::humanoid;
using sinew_test::MapCall;
using sinew_test::TestRig;

// The same rig turned, scaled and moved.
TestRig moved(TestRig rig, bool z_up, bool half_turn, float scale) {
  for (size_t i = 0; i < rig.names.size(); ++i) {
    float* const p = &rig.positions[3 * i];
    if (half_turn) {
      p[0] = -p[0];
      p[2] = -p[2];
    }
    if (z_up) {
      const float y = p[1];
      p[1] = -p[2];
      p[2] = y;
    }
    for (int k = 0; k < 3; ++k) p[k] = scale * p[k] + 3.0f * static_cast<float>(k);
  }
  return rig;
}

void expect_named_pairs(const MapCall& call, const TestRig& target, const TestRig& source, const char* what) {
  ASSERT_EQ(call.status, SINEW_OK) << what;
  for (const std::string& name : target.names) {
    if (source.find(name) < 0 || name.find("Spine") != std::string::npos) continue;
    EXPECT_EQ(call.source_of(target, source, name), name) << what << " " << name;
  }
}

TEST(Map, BodiesOfOtherPosesAndCountsFindEachOther) {
  const TestRig a = humanoid(2, true), b = humanoid(4, false);
  MapCall call;
  expect_named_pairs(call.run(a, b), a, b, "T pose from hanging arms");
  expect_named_pairs(call.run(b, a), b, a, "hanging arms from T pose");
  EXPECT_EQ(call.outputs.method, static_cast<uint32_t>(SINEW_MAP_SINEW));
  EXPECT_EQ(call.reasons[static_cast<size_t>(b.find("Spine2"))] == SINEW_MAP_FEWER_JOINTS ||
                call.reasons[static_cast<size_t>(b.find("Spine1"))] == SINEW_MAP_FEWER_JOINTS,
            true);
  for (size_t i = 0; i < call.sources.size(); ++i) {
    EXPECT_EQ(call.sources[i] >= 0, call.reasons[i] == SINEW_MAP_FOUND);
    EXPECT_EQ(call.sources[i] >= 0, call.confidence[i] > 0);
    EXPECT_LE(call.confidence[i], 32768);
  }
}

// A bust with one arm of four joints and a hand: fingers are no legs.
TEST(Map, ABodyWithoutLegsPlaysArmsTrunkAndHead) {
  const TestRig person = humanoid(3, true);
  TestRig bust;
  int32_t at = -1;
  for (int k = 0; k < 3; ++k)
    at = bust.add("spine" + std::to_string(k + 1), at, 0, 1 + 0.15f * static_cast<float>(k), 0);
  const int32_t chest = at;
  (void)bust.add("head", bust.add("neck", chest, 0, 1.5f, 0), 0, 1.6f, 0);
  (void)bust.add("shoulder.L", chest, 0.05f, 1.4f, 0);
  at = bust.add("shoulder.R", chest, -0.05f, 1.4f, 0);
  for (int k = 0; k < 4; ++k)
    at = bust.add("arm" + std::to_string(k + 1) + ".R", at, -0.2f - 0.14f * static_cast<float>(k), 1.4f, 0);
  const int32_t hand = bust.add("hand.R", at, -0.76f, 1.4f, 0);
  for (const int finger : {0, 1, 2, 3}) {
    at = hand;
    for (int k = 0; k < 4; ++k)
      at = bust.add("f" + std::to_string(finger) + std::to_string(k) + ".R", at, -0.8f - 0.03f * static_cast<float>(k),
                    1.4f, 0.02f * static_cast<float>(finger) - 0.03f);
  }
  MapCall call;
  call.names = true;
  ASSERT_EQ(call.run(bust, person).status, SINEW_OK);
  EXPECT_EQ(call.source_of(bust, person, "arm1.R"), "RightArm");
  EXPECT_EQ(call.source_of(bust, person, "arm3.R"), "RightForeArm");
  EXPECT_EQ(call.source_of(bust, person, "hand.R"), "RightHand");
  EXPECT_EQ(call.source_of(bust, person, "head"), "Head");
  EXPECT_NE(call.source_of(bust, person, "spine2"), "");
  for (const int32_t source : call.sources) {
    if (source < 0) continue;
    const std::string& name = person.names[static_cast<size_t>(source)];
    EXPECT_EQ(name.find("Leg"), std::string::npos) << name;
    EXPECT_EQ(name.find("Foot"), std::string::npos) << name;
  }
}

// A spine and a pelvis that begin at one place are one body; a staff and a second person are none.
TEST(Map, OneBodyMayHangOnTwoRoots) {
  const TestRig whole = humanoid(3, true);
  TestRig apart = whole;
  for (size_t i = 0; i < apart.names.size(); ++i)
    if (apart.names[i].find("UpLeg") != std::string::npos) apart.parents[i] = static_cast<int32_t>(apart.names.size());
  const float* const hips = &whole.positions[3 * static_cast<size_t>(whole.find("Hips"))];
  (void)apart.add("Pelvis2", -1, hips[0], hips[1], hips[2]);
  MapCall call;
  expect_named_pairs(call.run(apart, whole), apart, whole, "as target");
  expect_named_pairs(call.run(whole, apart), whole, apart, "as source");
}

// Hip joints near the middle, not quite mirrored: as in CMU's skeletons without names.
TEST(Map, BothLegsBeginAtTheSameJoint) {
  const TestRig target = humanoid(3, true), body = humanoid(3, true);
  for (int k = 0; k < 49; ++k) {
    const float off = 0.01f * static_cast<float>(k % 7), lower = 0.05f * static_cast<float>(k / 7);
    TestRig source;
    for (size_t i = 0; i < body.names.size(); ++i) {
      const std::string& name = body.names[i];
      int32_t parent = body.parents[i] < 0 ? -1 : source.find(body.names[static_cast<size_t>(body.parents[i])]);
      const float* const p = &body.positions[3 * i];
      const bool thigh = name.find("UpLeg") != std::string::npos;
      if (thigh) parent = source.add(name + "Hip", parent, name[0] == 'L' ? off : 0, 1, 0);
      (void)source.add(name, parent, p[0], thigh ? p[1] - lower : p[1], p[2], body.ends[i] != 0);
    }
    MapCall call;
    ASSERT_EQ(call.run(target, source).status, SINEW_OK);
    EXPECT_EQ(call.source_of(target, source, "LeftUpLeg") == "LeftUpLeg",
              call.source_of(target, source, "RightUpLeg") == "RightUpLeg")
        << off << " " << lower;
  }
}

// A pelvis that carries the legs alone, beside the spine: the root above both is the hips.
TEST(Map, APelvisBesideTheSpineIsNotTheTrunk) {
  const TestRig a = humanoid(2, true);
  TestRig b = humanoid(3, false);
  b.names[0] = "Root";
  const int32_t pelvis = b.add("Pelvis", 0, 0, 0.96f, 0);
  for (const char* thigh : {"LeftUpLeg", "RightUpLeg"}) b.parents[static_cast<size_t>(b.find(thigh))] = pelvis;
  MapCall call;
  for (const bool names : {false, true}) {
    call.names = names;
    call.run(b, a);
    expect_named_pairs(call, b, a, "a pelvis");
    EXPECT_EQ(call.source_of(b, a, "Root"), "Hips");
    EXPECT_EQ(call.source_of(b, a, "Pelvis"), "-");
    expect_named_pairs(call.run(a, b), a, b, "from a pelvis");
    EXPECT_EQ(call.source_of(a, b, "Hips"), "Root");
  }
}

// Legs that hang on the first joint of the spine, under a pelvis on their level: that one is the hips.
TEST(Map, APelvisUnderTheSpineIsTheHips) {
  const TestRig a = humanoid(2, true);
  TestRig b;
  b.add("Pelvis", -1, 0, 0.95f, 0);
  const TestRig body = humanoid(3, false);
  for (uint32_t i = 0; i < body.count(); ++i) {
    const float* const p = &body.positions[3 * size_t{i}];
    b.add(i == 0 ? "Spine0" : body.names[i], body.parents[i] + 1, p[0], i == 0 ? 1.03f : p[1], p[2], body.ends[i] != 0);
  }
  MapCall call;
  for (const bool names : {false, true}) {
    call.names = names;
    call.run(b, a);
    expect_named_pairs(call, b, a, "a pelvis below");
    EXPECT_EQ(call.source_of(b, a, "Pelvis"), "Hips");
    expect_named_pairs(call.run(a, b), a, b, "from a pelvis below");
    EXPECT_EQ(call.source_of(a, b, "Hips"), "Pelvis");
  }
}

// Positions from which nobody reads a body, names that say nothing: a hammer, say.
TestRig oddity(bool with_end) {
  TestRig rig;
  rig.add("Bone", -1, 0, 0, -3.0f, 0);
  rig.add("Bone.001", 0, 0, 0.7f, -3.0f, 0);
  rig.add("Bone.002", 1, 0, 2.1f, -3.0f, 0);
  rig.add("Bone.003", 2, 0, 3.8f, -3.1f, 0);
  rig.add("Bone.004", 2, 0.9f, 2.1f, -3.4f, 0);
  rig.add("Bone.005", 4, 2.0f, 2.1f, -3.9f, 0);
  if (with_end) rig.add("Bone.003_tip", 3, 0, 5.0f, -3.1f, 0);
  return rig;
}

TEST(Map, ARigOfTheSameNamesAndHierarchyIsTheSame) {
  const TestRig a = oddity(false);
  TestRig b = oddity(true);
  for (size_t i = 0; i < b.positions.size(); i += 3) {  // in another pose: bent down, and longer on one side
    b.positions[i] *= 3;
    b.positions[i + 1] *= -0.4f;
  }
  MapCall call;
  call.names = true;
  call.run(a, b);
  for (const std::string& name : a.names) EXPECT_EQ(call.source_of(a, b, name), name);
  EXPECT_EQ(call.confidence[4], 32768);
  call.run(b, a);
  for (const std::string& name : a.names) EXPECT_EQ(call.source_of(b, a, name), name);
  EXPECT_EQ(call.source_of(b, a, "Bone.003_tip"), "-");
  // A node above all of it, as files of motions have one.
  TestRig held;
  held.add("Armature", -1, 0, 0, 0);
  for (uint32_t i = 0; i < b.count(); ++i) {
    const float* const p = &b.positions[3 * size_t{i}];
    held.add(b.names[i], b.parents[i] + 1, p[0], p[1], p[2]);
  }
  call.run(a, held);
  for (const std::string& name : a.names) EXPECT_EQ(call.source_of(a, held, name), name);
  call.run(held, a);
  for (const std::string& name : a.names) EXPECT_EQ(call.source_of(held, a, name), name);
  // Names like those of another rig: another hierarchy, or a joint that is not its own.
  for (const bool renamed : {false, true}) {
    TestRig stranger = b;
    if (renamed) {
      stranger.names[2] = "Bone.009";
    } else {
      stranger.parents[4] = 3;
    }
    EXPECT_NE(call.run(a, stranger).sources, (std::vector<int32_t>{0, 1, 2, 3, 4, 5})) << renamed;
  }
}

TEST(Map, SizePlaceTurnAndUpDoNotMatter) {
  const TestRig a = humanoid(2, true);
  for (const bool half_turn : {false, true}) {
    const TestRig b = moved(humanoid(3, false), false, half_turn, 40);
    MapCall call;
    expect_named_pairs(call.run(a, b), a, b, half_turn ? "half turn" : "scaled");
    call.up_known = false;
    const TestRig z = moved(humanoid(3, true), true, half_turn, 0.01f);
    expect_named_pairs(call.run(a, z), a, z, "z up, not told");
  }
}

TEST(Map, NamesOnlyHelp) {
  const TestRig a = humanoid(3, true), b = humanoid(3, true, "x:");
  MapCall named;
  named.names = true;
  named.run(a, b);
  MapCall bare;
  bare.run(a, b);
  EXPECT_EQ(named.sources, bare.sources);
}

// Bones of which an exporter wrote copies, those of one arm far away and the hand's end with them.
TEST(Map, PlainNamesWinOverOddCopiesOfBones) {
  const TestRig a = humanoid(2, true);
  TestRig b = humanoid(2, true, "Character1_");
  const auto copy = [&](const std::string& of, const std::string& name, float x, float y, float z) {
    const int32_t joint = b.find("Character1_" + of);
    const float* const at = &b.positions[3 * static_cast<size_t>(joint)];
    const float position[3] = {at[0] + x, at[1] + y, at[2] + z};
    const int32_t made = b.add(name + "_RIGMESH", joint, position[0], position[1], position[2]);
    b.add(name + "_RIGMESH_end", made, position[0], position[1], position[2], true);
  };
  for (const char* trunk : {"Hips", "Spine1", "Spine2", "Neck"}) copy(trunk, trunk, 0, 0, 0);
  for (const char* const side : {"Left", "Right"}) {
    const bool far = std::string(side) == "Right";
    const std::string letter(side, 1);
    copy(std::string(side) + "Shoulder", letter + "_Shoulder", 0, 0, 0);
    copy(std::string(side) + "Arm", letter + "_Humerus", far ? 0.3f : 0, far ? -0.2f : 0, 0);
    copy(std::string(side) + "ForeArm", letter + "_Radius", far ? 0.7f : 0, far ? -0.5f : 0, far ? 0.6f : 0);
    copy(std::string(side) + "UpLeg", letter + "_Femur", 0, 0, 0);
    copy(std::string(side) + "Leg", letter + "_Tibia", 0, 0, 0);
    copy(std::string(side) + "Foot", letter + "_Talus", 0.05f, -0.03f, 0.02f);
  }
  float* const end = &b.positions[3 * static_cast<size_t>(b.find("Character1_RightHandEnd"))];
  end[0] += 1.1f;
  end[2] += 1.2f;
  MapCall call;
  call.names = true;
  ASSERT_EQ(call.run(a, b).status, SINEW_OK);
  for (const char* const side : {"Left", "Right"}) {
    for (const char* const part : {"Arm", "ForeArm", "Hand", "UpLeg", "Leg", "Foot"}) {
      const std::string name = std::string(side) + part;
      EXPECT_EQ(call.source_of(a, b, name), "Character1_" + name);
      EXPECT_EQ(call.reasons[static_cast<size_t>(a.find(name))], SINEW_MAP_FOUND);
    }
  }
  EXPECT_EQ(call.source_of(a, b, "Head"), "Character1_Head");
}

// A body under a root that stays where its stage begins: size and middle are the body's, with names and without.
TEST(Map, ARootFarFromTheBodyIsNoPartOfIt) {
  const TestRig target = humanoid(2, true), body = humanoid(2, true);
  TestRig source;
  source.add("joint_Root", -1, 0.02f, 0.1f, 4.5f);
  for (size_t i = 0; i < body.names.size(); ++i) {
    const float* const p = &body.positions[3 * i];
    source.add(body.names[i], body.parents[i] + 1, p[0], p[1], p[2], body.ends[i] != 0);
  }
  for (const bool names : {false, true}) {
    MapCall call;
    call.names = names;
    ASSERT_EQ(call.run(target, source).status, SINEW_OK);
    for (const std::string& name : target.names) EXPECT_EQ(call.source_of(target, source, name), name) << names;
    ASSERT_EQ(call.run(source, target).status, SINEW_OK);
    EXPECT_EQ(call.source_of(source, target, "joint_Root"), "-");
    EXPECT_EQ(call.reasons[0], SINEW_MAP_OUTSIDE);
    for (const std::string& name : target.names) EXPECT_EQ(call.source_of(source, target, name), name) << names;
  }
}

// A jaw where the other body has its head: names that contradict are no pair.
TEST(Map, AJawDoesNotMoveAsAHead) {
  TestRig target = humanoid(2, true), source = humanoid(2, true);
  target.names[static_cast<size_t>(target.find("Head"))] = "Jaw";
  source.names[static_cast<size_t>(source.find("LeftHand"))] = "LeftHandThumb1";
  MapCall call;
  call.names = true;
  ASSERT_EQ(call.run(target, source).status, SINEW_OK);
  EXPECT_EQ(call.source_of(target, source, "Jaw"), "-");
  EXPECT_EQ(call.source_of(target, source, "RightHand"), "RightHand");
  source.names[static_cast<size_t>(source.find("RightHand"))] = "RightForeArmTwist";
  ASSERT_EQ(call.run(target, source).status, SINEW_OK);
  EXPECT_EQ(call.source_of(target, source, "RightHand"), "-");
}

TEST(Map, OrderOfJointsDoesNotMatter) {
  const TestRig a = humanoid(3, true), b = humanoid(2, false);
  TestRig turned;
  std::vector<int32_t> new_of(a.count());
  for (uint32_t i = 0; i < a.count(); ++i) new_of[a.count() - 1 - i] = static_cast<int32_t>(i);
  for (uint32_t i = 0; i < a.count(); ++i) {
    const size_t old = a.count() - 1 - i;
    turned.add(a.names[old], a.parents[old] < 0 ? -1 : new_of[static_cast<size_t>(a.parents[old])],
               a.positions[3 * old], a.positions[3 * old + 1], a.positions[3 * old + 2], a.ends[old] != 0);
  }
  MapCall x, y;
  x.run(a, b);
  y.run(turned, b);
  for (const std::string& name : a.names) EXPECT_EQ(x.source_of(a, b, name), y.source_of(turned, b, name)) << name;
}

TEST(Map, PinsAreKeptAndTheRestFollows) {
  const TestRig a = humanoid(2, true), b = humanoid(4, true);
  MapCall call;
  call.pins = {{static_cast<uint32_t>(a.find("Spine1")), b.find("Spine4")},
               {static_cast<uint32_t>(a.find("Head")), -1}};
  call.run(a, b);
  ASSERT_EQ(call.status, SINEW_OK);
  EXPECT_EQ(call.source_of(a, b, "Spine1"), "Spine4");
  EXPECT_EQ(call.source_of(a, b, "Head"), "-");
  EXPECT_EQ(call.reasons[static_cast<size_t>(a.find("Head"))], SINEW_MAP_PINNED);
  EXPECT_EQ(call.reasons[static_cast<size_t>(a.find("Spine1"))], SINEW_MAP_PINNED);
  EXPECT_EQ(call.confidence[static_cast<size_t>(a.find("Spine1"))], 32768);
  EXPECT_EQ(call.confidence[static_cast<size_t>(a.find("Head"))], 0);
  EXPECT_EQ(call.source_of(a, b, "LeftHand"), "LeftHand");
  // One pair of a side turns all of it.
  call.pins = {{static_cast<uint32_t>(a.find("LeftHand")), b.find("RightHand")}};
  call.run(a, b);
  EXPECT_EQ(call.source_of(a, b, "RightFoot"), "LeftFoot");
  EXPECT_EQ(call.source_of(a, b, "LeftArm"), "RightArm");
  // Limbs that are pinned together are matched as such, on both sides, and a source is given once.
  call.pins = {{static_cast<uint32_t>(a.find("LeftForeArm")), b.find("LeftLeg")}};
  call.run(a, b);
  EXPECT_EQ(call.source_of(a, b, "LeftForeArm"), "LeftLeg");
  EXPECT_EQ(call.source_of(a, b, "LeftArm"), "LeftUpLeg");
  EXPECT_EQ(call.source_of(a, b, "RightArm"), "RightUpLeg");
  EXPECT_NE(call.source_of(a, b, "LeftFoot"), "LeftFoot");
}

TEST(Map, ByBranchesTheSameRigIsItself) {
  const TestRig a = humanoid(3, true);
  MapCall call;
  call.method = SINEW_MAP_BRANCHES;
  call.run(a, a);
  ASSERT_EQ(call.status, SINEW_OK);
  EXPECT_EQ(call.outputs.method, static_cast<uint32_t>(SINEW_MAP_BRANCHES));
  for (size_t i = 0; i < call.sources.size(); ++i) EXPECT_EQ(call.sources[i], static_cast<int32_t>(i));
}

TEST(Map, TwistJointsAreNoFingers) {
  // Five fingers on each hand of both; the target has twist joints on its arms, too.
  const auto with_fingers = [](TestRig rig, bool twists) {
    for (const float s : {1.0f, -1.0f}) {
      const std::string side = s > 0 ? "Left" : "Right";
      const int32_t hand = rig.find(side + "Hand");
      for (int f = 0; f < 5; ++f) {
        const float z = 0.04f - 0.02f * static_cast<float>(f), start = f == 0 ? 0.73f : 0.78f;
        int32_t last = hand;
        for (int k = 0; k < 3; ++k)
          last = rig.add(side + "Finger" + std::to_string(f) + std::to_string(k), last,
                         s * (start + 0.03f * static_cast<float>(k)), 1.42f,
                         f == 0 ? 0.05f + 0.02f * static_cast<float>(k) : z);
      }
      if (!twists) continue;
      rig.add(side + "ArmTwist", rig.find(side + "Arm"), 0.3f * s, 1.42f, -0.005f);
      rig.add(side + "ForeArmTwist", rig.find(side + "ForeArm"), 0.6f * s, 1.42f, -0.004f);
    }
    return rig;
  };
  const TestRig a = with_fingers(humanoid(2, true), true), b = with_fingers(humanoid(3, true), false);
  MapCall call;
  call.run(a, b);
  for (const std::string& name : a.names) {
    if (name.find("Finger") != std::string::npos) {
      EXPECT_EQ(call.source_of(a, b, name), name);
    }
    if (name.find("Twist") != std::string::npos) {
      EXPECT_EQ(call.source_of(a, b, name), "-") << name;
    }
  }
  call.run(a, a);
  EXPECT_EQ(call.source_of(a, a, "LeftForeArmTwist"), "LeftForeArmTwist");
}

// A glove's: index and thumb share one bone of the palm, ring and little finger another.
TEST(Map, FingersThatShareABoneOfThePalmAreFingers) {
  const char* const fingers[] = {"Thumb", "Index", "Middle", "Ring", "Pinky"};
  const auto with_fingers = [&](TestRig rig, bool shared) {
    for (const float s : {1.0f, -1.0f}) {
      const std::string side = s > 0 ? "Left" : "Right";
      const int32_t hand = rig.find(side + "Hand");
      int32_t palm[2] = {hand, hand};
      for (int k = 0; k < 2 && shared; ++k)
        palm[k] = rig.add(side + "HandPalm" + std::to_string(k), hand, s * 0.71f, 1.42f, k == 0 ? 0.005f : -0.005f);
      for (int f = 0; f < 5; ++f) {
        const float z = 0.04f - 0.02f * static_cast<float>(f), start = f == 0 ? 0.73f : 0.78f;
        int32_t last = f == 2 ? hand : palm[f < 2 ? 0 : 1];
        for (int k = 0; k < 3; ++k)
          last = rig.add(side + fingers[f] + std::to_string(k), last, s * (start + 0.03f * static_cast<float>(k)),
                         1.42f, f == 0 ? 0.05f + 0.02f * static_cast<float>(k) : z);
      }
    }
    return rig;
  };
  const TestRig hand = with_fingers(humanoid(2, true), false), glove = with_fingers(humanoid(2, true), true);
  MapCall call;
  call.run(hand, glove);
  for (const std::string& name : hand.names) EXPECT_EQ(call.source_of(hand, glove, name), name);
}

TEST(Map, NearlyEqualRigsOfTooManyLimbsGoByTheirPlaces) {
  TestRig urchin;
  urchin.add("a", -1, 0, 0, 0);
  for (int i = 0; i < 500; ++i) {
    const float height = 1 - 0.004f * static_cast<float>(i), turn = 2.4f * static_cast<float>(i);
    const float wide = std::sqrt(1 - height * height);
    const float x = wide * std::cos(turn), z = wide * std::sin(turn);
    const int32_t spine = urchin.add("b", 0, x, height, z);
    urchin.add("c", spine, 2 * x, 2 * height, 2 * z);
  }
  TestRig later = urchin;
  for (size_t i = 0; i < later.positions.size(); ++i) later.positions[i] *= 1.001f;
  MapCall call;
  call.run(urchin, later);
  for (size_t i = 0; i < call.sources.size(); ++i) ASSERT_EQ(call.sources[i], static_cast<int32_t>(i));
  for (TestRig* rig : {&urchin, &later}) rig->add("camera", -1, 0, 0, 0);  // of two roots shapes are not compared
  call.method = SINEW_MAP_SINEW;
  call.run(urchin, later);
  EXPECT_LT(call.outputs.mapped, urchin.count() * 6 / 10);
  EXPECT_GT(std::count(call.reasons.begin(), call.reasons.end(), SINEW_MAP_BESIDE_LIMITS), 0);
  call.method = SINEW_MAP_AUTO;
  call.run(urchin, later);
  EXPECT_EQ(call.outputs.method, static_cast<uint32_t>(SINEW_MAP_BRANCHES));
  for (size_t i = 0; i + 1 < call.sources.size(); ++i) ASSERT_EQ(call.sources[i], static_cast<int32_t>(i));
}

TEST(Map, OneJointAndBonesWithoutLength) {
  TestRig one, same;
  one.add("a", -1, 1, 2, 3);
  for (int i = 0; i < 5; ++i) same.add("b" + std::to_string(i), i - 1, 1, 1, 1);
  for (const uint32_t method : {uint32_t{SINEW_MAP_AUTO}, uint32_t{SINEW_MAP_SINEW}, uint32_t{SINEW_MAP_BRANCHES}}) {
    MapCall call;
    call.method = method;
    EXPECT_EQ(call.run(one, same).status, SINEW_OK);
    EXPECT_EQ(call.sources[0], 0);
    EXPECT_EQ(call.run(same, one).status, SINEW_OK);
    EXPECT_EQ(call.sources[0], 0);
    EXPECT_EQ(call.run(same, same).status, SINEW_OK);
  }
}

class MapRefusals : public ::testing::Test {
 protected:
  MapRefusals() {
    a_ = humanoid(2, true);
    rig_ = call_.view(a_, &names_);
    (void)sinew_map_workspace_size(a_.count(), a_.count(), &bytes_);
    block_ = sinew::test::AlignedBytes(bytes_);
    sources_.assign(a_.count(), -7);
    outputs_ = SINEW_INIT(sinew_map_outputs);
    outputs_.sources = sources_.data();
  }
  void expect(sinew_status status, const char* what) {
    EXPECT_EQ(sinew_map(&rig_, &rig_, &options_, block_.data(), bytes_, &outputs_), status) << what;
    EXPECT_EQ(std::count(sources_.begin(), sources_.end(), -7), static_cast<long>(sources_.size())) << what;
  }
  TestRig a_;
  MapCall call_;
  std::vector<const char*> names_;
  sinew_skeleton rig_;
  sinew_map_options options_ = SINEW_INIT(sinew_map_options);
  size_t bytes_ = 0;
  sinew::test::AlignedBytes block_{0};
  std::vector<int32_t> sources_;
  sinew_map_outputs outputs_ = {};
};

TEST_F(MapRefusals, Arguments) {
  outputs_.sources = nullptr;
  expect(SINEW_ERROR_ARGUMENT, "no array");
  outputs_.sources = sources_.data();
  options_.method = 3;
  expect(SINEW_ERROR_ARGUMENT, "method");
  options_.method = 0;
  options_.pin_count = 1;
  expect(SINEW_ERROR_ARGUMENT, "no pins");
  options_.pin_count = 0;
  rig_.up = SINEW_UP_Z + 1;
  expect(SINEW_ERROR_ARGUMENT, "up");
  rig_.up = SINEW_UP_Y;
  rig_.positions = nullptr;
  expect(SINEW_ERROR_ARGUMENT, "positions");
  EXPECT_EQ(sinew_map(nullptr, &rig_, nullptr, block_.data(), bytes_, &outputs_), SINEW_ERROR_ARGUMENT);
  EXPECT_EQ(sinew_map_workspace_size(1, 1, nullptr), SINEW_ERROR_ARGUMENT);
}

TEST_F(MapRefusals, StructsOfOtherVersions) {
  options_.struct_size = 4;
  expect(SINEW_ERROR_ARGUMENT, "too small");
  options_ = SINEW_INIT(sinew_map_options);
  options_.reserved = 1;
  expect(SINEW_ERROR_VERSION, "reserved");
  options_.reserved = 0;
  rig_.reserved = 1;
  expect(SINEW_ERROR_VERSION, "reserved of a rig");
  rig_.reserved = 0;
  struct Future {
    sinew_map_options known;
    uint64_t more;
  } future = {SINEW_INIT(sinew_map_options), 0};
  future.known.struct_size = sizeof future;
  EXPECT_EQ(sinew_map(&rig_, &rig_, &future.known, block_.data(), bytes_, &outputs_), SINEW_OK);
  future.more = 1;
  EXPECT_EQ(sinew_map(&rig_, &rig_, &future.known, block_.data(), bytes_, &outputs_), SINEW_ERROR_VERSION);
}

TEST_F(MapRefusals, CountsAndWorkspace) {
  rig_.joint_count = 0;
  expect(SINEW_ERROR_COUNT, "no joint");
  rig_.joint_count = SINEW_MAX_JOINTS + 1;
  expect(SINEW_ERROR_COUNT, "too many joints");
  size_t size = 1;
  EXPECT_EQ(sinew_map_workspace_size(SINEW_MAX_JOINTS + 1, 1, &size), SINEW_ERROR_COUNT);
  EXPECT_EQ(size, 0u);
  rig_.joint_count = a_.count();
  EXPECT_EQ(sinew_map(&rig_, &rig_, nullptr, block_.data(), bytes_ - 64, &outputs_), SINEW_ERROR_WORKSPACE);
  EXPECT_EQ(sinew_map(&rig_, &rig_, nullptr, block_.data() + 8, bytes_, &outputs_), SINEW_ERROR_WORKSPACE);
  EXPECT_EQ(sinew_map(&rig_, &rig_, nullptr, block_.data(), bytes_, &outputs_), SINEW_OK);
  EXPECT_EQ(outputs_.used_bytes, bytes_);
}

TEST_F(MapRefusals, PlacesAndParents) {
  a_.positions[4] = std::numeric_limits<float>::infinity();
  expect(SINEW_ERROR_NOT_FINITE, "infinite");
  a_.positions[4] = 1;
  a_.parents[3] = static_cast<int32_t>(a_.count());
  expect(SINEW_ERROR_INDEX, "no such parent");
  a_.parents[3] = -2;
  expect(SINEW_ERROR_INDEX, "negative parent");
  a_.parents[3] = 4;
  expect(SINEW_ERROR_HIERARCHY, "circle");
  a_.parents[3] = 3;
  expect(SINEW_ERROR_HIERARCHY, "own parent");
}

TEST_F(MapRefusals, Pins) {
  sinew_map_pin pins[2] = {{a_.count(), 0}, {1, 1}};
  options_.pins = pins;
  options_.pin_count = 1;
  expect(SINEW_ERROR_RANGE, "target");
  pins[0] = {0, static_cast<int32_t>(a_.count())};
  expect(SINEW_ERROR_RANGE, "source");
  pins[0] = {0, -2};
  expect(SINEW_ERROR_RANGE, "below -1");
  options_.pin_count = 2;
  pins[0] = {1, 2};
  expect(SINEW_ERROR_RANGE, "target twice");
  pins[0] = {2, 1};
  expect(SINEW_ERROR_RANGE, "source twice");
}

TEST_F(MapRefusals, ASmallBodyFitsAMegabyte) {
  size_t size = 0;
  ASSERT_EQ(sinew_map_workspace_size(60, 60, &size), SINEW_OK);
  EXPECT_LE(size, size_t{1} << 20);
}

}  // namespace
