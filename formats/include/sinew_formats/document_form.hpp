// SPDX-License-Identifier: MIT
// The same character in another program's form: joints with other axes and names, a root above them, the whole turned. What is shown stays
// but for the turn.
#ifndef SINEW_FORMATS_DOCUMENT_FORM_HPP
#define SINEW_FORMATS_DOCUMENT_FORM_HPP

#include <string>
#include <vector>

#include "sinew_formats/base/affine.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/morphs.hpp"
#include "sinew_formats/vrm.hpp"

namespace sinew {

struct DocumentForm {
  Rotation turn = kNoRotation;  // of the whole character, world space
  std::vector<Rotation>
      axes;  // [J] the joints' axes in the rest pose, as columns, in the turned world; empty: they stay
  std::vector<std::string> names;  // [J] new names; empty: they stay
  std::string root;                // name of a joint at the origin that carries all others; empty: none is added
  const VrmData* vrm = nullptr;    // what a VRM says; null: nothing
};

// As write_gltf_morphs(). Inverse bind matrices, animations, drivers of corrections and what hangs on joints follow: each joint's world
// transform W becomes turn * W * C with a rotation C of its own that is the same at all times. A joint that is scaled unevenly, and every joint of
// a document whose constraints are bound to axes, keeps its axes. Returns such remarks for the user, a line each. Throws Error.
std::vector<std::string> write_gltf_form(const std::string& path, const Character& character, const GlbOptions& options,
                                         const Morphs& morphs, const DocumentForm& form);

}  // namespace sinew
#endif
