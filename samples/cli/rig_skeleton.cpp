// SPDX-License-Identifier: MIT
// Edits in the order of the command line; a skeleton from a file or a template, fitted.
#include "rig_skeleton.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>

#include "options.hpp"
#include "sinew_character/joint_mirror.hpp"
#include "sinew_character/skeleton_template.hpp"
#include "sinew_formats/file_names.hpp"
#include "sinew_formats/io.hpp"
#include "support.hpp"

namespace sinew::cli {
namespace {

constexpr const char* kTemplate = "template:";

bool is_template(const std::string& source) { return source.rfind(kTemplate, 0) == 0; }

}  // namespace

EditOptions::EditOptions(CLI::App* sub) : sub_(sub) {
  const auto add = [&](EditKind kind, const char* name, const char* form, const char* about) {
    auto texts = std::make_shared<std::vector<std::string>>();
    CLI::Option* option = sub->add_option(name, *texts, about)->type_name(form)->allow_extra_args(false);
    options_.push_back({kind, option, std::move(texts)});
  };
  add(EditKind::kMove, "--move", "JOINT=X,Y,Z", "Put a joint there, its mirror image likewise");
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
    throw UsageError("--skeleton " + source + ": an OBJ holds no skeleton; expected " + skeleton_files() +
                     " or template:NAME");
  if (!is_template(source)) return;
  try {
    (void)skeleton_template(source.substr(std::string(kTemplate).size()));
  } catch (const Error& error) {
    throw UsageError(error.what());
  }
}

FittedSkeleton fit_into_mesh(const std::vector<Joint>& joints, const LabelledSkeleton& found, FitOptions options,
                             const Character& mesh) {
  float floor = component(mesh.vertices.at(0), options.up_axis);
  for (const Vec3& v : mesh.vertices) floor = std::min(floor, component(v, options.up_axis));
  options.floor = floor;
  return fit_skeleton(label_skeleton(joints), found, options);
}

FittedSkeleton fit_own_skeleton(const std::string& source, const LabelledSkeleton& found, FitOptions options,
                                const Character& mesh, PredictedSkeleton* skeleton) {
  Character own;
  if (is_template(source))
    own.joints = skeleton_template(source.substr(std::string(kTemplate).size()));
  else
    read_skeleton(source, false, &own);
  FittedSkeleton fitted;
  try {
    fitted = fit_into_mesh(own.joints, found, options, mesh);
  } catch (const Error& error) {
    throw Error("--skeleton " + source + ": " + error.what());
  }
  PredictedSkeleton result = skeleton_from_joints(fitted.joints);
  std::map<std::string, std::optional<bool>> deforms;
  for (const Joint& joint : own.joints) deforms.emplace(joint.name, joint.deforms);
  for (Joint& joint : result.joints) joint.deforms = deforms.at(joint.name);
  if (fitted.symmetric && !result.mirrored) {  // but for details that are on one side alone
    JointMirror mirror = find_joint_mirror(result.joints);
    result.mirrored = mirror.axis != 1;
    if (result.mirrored) result.partners = std::move(mirror.partners);
  }
  result.spread = skeleton->spread;
  result.seconds = skeleton->seconds;
  result.workspace_bytes = skeleton->workspace_bytes;
  *skeleton = std::move(result);
  return fitted;
}

CharacterBind bind_to_own(BindOptions options, const Character& character) {
  CharacterBindOptions bind;
  bind.bind = std::move(options);
  bind.bind_props = true;
  return bind_character(character, choose_joints(character, JointsFrom::kNames), bind);
}

CharacterBind bind_to_prediction(const PredictedSkeleton& skeleton, const BindOptions& options, Character* character) {
  character->joints = skeleton.joints;
  character->influences.clear();
  std::vector<uint8_t> said;
  for (const uint8_t end : skeleton.ends) said.push_back(end != 0 ? SINEW_JOINT_NEVER : SINEW_JOINT_DEFORMS);
  CharacterBindOptions bind;
  bind.bind = options;
  bind.keep_tips = true;
  bind.bind_props = true;
  return bind_character(*character, choose_joints(*character, JointsFrom::kAll, said), bind);
}

}  // namespace sinew::cli
