// SPDX-License-Identifier: MIT
// Rigs of files, predicted ones and their edits.
#include "rigs.hpp"

#include <map>
#include <string>
#include <utility>

#include "sinew_character/predict/fit_skeleton.hpp"
#include "sinew_character/predict/own_skeleton.hpp"
#include "sinew_formats/error.hpp"

namespace sinew::web {
namespace {

// Of a file's joints that were edited: the weights of now are not the file's.
JointChoice choose_by_names(const Character& character, const std::vector<Joint>& joints) {
  Character with;
  with.name = character.name;
  with.vertices = character.vertices;  // joints beside the mesh get none
  with.meshes = character.meshes;
  with.vertex_meshes = character.vertex_meshes;
  with.joints = joints;
  return choose_joints(with, JointsFrom::kNames);
}

}  // namespace

Rig rig_of_file(const Character& character, JointChoice choice) {
  Rig rig;
  rig.joints = character.joints;
  rig.choice = std::move(choice);
  if (character.joints.empty() || character.gltf) return rig;
  rig.skeleton = skeleton_from_joints(character.joints);
  // What its joints deform stays as the file says.
  std::map<std::string, std::optional<bool>> deforms;
  for (const Joint& joint : character.joints) deforms.emplace(joint.name, joint.deforms);
  for (Joint& joint : rig.skeleton->joints) joint.deforms = deforms.at(joint.name);
  return rig;
}

Rig predicted_rig(const Character& character, PredictedSkeleton skeleton) {
  Rig rig;
  rig.predicted = true;
  rig.joints = skeleton.joints;
  rig.choice = choose_predicted(skeleton, character);
  rig.skeleton = std::move(skeleton);
  return rig;
}

void Rigs::start(Rig rig) {
  now_ = std::move(rig);
  before_.reset();
}

void Rigs::put(Rig rig, bool continues) {
  if (!continues || !before_) before_ = std::move(now_);
  now_ = std::move(rig);
}

void Rigs::edit(const Character& character, const std::vector<SkeletonEdit>& edits, bool mirror, bool continues) {
  const Rig& base = continues && before_ ? *before_ : now_;
  if (!base.skeleton)
    throw Error(character.name + ": this skeleton belongs to the file's own nodes; make a new one to edit it");
  PredictedSkeleton skeleton = *base.skeleton;
  edit_skeleton(edits, mirror, &skeleton);
  Rig rig;
  if (base.predicted) {
    rig = predicted_rig(character, std::move(skeleton));
  } else {
    rig.joints = skeleton.joints;
    rig.choice = choose_by_names(character, rig.joints);
    rig.skeleton = std::move(skeleton);
  }
  put(std::move(rig), continues);
}

}  // namespace sinew::web
