// SPDX-License-Identifier: MIT
// Wishes to options of a bind, its result to rows and JSON.
#include "binds.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "characters.hpp"
#include "sinew_character/bind/answers.hpp"
#include "sinew_character/jobs/bind_job.hpp"
#include "sinew_formats/error.hpp"

namespace sinew::web {
namespace {

constexpr uint32_t kQuestions = 8;  // listed beside the mesh

// How sure the least sure tenth is on average, 0 to 1.
double sure_of_least_tenth(std::vector<uint8_t> confidence) {
  const size_t tenth = (confidence.size() + 9) / 10;
  std::partial_sort(confidence.begin(), confidence.begin() + static_cast<std::ptrdiff_t>(tenth), confidence.end());
  double sum = 0;
  for (size_t i = 0; i < tenth; ++i) sum += confidence[i] / 255.0;
  return sum / static_cast<double>(tenth);
}

// Whether all of a file's meshes hang on joints rigidly: what `sinew bind` takes for props would leave nothing to bind.
bool is_of_rigid_parts(const Character& character) {
  const auto hangs = [](const CharacterMesh& mesh) { return !mesh.skinned && mesh.carrier >= 0; };
  return !character.meshes.empty() && std::all_of(character.meshes.begin(), character.meshes.end(), hangs);
}

// The command's job for the character as it is, with what its user said. `sinew rig` binds attached meshes too, and tips keep their weight.
BindJob job_for(Session& s, const Wish& wish) {
  stand(s);
  const Rig& rig = s.rigs().now();
  BindJobOptions job;
  job.choice = &rig.choice;
  job.restored_joints = wish.always;
  if (!wish.never.empty()) job.joint_flags.assign(s.character.joints.size(), 0);
  for (const size_t joint : wish.never) job.joint_flags.at(joint) = SINEW_JOINT_NEVER;
  job.influence_count = wish.influences;
  job.up_axis = wish.up_axis;
  job.symmetric = wish.symmetric;
  job.rigid_parts = wish.rigid_parts;
  job.keep_tips = rig.predicted;
  job.bind_props = rig.predicted || is_of_rigid_parts(s.character);
  if (rig.predicted && rig.skeleton) {
    job.scenery = rig.skeleton->scenery;
    if (!rig.skeleton->rigid_joints.empty()) job.rigid_parts = SINEW_RIGID_PARTS_ALWAYS;
  }
  if (!s.character.influences.empty()) {  // rows to keep
    job.locked = s.locked;
    job.hinted = s.hints;
  }
  job.progress = wish.progress;
  Binder binder;
  binder.method = wish.method;
  if (wish.method == SINEW_METHOD_MODEL) {
    if (s.bind_model == nullptr) throw Error("no model is loaded");
    binder.model = &s.bind_model->model;
    job.softness_percent = wish.softness_percent;
  }
  return BindJob(job, binder, &s.character);
}

Json question_json(const Character& character, const sinew_question& question) {
  const std::vector<Joint>& joints = character.joints;
  Json alternatives = Json::array();
  for (uint32_t a = 0; a < question.alternative_count; ++a) {
    const sinew_alternative& alternative = question.alternatives[a];
    alternatives.push_back({{"answer", answer_text(joints, alternative.kind, alternative.joint)},
                            {"kind", alternative.kind},
                            {"joint", alternative.joint},
                            {"change", alternative.change / 65536.0}});
  }
  const bool has_mesh = question.vertex < character.vertex_meshes.size();
  const std::string mesh = has_mesh ? character.meshes.at(character.vertex_meshes[question.vertex]).name : "";
  return {{"part", question.vertex},
          {"parts", question.part_count},
          {"mesh", mesh},
          {"vertices", question.vertex_count},
          {"joint", joints[question.joint].name},
          {"share", question.share / 65535.0},
          {"doubt", question.doubt / 65536.0},
          {"gain", question.gain / 65536.0},
          {"alternatives", std::move(alternatives)}};
}

}  // namespace

// text: {method, upAxis, symmetric, rigidParts, softness, influences, never, always, toPose}
Wish read_wish(const char* text, sinew_progress progress) {
  const Json json = Json::parse(text);
  Wish wish;
  wish.method = json.at("method").get<uint32_t>();
  wish.up_axis = json.at("upAxis").get<uint32_t>() == 1 ? Axis::kZ : Axis::kY;
  wish.symmetric = json.at("symmetric").get<bool>();
  wish.rigid_parts = json.at("rigidParts").get<uint32_t>();
  wish.softness_percent = static_cast<uint32_t>(std::lround(json.at("softness").get<double>() * 100));
  wish.influences = json.at("influences").get<uint32_t>();
  wish.never = json.at("never").get<std::vector<size_t>>();
  wish.always = json.at("always").get<std::vector<size_t>>();
  wish.to_pose = json.at("toPose").get<std::string>();
  wish.progress = progress;
  return wish;
}

// text: [[vertex, kind, joint], ...]
std::vector<sinew_answer> read_answers(const std::string& text) {
  std::vector<sinew_answer> answers;
  for (const Json& one : Json::parse(text))
    answers.push_back({one.at(0).get<uint32_t>(), one.at(1).get<uint16_t>(), one.at(2).get<uint16_t>(), 0});
  return answers;
}

Json bind_shown(Session& s, const Wish& wish, const std::vector<sinew_answer>& answers) {
  need_joints(s);
  const bool keeps = !s.locked.empty() || !s.hints.empty();
  std::vector<std::vector<Influence>> began = keeps ? s.character.influences : std::vector<std::vector<Influence>>();
  BindJob job = job_for(s, wish);
  CharacterBind result = job.bind(answers, kQuestions);
  s.began = std::move(began);
  const JointChoice& choice = job.choice();
  s.taken = {};
  s.slots = wish.influences;
  Rows rows = {std::move(result.influences), std::move(result.confidence)};
  swap_rows(s, &rows);
  s.vertex_questions = std::move(result.vertex_questions);
  s.to_pose = wish.to_pose;
  s.up_axis = s.character.up = wish.up_axis;
  s.seams = result.seams;
  strike(s);
  std::vector<double> sums(s.character.joints.size(), 0);
  for (const std::vector<Influence>& row : s.character.influences)
    for (const Influence& influence : row) sums[influence.joint] += influence.weight;
  s.strongest.resize(s.surface.vertex_of.size());
  for (size_t i = 0; i < s.strongest.size(); ++i) s.strongest[i] = s.joints[size_t{s.surface.vertex_of[i]} * s.slots];
  Json off = Json::array();
  for (size_t j = 0; j < choice.flags.size(); ++j)
    if ((choice.flags[j] & SINEW_JOINT_NEVER) != 0) off.push_back(j);
  Json left_out = Json::array();
  for (const LeftOutJoint& left : choice.left_out)
    left_out.push_back(s.character.joints[left.joint].name + " (" + left.why + ")");
  Json questions = Json::array();
  for (const sinew_question& question : result.questions) questions.push_back(question_json(s.character, question));
  Json places = Json::array();
  for (const Joint& joint : s.character.joints)
    places.push_back({joint.position.x, joint.position.y, joint.position.z});
  return {{"seconds", result.seconds},
          {"places", std::move(places)},
          {"usedBytes", result.used_bytes},
          {"hash", bind_hash(s.character.influences, s.slots)},
          {"jointWeights", sums},
          {"leftOut", left_out},
          {"off", off},
          {"lockedVertices", std::count(s.locked.begin(), s.locked.end(), uint8_t{1})},
          {"paintedVertices", std::count(s.hints.begin(), s.hints.end(), uint8_t{1})},
          {"keptMeshes", result.kept_meshes},
          {"rigidParts", !s.rigs().now().predicted && is_of_rigid_parts(s.character) ? s.character.meshes.size() : 0},
          {"grownTogether",
           result.seams.seams.empty() ? "" : without_option(seams_text(s.character.joints, result.seams, 0))},
          {"lookFirst", (s.confidence.size() + 9) / 10},
          {"lookFirstSure", sure_of_least_tenth(s.confidence)},
          {"questions", std::move(questions)}};
}

// A bind that shows weights while a joint is dragged: no questions, no sums.
Json rebind(Session& s, const Wish& wish, const std::vector<sinew_answer>& answers) {
  need_joints(s);
  CharacterBind result = job_for(s, wish).bind(answers, 0);
  s.taken = {};
  s.slots = wish.influences;
  Rows rows = {std::move(result.influences), std::move(result.confidence)};
  swap_rows(s, &rows);
  return {{"seconds", result.seconds}};
}

// Shows the character as these answers would bind it; what was taken stays what is written.
Json preview(Session& s, const Wish& wish, const std::vector<sinew_answer>& answers) {
  CharacterBind result = job_for(s, wish).bind(answers, 0);
  end_preview(s);
  stand(s);
  s.taken = {std::move(result.influences), std::move(result.confidence)};
  swap_rows(s, &s.taken);
  strike(s);
  return {{"hash", bind_hash(s.character.influences, s.slots)}};
}

// Answers that the loaded style has for the character: with each its question, and the question's number in
// web_buffer(kVertexQuestions).
Json style_answers(Session& s, const Wish& wish) {
  Json list = Json::array();
  if (s.style.sheets.empty()) return {{"answers", std::move(list)}};
  BindJob job = job_for(s, wish);
  const CharacterBind& proposed = job.proposed();
  for (const sinew_answer& answer : job.answers_of(s.style)) {
    const uint32_t number = proposed.vertex_questions[answer.vertex];
    list.push_back({{"question", question_json(s.character, proposed.questions[number])},
                    {"number", number},
                    {"answer", answer_text(s.character.joints, answer.kind, answer.joint)},
                    {"kind", answer.kind},
                    {"joint", answer.joint}});
  }
  s.vertex_questions = proposed.vertex_questions;
  return {{"answers", std::move(list)}};
}

// The loaded style with these answers.
void save_style(Session& s, const Wish& wish, const std::vector<sinew_answer>& answers, const std::string& path) {
  write_style(path, job_for(s, wish).learned(s.style, answers, path));
  strike(s);
}

}  // namespace sinew::web
