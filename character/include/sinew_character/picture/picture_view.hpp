// SPDX-License-Identifier: MIT
// From where a picture shows its character, told by the skeletons that votes find in its inflated mesh, and what kind of body it is.
#ifndef SINEW_CHARACTER_PICTURE_VIEW_HPP
#define SINEW_CHARACTER_PICTURE_VIEW_HPP

#include <optional>
#include <vector>

#include "sinew_character/jobs/rig_job.hpp"
#include "sinew_character/picture/body_class.hpp"

namespace sinew {

enum class PictureView { kFront, kFacesRight, kFacesLeft };
const char* picture_view_text(PictureView view);

// A mesh of the picture plane (xy, seen from +z) as networks know bodies, facing +z with y up, and positions back.
Vec3 from_picture(PictureView view, const Vec3& position);
Vec3 to_picture(PictureView view, const Vec3& position);

struct SeenBody {
  PictureView view = PictureView::kFront;
  BodyClass body = BodyClass::kOther;
  float certainty = 1;         // 0..1, of view and body together
  PredictedSkeleton skeleton;  // in the picture plane, z 0 but for near and far limbs, which are a little off it
};

//   given  the user's class
//   guess  what its outline says; views that a class does not have are left out
//   job    method, mirror, spine_count, toes and ends are looked at
SeenBody see_body(const Character& mesh, const std::optional<BodyClass>& given, const BodyGuess& guess,
                  const RigJobOptions& job, const RigModels& models, std::vector<std::string>* notes);

}  // namespace sinew
#endif
