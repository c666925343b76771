// SPDX-License-Identifier: MIT
// The table of layouts, and which one keypoints without names are in. To add one: a row here, and its joints in person.cpp.
#include "motion/keypoint_layouts.hpp"

#include <algorithm>
#include <cmath>

#include "motion/person.hpp"
#include "sinew_formats/print.hpp"

namespace sinew {
namespace {

constexpr double kFits = 0.7;     // misfit of a body; wrong layouts of captures have 0.8 to 2
constexpr double kClearly = 1.4;  // how many times the next layout's misfit must be larger
constexpr size_t kMostFramesAsked = 256;

// Mean length of a bone over frames, and its standard deviation.
struct BoneLength {
  double mean = 0, deviation = 0;
};

BoneLength bone_length(const std::vector<std::vector<Point3>>& frames, size_t from, size_t to) {
  double sum = 0, squares = 0;
  for (const std::vector<Point3>& frame : frames) {
    const double l = length(frame[to] - frame[from]);
    sum += l;
    squares += l * l;
  }
  const double count = static_cast<double>(frames.size());
  const double mean = sum / count;
  return {mean, std::sqrt(std::max(0.0, squares / count - mean * mean))};
}

// 1 for a body whose head is where its feet are, as seen from the hips; 0 for one that stands.
double folded(const std::vector<std::vector<Point3>>& frames, const std::vector<MotionJoint>& joints) {
  const auto named = [&](const char* name) { return static_cast<size_t>(joint_named(joints, name)); };
  const size_t hips = named("hips"), head = named("head"), left = named("leftFoot"), right = named("rightFoot");
  double sum = 0;
  for (const std::vector<Point3>& frame : frames)
    sum += dot(unit(frame[head] - frame[hips]), unit(0.5 * (frame[left] + frame[right]) - frame[hips]));
  return std::max(0.0, sum / static_cast<double>(frames.size()));
}

}  // namespace

const std::vector<KeypointsLayout>& keypoint_layouts() {
  using Joints = std::vector<KeypointsLayout::Joint>;
  static const std::vector<KeypointsLayout> layouts = [] {
    const Joints body = {{"hips", {0}},
                         {"leftUpperLeg", {1}, {2}},
                         {"leftLowerLeg", {4}, {5}},
                         {"leftFoot", {7}, {8}},
                         {"leftToes", {10}, {11}},
                         {"spine", {3}},
                         {"chest", {6}},
                         {"upperChest", {9}},
                         {"neck", {12}},
                         {"head", {15}},
                         {"leftShoulder", {13}, {14}},
                         {"leftUpperArm", {16}, {17}},
                         {"leftLowerArm", {18}, {19}},
                         {"leftHand", {20}, {21}}};
    Joints smpl = body;
    smpl.push_back({"leftHand_end", {22}, {23}});
    const Joints coco = {{"hips", {11, 12}},         {"leftUpperLeg", {11}, {12}}, {"leftLowerLeg", {13}, {14}},
                         {"leftFoot", {15}, {16}},   {"upperChest", {5, 6}},       {"head", {3, 4}},
                         {"nose_end", {0}},          {"leftEar_end", {3}, {4}},    {"leftUpperArm", {5}, {6}},
                         {"leftLowerArm", {7}, {8}}, {"leftHand", {9}, {10}}};
    // Human3.6M: between the shoulders, the nose and the top of the head represent chest and head.
    const Joints h36m = {{"hips", {0}},
                         {"leftUpperLeg", {4}, {1}},
                         {"leftLowerLeg", {5}, {2}},
                         {"leftFoot", {6}, {3}},
                         {"spine", {7}},
                         {"upperChest", {8}},
                         {"head", {8, 10}},
                         {"nose_end", {9}},
                         {"headTop_end", {10}},
                         {"leftUpperArm", {11}, {14}},
                         {"leftLowerArm", {12}, {15}},
                         {"leftHand", {13}, {16}}};
    const Joints h36m_whole = {{"hips", {0}},           {"leftUpperLeg", {6}, {1}},   {"leftLowerLeg", {7}, {2}},
                               {"leftFoot", {8}, {3}},  {"leftToes", {9}, {4}},       {"spine", {12}},
                               {"upperChest", {13}},    {"head", {13, 15}},           {"nose_end", {14}},
                               {"headTop_end", {15}},   {"leftUpperArm", {17}, {25}}, {"leftLowerArm", {18}, {26}},
                               {"leftHand", {19}, {27}}};
    const Joints kinect = {{"hips", {0}},
                           {"leftUpperLeg", {12}, {16}},
                           {"leftLowerLeg", {13}, {17}},
                           {"leftFoot", {14}, {18}},
                           {"leftToes", {15}, {19}},
                           {"spine", {1}},
                           {"upperChest", {20}},
                           {"neck", {2}},
                           {"head", {3}},
                           {"leftUpperArm", {4}, {8}},
                           {"leftLowerArm", {5}, {9}},
                           {"leftHand", {6}, {10}},
                           {"leftHand_end", {7}, {11}}};
    const Joints openpose = {{"hips", {8}},
                             {"leftUpperLeg", {12}, {9}},
                             {"leftLowerLeg", {13}, {10}},
                             {"leftFoot", {14}, {11}},
                             {"leftToes", {19, 20}, {22, 23}},
                             {"upperChest", {1}},
                             {"head", {17, 18}},
                             {"nose_end", {0}},
                             {"leftEar_end", {18}, {17}},
                             {"leftUpperArm", {5}, {2}},
                             {"leftLowerArm", {6}, {3}},
                             {"leftHand", {7}, {4}}};
    const Joints lafan = {{"hips", {0}},
                          {"leftUpperLeg", {1}, {5}},
                          {"leftLowerLeg", {2}, {6}},
                          {"leftFoot", {3}, {7}},
                          {"leftToes", {4}, {8}},
                          {"spine", {9}},
                          {"chest", {10}},
                          {"upperChest", {11}},
                          {"neck", {12}},
                          {"head", {13}},
                          {"leftShoulder", {14}, {18}},
                          {"leftUpperArm", {15}, {19}},
                          {"leftLowerArm", {16}, {20}},
                          {"leftHand", {17}, {21}}};
    const Joints mediapipe = {{"hips", {23, 24}},
                              {"leftUpperLeg", {23}, {24}},
                              {"leftLowerLeg", {25}, {26}},
                              {"leftFoot", {27}, {28}},
                              {"leftToes", {31}, {32}},
                              {"upperChest", {11, 12}},
                              {"head", {7, 8}},
                              {"nose_end", {0}},
                              {"leftEar_end", {7}, {8}},
                              {"leftUpperArm", {11}, {12}},
                              {"leftLowerArm", {13}, {14}},
                              {"leftHand", {15}, {16}},
                              {"leftHand_end", {17, 19}, {18, 20}}};
    return std::vector<KeypointsLayout>{
        {"smpl24", 24, 30, smpl},         {"humanml3d22", 22, 20, body},     {"lafan22", 22, 30, lafan},
        {"smplh52", 52, 30, body},        {"smplx55", 55, 30, body},         {"coco17", 17, 30, coco},
        {"h36m17", 17, 50, h36m},         {"h36m32", 32, 50, h36m_whole},    {"kinect25", 25, 30, kinect},
        {"openpose25", 25, 30, openpose}, {"mediapipe33", 33, 30, mediapipe}};
  }();
  return layouts;
}

std::string motion_layouts() {
  std::string names;
  for (const KeypointsLayout& layout : keypoint_layouts())
    names += (names.empty() ? "" : ", ") + std::string(layout.name);
  return names;
}

LayoutColumns::LayoutColumns(const KeypointsLayout& layout) {
  for (const KeypointsLayout::Joint& joint : layout.joints) {
    names.emplace_back(joint.name);
    of.push_back(joint.columns);
    if (joint.right.empty()) continue;
    names.push_back(other_side_of_person(joint.name));
    of.push_back(joint.right);
  }
}

std::vector<Point3> LayoutColumns::joints_of(const std::vector<Point3>& row) const {
  std::vector<Point3> at;
  for (const std::vector<size_t>& columns : of) {
    Point3 sum{};
    for (const size_t column : columns) sum = sum + row[column];
    at.push_back((1 / static_cast<double>(columns.size())) * sum);
  }
  return at;
}

double layout_misfit(const KeypointsLayout& layout, const std::vector<std::vector<Point3>>& keypoints) {
  const LayoutColumns columns(layout);
  const std::vector<MotionJoint> joints = person_joints(columns.names);
  std::vector<std::vector<Point3>> frames;
  const size_t step = (keypoints.size() + kMostFramesAsked - 1) / kMostFramesAsked;
  for (size_t f = 0; f < keypoints.size(); f += step) frames.push_back(columns.joints_of(keypoints[f]));
  std::vector<BoneLength> bones(joints.size());
  double whole = 0, whole_person = 0, variation = 0, unlike = 0, proportions = 0;
  size_t bone_count = 0, pair_count = 0;
  for (size_t j = 0; j < joints.size(); ++j) {
    if (joints[j].parent < 0) continue;
    bones[j] = bone_length(frames, static_cast<size_t>(joints[j].parent), j);
    whole += bones[j].mean;
    whole_person += length(joints[j].offset);
    variation += bones[j].deviation;
    ++bone_count;
  }
  if (!(whole > 0)) return 10;  // all keypoints in one
  for (size_t j = 0; j < joints.size(); ++j) {
    if (joints[j].parent < 0) continue;
    const double share = std::max(bones[j].mean / whole, 1e-3);
    proportions += std::abs(std::log(share * whole_person / length(joints[j].offset)));
    const int right = joint_named(joints, other_side_of_person(joints[j].name));
    if (right <= static_cast<int>(j)) continue;
    const double a = bones[j].mean, b = bones[static_cast<size_t>(right)].mean;
    unlike += a + b > 0 ? 2 * std::abs(a - b) / (a + b) : 2;
    ++pair_count;
  }
  const double count = static_cast<double>(bone_count);
  return variation / whole + unlike / static_cast<double>(pair_count) + proportions / count + folded(frames, joints);
}

const KeypointsLayout* recognize_layout(const std::vector<std::vector<Point3>>& keypoints, std::string* misfits) {
  const KeypointsLayout* best = nullptr;
  double least = 0, next = 1e9;
  misfits->clear();
  for (const KeypointsLayout& layout : keypoint_layouts()) {
    if (layout.count != keypoints[0].size()) continue;
    const double misfit = layout_misfit(layout, keypoints);
    *misfits += print("%s%s %.2f", misfits->empty() ? "" : ", ", layout.name, misfit);
    if (best == nullptr || misfit < least) {
      next = best == nullptr ? next : least;
      least = misfit;
      best = &layout;
    } else {
      next = std::min(next, misfit);
    }
  }
  return best != nullptr && least < kFits && next > kClearly * least ? best : nullptr;
}

}  // namespace sinew
