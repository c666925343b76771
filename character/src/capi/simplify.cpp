// SPDX-License-Identifier: MIT
// Calls that reduce or transform a character: sinew_character_simplify() (`sinew simplify`), sinew_character_lod()
// (`sinew lod`) and sinew_character_transform() (--turn, --height and --floor of the command).
#include <cmath>

#include "conversions.hpp"
#include "handle.hpp"
#include "sinew_character/jobs/lod_job.hpp"
#include "sinew_character/jobs/simplify_job.hpp"
#include "sinew_character/pose/character_transform.hpp"

namespace sinew {
namespace {

void simplify(const sinew_character_simplify_options& options, sinew_character* character, uint32_t* into) {
  need(options.keep != nullptr || options.keep_count == 0, "keep");
  if (character->character.joints.empty())
    throw Error(file_of(*character) + ": expected a skeleton, found a mesh without one");
  SimplifyOptions job;
  check_at_most("as_drawn", options.as_drawn, 1);
  job.low = options.low != 0;
  job.as_drawn = options.as_drawn != 0;
  job.joints = options.joint_count;
  for (uint32_t k = 0; k < options.keep_count; ++k) job.keep.push_back(text_or_empty(options.keep[k]));
  std::vector<const Motion*> motions;
  if (!character->drop_animations && !own_motion(character).clips.empty()) motions.push_back(&own_motion(character));
  Motion added = motion_of(character->character.joints);
  added.clips = character->clips;
  if (!added.clips.empty()) motions.push_back(&added);
  Character left = character->character;
  SimplifiedCharacter done = simplify_character(job, motions, &left);
  if (into != nullptr) std::copy(done.simplified.into.begin(), done.simplified.into.end(), into);
  character->character = std::move(left);
  character->clips = std::move(done.motion.clips);
  character->drop_animations = true;
  character->morphs = {};
  changed(character);
}

LodOptions job_of(const sinew_character_lod_options& options) {
  check_at_most("level_count", options.level_count, SINEW_MAX_LOD_LEVELS);
  check_at_most("fewer_joints", options.fewer_joints, 1);
  LodOptions job;
  if (options.level_count != 0) job.levels = options.level_count;
  if (options.ratio != 0) job.ratio = options.ratio;
  if (!(job.ratio >= 0.05 && job.ratio <= 0.95))
    throw Failure(SINEW_ERROR_ARGUMENT, "ratio: expected 0.05 to 0.95, or 0 for 0.5");
  job.joints = options.fewer_joints != 0;
  return job;
}

std::unique_ptr<sinew_character> handle_of(const sinew_character& from, LodLevel&& level, bool fewer_joints) {
  auto handle = std::make_unique<sinew_character>();
  handle->character = std::move(level.character);
  handle->same_skin = !fewer_joints;
  handle->drop_animations = fewer_joints;
  if (fewer_joints) handle->clips = std::move(level.motion.clips);
  handle->profile = from.profile;
  handle->profile_options = from.profile_options;
  return handle;
}

void transform_character(const sinew_character_transform_options& options, sinew_character* character) {
  need(options.turns != nullptr || options.turn_count == 0, "turns");
  check_at_most("floor", options.floor, 1);
  CharacterTransform transform;
  for (uint32_t t = 0; t < options.turn_count; ++t) {
    need(options.turns[t] != nullptr, "turns");
    transform.turns.emplace_back(options.turns[t]);
  }
  transform.height = options.height;
  transform.floor = options.floor != 0;
  check_transform(transform);
  const std::string& name = character->character.name;
  if (character->picture != nullptr)
    throw Error(name + ": is a picture, which stays in its plane; rotate it after saving");
  check_nothing_added(*character);
  const Axis up_axis = up_axis_of("up", options.up == SINEW_UP_AUTO ? uint32_t{SINEW_UP_Y} : options.up);
  const bool same_skin = character->same_skin;
  character->character = transformed(character->character, transform, up_axis);
  character->own_motion.reset();
  changed(character);
  character->same_skin = same_skin;
}

}  // namespace
}  // namespace sinew

using namespace sinew;

extern "C" sinew_status sinew_character_simplify(sinew_character* character,
                                                 const sinew_character_simplify_options* given, uint32_t* into) {
  return guarded(character, [&] {
    need(character != nullptr, "character");
    simplify(options_of(given), character, into);
  });
}

extern "C" sinew_status sinew_character_lod(sinew_character* character, const sinew_character_lod_options* given,
                                            sinew_character** levels, sinew_character_lod_level* figures) {
  return guarded(character, [&] {
    need(character != nullptr, "character");
    need(levels != nullptr, "levels");
    const LodOptions job = job_of(options_of(given));
    check_nothing_added(*character);
    std::vector<LodLevel> made = levels_of_detail(job, character->character);
    std::vector<std::unique_ptr<sinew_character>> handles;
    for (size_t k = 0; k < made.size(); ++k) {
      if (figures != nullptr)
        figures[k] = {made[k].rest_error, made[k].posed_error, made[k].mean_error, count32(made[k].triangles), 0};
      handles.push_back(handle_of(*character, std::move(made[k]), job.joints && k > 0));
    }
    for (size_t k = 0; k < handles.size(); ++k) levels[k] = handles[k].release();
  });
}

extern "C" sinew_status sinew_character_transform(sinew_character* character,
                                                  const sinew_character_transform_options* given) {
  return guarded(character, [&] {
    need(character != nullptr, "character");
    transform_character(options_of(given), character);
  });
}
