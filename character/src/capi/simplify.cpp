// SPDX-License-Identifier: MIT
// sinew_character_simplify(): the job of `sinew simplify`.
#include "corrections_of.hpp"
#include "handle.hpp"
#include "sinew_character/jobs/simplify_job.hpp"

namespace sinew {
namespace {

void simplify(const sinew_character_simplify_options& options, sinew_character* character, uint32_t* into) {
  need(options.keep != nullptr || options.keep_count == 0, "keep");
  if (character->character.joints.empty())
    throw Error(file_of(*character) + ": expected a skeleton, found a mesh without one");
  SimplifyOptions job;
  job.low = options.low != 0;
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
