// SPDX-License-Identifier: MIT
// Pictures of maps and motions.
#ifndef SINEW_CLI_PICTURES_HPP
#define SINEW_CLI_PICTURES_HPP

#include "sinew_character/draw/image.hpp"
#include "sinew_character/motion/map_skeleton.hpp"
#include "sinew_character/picture/picture_file.hpp"
#include "sinew_character/pose/deform.hpp"
#include "sinew_formats/base/box.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew::cli {

// Both skeletons side by side, what represents each other in one color. The target on the left. Joints without a counterpart are gray.
Image draw_map(const MapRig& target, MaybeAxis target_up, const MapRig& source, MaybeAxis source_up,
               const MappedSkeleton& map);

// The character in frames at equal distances, seen from its front at one scale a clip, in which no pose leaves the
// picture; it may walk, the picture goes with it. A ground beside the character is not framed. Without a deformer it
// is skinned linearly.
//   picture  whose character it is, drawn from the front in its colors; null: by weights
Image motion_sheet(const Character& character, const Motion& motion, Axis up, CharacterDeformer* deformer,
                   const PictureFile* picture = nullptr);

}  // namespace sinew::cli
#endif
