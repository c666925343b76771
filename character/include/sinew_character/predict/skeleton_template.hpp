// SPDX-License-Identifier: MIT
// Skeletons with the names and the hierarchy of well-known conventions, at plausible positions: for fit_skeleton().
#ifndef SINEW_CHARACTER_SKELETON_TEMPLATE_HPP
#define SINEW_CHARACTER_SKELETON_TEMPLATE_HPP

#include <string>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

struct TemplateInfo {
  std::string name;   // "mixamo"
  std::string about;  // one line
};
std::vector<TemplateInfo> skeleton_templates();

// Parents first, y up, facing +z, left at +x, 1.8 high or as the kind is; both sides are mirror images of each other. Throws
// Error with the names there are.
std::vector<Joint> skeleton_template(const std::string& name);

// The files of templates/ as they were when the library was built.
struct TemplateText {
  const char *name, *text;
};
const TemplateText* template_texts();  // by name; a null name ends them

}  // namespace sinew
#endif
