// SPDX-License-Identifier: MIT
// Motions as sources: their stance, and what the mesh of their file tells of their joints.
#include "sinew_character/motion/map_source.hpp"

#include <cmath>
#include <map>
#include <utility>

#include "sinew_character/clips/builtin_motion.hpp"
#include "sinew_character/motion/retarget.hpp"
#include "sinew_character/motion/stance.hpp"
#include "sinew_character/predict/own_skeleton.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/file_kinds.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew {
namespace {

// Whether a motion was made on a skeleton: most of its joints stand from their parents as that one's of the same names do.
bool has_rest_of(const Motion& motion, const std::vector<Joint>& target) {
  const Motion own = motion_of(target);
  std::map<std::string, size_t> named;
  for (size_t j = 0; j < own.joints.size(); ++j) named[own.joints[j].name] = j;
  size_t same = 0;
  for (const MotionJoint& joint : motion.joints) {
    const auto found = named.find(joint.name);
    if (found == named.end() || joint.parent < 0) continue;
    const Point3 &a = joint.offset, &b = own.joints[found->second].offset;
    const double off = std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]), size = std::hypot(b[0], b[1], b[2]);
    same += off <= 0.01 * size ? 1 : 0;
  }
  return 2 * same > motion.joints.size();
}

// Animated nodes beside the skin stand behind the body's joints and move nothing of it.
MapRig with_skin_of(const Character& body, MapRig rig) {
  Character whole = body;
  whole.joints = rig.joints;
  MapRig skinned = map_rig_of(whole);
  skinned.name = std::move(rig.name);
  skinned.animated = std::move(rig.animated);
  return skinned;
}

bool is_motion(const std::string& path) {
  return is_builtin_motion(path) || (!is_template(path) && has_use(path, kReadsMotion));
}

}  // namespace

std::optional<MotionFile> read_motion_in(const MapSourceRequest& request, const MapRig& target) {
  if (!request.layout.empty()) check_layout(request.path);
  const MotionRequest motion = {request.path,     0, request.layout, request.actor, request.target_up, request.down,
                                request.find_down};
  if (is_builtin_motion(request.path) || is_motion_alone(request.path) || !request.actor.empty())
    return read_motion_for(motion, target);
  if (!is_motion(request.path)) return std::nullopt;
  try {
    return read_motion_for(motion, target);
  } catch (const OutOfMemory&) {
    throw;
  } catch (const Error&) {  // read_map_rig() reports its error as a skeleton
    return std::nullopt;
  }
}

MapSource map_source_of(const Motion& motion, const Character* body, const std::vector<Joint>& target, MaybeAxis up) {
  const bool has_skin = body != nullptr && !body->influences.empty();
  MapSource source;
  if (!has_skin && !has_rest_of(motion, target)) source.standing = standing_motion(motion, up);
  source.rig = map_rig_of(source.standing ? *source.standing : motion);
  if (has_skin) source.rig = with_skin_of(*body, std::move(source.rig));
  return source;
}

MapRig read_map_source(const MapSourceRequest& request, const MapRig& target) {
  const std::optional<MotionFile> file = read_motion_in(request, target);
  if (!file) {
    MapRig rig = read_map_rig(request.path);
    if (request.down) turn_over(*request.down, &rig.joints);
    return rig;
  }
  const std::optional<Character> body = file->whole ? body_of_motion(request.path) : std::nullopt;
  MapRig rig = map_source_of(file->motion, body ? &*body : nullptr, target.joints, request.up).rig;
  rig.name = request.path;
  return rig;
}

}  // namespace sinew
