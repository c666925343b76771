// SPDX-License-Identifier: MIT
// Files to characters, rigs to the session's joints.
#include "characters.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "gltf/gltf_source.hpp"
#include "rig_json.hpp"
#include "sinew_character/jobs/bind_job.hpp"
#include "sinew_character/jobs/plane_motion.hpp"
#include "sinew_character/jobs/rig_job.hpp"
#include "sinew_character/pose/character_transform.hpp"
#include "sinew_formats/base/box.hpp"
#include "sinew_formats/base/segment.hpp"
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

// Where the picture lies in the mesh's plane, by the mesh's own texture: pixel (x, y) is at ((x - left) scale, (bottom - y) scale).
Json place_of(const PictureFile& picture, const Character& mesh) {
  struct Corner {
    double x, y, px, py;
  };
  std::vector<Corner> corners;
  for (size_t c = 0; c < mesh.face_vertices.size(); ++c) {
    const Vec3& p = mesh.vertices[mesh.face_vertices[c]];
    const PicturePoint seen = seen_point(picture, {mesh.corner_uvs[c][0], 1 - mesh.corner_uvs[c][1]});
    corners.push_back({p.x, p.y, double{seen.u} * picture.pixels.width, double{seen.v} * picture.pixels.height});
  }
  const auto less = [](const Corner& a, const Corner& b) { return a.x < b.x; };
  const auto [low, high] = std::minmax_element(corners.begin(), corners.end(), less);
  const double scale = (high->x - low->x) / (high->px - low->px);
  return {{"scale", scale}, {"left", low->px - low->x / scale}, {"bottom", low->py + low->y / scale}};
}

PictureJobOptions picture_options(const Json& wishes) {
  PictureJobOptions options;
  const std::string word = wishes.value("class", "");
  if (!word.empty()) options.body = body_class_of(word);
  if (!word.empty() && !options.body) throw Error("class: there is none that is called " + word);
  options.figure.number = wishes.value("figure", 0u);
  options.figure.cut = wishes.value("cut", false);
  options.mask = wishes.value("mask", "");
  options.mesh.flat = wishes.value("flat", false);
  for (const Json& line : wishes.value("outline", Json::array())) {
    options.outline.emplace_back();
    for (const Json& place : line)
      options.outline.back().push_back({place.at(0).get<float>(), place.at(1).get<float>()});
  }
  return options;
}

// From the lowest vertex to the highest, along y and along z.
std::array<float, 2> tall(const Character& character) {
  Vec3 low = character.vertices.front(), high = low;
  for (const Vec3& p : character.vertices) {
    low = {0, std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {0, std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  return {high.y - low.y, high.z - low.z};
}

constexpr double kFarFromItsBones =
    0.35;  // of the longest side: farther than props that hands hold, and hair that hangs down from heads

// Meshes of the file that lie, on average, far from the joints that its own weights give them to: the file's skin does not put them there.
Json misplaced_meshes(const Character& character, const std::vector<std::vector<Influence>>& reference) {
  std::vector<double> sums(std::max<size_t>(1, character.meshes.size())), counts(sums.size());
  for (size_t v = 0; v < reference.size(); ++v) {
    const Point3 at = point(character.vertices[v]);
    if (reference[v].empty()) continue;
    const auto strongest = std::max_element(reference[v].begin(), reference[v].end(),
                                            [](const auto& a, const auto& b) { return a.weight < b.weight; });
    const Joint& joint = character.joints[strongest->joint];
    const Point3 head = point(joint.position);
    double distance = joint.parent < 0 ? length(at - head)
                                       : segment_distance(at, head, point(character.joints[joint.parent].position));
    for (const Joint& child : character.joints)
      if (child.parent == static_cast<int>(strongest->joint))
        distance = std::min(distance, segment_distance(at, head, point(child.position)));
    const size_t mesh = v < character.vertex_meshes.size() ? character.vertex_meshes[v] : 0;
    sums[mesh] += distance;
    ++counts[mesh];
  }
  const double far = kFarFromItsBones * double{box_of(character.vertices).longest_side()};
  Json list = Json::array();
  for (size_t m = 0; m < sums.size(); ++m)
    if (counts[m] > 0 && sums[m] > far * counts[m])
      list.push_back(m < character.meshes.size() ? character.meshes[m].name : character.name);
  return list;
}

// What a VRM says of who made it and what its license forbids; null for other files.
Json license_json(const Character& character) {
  if (character.gltf == nullptr) return nullptr;
  const Json& document = character.gltf->document;
  const Json::json_pointer one("/extensions/VRMC_vrm/meta"), zero("/extensions/VRM/meta");
  if (document.contains(one)) {
    const Json& meta = document[one];
    return {{"authors", meta.value("authors", Json::array())},
            {"forbidsChanges", meta.value("modification", "") == "prohibited"}};
  }
  if (!document.contains(zero)) return nullptr;
  const Json& meta = document[zero];
  const std::string author = meta.value("author", ""), name = meta.value("licenseName", "");
  return {{"authors", author.empty() ? Json::array() : Json::array({author})},
          {"forbidsChanges", name.find("_ND") != std::string::npos}};
}

Json start(Session& s, Character character, JointChoice choice, std::vector<std::vector<Influence>> reference,
           uint32_t number, const std::string& placement = {}) {
  if (s.rigs_of.find(number) == s.rigs_of.end() || s.placement_of[number] != placement) {
    Rig rig = rig_of_file(character, std::move(choice));
    s.rigs_of[number].start(std::move(rig));
  }
  s.placement_of[number] = placement;
  s.standing.reset();
  s.to_pose.clear();
  s.seams = {};
  s.number = number;
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
  reply["misplaced"] = misplaced_meshes(s.character, s.reference);
  reply["license"] = license_json(s.character);
  reply["name"] = s.character.name;
  reply["notes"] = s.character.notes;
  reply["tall"] = tall(s.character);
  reply["vertices"] = s.character.vertices.size();
  reply["faces"] = s.character.face_count();
  return reply;
}

Character bare(Character mesh) {
  mesh.joints.clear();
  mesh.influences.clear();
  mesh.notes.clear();
  return mesh;
}

}  // namespace

std::string without_option(std::string line) {
  for (const char* option : {" (--no-mirror)", "; --fit mends that", ", --cut opens it", "; --class says what it is",
                             " (--mask-out shows where, --mask cuts by hand)", " (--mask cuts by hand)"})
    if (const size_t at = line.find(option); at != std::string::npos) line.erase(at, std::string(option).size());
  return line;
}

Json picture_json(const PictureCharacter& picture) {
  Json outline = Json::array();
  for (const auto& line : outline_of(picture.figure)) {
    outline.push_back(Json::array());
    for (const auto& place : line) outline.back().push_back({place[0], place[1]});
  }
  return {{"width", picture.picture->pixels.width}, {"height", picture.picture->pixels.height},
          {"figures", picture.figure.count},        {"figure", picture.figure.number},
          {"clip", default_clip(picture.body)},     {"flat", picture.options.mesh.flat},
          {"cut", picture.options.figure.cut},      {"outline", std::move(outline)}};
}

bool are_alike(const std::vector<Joint>& some, const std::vector<Joint>& others) {
  return std::equal(some.begin(), some.end(), others.begin(), others.end(),
                    [](const Joint& a, const Joint& b) { return a.parent == b.parent; });
}

// The character has the present rig. Weights stay where joints were moved or renamed, until the next bind.
Json show_rig(Session& s) {
  const std::vector<Joint>&before = s.character.joints, &now = s.rigs().now().joints;
  const bool alike = are_alike(before, now);
  s.character.joints = now;
  s.taken = {};
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
  if (s.rig_model == nullptr) throw Error("no model of skeletons is loaded");
  stand(s);
  RigJobOptions job;
  job.bind = false;  // the page shows the skeleton first
  job.detail = static_cast<SkeletonDetail>(wishes.at("detail").get<uint8_t>());
  const uint32_t up = wishes.at("up").get<uint32_t>();
  if (up <= 1) job.up = up == 1 ? Axis::kZ : Axis::kY;
  job.category = wishes.at("category").get<uint32_t>();
  job.front = wishes.at("front").get<uint32_t>();
  job.mirror = wishes.at("mirror").get<uint32_t>();
  job.spine_count = wishes.at("spine").get<uint32_t>();
  job.toes = wishes.at("toes").get<bool>();
  job.ends = wishes.at("ends").get<bool>();
  const std::vector<SkeletonEdit> markers = read_edits(wishes.value("at", Json::array()));
  const bool alike = wishes.value("alike", true);
  if (alike) job.edits = markers;
  if (job.detail != SkeletonDetail::kBody && s.hands_model == nullptr) throw Error("no model of hands is loaded");
  const auto model_of = [](const std::unique_ptr<LoadedModel>& one) { return one == nullptr ? nullptr : &one->model; };
  const RigModels models = {&s.rig_model->model, nullptr, model_of(s.hands_model), model_of(s.front_model)};
  RiggedCharacter rigged;
  const std::shared_ptr<const PictureCharacter> picture = s.picture();
  if (picture != nullptr) {
    PictureCharacter made = *picture;
    rig_picture(job, models, &made);
    rigged = made.rigged;
    made.rigged.character = {};
    s.pictures_of[s.number] = std::make_shared<const PictureCharacter>(std::move(made));
  } else {
    rigged = rig_character(bare(s.character), job, models);
  }
  std::vector<std::string> notes = std::move(rigged.character.notes);
  for (std::string& note : notes) note = without_option(std::move(note));
  const bool wants_hands = models.hands == nullptr && picture == nullptr && may_be_lone_hand(job, rigged.skeleton);
  if (!alike) edit_skeleton(markers, false, &rigged.skeleton);
  Rig rig = predicted_rig(s.character, std::move(rigged.skeleton));
  if (s.character.joints.empty())
    s.rigs().start(std::move(rig));  // a mesh without skeleton is no step to go back to
  else
    s.rigs().put(std::move(rig), false);
  Json reply = show_rig(s);
  reply["notes"] = notes;
  reply["wantsHands"] = wants_hands;  // the same call with that model may tell a hand without a body
  if (s.picture() != nullptr) reply["picture"] = picture_json(*s.picture());
  return reply;
}

Json edit(Session& s, const Json& edits, bool mirror, bool continues) {
  stand(s);
  try {
    s.rigs().edit(s.character, read_edits(edits), mirror, continues);
  } catch (const Error& error) {
    throw Error(without_option(error.what()));
  }
  return show_rig(s);
}

Json load(Session& s, const std::string& mesh, const std::string& skeleton, uint32_t number, const Json& place) {
  if (is_picture(mesh)) return load_picture(s, mesh, Json::object(), number);
  Character character = read_mesh(mesh);
  if (!skeleton.empty()) read_skeleton(skeleton, false, &character);
  if (character.vertices.empty()) throw Error(mesh + ": has no vertices to bind");
  if (character.face_count() == 0) throw Error(mesh + ": has no faces to show; drop a mesh with polygons");
  const CharacterTransform transform = {place.value("turns", std::vector<std::string>()), place.value("height", 0.0),
                                        place.value("floor", false)};
  character = transformed(std::move(character), transform, place.value("up", 0u) == 1 ? Axis::kZ : Axis::kY);
  JointChoice choice;
  if (!character.joints.empty()) {
    choice = prepare_joints(skeleton.empty() ? JointsFrom::kAuto : JointsFrom::kNames, false, &character);
    for (std::string& note : character.notes) note = without_option(std::move(note));
  }
  std::vector<std::vector<Influence>> reference =
      skeleton.empty() ? std::move(character.influences) : weights_of_file(skeleton, read_mesh(mesh));
  character.influences.clear();
  if (place.value("anew", false)) s.rigs_of.erase(number);
  Json reply = start(s, std::move(character), std::move(choice), std::move(reference), number,
                     is_identity(transform)
                         ? ""
                         : Json{transform.turns, transform.height, transform.floor, place.value("up", 0u)}.dump());
  s.pictures_of.erase(number);
  return reply;
}

Json load_picture(Session& s, const std::string& path, const Json& wishes, uint32_t number) {
  Character mesh;
  const auto known = s.pictures_of.find(number);
  if (wishes.empty() && known != s.pictures_of.end()) {  // it is looked at again
    const PictureCharacter& picture = *known->second;
    mesh = picture_mesh(*picture.picture, picture.figure);
  } else {
    PictureJobOptions options = picture_options(wishes);
    const bool flat =
        std::exchange(options.mesh.flat, false);  // strike() makes it so: weights are those of what is round
    PictureCharacter picture = open_picture(path, options);
    picture.options.mesh.flat = flat;
    mesh = std::move(picture.rigged.character);
    picture.rigged.character = {};
    s.pictures_of[number] = std::make_shared<const PictureCharacter>(std::move(picture));
  }
  for (std::string& note : mesh.notes) note = without_option(std::move(note));
  Json place = place_of(*s.pictures_of[number]->picture, mesh);
  Json reply = start(s, std::move(mesh), {}, {}, number);
  reply["picture"] = picture_json(*s.picture());
  reply["picture"]["place"] = std::move(place);
  return reply;
}

}  // namespace sinew::web
