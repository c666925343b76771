// SPDX-License-Identifier: MIT
// Skeletons from files and templates, fitted, and binds to them.
#include "sinew_character/predict/own_skeleton.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "predict/fit_details.hpp"
#include "sinew_character/predict/predict_details.hpp"
#include "sinew_character/predict/skeleton_template.hpp"
#include "sinew_character/rig/joint_mirror.hpp"
#include "sinew_character/rig/joint_verdicts.hpp"
#include "sinew_formats/base/box.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"

namespace sinew {
namespace {

constexpr const char* kTemplate = "template:";

// Eyes and jaws of a template take no weight where the mesh shows none: its head would follow them.
void rest_faces(const LabeledSkeleton& found, FittedSkeleton* fitted) {
  const std::vector<uint8_t> shown = joint_verdicts(found.joints).classes;
  const std::vector<uint8_t> classes = joint_verdicts(fitted->joints).classes;
  for (size_t j = 0; j < classes.size(); ++j) {
    if (is_face_class(classes[j]) && std::find(shown.begin(), shown.end(), classes[j]) == shown.end())
      fitted->joints[j].deforms = false;
  }
}

}  // namespace

bool is_template(const std::string& source) { return source.rfind(kTemplate, 0) == 0; }

std::vector<Joint> read_own_skeleton(const std::string& source) {
  if (is_template(source)) return skeleton_template(source.substr(std::string(kTemplate).size()));
  Character own;
  read_skeleton(source, false, &own);
  return own.joints;
}

FittedSkeleton fit_into_mesh(const std::vector<Joint>& joints, const LabeledSkeleton& found, FitOptions options,
                             const Character& mesh) {
  const uint32_t up = axis_index(options.up_axis);
  float floor = component(mesh.vertices.at(0), up);
  for (const Vec3& v : mesh.vertices) floor = std::min(floor, component(v, up));
  options.floor = floor;
  return fit_skeleton(label_skeleton(joints), found, options);
}

FittedSkeleton fit_own_skeleton(const std::vector<Joint>& own, const std::string& source, const LabeledSkeleton& found,
                                FitOptions options, const Character& mesh, PredictedSkeleton* skeleton) {
  FittedSkeleton fitted;
  std::optional<FittedSkeleton> hand;
  if (is_lone_hand(*skeleton)) hand = fit_lone_hand(own, *skeleton);
  try {
    fitted = hand ? std::move(*hand) : fit_into_mesh(own, found, options, mesh);
  } catch (const Error& error) {
    throw Error(source + ": " + error.what());
  }
  if (!hand && !options.keep_lengths) (void)fit_fingers(*skeleton, &fitted);
  if (is_template(source)) {
    rest_faces(found, &fitted);
    if (!options.keep_lengths) keep_inside(mesh, &fitted);
  }
  PredictedSkeleton result = skeleton_from_joints(fitted.joints);
  std::map<std::string, std::optional<bool>> deforms;
  for (const Joint& joint : fitted.joints) deforms.emplace(joint.name, joint.deforms);
  for (Joint& joint : result.joints) joint.deforms = deforms.at(joint.name);
  if (fitted.symmetric && !result.mirrored) {  // but for details that are on one side alone
    JointMirror mirror = find_joint_mirror(result.joints);
    result.mirrored = mirror.axis != 1;
    if (result.mirrored) result.partners = std::move(mirror.partners);
  }
  result.spread = skeleton->spread;
  result.usable = skeleton->usable;
  result.seconds = skeleton->seconds;
  result.workspace_bytes = skeleton->workspace_bytes;
  *skeleton = std::move(result);
  return fitted;
}

CharacterBind bind_to_own(BindOptions options, const Character& character, const std::vector<uint8_t>& scenery) {
  CharacterBindOptions bind;
  bind.scenery = scenery;
  bind.bind = std::move(options);
  bind.bind_props = true;
  return bind_character(character, choose_joints(character, JointsFrom::kNames), bind);
}

CharacterBind bind_to_prediction(const PredictedSkeleton& skeleton, const BindOptions& options, Character* character) {
  character->joints = skeleton.joints;
  character->influences.clear();
  CharacterBindOptions bind;
  bind.bind = options;
  bind.keep_tips = true;
  bind.bind_props = true;
  bind.scenery = skeleton.scenery;
  return bind_character(*character, choose_predicted(skeleton, *character), bind);
}

JointChoice choose_predicted(const PredictedSkeleton& skeleton, const Character& mesh) {
  Character joints;  // vertices do not matter
  joints.joints = skeleton.joints;
  joints.meshes = mesh.meshes;
  std::vector<uint8_t> said;
  for (const uint8_t end : skeleton.ends) said.push_back(end != 0 ? SINEW_JOINT_NEVER : SINEW_JOINT_DEFORMS);
  return choose_joints(joints, JointsFrom::kAll, said);
}

}  // namespace sinew
