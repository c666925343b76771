// SPDX-License-Identifier: MIT
// Poses, shapes that correct them, and how well.
#include "sinew_character/jobs/bake_job.hpp"

#include <utility>

#include "sinew_formats/error.hpp"

namespace sinew {
namespace {

constexpr size_t kHeldOut = 10;

// Poses to learn from, and others to be measured by.
struct Poses {
  std::vector<Palette> learned, held_out;
};

Poses chosen_poses(const BakeJobOptions& s, const Character& character, const Motion& motion) {
  Poses poses;
  if (!s.animation) {
    poses.learned = random_palettes(character, s.poses, s.limit, s.seed);
    poses.held_out = random_palettes(character, kHeldOut, s.limit, s.seed + 1);
    return poses;
  }
  const Clip& clip = find_clip(motion, s.character, *s.animation);
  const size_t frames = clip.frames.size();
  for (size_t f = 0; f < frames; ++f) {
    const Palette palette = motion_palette(motion, clip.frames[f], character.joints.size());
    // Ten frames at even distances, none of a clip too short to spare them.
    const bool spared = frames >= 3 * kHeldOut && (f * kHeldOut) / frames != ((f + 1) * kHeldOut) / frames;
    (spared ? poses.held_out : poses.learned).push_back(palette);
  }
  if (poses.learned.size() > s.poses) {  // evenly thinned
    std::vector<Palette> thinned;
    for (size_t p = 0; p < s.poses; ++p) thinned.push_back(poses.learned[p * poses.learned.size() / s.poses]);
    poses.learned = std::move(thinned);
  }
  return poses;
}

}  // namespace

void play_in_animations(const OwnMotion& own, const Character& character, Morphs* morphs) {
  for (size_t c = 0; c < own.keys.size(); ++c) {
    MorphClip keys = own.keys[c];
    for (const MotionFrame& frame : own.motion.clips[c].frames)
      keys.weights.push_back(
          shape_weights(character.joints, *morphs, motion_palette(own.motion, frame, character.joints.size())));
    morphs->clips.push_back(std::move(keys));
  }
}

BakedCharacter bake_character(const Character& character, const OwnMotion& own, const BakeJobOptions& job,
                              const std::function<std::function<bool()>(size_t)>& steps) {
  if (character.joints.empty() || character.influences.empty())
    throw Error(job.character + ": has no skin weights to bake; bind it first with sinew bind");
  if (job.animation && own.motion.clips.empty())
    throw Error(job.character + ": has no animation to bake; leave out --animation, or add one with sinew animate");
  const Poses poses = chosen_poses(job, character, own.motion);
  BakeSettings settings;
  settings.deform = job.deform;
  settings.shapes_per_bend = job.shapes;
  settings.error = job.error;
  const BakeProgress step = steps(2 * poses.learned.size() + poses.held_out.size());
  BakedCharacter baked;
  baked.morphs = bake_bends(character, poses.learned, settings, step);
  if (baked.morphs.shapes.empty()) {
    throw Error(job.character +
                ": nothing to bake: no joint bends in the poses; expected vertices or faces that follow two joints");
  }
  baked.learnt_poses = poses.learned.size();
  baked.held_out_poses = poses.held_out.size();
  baked.learned = bake_error(character, baked.morphs, poses.learned, job.deform, step);
  if (!poses.held_out.empty()) baked.held_out = bake_error(character, baked.morphs, poses.held_out, job.deform, step);
  play_in_animations(own, character, &baked.morphs);
  return baked;
}

}  // namespace sinew
