// SPDX-License-Identifier: MIT
// Skeletons with the names and hierarchy of well-known conventions, at plausible positions, for fit_skeleton().
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

// Returns a template: parents first, y up, facing +z, left at +x, 1.8 high or a typical height; the sides are
// mirrored. Throws Error that lists the names.
std::vector<Joint> skeleton_template(const std::string& name);

// The files of templates/, embedded at build time.
struct TemplateText {
  const char *name, *text;
};
const TemplateText* template_texts();  // by name; terminated by a null name

}  // namespace sinew
#endif
