// SPDX-License-Identifier: MIT
// sinew_character_lod(): the job of `sinew lod`.
#include <cmath>

#include "handle.hpp"
#include "sinew_character/jobs/lod_job.hpp"

namespace sinew {
namespace {

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

}  // namespace
}  // namespace sinew

using namespace sinew;

extern "C" sinew_status sinew_character_lod(sinew_character* character, const sinew_character_lod_options* given,
                                            sinew_character** levels, sinew_character_lod_level* figures) {
  return guarded(character, [&] {
    need(character != nullptr, "character");
    need(levels != nullptr, "levels");
    const LodOptions job = job_of(options_of(given));
    if (!character->clips.empty() || !character->morphs.shapes.empty())
      throw Error(character->character.name +
                  ": has clips or morph targets that are in no file yet; save it and open that");
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
