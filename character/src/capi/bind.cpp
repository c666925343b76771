// SPDX-License-Identifier: MIT
// sinew_character_bind(): the job of `sinew bind`.
#include "conversions.hpp"
#include "handle.hpp"
#include "sinew_character/jobs/bind_job.hpp"

namespace sinew {
namespace {

std::vector<uint8_t> marks(const uint8_t* given, size_t count) {
  return given == nullptr ? std::vector<uint8_t>() : std::vector<uint8_t>(given, given + count);
}

// Vertices can keep only weights that they have.
void check_kept(const char* what, const std::vector<uint8_t>& kept, const Character& character) {
  for (size_t v = 0; v < kept.size(); ++v)
    if (kept[v] != 0 && (character.influences.empty() || character.influences[v].empty()))
      throw Error(std::string(what) + ": vertex " + std::to_string(v) + " of " + character.name +
                  " has no weights to keep");
}

JointsFrom joints_from(uint32_t given, const sinew_character& character) {
  switch (given) {
    case SINEW_JOINTS_OWN:
      return JointsFrom::kOwn;
    case SINEW_JOINTS_NAMES:
      return JointsFrom::kNames;
    case SINEW_JOINTS_ALL:
      return JointsFrom::kAll;
    default:
      return character.own_skeleton ? JointsFrom::kAuto : JointsFrom::kNames;
  }
}

BindJobOptions job_of(const sinew_character_bind_options& options, const sinew_character& from) {
  check_at_most("joints", options.joints, SINEW_JOINTS_ALL);
  check_at_most("influence_count", options.influence_count, SINEW_MAX_INFLUENCES);
  check_at_most("thread_count", options.thread_count, SINEW_MAX_THREADS);
  check_at_most("method", options.method, SINEW_METHOD_DISTANCE);
  check_at_most("question_count", options.question_count, SINEW_MAX_QUESTIONS);
  check_at_most("answer_count", options.answer_count, SINEW_MAX_QUESTIONS);
  need(options.answers != nullptr || options.answer_count == 0, "answers");
  const Character& character = from.character;
  BindJobOptions job;
  job.mesh = from.path.empty() ? character.name : from.path;
  job.joints = joints_from(options.joints, from);
  if (options.influence_count != 0) job.influence_count = options.influence_count;
  if (options.thread_count != 0) job.thread_count = options.thread_count;
  job.up_axis = up_axis_of("up", options.up);
  job.rigid_parts = options.rigid_parts;
  if (options.softness_percent != 0) job.softness_percent = options.softness_percent;
  if (options.surface_vertices != 0) job.surface_vertices = options.surface_vertices;
  job.keep_tips = options.keep_tips != 0;
  job.bind_props = options.bind_props != 0;
  job.fit = options.fit != 0;
  job.symmetric = options.symmetric != 0;
  job.cut = options.cut != 0;
  if (options.to_pose != nullptr) job.to_pose = options.to_pose;
  job.joint_flags = marks(options.joint_flags, character.joints.size());
  job.locked = marks(options.locked, character.vertices.size());
  job.hinted = marks(options.hinted, character.vertices.size());
  check_kept("locked", job.locked, character);
  check_kept("hinted", job.hinted, character);
  return job;
}

void fill_result(const Character& character, const BindJob& job, const CharacterBind& bound, uint32_t influence_count,
                 size_t by_style, ResultViews* views, sinew_character_bind_result* result) {
  if (result == nullptr) return;
  *views = {};
  for (const LeftOutJoint& left : job.choice().left_out) views->texts.push_back(left.why);
  for (size_t i = 0; i < views->texts.size(); ++i)
    views->left_out.push_back({views->texts[i].c_str(), count32(job.choice().left_out[i].joint), 0});
  views->questions = bound.questions;
  views->vertex_questions = bound.vertex_questions;
  views->text = bind_hash(character.influences, influence_count);
  sinew_character_bind_result filled = SINEW_INIT(sinew_character_bind_result);
  filled.symmetric_vertices = bound.symmetric_vertices;
  filled.kept_meshes = count32(bound.kept_meshes);
  filled.folded_tips = count32(bound.folded_tips);
  filled.left_out_count = count32(views->left_out.size());
  filled.question_count = count32(views->questions.size());
  filled.answers_by_style = count32(by_style);
  filled.seconds = bound.seconds;
  filled.workspace_bytes = bound.workspace_bytes;
  filled.left_out = views->left_out.data();
  filled.questions = views->questions.data();
  filled.vertex_questions = views->vertex_questions.empty() ? nullptr : views->vertex_questions.data();
  filled.hash = views->text.c_str();
  views->seams = seams_of(bound.seams);
  filled.seams = views->seams.data();
  filled.seam_count = count32(views->seams.size());
  filled.doubled_vertices = count32(bound.doubled_vertices);
  give(filled, result);
}

void bind(const sinew_character_bind_options& options, ProgressOfCaller* progress, sinew_character* target,
          sinew_character_bind_result* result) {
  Character character = target->character;
  if (character.vertices.empty()) throw Error(character.name + ": has no mesh to bind");
  if (character.joints.empty()) throw Error(character.name + ": has no skeleton; set one, or rig it");
  BindJobOptions job_options = job_of(options, *target);
  job_options.progress = progress->callback();
  job_options.progress_user = progress->user();
  // Weights for the skeleton of another file matter only if some are kept.
  if (!target->own_skeleton && job_options.locked.empty() && job_options.hinted.empty()) character.influences.clear();
  BindHints hints;
  if (options.hints != nullptr) {
    const Character& painted = options.hints->character;
    if (painted.influences.size() != character.vertices.size())
      throw Error(painted.name + ": expected weights for " + std::to_string(character.vertices.size()) +
                  " vertices, found " + std::to_string(painted.influences.size()));
    hints = {painted.name, painted.joints, painted.influences};
    job_options.hints = &hints;
  }
  if (options.like != nullptr) {
    job_options.like = &options.like->character;
    if (job_options.like->joints.empty() || job_options.like->influences.empty())
      throw Error(job_options.like->name + ": expected a bound character, found one without skin weights");
  }
  std::unique_ptr<LoadedModel> model;
  Binder binder;
  if (options.method == SINEW_METHOD_MODEL) {
    model = model_of(options.models, ModelUse::kBind);
    binder = {&model->model, "model"};
  } else {
    binder.method = options.method;
    if (job_options.softness_percent != 100)
      throw Error("softness_percent needs the model's weights: leave it out with heat or distance");
  }
  BindJob job(job_options, binder, &character);
  std::vector<sinew_answer> answers;
  if (options.style != nullptr) answers = job.answers_of(read_style(options.style));
  const size_t by_style = answers.size();
  for (uint32_t a = 0; a < options.answer_count; ++a) {
    const sinew_answer& answer = options.answers[a];
    if (answer.vertex >= character.vertices.size() || answer.joint >= character.joints.size())
      throw Failure(SINEW_ERROR_RANGE,
                    "answers: answer " + std::to_string(a) + " names a vertex or joint that does not exist");
    answers.push_back(answer);
  }
  CharacterBind bound = job.bind(answers, options.question_count);
  job.apply(&bound);
  character.confidence = bound.confidence;
  for (std::string& note : bind_notes(character, job.choice(), bound)) character.notes.push_back(std::move(note));
  target->character = std::move(character);
  target->keep_confidence = options.keep_confidence != 0;
  changed(target);
  fill_result(target->character, job, bound, job_options.influence_count, by_style, &target->results, result);
}

}  // namespace

std::unique_ptr<LoadedModel> model_of(const sinew_character_models* models, ModelUse use) {
  if (models == nullptr) return load_model("", use);
  const sinew_character_models given = options_of(models);
  const auto [bytes, size] = [&]() -> std::pair<const void*, size_t> {
    switch (use) {
      case ModelUse::kBind:
        return {given.bind, given.bind_size};
      case ModelUse::kRig:
        return {given.rig, given.rig_size};
      case ModelUse::kHands:
        return {given.hands, given.hands_size};
      case ModelUse::kFront:
        return {given.front, given.front_size};
      case ModelUse::kSlotJoints:
        break;
    }
    return {given.slots, given.slots_size};
  }();
  if (bytes == nullptr) return load_model("", use);
  const auto* first = static_cast<const uint8_t*>(bytes);
  return model_from_bytes({first, first + size}, "the model that was given", use);
}

}  // namespace sinew

using namespace sinew;

extern "C" sinew_status sinew_character_bind(sinew_character* character, const sinew_character_bind_options* given,
                                             sinew_character_bind_result* result) {
  ProgressOfCaller progress = progress_of(given);
  return guarded(
      character,
      [&] {
        need(character != nullptr, "character");
        check_result(result);
        bind(options_of(given), &progress, character, result);
      },
      &progress);
}
