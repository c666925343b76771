// SPDX-License-Identifier: MIT
// A document put into another form.
#ifndef SINEW_FORMATS_GLTF_DOCUMENT_FORM_HPP
#define SINEW_FORMATS_GLTF_DOCUMENT_FORM_HPP

#include <string>
#include <vector>

#include "sinew_formats/character.hpp"
#include "sinew_formats/document_form.hpp"

namespace sinew {

struct GltfJoints;

// Changes nodes, skins, animations and extras of the document; `joints` are its joints before, and are not changed. Returns remarks.
std::vector<std::string> put_into_form(const std::string& path, const DocumentForm& form, const GltfJoints& joints,
                                       GltfSource* source);

}  // namespace sinew
#endif
