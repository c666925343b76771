// SPDX-License-Identifier: MIT
// sinew_character_bake(): the job of `sinew bake`.
#include "conversions.hpp"
#include "handle.hpp"
#include "sinew_character/jobs/bake_job.hpp"

namespace sinew {
namespace {

// The file's animations and those that were added, as one; the shapes play in both.
OwnMotion motion_of_handle(sinew_character* from) {
  OwnMotion own;
  if (from->character.gltf != nullptr && !from->path.empty() && !from->drop_animations) {
    const FilesOf scope(*from);
    own = read_own_motion(from->path);
  }
  return own;
}

void play_in_added(const sinew_character& from, Morphs* morphs) {
  OwnMotion added;
  added.motion = motion_of(from.character.joints);
  added.motion.clips = from.clips;
  for (size_t c = 0; c < from.clips.size(); ++c) {
    MorphClip keys;
    keys.is_new = true;
    keys.animation = c;
    keys.frame_time = from.clips[c].frame_time;
    added.keys.push_back(keys);
  }
  play_in_animations(added, from.character, morphs);
}

void bake(const sinew_character_bake_options& options, ProgressOfCaller* progress, sinew_character* character,
          sinew_character_bake_result* result) {
  BakeJobOptions job;
  job.character = file_of(*character);
  const auto corrections = corrections_of(options.deform, SINEW_POSE_VOLUME);
  if (!corrections) throw Failure(SINEW_ERROR_ARGUMENT, "deform: expected a correction, SINEW_POSE_VOLUME or above");
  job.deform = *corrections;
  check_at_most("poses", options.poses, 10000);
  check_at_most("shapes", options.shapes, 64);
  if (!(options.limit >= 0 && options.limit <= 180))
    throw Failure(SINEW_ERROR_ARGUMENT, "limit: expected 0 to 180 degrees");
  if (options.poses != 0) job.poses = options.poses;
  if (options.shapes != 0) job.shapes = options.shapes;
  if (options.seed != 0) job.seed = options.seed;
  if (options.limit != 0) job.limit = options.limit;
  if (!(options.error >= 0 && options.error <= 0.1)) throw Failure(SINEW_ERROR_ARGUMENT, "error: expected 0 to 0.1");
  if (options.error != 0) job.error = options.error;
  if (options.clip != nullptr) job.animation = options.clip;
  const OwnMotion own = motion_of_handle(character);
  BakedCharacter baked = bake_character(character->character, own, job, steps_of(progress));
  play_in_added(*character, &baked.morphs);
  sinew_character_bake_result filled = SINEW_INIT(sinew_character_bake_result);
  filled.shape_count = count32(baked.morphs.shapes.size());
  filled.bend_count = count32(baked.morphs.drivers.size());
  for (const MorphShape& shape : baked.morphs.shapes) filled.moved_vertices += count32(shape.vertices.size());
  filled.learnt_poses = count32(baked.learnt_poses);
  filled.held_out_poses = count32(baked.held_out_poses);
  filled.linear_error = baked.learned.linear;
  filled.baked_error = baked.learned.baked;
  filled.held_out_linear_error = baked.held_out.linear;
  filled.held_out_baked_error = baked.held_out.baked;
  character->morphs = std::move(baked.morphs);
  give(filled, result);
}

}  // namespace
}  // namespace sinew

using namespace sinew;

extern "C" sinew_status sinew_character_bake(sinew_character* character, const sinew_character_bake_options* given,
                                             sinew_character_bake_result* result) {
  ProgressOfCaller progress = progress_of(given);
  return guarded(
      character,
      [&] {
        need(character != nullptr, "character");
        check_result(result);
        bake(options_of(given), &progress, character, result);
      },
      &progress);
}
