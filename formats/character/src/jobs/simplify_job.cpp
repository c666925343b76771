// SPDX-License-Identifier: MIT
// Fewer joints, and motion for them.
#include "sinew_character/simplify_job.hpp"

#include <utility>

#include "sinew_character/retarget.hpp"

namespace sinew {

SimplifiedCharacter simplify_character(const SimplifyOptions& options, const std::vector<const Motion*>& motions,
                                       Character* character) {
  Character left = *character;
  SimplifiedCharacter out;
  out.simplified = simplify_skeleton(options, &left);
  out.motion = motion_of(left.joints);
  std::vector<int> sources(left.joints.size(), -1);
  for (size_t j = 0; j < out.simplified.number.size(); ++j)
    if (out.simplified.number[j] >= 0) sources[static_cast<size_t>(out.simplified.number[j])] = static_cast<int>(j);
  RetargetSettings settings;
  settings.method = SINEW_RETARGET_COPY;
  settings.scale = 1;
  for (const Motion* own : motions) {
    Retargeter retargeter(*own, left.joints, sources, std::vector<uint8_t>(left.joints.size(), SINEW_CLASS_OTHER),
                          settings);
    for (const Clip& clip : own->clips) out.motion.clips.push_back(retargeter.run(clip));
  }
  *character = std::move(left);
  return out;
}

}  // namespace sinew
