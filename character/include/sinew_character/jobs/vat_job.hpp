// SPDX-License-Identifier: MIT
// The job of `sinew animate --vat` for one animated character: clips as vertex animation textures, a mesh that reads
// them, and their layout.
#ifndef SINEW_CHARACTER_VAT_JOB_HPP
#define SINEW_CHARACTER_VAT_JOB_HPP

#include <optional>
#include <string>
#include <vector>

#include "sinew_character/crowd/vertex_textures.hpp"
#include "sinew_character/jobs/animate_job.hpp"
#include "sinew_formats/io.hpp"

namespace sinew {

// Distances between vertices as skinned and as a shader decodes them, meters.
struct VatDistance {
  double largest = 0, mean = 0;
};

struct VatClip {
  std::string name;
  size_t first_frame = 0, frames = 0;  // in the textures
  double frame_time = 0;               // seconds
  double gap = 0;      // largest distance between a vertex's positions in the first and last frames, meters
  bool loops = false;  // the gap is at most 1 % of the height
  size_t bytes = 0;    // on a GPU: three textures with 4 bytes per texel
  VatDistance at_frames, between_frames;  // at frames, and halfway between frames, where shaders interpolate positions
  double normal_angle = 0;                // largest between a normal and the decoded one at frames, degrees
};

struct VatResult {
  std::vector<NamedBytes> files;  // names without a folder; the last one is the layout, which lists the others
  TextureLayout layout;
  Box bounds;         // of all frames of all clips, meters, y up
  double height = 0;  // of the rest pose, meters
  std::vector<VatClip> clips;
};

// Writes all clips of `animated` into one set of textures, so that one material plays any of them. Errors are
// measured on the bytes of `files`.
//   name    of the files: NAME.vat.glb, NAME.vat.position_high.png, NAME.vat.position_low.png, NAME.vat.normal.png, NAME.vat.json
//           (formats/spec/vat.schema.json)
//   deform  corrections of positions, or none for linear skinning; normals are those of linear skinning
//   steps   gets the number of poses, and its function is called before each
// Throws Error for more frames than a texture holds, and if a step requests a stop.
VatResult vertex_animation(const std::string& name, const AnimatedCharacter& animated,
                           const std::optional<sinew_deform_options>& deform, const StepsOf& steps);

}  // namespace sinew
#endif
