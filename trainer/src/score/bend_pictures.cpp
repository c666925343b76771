// SPDX-License-Identifier: MIT
// One joint turned, seen from the side on which it bends, by linear skinning and by the engine's deformer.
#include "sinew_trainer/bend_pictures.hpp"

#include "bends.hpp"
#include "sinew/deform.h"
#include "sinew_character/draw/image.hpp"
#include "sinew_character/pose/deform.hpp"
#include "sinew_character/pose/pose.hpp"
#include "sinew_character/predict/fit_skeleton.hpp"

namespace sinew {

ReportPicture bend_pictures(const Character& character, Axis up, int side) {
  constexpr float kRadius = 0.16f;  // of the longest side: what a picture shows
  ReportPicture picture;
  picture.heading = "bends";
  picture.character = character.name;
  picture.note = "left linear skinning, right with the volume kept (sinew pose --deform volume)";
  const LabelledSkeleton labels = label_skeleton(character.joints);
  CharacterDeformer deformer(character, SINEW_INIT(sinew_deform_options));
  const std::vector<std::array<uint8_t, 3>> grey(character.vertices.size(), {200, 190, 180});
  for (const Bend& bend : report_bends()) {
    const size_t joint = bent_joint(character, labels, bend);
    if (joint == SIZE_MAX) continue;
    const auto [palette, view] = bent_view(character, joint, bend, bend.degrees, up, kRadius, side);
    const Character linear = apply_pose(character, palette), kept = deformer.pose_character(character, palette);
    picture.panels.push_back(
        {bend_text(bend, bend.degrees), encode_png(beside({render(linear, grey, view), render(kept, grey, view)}))});
  }
  return picture;
}

}  // namespace sinew
