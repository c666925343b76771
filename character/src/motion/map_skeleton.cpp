// SPDX-License-Identifier: MIT
// Maps rigs from files, with their end markers, by sinew_map().
#include "sinew_character/motion/map_skeleton.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <optional>
#include <utility>

#include "motion/upright_body.hpp"
#include "sinew/names.h"
#include "sinew/sinew.hpp"
#include "sinew_character/bind/bind.hpp"
#include "sinew_character/clips/builtin_motion.hpp"
#include "sinew_character/motion/map_source.hpp"
#include "sinew_character/predict/skeleton_template.hpp"
#include "sinew_character/rig/mesh_surface.hpp"
#include "sinew_formats/base/point.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/file_kinds.hpp"
#include "sinew_formats/io.hpp"
#include "text/text_lines.hpp"

namespace sinew {
namespace {

constexpr const char* kTemplate = "template:";
constexpr float kSomeWeight = 1e-3f;  // in sum over a mesh; less is what exporters leave behind

// Vertices that the skin lines of a rig.txt number: the mesh itself is not needed to see who has weight.
size_t skin_vertices(const std::string& path) {
  const std::string text = read_text_file(path);
  TextLines lines(path, text);
  size_t count = 0;
  while (lines.next()) {
    if (lines.words().size() < 2 || lines.words()[0] != "skin") continue;
    const std::optional<int64_t> vertex = to_integer(lines.words()[1]);
    if (!vertex || *vertex < 0 || *vertex >= static_cast<int64_t>(SINEW_MAX_VERTICES))
      lines.fail("a vertex number below " + std::to_string(SINEW_MAX_VERTICES), lines.words()[1]);
    count = std::max(count, static_cast<size_t>(*vertex) + 1);
  }
  return count;
}

// [J] joints that some frame of some clip rotates or moves from its first; empty without clips.
std::vector<uint8_t> animated_joints(const Motion& motion) {
  if (motion.clips.empty()) return {};
  std::vector<uint8_t> animated(motion.joints.size(), 0);
  for (const Clip& clip : motion.clips) {
    for (const MotionFrame& frame : clip.frames) {
      for (size_t j = 0; j < animated.size(); ++j) {
        const MotionFrame& first = clip.frames[0];
        const bool turns = j < frame.rotations.size() && frame.rotations[j] != first.rotations[j];
        const bool moves = j < frame.translations.size() && frame.translations[j] != first.translations[j];
        if (turns || moves) animated[j] = 1;
      }
    }
  }
  return animated;
}

MapRig rig_in_stance(const Motion& motion) { return map_source_of(motion, nullptr, {}, {}).rig; }

// The rig of a file with a mesh, or with moving nodes alone.
MapRig rig_of_scene(const std::string& path) {
  try {
    Character character;
    read_skeleton(path, false, &character);  // reports a file without joints
    return map_rig_of(read_gltf(path));
  } catch (const Error&) {
    try {
      return rig_in_stance(read_motion(path));
    } catch (const Error&) {  // its error as a skeleton is reported
    }
    throw;
  }
}

}  // namespace

MapRig map_rig_of(const Character& character) {
  MapRig rig;
  rig.name = character.name;
  rig.joints = character.joints;
  std::vector<float> weight(rig.joints.size(), 0);
  bool any = false;
  for (const auto& row : character.influences) {
    for (const Influence& influence : row) {
      weight[influence.joint] += influence.weight;
      any = any || influence.weight > 0;
    }
  }
  if (!any) return rig;
  rig.surfaces = joint_surfaces(character);
  rig.ends.assign(rig.joints.size(), 1);
  for (size_t j = 0; j < rig.joints.size(); ++j) {
    if (weight[j] > kSomeWeight) rig.ends[j] = 0;
    if (rig.joints[j].parent >= 0) rig.ends[static_cast<size_t>(rig.joints[j].parent)] = 0;
  }
  return rig;
}

MapRig map_rig_of(const Motion& motion) {
  MapRig rig;
  rig.name = motion.name;
  rig.joints = rest_joints(motion);
  rig.animated = animated_joints(motion);
  std::vector<size_t> children(motion.joints.size(), 0);
  for (const MotionJoint& joint : motion.joints)
    if (joint.parent >= 0) ++children[static_cast<size_t>(joint.parent)];
  for (const MotionJoint& joint : motion.joints) rig.ends.push_back(joint.end ? 1 : 0);
  for (const MotionJoint& joint : motion.joints) {
    if (!joint.end || joint.parent < 0) continue;
    const size_t above = static_cast<size_t>(joint.parent);
    if (children[above] == 1 && joint.offset == motion.joints[above].offset && joint.offset != Point3{})
      rig.ends[above] = 1;
  }
  if (std::all_of(rig.ends.begin(), rig.ends.end(), [](uint8_t end) { return end == 0; })) rig.ends.clear();
  return rig;
}

MapRig read_map_rig(const std::string& path) {
  MapRig rig;
  if (path.rfind(kTemplate, 0) == 0) {
    rig.joints = skeleton_template(path.substr(std::string(kTemplate).size()));
    for (const Joint& joint : rig.joints) rig.ends.push_back(joint.deforms.value_or(true) ? 0 : 1);
  } else if (is_builtin_motion(path)) {
    rig = map_rig_of(builtin_motions(path)[0]);
  } else if (has_extension(path, ".obj")) {
    rig = map_rig_of(read_character(path));
  } else if (is_motion_alone(path)) {
    rig = rig_in_stance(read_motion(path));
  } else if (has_extension(path, ".txt")) {
    Character character;
    character.vertices.resize(skin_vertices(path));
    read_skeleton(path, !character.vertices.empty(), &character);
    rig = map_rig_of(character);
  } else {
    rig = rig_of_scene(path);
  }
  rig.name = path;
  return rig;
}

// Up axis if it is unknown: along the legs of a body with two legs, else y, as in nearly all files. The engine's own
// guess is wrong for one animal in eight and for most fish (F1 of public maps without names 0.855, of y 0.900).
Axis found_up(const MapRig& rig, const MapSkeletonOptions& options) {
  MapRig read = rig;
  if (!options.names)
    for (Joint& joint : read.joints) joint.name.clear();
  if (!options.ends) read.ends.clear();
  const std::optional<UprightBody> body = find_upright_body(read.joints, limb_classes(read, {}));
  std::vector<Point3> positions;
  for (const Joint& joint : rig.joints) positions.push_back(point(joint.position));
  if (!body || !is_upright(*body, positions)) return Axis::kY;  // a spider laid over a person says nothing
  Point3 legs{};
  for (const UprightLimb& leg : body->legs)
    legs = legs + unit(point(rig.joints[static_cast<size_t>(leg.upper)].position) -
                       point(rig.joints[static_cast<size_t>(leg.end)].position));
  const Point3 up = unit(legs);
  constexpr double kPlain = 0.8;  // cosine
  for (size_t axis = 0; axis < 3; ++axis)
    if (up[axis] > kPlain) return static_cast<Axis>(axis);
  return Axis::kY;
}

MappedSkeleton map_skeleton(const MapRig& target, const MapRig& source, const MapSkeletonOptions& options) {
  const auto up_of = [&](const MapRig& rig, MaybeAxis up) { return up ? *up : found_up(rig, options); };
  const MapRigView target_view(target, up_of(target, options.target_up), options),
      source_view(source, up_of(source, options.source_up), options);
  const sinew_skeleton &to = target_view.skeleton, &from = source_view.skeleton;
  MapSettings settings;
  settings.method = options.method;
  settings.pins = options.pins.data();
  settings.pin_count = static_cast<uint32_t>(options.pins.size());
  if (options.method == SINEW_MAP_BRANCHES) {
    settings.branches_first = options.branches_first;
    settings.branches_cost = options.branches_cost;
    if (!target.surfaces.shares.empty()) settings.target_areas = target.surfaces.shares.data();
    if (!source.surfaces.shares.empty()) settings.source_areas = source.surfaces.shares.data();
    if (!source.animated.empty()) settings.source_animated = source.animated.data();
  }
  const auto check = [&](sinew_status status) {
    if (status != SINEW_OK)
      throw Error(target.name + " from " + source.name + ": cannot map, " + sinew_status_text(status));
  };
  for (const MapRig* rig : {&target, &source})
    if (rig->joints.size() > SINEW_MAX_JOINTS)
      throw Error(rig->name + ": expected at most " + std::to_string(SINEW_MAX_JOINTS) + " joints, found " +
                  std::to_string(rig->joints.size()));
  MappedSkeleton result;
  check(sinew_map_workspace_size(to.joint_count, from.joint_count, &result.workspace_bytes));
  Workspace workspace(result.workspace_bytes);
  if (workspace.size() < result.workspace_bytes)
    throw OutOfMemory(target.name + ": no memory for a workspace of " +
                      std::to_string(result.workspace_bytes / 1000000) + " MB in one block");
  JointMap map;
  const auto begin = std::chrono::steady_clock::now();
  check(map_joints(to, from, settings, &workspace, &map));
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  result.sources = std::move(map.sources);
  result.reasons = std::move(map.reasons);
  for (const uint16_t one : map.confidence) result.confidence.push_back(static_cast<float>(one) / 32768.0f);
  result.method = map.method;
  result.mapped = map.mapped;
  result.certainty = static_cast<float>(map.certainty) / 32768.0f;
  return result;
}

std::vector<uint8_t> limb_classes(const MapRig& target, MaybeAxis target_up, const MapRig* source,
                                  const std::vector<int>& sources) {
  const MapSkeletonOptions options;
  const MapRigView target_view(target, target_up, options);
  std::optional<MapRigView> source_view;
  if (source != nullptr) source_view.emplace(*source, MaybeAxis(), options);
  const sinew_skeleton& to = target_view.skeleton;
  const sinew_skeleton* const from = source_view ? &source_view->skeleton : nullptr;
  std::vector<uint8_t> classes(target.joints.size());
  const auto check = [&](sinew_status status) {
    if (status != SINEW_OK) throw Error(target.name + ": cannot tell arms from legs, " + sinew_status_text(status));
  };
  size_t bytes = 0;
  check(sinew_limb_classes_workspace_size(to.joint_count, from != nullptr ? from->joint_count : 0, &bytes));
  Workspace workspace;
  check(workspace.reserve(bytes) ? SINEW_OK : SINEW_ERROR_WORKSPACE);
  check(sinew_limb_classes(&to, from, source != nullptr ? sources.data() : nullptr, workspace.data(), workspace.size(),
                           classes.data()));
  return classes;
}

}  // namespace sinew
