// SPDX-License-Identifier: MIT
// sinew_character_rig(): the job of `sinew rig`.
#include <algorithm>
#include <cmath>

#include "conversions.hpp"
#include "handle.hpp"
#include "sinew_character/bind/engine_views.hpp"
#include "sinew_character/jobs/rig_job.hpp"
#include "sinew_character/predict/skeleton_template.hpp"

namespace sinew {
namespace {

SkeletonEdit edit_of(const sinew_skeleton_edit& edit) {
  check_at_most("edits: kind", edit.kind, SINEW_EDIT_AT);
  need(edit.joint != nullptr, "edits: joint");
  const bool of_two = edit.kind == SINEW_EDIT_ADD || edit.kind == SINEW_EDIT_PARENT || edit.kind == SINEW_EDIT_RENAME;
  need(edit.other != nullptr || !of_two, "edits: other");
  for (const float x : edit.position)
    if (!std::isfinite(x))
      throw Failure(SINEW_ERROR_NOT_FINITE, std::string("edits: the position of ") + edit.joint + " is not finite");
  return {static_cast<EditKind>(edit.kind),
          edit.joint,
          of_two ? edit.other : "",
          {edit.position[0], edit.position[1], edit.position[2]}};
}

RigJobOptions job_of(const sinew_character_rig_options& options) {
  check_at_most("method", options.method, SINEW_CHARACTER_RIG_SLOTS);
  check_at_most("category", options.category, SINEW_CATEGORY_VEHICLE);
  if (options.category != 0 &&
      (options.method == SINEW_CHARACTER_RIG_SHAPE || options.method == SINEW_CHARACTER_RIG_REGIONS))
    throw Failure(SINEW_ERROR_ARGUMENT, "category: steers the model, but this method has none");
  check_at_most("detail", options.detail, SINEW_CHARACTER_DETAIL_FULL);
  check_at_most("mirror", options.mirror, SINEW_MIRROR_NEVER);
  check_at_most("thread_count", options.thread_count, SINEW_MAX_THREADS);
  const sinew_character_bind_options bind = options_of(options.bind);
  check_at_most("influence_count", bind.influence_count, SINEW_MAX_INFLUENCES);
  need(options.edits != nullptr || options.edit_count == 0, "edits");
  RigJobOptions job;
  job.method = static_cast<RigMethod>(options.method);
  job.category = options.category;
  job.detail = static_cast<SkeletonDetail>(options.detail);
  job.mirror = options.mirror;
  if (options.up != SINEW_UP_AUTO) job.up = up_axis_of("up", options.up);
  check_at_most("front", options.front, SINEW_FRONT_MINUS_Y);
  job.front = options.front;
  job.spine_count = options.spine_count;
  check_without(options.without, SINEW_WITHOUT_TOES | SINEW_WITHOUT_ENDS | SINEW_WITHOUT_BIND);
  job.toes = (options.without & SINEW_WITHOUT_TOES) == 0;
  job.ends = (options.without & SINEW_WITHOUT_ENDS) == 0;
  job.bind = (options.without & SINEW_WITHOUT_BIND) == 0;
  job.keep_lengths = options.keep_lengths != 0;
  job.gate = options.gate != 0;
  job.cut = bind.cut != 0;
  if (bind.to_pose != nullptr) job.to_pose = bind.to_pose;
  if (bind.influence_count != 0) job.influence_count = bind.influence_count;
  if (options.thread_count != 0) job.thread_count = options.thread_count;
  job.rigid_parts = bind.rigid_parts;
  if (bind.softness_percent != 0) job.softness_percent = bind.softness_percent;
  if (bind.surface_vertices != 0) job.surface_vertices = bind.surface_vertices;
  for (uint32_t e = 0; e < options.edit_count; ++e) job.edits.push_back(edit_of(options.edits[e]));
  if (options.skeleton != nullptr) job.skeleton = options.skeleton;
  if (options.skeleton_character != nullptr) {
    const sinew_character& own = *options.skeleton_character;
    if (own.character.joints.empty()) throw Error(own.character.name + ": expected a skeleton, found only a mesh");
    job.skeleton = own.path.empty() ? own.character.name : own.path;
    job.own = own.character.joints;
  }
  return job;
}

// The mesh as `sinew rig` reads it: from its file where it is one, without the skeleton of another.
Character bare_mesh(const sinew_character& from) {
  Character mesh = from.character;
  if (mesh.vertices.empty()) throw Error(mesh.name + ": has no mesh to rig");
  if (!from.own_skeleton) {
    mesh.joints.clear();
    mesh.influences.clear();
  }
  return mesh;
}

void fill_result(const RiggedCharacter& rigged, ResultViews* views, sinew_character_rig_result* result) {
  if (result == nullptr) return;
  *views = {};
  const PredictedSkeleton& skeleton = rigged.skeleton;
  views->ends = skeleton.ends;
  views->confidence = skeleton.confidence;
  views->parent_confidence = skeleton.parent_confidence;
  sinew_character_rig_result filled = SINEW_INIT(sinew_character_rig_result);
  filled.mirrored = skeleton.mirrored ? 1 : 0;
  filled.joint_count = count32(skeleton.joints.size());
  filled.spread = skeleton.spread;
  filled.scale = 1;
  std::copy(skeleton.front.begin(), skeleton.front.end(), filled.front);
  filled.up = engine_up(skeleton.up_axis);
  filled.front_confidence = skeleton.front_confidence;
  filled.up_confidence = skeleton.up_confidence;
  if (rigged.fitted) {
    filled.matched = count32(rigged.fitted->matched);
    filled.scale = rigged.fitted->scale;
  }
  filled.seconds = skeleton.seconds;
  filled.bind_seconds = rigged.bind_seconds;
  filled.ends = views->ends.data();
  filled.confidence = views->confidence.data();
  filled.parent_confidence = views->parent_confidence.data();
  for (const LimbDoubt& limb : rigged.doubtful) views->texts.push_back(limb.name);
  for (size_t i = 0; i < rigged.doubtful.size(); ++i)
    views->doubtful.push_back({views->texts[i].c_str(), rigged.doubtful[i].doubt, 0});
  filled.doubtful = views->doubtful.data();
  filled.doubtful_count = count32(views->doubtful.size());
  views->seams = seams_of(rigged.seams);
  filled.seams = views->seams.data();
  filled.seam_count = count32(views->seams.size());
  give(filled, result);
}

}  // namespace

RiggedCharacter rig_of(const sinew_character& from, const sinew_character_rig_options& options,
                       ProgressOfCaller* progress, std::shared_ptr<const PictureCharacter>* picture) {
  RigJobOptions job = job_of(options);
  job.progress = progress->callback();
  job.progress_user = progress->user();
  std::unique_ptr<LoadedModel> rig, bind, hands, front;
  if (job.method == RigMethod::kAuto || job.method == RigMethod::kVotes) rig = model_of(options.models, ModelUse::kRig);
  if (job.method == RigMethod::kSlots) rig = model_of(options.models, ModelUse::kSlotJoints);
  if (job.bind) bind = model_of(options.models, ModelUse::kBind);
  if (job.detail != SkeletonDetail::kBody || job.method == RigMethod::kAuto)
    hands = model_of(options.models, ModelUse::kHands);
  if (from.picture == nullptr)
    front = options.models != nullptr && options_of(options.models).front != nullptr
                ? model_of(options.models, ModelUse::kFront)
                : load_front_model();
  RigModels models;
  if (front) models.front = &front->model;
  if (rig) models.rig = &rig->model;
  if (bind) models.bind = &bind->model;
  if (hands) models.hands = &hands->model;
  if (from.picture == nullptr) return rig_character(bare_mesh(from), job, models);
  PictureCharacter made = *from.picture;
  rig_picture(job, models, &made);
  RiggedCharacter rigged = made.rigged;
  *picture = without_mesh(std::move(made));
  return rigged;
}

}  // namespace sinew

using namespace sinew;

extern "C" {

sinew_status sinew_character_rig(sinew_character* character, const sinew_character_rig_options* given,
                                 sinew_character_rig_result* result) {
  ProgressOfCaller progress = progress_of(given);
  return guarded(
      character,
      [&] {
        need(character != nullptr, "character");
        check_result(result);
        std::shared_ptr<const PictureCharacter> picture;
        RiggedCharacter rigged = rig_of(*character, options_of(given), &progress, &picture);
        character->picture = picture;
        character->character = std::move(rigged.character);
        character->own_skeleton = true;
        character->clips.clear();
        character->morphs = {};
        changed(character);
        fill_result(rigged, &character->results, result);
      },
      &progress);
}

const char* sinew_character_templates(void) {
  static const std::string names = [] {
    std::string text;
    for (const TemplateInfo& one : skeleton_templates()) text += (text.empty() ? "" : " ") + one.name;
    return text;
  }();
  return names.c_str();
}

}  // extern "C"
