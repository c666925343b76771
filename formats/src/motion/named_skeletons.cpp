// SPDX-License-Identifier: MIT
// Orders of joints: SMPL, SMPL-H and SMPL-X as their authors publish them; SOMA and G1 as Kimodo (nv-tlabs/kimodo) writes them.
#include "motion/named_skeletons.hpp"

#include <algorithm>

#include "motion/person.hpp"

namespace sinew {
namespace {

// Adds joints by their names and their parents' names.
class SkeletonWriter {
 public:
  explicit SkeletonWriter(const char* name) : skeleton_{name, {}, {}} {}

  void add(const std::string& joint, const std::string& parent) {
    const auto at = std::find(skeleton_.joints.begin(), skeleton_.joints.end(), parent);
    skeleton_.parents.push_back(at == skeleton_.joints.end() ? -1 : static_cast<int>(at - skeleton_.joints.begin()));
    skeleton_.joints.push_back(joint);
  }
  // Each joint below the one before it, the first below `parent`.
  void add_chain(std::string parent, const std::string& prefix, const std::vector<const char*>& joints) {
    for (const char* joint : joints) {
      add(prefix + joint, parent);
      parent = prefix + joint;
    }
  }
  NamedSkeleton take() { return std::move(skeleton_); }

 private:
  NamedSkeleton skeleton_;
};

// Of 77 joints, or the 30 of them without fingers that the network of Kimodo knows.
NamedSkeleton soma_skeleton(bool with_fingers) {
  SkeletonWriter soma(with_fingers ? "SOMA (77 joints)" : "SOMA (30 joints)");
  soma.add_chain("", "", {"Hips", "Spine1", "Spine2", "Chest", "Neck1", "Neck2", "Head"});
  if (with_fingers) soma.add("HeadEnd", "Head");
  for (const char* part : {"Jaw", "LeftEye", "RightEye"}) soma.add(part, "Head");
  for (const std::string side : {"Left", "Right"}) {
    const std::string hand = side + "Hand";
    soma.add_chain("Chest", side, {"Shoulder", "Arm", "ForeArm", "Hand"});
    if (with_fingers) {
      soma.add_chain(hand, hand + "Thumb", {"1", "2", "3", "End"});
      for (const char* finger : {"Index", "Middle", "Ring", "Pinky"})
        soma.add_chain(hand, hand + finger, {"1", "2", "3", "4", "End"});
    } else {
      for (const char* end : {"ThumbEnd", "MiddleEnd"}) soma.add(hand + end, hand);
    }
  }
  for (const char* side : {"Left", "Right"}) {
    soma.add_chain("Hips", side, {"Leg", "Shin", "Foot", "ToeBase"});
    if (with_fingers) soma.add(side + std::string("ToeEnd"), side + std::string("ToeBase"));
  }
  return soma.take();
}

NamedSkeleton g1_skeleton() {
  SkeletonWriter g1("Unitree G1 (34 joints)");
  g1.add("pelvis", "");
  for (const char* side : {"left_", "right_"})
    g1.add_chain("pelvis", side, {"hip_pitch", "hip_roll", "hip_yaw", "knee", "ankle_pitch", "ankle_roll", "toe_base"});
  g1.add_chain("pelvis", "waist_", {"yaw", "roll", "pitch"});
  for (const char* side : {"left_", "right_"})
    g1.add_chain("waist_pitch", side,
                 {"shoulder_pitch", "shoulder_roll", "shoulder_yaw", "elbow", "wrist_roll", "wrist_pitch", "wrist_yaw",
                  "hand_roll"});
  return g1.take();
}

NamedSkeleton smpl_skeleton() {
  NamedSkeleton smpl = {"SMPL (22 joints)", body_models()[0].joints, {}};
  for (const MotionJoint& joint : person_joints(smpl.joints)) smpl.parents.push_back(joint.parent);
  return smpl;
}

}  // namespace

const std::vector<BodyModel>& body_models() {
  // Hands are five fingers of three joints in the order of MANO.
  static const std::vector<BodyModel> models = [] {
    const std::vector<std::string> body = {
        "hips",         "leftUpperLeg",  "rightUpperLeg", "spine",      "leftLowerLeg", "rightLowerLeg",
        "chest",        "leftFoot",      "rightFoot",     "upperChest", "leftToes",     "rightToes",
        "neck",         "leftShoulder",  "rightShoulder", "head",       "leftUpperArm", "rightUpperArm",
        "leftLowerArm", "rightLowerArm", "leftHand",      "rightHand"};
    std::vector<std::string> hands;
    for (const char* side : {"left", "right"})
      for (const char* finger : {"Index", "Middle", "Little", "Ring"})
        for (const char* part : {"Proximal", "Intermediate", "Distal"})
          hands.push_back(side + std::string(finger) + part);
    for (const size_t at : {12u, 27u})  // a thumb behind four fingers
      for (const char* part : {"Distal", "Proximal", "Metacarpal"})
        hands.insert(hands.begin() + static_cast<std::ptrdiff_t>(at),
                     (at == 12 ? "leftThumb" : "rightThumb") + std::string(part));
    const auto join = [](std::vector<std::string> a, const std::vector<std::string>& b) {
      a.insert(a.end(), b.begin(), b.end());
      return a;
    };
    return std::vector<BodyModel>{{"SMPL, without hands", body},
                                  {"SMPL", join(body, {"leftHand_end", "rightHand_end"})},
                                  {"SMPL-H", join(body, hands)},
                                  {"SMPL-X", join(join(body, {"jaw", "leftEye", "rightEye"}), hands)}};
  }();
  return models;
}

const std::vector<NamedSkeleton>& named_skeletons() {
  static const std::vector<NamedSkeleton> skeletons = {soma_skeleton(true), soma_skeleton(false), g1_skeleton(),
                                                       smpl_skeleton()};
  return skeletons;
}

}  // namespace sinew
