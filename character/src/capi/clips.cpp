// SPDX-License-Identifier: MIT
// A character's motion, out and in.
#include <cmath>

#include "handle.hpp"
#include "sinew_character/clips/builtin_motion.hpp"
#include "sinew_formats/file_kinds.hpp"

namespace sinew {
namespace {

// The rest pose of motions is that of their own file.
std::vector<int32_t> parents_of(const Motion& motion) {
  std::vector<int32_t> parents;
  for (const MotionJoint& joint : motion.joints) parents.push_back(joint.parent);
  return parents;
}

ClipView view_of(const Motion& motion, const Clip& clip) {
  ClipView view;
  for (const MotionFrame& frame : clip.frames) {
    for (const Quaternion& q : frame.rotations) view.rotations.insert(view.rotations.end(), q.begin(), q.end());
    for (const Point3& p : frame.translations) view.translations.insert(view.translations.end(), p.begin(), p.end());
  }
  view.parents = parents_of(motion);
  return view;
}

Clip clip_of(const sinew_character_clip& given, size_t joint_count) {
  if (given.joint_count != joint_count)
    throw Error("clip: expected the character's " + std::to_string(joint_count) + " joints, found " +
                std::to_string(given.joint_count));
  if (given.frame_count == 0 || !(given.frame_time > 0) || !std::isfinite(given.frame_time))
    throw Error("clip: expected frames and seconds between them");
  need(given.rotations != nullptr && given.translations != nullptr, "clip.rotations, clip.translations");
  Clip clip;
  clip.name = given.name != nullptr ? given.name : "clip";
  clip.frame_time = given.frame_time;
  for (size_t f = 0; f < given.frame_count; ++f) {
    MotionFrame frame;
    for (size_t j = 0; j < joint_count; ++j) {
      const double* q = given.rotations + 4 * (f * joint_count + j);
      const double* p = given.translations + 3 * (f * joint_count + j);
      const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
      if (!std::isfinite(length + p[0] + p[1] + p[2]) || !(length > 0))
        throw Failure(SINEW_ERROR_NOT_FINITE, "clip: frame " + std::to_string(f) + ", joint " + std::to_string(j) +
                                                  " is not finite, or its rotation has no length");
      frame.rotations.push_back({q[0] / length, q[1] / length, q[2] / length, q[3] / length});
      frame.translations.push_back({p[0], p[1], p[2]});
    }
    clip.frames.push_back(std::move(frame));
  }
  return clip;
}

}  // namespace

const Motion& own_motion(sinew_character* character) {
  if (character->own_motion) return *character->own_motion;
  Motion motion;
  if (is_builtin_motion(character->path)) {
    motion = builtin_motions(character->path)[0];
  } else if (has_use(character->path, kReadsMotion)) {
    const FilesOf scope(*character);
    try {
      motion = read_motion(character->path);
    } catch (const OutOfMemory&) {
      throw;
    } catch (const Error&) {  // none is fine: the file itself was read before
      motion = motion_of(character->character.joints);
    }
  }
  character->own_motion = std::move(motion);
  return *character->own_motion;
}

size_t own_clip_count(sinew_character* character) {
  return character->drop_animations ? 0 : own_motion(character).clips.size();
}

}  // namespace sinew

using namespace sinew;

extern "C" {

sinew_status sinew_character_clip_count(sinew_character* character, uint32_t* count) {
  return guarded(character, [&] {
    need(character != nullptr, "character");
    need(count != nullptr, "count");
    *count = count32(own_clip_count(character) + character->clips.size());
  });
}

sinew_status sinew_character_get_clip(sinew_character* character, uint32_t index, sinew_character_clip* clip) {
  return guarded(character, [&] {
    need(character != nullptr, "character");
    need(clip != nullptr, "clip");
    check_result(clip);
    const size_t own = own_clip_count(character), count = own + character->clips.size();
    if (index >= count)
      throw Failure(SINEW_ERROR_ARGUMENT,
                    "clip " + std::to_string(index) + ": the character has " + std::to_string(count) + " clips");
    const Motion added = motion_of(character->character.joints);
    const Clip& from = index < own ? own_motion(character).clips[index] : character->clips[index - own];
    if (character->clip_views.size() < count) character->clip_views.resize(count);
    ClipView& view = character->clip_views[index];
    if (view.rotations.empty()) view = view_of(index < own ? own_motion(character) : added, from);
    view.joint_names.clear();
    if (index < own)
      for (const MotionJoint& joint : own_motion(character).joints) view.joint_names.push_back(joint.name.c_str());
    else
      for (const Joint& joint : character->character.joints) view.joint_names.push_back(joint.name.c_str());
    sinew_character_clip filled = SINEW_INIT(sinew_character_clip);
    filled.frame_count = count32(from.frames.size());
    filled.joint_count = count32(view.parents.size());
    filled.frame_time = from.frame_time;
    filled.name = from.name.c_str();
    filled.rotations = view.rotations.data();
    filled.translations = view.translations.data();
    filled.joint_names = view.joint_names.data();
    filled.parents = view.parents.data();
    give(filled, clip);
  });
}

sinew_status sinew_character_add_clip(sinew_character* character, const sinew_character_clip* clip) {
  return guarded(character, [&] {
    need(character != nullptr, "character");
    need(clip != nullptr, "clip");
    const sinew_character_clip given = options_of(clip);
    if (character->character.joints.empty()) throw Error(character->character.name + ": has no skeleton to animate");
    character->clips.push_back(clip_of(given, character->character.joints.size()));
    character->clip_views.clear();
  });
}

}  // extern "C"
