// SPDX-License-Identifier: MIT
// Bends of the report's pictures and which connected parts of a character are cloth, the step before bend_pictures.cpp.
#include "score/bends.hpp"

#include <array>
#include <cmath>
#include <map>

#include "sinew/rig.h"
#include "sinew_character/pose/pose.hpp"
#include "sinew_character/predict/fit_skeleton.hpp"
#include "sinew_character/rig/mesh_surface.hpp"
#include "sinew_formats/base/box.hpp"
#include "sinew_formats/print.hpp"

namespace sinew {
namespace {

Vec3d position_of(const Joint& joint) {
  return {static_cast<double>(joint.position.x), static_cast<double>(joint.position.y),
          static_cast<double>(joint.position.z)};
}

Vec3d rotation_axis(const Character& character, size_t joint, const Bend& bend, Axis up) {
  const Vec3d at = position_of(character.joints[joint]);
  if (bend.twist) return unit(at - position_of(character.joints[static_cast<size_t>(character.joints[joint].parent)]));
  const Vec3d after = bone_direction(character, joint);
  const Vec3d front = up == Axis::kZ ? Vec3d{0, -1, 0} : Vec3d{0, 0, 1},
              upwards = up == Axis::kZ ? Vec3d{0, 0, 1} : Vec3d{0, 1, 0};
  const Vec3d direction = bend.upwards ? upwards : bend.backwards ? -1.0 * front : front;
  const Vec3d axis = cross(after, direction);
  return unit(length(axis) > 0.3 ? axis : cross(after, front));  // an arm that hangs down
}

}  // namespace

const std::vector<Bend>& report_bends() {
  static const std::vector<Bend> bends = {
      {SINEW_CLASS_FOREARM, "elbow, bent by", 130, false, true, false, 20},
      {SINEW_CLASS_CALF, "knee, bent by", 130, false, false, true, 20},
      {SINEW_CLASS_THIGH, "hip, thigh forward by", 90, false, false, false, 45},
      {SINEW_CLASS_UPPER_ARM, "shoulder, arm rotated by", 75, false, true, false, 20},
      {SINEW_CLASS_HAND, "wrist, twisted by", 150, true, false, false, 20}};
  return bends;
}

size_t bent_joint(const Character& character, const LabeledSkeleton& labels, const Bend& bend) {
  std::vector<double> weight(character.joints.size(), 0);
  std::vector<char> has_child(character.joints.size(), 0);
  for (const auto& row : character.influences)
    for (const Influence& influence : row) weight[influence.joint] += static_cast<double>(influence.weight);
  for (const Joint& joint : character.joints)
    if (joint.parent >= 0) has_child[static_cast<size_t>(joint.parent)] = 1;
  size_t best = SIZE_MAX;
  for (size_t j = 0; j < weight.size(); ++j) {
    if (labels.classes[j] != bend.joint_class || labels.ends[j] != 0 || character.joints[j].parent < 0 ||
        weight[j] <= 0 || (has_child[j] == 0 && !bend.twist))
      continue;
    if (best == SIZE_MAX || weight[j] > weight[best]) best = j;
  }
  return best;
}

Vec3d bone_direction(const Character& character, size_t joint) {
  const Vec3d at = position_of(character.joints[joint]);
  Vec3d sum{0, 0, 0};
  for (const Joint& child : character.joints)
    if (child.parent == static_cast<int>(joint)) sum = sum + (position_of(child) - at);
  return unit(sum);
}

std::string bend_text(const Bend& bend, double degrees) { return print("%s %.0f degrees", bend.what, degrees); }

BentView bent_view(const Character& character, size_t joint, const Bend& bend, double degrees, Axis up, float radius,
                   int side) {
  constexpr double kDegree = 3.14159265358979323846 / 180;
  BentView out;
  const Vec3d axis = rotation_axis(character, joint, bend, up), at = position_of(character.joints[joint]);
  const Affine turn = rotation_about(axis_rotation({axis.x, axis.y, axis.z}, degrees * kDegree), {at.x, at.y, at.z});
  out.palette.assign(character.joints.size(), kIdentity);
  for (const size_t j : joint_tree(character).parents_first) {
    const int parent = character.joints[j].parent;
    if (parent >= 0) out.palette[j] = out.palette[static_cast<size_t>(parent)];
    if (j == joint) out.palette[j] = multiply(out.palette[j], turn);
  }
  const Box box = box_of(character.vertices);
  RenderOptions& view = out.view;
  view.width = view.height = side;
  view.up = up;
  view.draw_skeleton = false;
  view.focus = character.joints[joint].position;
  view.focus_radius = radius * box.longest_side();
  // Along the axis of a bend, across a twist. An axis has two ends to look from.
  const double outward = view.focus.x < (box.low.x + box.high.x) / 2 ? -1 : 1;
  const Vec3d look = bend.twist ? (up == Axis::kZ ? Vec3d{0, -1, 0} : Vec3d{0, 0, 1}) : axis;
  double across = look.x, ahead = up == Axis::kZ ? -look.y : look.z;
  const bool from_front = std::abs(ahead) > 0.7;
  if (from_front ? ahead < 0 : outward * across < 0) across = -across, ahead = -ahead;
  view.yaw_degrees =
      static_cast<float>(std::atan2(across, ahead) / kDegree + (from_front ? bend.aside : -bend.aside) * outward);
  return out;
}

namespace {

constexpr int kRays = 12;
constexpr double kDressReach = 0.25;  // of the longest side: cloth farther from the bone is not around it
constexpr double kDownTheBone = 0.3;  // beside the joint, where a bend has its creases, but outside of the torso

Vec3d position_of(const Vec3& p) {
  return {static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z)};
}

// [V] the number of the vertex' connected part, in the order of their first vertices.
std::vector<size_t> parts_of(const Character& character, size_t* count) {
  const auto neighbors = neighbors_of(character);
  std::vector<size_t> parts(character.vertices.size(), SIZE_MAX), queue;
  *count = 0;
  for (size_t first = 0; first < parts.size(); ++first) {
    if (parts[first] != SIZE_MAX) continue;
    parts[first] = *count;
    queue = {first};
    while (!queue.empty()) {
      const size_t v = queue.back();
      queue.pop_back();
      for (const uint32_t n : neighbors[v]) {
        if (parts[n] != SIZE_MAX) continue;
        parts[n] = *count;
        queue.push_back(n);
      }
    }
    ++*count;
  }
  return parts;
}

// How far along a ray of unit length a triangle is met (Moeller and Trumbore, 1997), or infinity.
double met_after(Vec3d from, Vec3d direction, Vec3d a, Vec3d b, Vec3d c) {
  const Vec3d u = b - a, v = c - a, across = cross(direction, v);
  const double volume = dot(u, across);
  if (volume == 0) return INFINITY;
  const Vec3d to = from - a, over = cross(to, u);
  const double s = dot(to, across) / volume, t = dot(direction, over) / volume, distance = dot(v, over) / volume;
  return s >= 0 && t >= 0 && s + t <= 1 && distance > 0 ? distance : INFINITY;
}

// Parts that every ray meets, each with the mean of its nearest distances.
std::map<size_t, double> parts_around(const Character& character, const std::vector<size_t>& parts, Vec3d from,
                                      Vec3d bone, double reach) {
  const Vec3d any = std::abs(bone.y) < 0.7 ? Vec3d{0, 1, 0} : Vec3d{1, 0, 0};
  const Vec3d u = unit(cross(bone, any)), v = cross(bone, u);
  std::map<size_t, std::array<double, kRays>> met;
  std::array<double, kRays> none;
  none.fill(INFINITY);
  for (size_t f = 0; f < character.face_count(); ++f) {
    const uint32_t begin = character.face_offsets[f], end = character.face_offsets[f + 1];
    for (uint32_t i = begin + 2; i < end; ++i) {
      const uint32_t first = character.face_vertices[begin];
      const Vec3d a = position_of(character.vertices[first]),
                  b = position_of(character.vertices[character.face_vertices[i - 1]]),
                  c = position_of(character.vertices[character.face_vertices[i]]);
      for (size_t r = 0; r < kRays; ++r) {
        const double angle = 2 * std::acos(-1.0) * static_cast<double>(r) / kRays;
        const double distance = met_after(from, std::cos(angle) * u + std::sin(angle) * v, a, b, c);
        if (distance > reach) continue;
        double& nearest = met.emplace(parts[first], none).first->second[r];
        nearest = std::min(nearest, distance);
      }
    }
  }
  std::map<size_t, double> around;
  for (const auto& [part, distances] : met) {
    double sum = 0;
    for (const double distance : distances) sum += distance / kRays;
    if (sum < INFINITY) around.emplace(part, sum);
  }
  return around;
}

// The parts that `keep` tells, with all joints.
Character piece(const Character& whole, const std::vector<char>& keep) {
  Character out;
  out.name = whole.name;
  out.joints = whole.joints;
  std::vector<uint32_t> index(whole.vertices.size(), 0);
  for (size_t v = 0; v < keep.size(); ++v) {
    if (keep[v] == 0) continue;
    index[v] = static_cast<uint32_t>(out.vertices.size());
    out.vertices.push_back(whole.vertices[v]);
    out.influences.push_back(whole.influences[v]);
  }
  for (size_t f = 0; f < whole.face_count(); ++f) {
    const uint32_t begin = whole.face_offsets[f], end = whole.face_offsets[f + 1];
    if (begin == end || keep[whole.face_vertices[begin]] == 0) continue;
    for (uint32_t i = begin; i < end; ++i) out.face_vertices.push_back(index[whole.face_vertices[i]]);
    out.face_offsets.push_back(static_cast<uint32_t>(out.face_vertices.size()));
  }
  return out;
}

}  // namespace

std::optional<Dressed> take_apart(const Character& character) {
  if (character.influences.empty()) return std::nullopt;
  size_t part_count = 0;
  const std::vector<size_t> parts = parts_of(character, &part_count);
  if (part_count < 2) return std::nullopt;
  const LabeledSkeleton labels = label_skeleton(character.joints);
  const double size = static_cast<double>(box_of(character.vertices).longest_side());
  Dressed out;
  std::vector<char> cloth(part_count, 0);
  for (const Bend& bend : report_bends()) {
    const size_t joint = bend.twist ? SIZE_MAX : bent_joint(character, labels, bend);
    if (joint == SIZE_MAX) continue;
    const Vec3d bone = bone_direction(character, joint), at = position_of(character.joints[joint].position);
    double bone_length = size;
    for (const Joint& child : character.joints)
      if (child.parent == static_cast<int>(joint))
        bone_length = std::min(bone_length, length(position_of(child.position) - at));
    const auto around =
        parts_around(character, parts, at + kDownTheBone * bone_length * bone, bone, kDressReach * size);
    if (around.size() < 2) continue;
    double inner = INFINITY;
    for (const auto& [part, distance] : around) inner = std::min(inner, distance);
    for (const auto& [part, distance] : around)
      if (distance > inner) cloth[part] = 1;
    out.bends.emplace_back(&bend, joint);
  }
  if (out.bends.empty()) return std::nullopt;
  std::vector<char> keep(character.vertices.size());
  for (size_t v = 0; v < keep.size(); ++v) keep[v] = cloth[parts[v]] != 0;
  out.garment = piece(character, keep);
  out.garment.influences.clear();
  for (char& one : keep) one = one == 0;
  out.body = piece(character, keep);
  return out;
}

}  // namespace sinew
