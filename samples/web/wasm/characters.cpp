// SPDX-License-Identifier: MIT
// Files to characters, rigs to the session's joints.
#include "characters.hpp"

#include <algorithm>
#include <utility>

#include "rig_json.hpp"
#include "sinew_character/bind_job.hpp"
#include "sinew_character/rig_job.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"

namespace sinew::web {
namespace {

// The weights of a rig.txt, or none where its skin lines are not of this mesh.
std::vector<std::vector<Influence>> weights_of_file(const std::string& skeleton, Character character) {
  try {
    read_skeleton(skeleton, true, &character);
    return std::move(character.influences);
  } catch (const Error&) {
    return {};
  }
}

}  // namespace

std::string without_option(std::string line) {
  for (const char* option : {" (--no-mirror)", "; --fit mends that", ", --cut opens it"})
    if (const size_t at = line.find(option); at != std::string::npos) line.erase(at, std::string(option).size());
  return line;
}

// The character has the present rig. Weights stay where joints were moved or renamed, until the next bind.
Json show_rig(Session& s) {
  const std::vector<Joint>&before = s.character.joints, &now = s.rigs().now().joints;
  const bool alike = std::equal(before.begin(), before.end(), now.begin(), now.end(),
                                [](const Joint& a, const Joint& b) { return a.parent == b.parent; });
  s.character.joints = now;
  s.taken = {};
  if (!alike) s.player.close();  // it is of the joints before
  if (!alike) {
    s.character.influences.clear();
    s.locked.clear();
    s.hints.clear();
    s.began.clear();
    s.reference.clear();
    s.joints.clear();
    s.weights.clear();
    s.skinning.forget();
    s.posed = s.rest;
    show(s);
  }
  return rig_json(s.rigs());
}

Json predict(Session& s, const Json& wishes) {
  if (s.rig_model.bytes.empty()) throw Error("no model of skeletons is loaded");
  RigJobOptions job;
  job.bind = false;  // the page shows the skeleton first
  job.detail = static_cast<SkeletonDetail>(wishes.at("detail").get<uint8_t>());
  const uint32_t up = wishes.at("up").get<uint32_t>();
  job.up = up == 0 ? UpChoice::kY : up == 1 ? UpChoice::kZ : UpChoice::kFound;
  job.category = wishes.at("category").get<uint32_t>();
  job.front = wishes.at("front").get<uint32_t>();
  job.mirror = wishes.at("mirror").get<uint32_t>();
  job.spine_count = wishes.at("spine").get<uint32_t>();
  job.toes = wishes.at("toes").get<bool>();
  job.ends = wishes.at("ends").get<bool>();
  if (job.detail != SkeletonDetail::kBody && s.hands_model.bytes.empty()) throw Error("no model of hands is loaded");
  const RigModels models = {&s.rig_model.model, nullptr, &s.hands_model.model,
                            s.front_model.bytes.empty() ? nullptr : &s.front_model.model};
  Character mesh = s.character;
  mesh.joints.clear();
  mesh.influences.clear();
  mesh.notes.clear();
  RiggedCharacter rigged = rig_character(std::move(mesh), job, models);
  const std::vector<std::string> notes = std::move(rigged.character.notes);
  Rig rig = predicted_rig(s.character, std::move(rigged.skeleton));
  if (s.character.joints.empty())
    s.rigs().start(std::move(rig));  // a mesh without skeleton is no step to go back to
  else
    s.rigs().put(std::move(rig), false);
  Json reply = show_rig(s);
  reply["notes"] = notes;
  return reply;
}

Json edit(Session& s, const Json& edits, bool mirror, bool continues) {
  try {
    s.rigs().edit(s.character, read_edits(edits), mirror, continues);
  } catch (const Error& error) {
    throw Error(without_option(error.what()));
  }
  return show_rig(s);
}

Json load(Session& s, const std::string& mesh, const std::string& skeleton, uint32_t number) {
  Character character = read_mesh(mesh);
  if (!skeleton.empty()) read_skeleton(skeleton, false, &character);
  if (character.vertices.empty()) throw Error(mesh + ": has no vertices to bind");
  if (character.face_count() == 0) throw Error(mesh + ": has no faces to show; drop a mesh with polygons");
  JointChoice choice;
  if (!character.joints.empty()) {
    choice = prepare_joints(skeleton.empty() ? JointsFrom::kAuto : JointsFrom::kNames, false, &character);
    for (std::string& note : character.notes) note = without_option(std::move(note));
  }
  std::vector<std::vector<Influence>> reference =
      skeleton.empty() ? std::move(character.influences) : weights_of_file(skeleton, read_mesh(mesh));
  character.influences.clear();
  if (s.rigs_of.find(number) == s.rigs_of.end()) {
    Rig rig = rig_of_file(character, std::move(choice));
    s.rigs_of[number].start(std::move(rig));
  }
  s.number = number;
  s.player.close();
  character.joints = s.rigs().now().joints;
  s.surface = make_surface(character);
  s.character = std::move(character);
  s.rest.clear();
  for (const Vec3& p : s.character.vertices) s.rest.insert(s.rest.end(), {p.x, p.y, p.z});
  s.posed = s.rest;
  s.joints.clear();
  s.weights.clear();
  s.locked.clear();
  s.hints.clear();
  s.began.clear();
  s.taken = {};
  const bool is_files = !s.rigs().now().predicted && reference.size() == s.character.vertices.size();
  const bool some = std::any_of(reference.begin(), reference.end(), [](const auto& row) { return !row.empty(); });
  s.reference = is_files && some ? std::move(reference) : std::vector<std::vector<Influence>>();
  show(s);
  Json reply = rig_json(s.rigs());
  reply["hasReference"] = !s.reference.empty();
  reply["name"] = s.character.name;
  reply["notes"] = s.character.notes;
  reply["vertices"] = s.character.vertices.size();
  reply["faces"] = s.character.face_count();
  return reply;
}

}  // namespace sinew::web
