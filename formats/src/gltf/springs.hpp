// SPDX-License-Identifier: MIT
// VRMC_springBone put into a document.
#ifndef SINEW_FORMATS_GLTF_SPRINGS_HPP
#define SINEW_FORMATS_GLTF_SPRINGS_HPP

#include "gltf/gltf_source.hpp"
#include "sinew_formats/base/affine.hpp"
#include "sinew_formats/springs.hpp"

namespace sinew {

// Replaces what the document has of VRMC_springBone, but for what of it the springs know by number. A chain with an end gets a node there, unless its last joint has a child there that
// holds nothing.
//   joints  where the springs' joints are in the document
//   turn    from the springs' world to the document's, for directions of gravity
void write_springs(const Springs& springs, const GltfJoints& joints, const Rotation& turn, Json* document);

}  // namespace sinew
#endif
