// SPDX-License-Identifier: MIT
// Which options go with which method; edits in the order of the command line; a skeleton from a file or a template.
#include "rig_options.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>
#include <string>

#include "option_groups.hpp"
#include "options.hpp"
#include "sinew_character/predict/skeleton_template.hpp"
#include "sinew_formats/file_kinds.hpp"
#include "support.hpp"

namespace sinew::cli {

void add_method_options(CLI::App* sub, MethodOptions* options) {
  shared_word_option(sub, "--method", options->method, kCharacterRigMethod,
                     "votes: surface points vote for bones; shape: joints along the medial axis of the mesh, without a "
                     "model; auto: votes, or for a flat mesh its outline, or for a mesh of solid parts its parts. For "
                     "comparison, as published: slots (joints in fixed slots and a matrix of connections) and regions "
                     "(boxes around surface patches, whose contacts are collapsed to a tree)");
  word_option(sub, "--class", options->category, kCategory, kClassMeaning)->type_name("KIND");
}

void check_method(const CLI::App& sub, const MethodOptions& options) {
  const auto given = [&](const char* option) { return sub.get_option(option)->count() > 0; };
  if (options.extracts() && given("--class"))
    throw UsageError("--class steers the model: leave --method " +
                     kCharacterRigMethod[static_cast<size_t>(options.method)] + " out");
  if (given("--class") && given("--prediction"))
    throw UsageError("--class steers a prediction: leave out --prediction, whose names determine the anatomy");
  if (!options.slots()) return;
  for (const char* option : {"--mirror", "--spine", "--prediction"})
    if (given(option)) throw UsageError(std::string(option) + " needs another method than --method slots");
}

EditOptions::EditOptions(CLI::App* sub) : sub_(sub) {
  const auto add = [&](EditKind kind, const char* name, const char* form, const char* about) {
    auto texts = std::make_shared<std::vector<std::string>>();
    CLI::Option* option = sub->add_option(name, *texts, about)->type_name(form)->allow_extra_args(false);
    options_.push_back({kind, option, std::move(texts)});
  };
  add(EditKind::kMove, "--move", "JOINT=X,Y,Z", "Move a joint there, and its mirror twin likewise");
  add(EditKind::kAt, "--at", "JOINT=X,Y,Z",
      "Give the position of a joint, such as LeftHand. If it was not found, it is added with the joints between it and "
      "the body");
  add(EditKind::kAdd, "--add", "NAME=PARENT:X,Y,Z", "Add a joint; NAME_end is a bone end");
  add(EditKind::kRemove, "--remove", "JOINT", "Remove a joint; its children move to its parent");
  add(EditKind::kParent, "--parent", "JOINT=OTHER", "Change the parent of a joint");
  add(EditKind::kRename, "--rename", "JOINT=NAME", "Rename a joint");
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
