// SPDX-License-Identifier: MIT
#include "sinew_character/motion/motion_file.hpp"

#include <optional>
#include <utility>

#include "sinew_character/clips/builtin_motion.hpp"
#include "sinew_character/motion/map_cover.hpp"
#include "sinew_character/motion/map_skeleton.hpp"
#include "sinew_character/motion/rest_floor.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew {
namespace {

// How much of both bodies a map from the motion's reaches, then how many joints of the rig it moves.
std::pair<float, size_t> fit_of(const Motion& motion, const MapRig& rig, MaybeAxis up) {
  MapSkeletonOptions options;
  options.target_up = up;
  const MapRig from = map_rig_of(motion);
  const MappedSkeleton found = map_skeleton(rig, from, options);
  const MapCover cover =
      map_cover(rig, options.target_up, from, options.source_up, {found.sources.begin(), found.sources.end()});
  return {cover.share, found.mapped};
}

Motion motion_of_request(const MotionRequest& request, const MapRig& rig) {
  if (!is_builtin_motion(request.path)) return read_motion(request.path, request.fps, request.layout);
  if (!request.layout.empty()) check_layout(request.path);
  std::vector<Motion> motions = builtin_motions(request.path);
  size_t best = 0;
  std::pair<float, size_t> best_fit;
  for (size_t m = 0; m < motions.size() && motions.size() > 1; ++m) {
    const std::pair<float, size_t> fit = fit_of(motions[m], rig, request.up);
    if (m > 0 && fit <= best_fit) continue;
    best = m;
    best_fit = fit;
  }
  return std::move(motions[best]);
}

}  // namespace

MotionFile read_motion_for(const MotionRequest& request, const MapRig& rig) {
  Motion motion = motion_of_request(request, rig);
  std::optional<Motion> one = one_actor(motion, request.path, request.actor);
  MotionFile file = one ? MotionFile{std::move(*one), false} : MotionFile{std::move(motion), true};
  if (std::optional<Motion> level = motion_on_rest_floor(file.motion)) file.motion = std::move(*level);
  return file;
}

}  // namespace sinew
