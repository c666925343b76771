// SPDX-License-Identifier: MIT
// Numbers by kind.
#include <algorithm>
#include <array>
#include <cmath>

#include "sinew_character/springs/find_springs.hpp"
#include "sinew_formats/median.hpp"
#include "springs/body_skin.hpp"

namespace sinew {
namespace {

// A step of the reference algorithm draws a bone back by stiffness / (60 length) of its angle: `pull` is that share for the first bone. And the
// air stands still in it, so that a chain that travels hangs back by an angle whose sine is drag * speed / stiffness: at walking speed by `lag` at
// most. The larger one of both stiffnesses counts. A bone that keeps 1 - drag of its motion comes to rest within 1.5 seconds where pull is above
// 0.03 (roots of z^2 - (2 - drag - pull) z + 1 - drag).
struct Preset {
  SpringKind kind;
  const char* text;
  double pull;     // a step, of the first bone
  double fall;     // by how much of the stiffness it is less at the last bone
  double drag;     // of the motion, a step
  double gravity;  // share of the stiffness
  double lag;      // degrees
  double limit;    // degrees
};
constexpr std::array<Preset, 8> kPresets = {{{SpringKind::kHair, "hair", 0.20, 0.4, 0.30, 0.05, 10, 60},
                                             {SpringKind::kLongHair, "long-hair", 0.10, 0.4, 0.30, 0.10, 15, 70},
                                             {SpringKind::kSkirt, "skirt", 0.12, 0.3, 0.40, 0.08, 10, 50},
                                             {SpringKind::kTail, "tail", 0.08, 0.4, 0.30, 0.00, 12, 60},
                                             {SpringKind::kEar, "ear", 0.30, 0.3, 0.30, 0.00, 8, 40},
                                             {SpringKind::kCape, "cape", 0.07, 0.3, 0.25, 0.12, 20, 80},
                                             {SpringKind::kBust, "bust", 0.30, 0.0, 0.30, 0.00, 6, 20},
                                             {SpringKind::kRibbon, "ribbon", 0.14, 0.4, 0.25, 0.08, 15, 70}}};
constexpr double kWalk = 0.8;           // heights a second
constexpr double kSteps = 60;           // a second: those that the engine and other players take
constexpr double kSkinShare = 0.8;      // of the skin's distance from the bone is the hit radius
constexpr double kMostBoneShare = 0.3;  // of a bone's length a hit radius is
constexpr size_t kFewVertices = 4;
constexpr double kRadians = 0.017453292519943295;  // of a degree

const Preset& preset_of(SpringKind kind) {
  return *std::find_if(kPresets.begin(), kPresets.end(), [&](const Preset& one) { return one.kind == kind; });
}

}  // namespace

const char* spring_kind_text(SpringKind kind) { return preset_of(kind).text; }

std::optional<SpringKind> spring_kind_of(const std::string& text) {
  for (const Preset& one : kPresets)
    if (text == one.text) return one.kind;
  return std::nullopt;
}

std::string spring_kinds_text() {
  std::string out;
  for (const Preset& one : kPresets) out += (out.empty() ? "" : ", ") + std::string(one.text);
  return out;
}

double chain_length(const SpringChain& chain, const std::vector<Joint>& joints, std::vector<double>* bones) {
  double sum = 0;
  for (size_t i = 0; i < chain.turning_joints(); ++i) {
    const Point3 from = point(joints[chain.joints[i].joint].position);
    const bool last = i + 1 == chain.joints.size();
    const double bone = length(last ? *chain.end : point(joints[chain.joints[i + 1].joint].position) - from);
    if (bones != nullptr) bones->push_back(bone);
    sum += bone;
  }
  return sum;
}

void preset_chain(SpringKind kind, const Character& character, SpringChain* chain) {
  const Preset& preset = preset_of(kind);
  std::vector<double> bones;
  (void)chain_length(*chain, character.joints, &bones);
  std::vector<std::vector<double>> distances(bones.size());  // of the skin from each bone
  std::vector<int> bone_of(character.joints.size(), -1);
  for (size_t i = 0; i < bones.size(); ++i) bone_of[chain->joints[i].joint] = static_cast<int>(i);
  const std::vector<std::vector<uint32_t>> held = followers_of(character);
  // Panels of a skirt move out and in: a panel that moves along the skirt lets a leg pass.
  Point3 outward{};
  const int on = character.joints[chain->joints[0].joint].parent;
  if (kind == SpringKind::kSkirt && on >= 0)
    outward = unit(across(point(character.joints[chain->joints[0].joint].position) -
                              point(character.joints[static_cast<size_t>(on)].position),
                          up_of(character)));
  const double against_air = preset.drag * kWalk * height_of(character) / std::sin(preset.lag * kRadians);
  for (size_t i = 0; i < bones.size(); ++i) {
    SpringJoint& joint = chain->joints[i];
    const Point3 from = point(character.joints[joint.joint].position);
    const Point3 to = tail_at_rest(*chain, i, character.joints);
    for (const uint32_t v : held[joint.joint])
      distances[i].push_back(segment_distance(point(character.vertices[v]), from, to));
    const double along = bones.size() > 1 ? static_cast<double>(i) / static_cast<double>(bones.size() - 1) : 0;
    joint.stiffness = (1 - preset.fall * along) * std::max(preset.pull * kSteps * bones[i], against_air);
    joint.gravity_power = preset.gravity * joint.stiffness;
    joint.gravity = -1.0 * up_of(character);
    joint.drag = preset.drag;
    joint.limit = preset.limit;
    joint.hinge = unit(cross(to - from, outward));
    joint.hit_radius = 0;
    if (distances[i].size() >= kFewVertices)
      joint.hit_radius = std::min(kSkinShare * median(&distances[i]), kMostBoneShare * bones[i]);
  }
}

}  // namespace sinew
