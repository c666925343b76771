// SPDX-License-Identifier: MIT
// Edits in the order of the command line; a skeleton from a file or a template, fitted.
#include "rig_skeleton.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>

#include "sinew_character/predict/skeleton_template.hpp"
#include "sinew_formats/file_kinds.hpp"
#include "support.hpp"

namespace sinew::cli {
EditOptions::EditOptions(CLI::App* sub) : sub_(sub) {
  const auto add = [&](EditKind kind, const char* name, const char* form, const char* about) {
    auto texts = std::make_shared<std::vector<std::string>>();
    CLI::Option* option = sub->add_option(name, *texts, about)->type_name(form)->allow_extra_args(false);
    options_.push_back({kind, option, std::move(texts)});
  };
  add(EditKind::kMove, "--move", "JOINT=X,Y,Z", "Put a joint there, its mirror image likewise");
  add(EditKind::kAt, "--at", "JOINT=X,Y,Z",
      "A joint is there, as LeftHand; it is added where it was not found, with what is between it and the body");
  add(EditKind::kAdd, "--add", "NAME=PARENT:X,Y,Z", "A new joint; NAME_end is a bone end");
  add(EditKind::kRemove, "--remove", "JOINT", "Take a joint out; its children go to its parent");
  add(EditKind::kParent, "--parent", "JOINT=OTHER", "Hang a joint on another");
  add(EditKind::kRename, "--rename", "JOINT=NAME", "Give a joint another name");
}

std::vector<SkeletonEdit> EditOptions::in_order() const {
  std::vector<SkeletonEdit> edits;
  std::map<const CLI::Option*, size_t> taken;
  for (const CLI::Option* option : sub_->parse_order()) {
    const auto found =
        std::find_if(options_.begin(), options_.end(), [&](const One& one) { return one.option == option; });
    if (found == options_.end()) continue;
    const size_t i = taken[option]++;
    if (i >= found->texts->size()) continue;
    try {
      edits.push_back(parse_edit(found->kind, (*found->texts)[i]));
    } catch (const Error& error) {
      throw UsageError(error.what());
    }
  }
  return edits;
}

void check_skeleton_source(const std::string& source) {
  if (has_extension(source, ".obj"))
    throw UsageError("--skeleton " + source + ": an OBJ holds no skeleton; expected " +
                     extensions_text(kReadsSkeleton) + " or template:NAME");
  if (!is_template(source)) return;
  try {
    (void)read_own_skeleton(source);
  } catch (const Error& error) {
    throw UsageError(error.what());
  }
}

}  // namespace sinew::cli
