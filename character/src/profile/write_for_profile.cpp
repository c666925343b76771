// SPDX-License-Identifier: MIT
// A character written in a profile's form.
#include <algorithm>

#include "predict/turn.hpp"
#include "sinew_character/jobs/character_file.hpp"
#include "sinew_character/profile/controls.hpp"
#include "sinew_character/profile/profile.hpp"
#include "sinew_character/rig/joint_verdicts.hpp"
#include "sinew_formats/base/point.hpp"
#include "sinew_formats/document_form.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/file_kinds.hpp"

namespace sinew {
namespace {

Rotation transposed(const Rotation& r) { return {r[0], r[3], r[6], r[1], r[4], r[7], r[2], r[5], r[8]}; }

// Brings the body upright and to the front that the profile wants.
Rotation turn_of(const Profile& profile, const Rotation& body) {
  const Rotation wanted = profile.faces_back ? Rotation{-1, 0, 0, 0, 1, 0, 0, 0, -1} : kNoRotation;
  return multiply(wanted, transposed(body));
}

// Rows with at most `most` influences. Returns how many were longer.
size_t keep_strongest(uint32_t most, std::vector<std::vector<Influence>>* rows) {
  size_t longer = 0;
  for (std::vector<Influence>& row : *rows) {
    if (row.size() <= most) continue;
    const auto stronger = [](const Influence& a, const Influence& b) { return a.weight > b.weight; };
    std::stable_sort(row.begin(), row.end(), stronger);
    double sum = 0, left = 0;
    for (size_t k = 0; k < row.size(); ++k) {
      sum += static_cast<double>(row[k].weight);
      if (k < most) left += static_cast<double>(row[k].weight);
    }
    const bool counts = row[most].weight > 0;
    row.resize(most);
    if (!counts || !(left > 0)) continue;
    ++longer;
    for (Influence& one : row) one.weight = static_cast<float>(static_cast<double>(one.weight) * sum / left);
  }
  return longer;
}

// The joint that carries all others already, or -1.
int root_of(const std::vector<Joint>& joints) {
  int root = -1;
  for (size_t j = 0; j < joints.size(); ++j) {
    if (joints[j].parent >= 0) continue;
    if (root >= 0) return -1;
    root = static_cast<int>(j);
  }
  if (root < 0) return -1;
  const JointVerdicts verdicts = joint_verdicts(joints);
  const size_t j = static_cast<size_t>(root);
  if (verdicts.roles[j] != SINEW_ROLE_ROOT) return -1;
  for (size_t other = 0; other < joints.size(); ++other)  // a pelvis that is called root
    if (other != j && verdicts.classes[other] == SINEW_CLASS_PELVIS) return root;
  return verdicts.classes[j] == SINEW_CLASS_PELVIS ? -1 : root;
}

DocumentForm form_of(const Profile& profile, const ProfileOptions& options, const std::vector<Joint>& joints,
                     std::vector<std::string>* notes) {
  DocumentForm form;
  if (joints.empty()) return form;
  form.turn = turn_of(profile, body_axes(joints));
  const Rotation usual = profile.faces_back ? Rotation{-1, 0, 0, 0, 1, 0, 0, 0, -1} : kNoRotation;
  if (form.turn != usual)
    notes->push_back(std::string("rotated to have y up and face ") + (profile.faces_back ? "-z" : "+z"));
  if (options.keep_axes) return form;
  form.names = profile_names(joints, profile.names);
  const int root = *profile.root == 0 ? -1 : root_of(joints);
  if (root >= 0)
    form.names[static_cast<size_t>(root)] = profile.root;
  else
    form.root = profile.root;
  if (profile.axes == nullptr) {
    form.axes.assign(joints.size(), kNoRotation);
    return form;
  }
  std::vector<Joint> turned_joints = joints;
  for (Joint& joint : turned_joints) {
    joint.position = to_vec3(turned(form.turn, point(joint.position)));
  }
  form.axes = joint_axes(turned_joints, *profile.axes);
  if (root >= 0) form.axes[static_cast<size_t>(root)] = kNoRotation;
  return form;
}

void tell_names(const Profile& profile, const std::vector<Joint>& joints, const DocumentForm& form,
                std::vector<std::string>* notes) {
  if (profile.names.naming < 0 || form.names.empty()) return;
  size_t own = 0;
  for (size_t j = 0; j < joints.size(); ++j) own += joints[j].name == form.names[j] ? 1 : 0;
  if (2 * own > joints.size() && own < joints.size())
    notes->push_back(std::to_string(own) + " of " + std::to_string(joints.size()) + " joints keep their names: " +
                     profile.name + " has no names for them, or has two joints with one");
}

std::string formed_controls(const Character& character, const DocumentForm& form) {
  std::vector<Joint> joints = character.joints;
  for (size_t j = 0; j < joints.size(); ++j) {
    joints[j].position = to_vec3(turned(form.turn, point(joints[j].position)));
    if (!form.names.empty()) joints[j].name = form.names[j];
  }
  return controls_text(find_controls(character), character.name, joints, form.turn);
}

}  // namespace

std::string controls_for_profile(const Profile& profile, const ProfileOptions& options, const Character& character) {
  std::vector<std::string> said;
  return formed_controls(character, form_of(profile, options, character.joints, &said));
}

void check_profile(const Profile& profile, const ProfileOptions& options) {
  const std::map<std::string, std::string> license = parse_vrm_license(options.license);
  if (profile.vrm == 0) {
    if (!options.authors.empty() || !options.license.empty() || !options.title.empty())
      throw Error("--author, --license and --title need --for vrm or vrm0");
    return;
  }
  if (profile.vrm != 1 && license.count("licenseName") != 0)
    throw Error("license licenseName: a term of VRM 0.x; VRM 1.0 has no license names, give permissions");
}

std::vector<std::string> write_for_profile(const Profile& profile, const ProfileOptions& options,
                                           const std::string& path, const Character& character, const GlbOptions& glb,
                                           const Morphs& morphs) {
  std::vector<std::string> notes;
  Character written = character;
  GlbOptions how = glb;
  if (profile.influences > 0) {
    const size_t longer = keep_strongest(profile.influences, &written.influences);
    if (longer > 0) {
      notes.push_back(std::to_string(longer) + " vertices had more than " + std::to_string(profile.influences) +
                      " influences, the maximum of " + profile.name + "; the weakest were dropped");
      how.keep_skin = false;
    }
  }
  DocumentForm form = form_of(profile, options, written.joints, &notes);
  tell_names(profile, written.joints, form, &notes);
  if (options.controls) how.extras = controls_extras(formed_controls(written, form));
  const FileKind* kind = path == "-" ? nullptr : file_kind(path);
  if (kind == nullptr || kind->reader == FileReader::kRig || kind->reader == FileReader::kObj) {
    if (profile.vrm != 0) throw Error(path + ": a VRM is one file; write a .vrm or a .glb");
    for (size_t j = 0; j < form.names.size(); ++j) written.joints[j].name = form.names[j];
    write_character(path, written, how, morphs);  // has no axes
    return notes;
  }
  VrmData vrm;
  if (profile.vrm != 0) {
    if (!has_extension(path, ".vrm") && !has_extension(path, ".glb"))
      throw Error(path + ": a VRM is one file; write a .vrm or a .glb");
    vrm.file_name = character.name;
    vrm.title = options.title;
    vrm.authors = options.authors;
    vrm.license = parse_vrm_license(options.license);
    vrm.zero = profile.vrm == 1;
    vrm.bones = vrm_bones(character.joints, path, vrm.zero);
    form.vrm = &vrm;
  }
  const std::vector<std::string> told = write_gltf_form(path, written, how, morphs, form);
  notes.insert(notes.end(), told.begin(), told.end());
  return notes;
}

}  // namespace sinew
