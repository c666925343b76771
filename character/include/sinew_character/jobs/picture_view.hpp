// SPDX-License-Identifier: MIT
// Finds the view and body class of a picture's character, by the skeletons that are predicted for its inflated mesh.
#ifndef SINEW_CHARACTER_PICTURE_VIEW_HPP
#define SINEW_CHARACTER_PICTURE_VIEW_HPP

#include <cstddef>
#include <optional>
#include <vector>

#include "sinew_character/jobs/rig_job.hpp"
#include "sinew_character/picture/body_class.hpp"

namespace sinew {

enum class PictureView { kFront, kFacesRight, kFacesLeft };
const char* picture_view_text(PictureView view);

// Maps a mesh of the picture plane (xy, seen from +z) to the orientation of training bodies, facing +z with y up, and
// positions back.
Vec3 from_picture(PictureView view, const Vec3& position);
Vec3 to_picture(PictureView view, const Vec3& position);

struct SeenBody {
  PictureView view = PictureView::kFront;
  BodyClass body = BodyClass::kOther;
  float certainty = 1;         // 0..1, of view and body together
  PredictedSkeleton skeleton;  // in the picture plane, z = 0 except for near and far limbs, which are slightly off it
};

//   given  the user's class
//   guess  class of the outline; views that a class does not have are left out
//   job    uses method, mirror, spine_count, toes and ends
SeenBody see_body(const Character& mesh, const std::optional<BodyClass>& given, const BodyGuess& guess,
                  const RigJobOptions& job, const RigModels& models, std::vector<std::string>* notes);

// Returns the view whose votes agree most. Bipeds are usually drawn from the front, which is preferred if the votes
// differ little.
inline size_t choose_view(const std::vector<SeenBody>& seen) {
  constexpr float kHardly = 1.11f;  // times the least spread
  size_t best = 0;
  for (size_t s = 1; s < seen.size(); ++s)
    if (seen[s].skeleton.spread < seen[best].skeleton.spread) best = s;
  if (seen[best].body != BodyClass::kBiped) return best;
  for (size_t s = 0; s < seen.size(); ++s)
    if (seen[s].view == PictureView::kFront && seen[s].skeleton.spread < kHardly * seen[best].skeleton.spread) return s;
  return best;
}

}  // namespace sinew
#endif
