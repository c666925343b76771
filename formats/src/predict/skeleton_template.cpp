// SPDX-License-Identifier: MIT
#include "sinew_formats/skeleton_template.hpp"

#include "sinew_formats/error.hpp"
namespace sinew {
std::vector<TemplateInfo> skeleton_templates() { return {}; }
std::vector<Joint> skeleton_template(const std::string& name) { throw Error(name); }
}  // namespace sinew
