// SPDX-License-Identifier: MIT
// A document's own joints moved: their nodes, and the inverse bind matrices of its skins.
#ifndef SINEW_FORMATS_GLTF_MOVE_JOINTS_HPP
#define SINEW_FORMATS_GLTF_MOVE_JOINTS_HPP

#include <memory>
#include <string>
#include <vector>

#include "sinew_formats/affine.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

// A copy of a document whose joints stand elsewhere. What hangs on them goes with them, skins hold their meshes as before, animations
// go on from the same keys.
//   palette  [J] rest to posed, world space
//   joints   [J] the Character's, moved
// Throws Error for a document whose nodes or skins are broken.
std::shared_ptr<const GltfSource> moved_joints(const std::string& name, const GltfSource& source,
                                               const std::vector<Affine>& palette, const std::vector<Joint>& joints);

}  // namespace sinew
#endif
