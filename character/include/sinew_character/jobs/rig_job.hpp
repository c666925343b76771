// SPDX-License-Identifier: MIT
// The default job of `sinew rig` for one mesh: a skeleton by the model or the shape, details, the user's own
// skeleton, edits, weights.
#ifndef SINEW_CHARACTER_RIG_JOB_HPP
#define SINEW_CHARACTER_RIG_JOB_HPP

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sinew_character/bind/seams.hpp"
#include "sinew_character/check/rig_gate.hpp"
#include "sinew_character/predict/edit_skeleton.hpp"
#include "sinew_character/predict/fit_skeleton.hpp"
#include "sinew_character/predict/predict_details.hpp"
#include "sinew_character/predict/predict_skeleton.hpp"
#include "sinew_formats/base/box.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

enum class RigMethod {
  kAuto,  // votes; if the mesh is unlike the training data, a hand without a body, or the shape
  kVotes,
  kShape,
  kRegions,
  kSlots
};

struct RigJobOptions {
  RigMethod method = RigMethod::kAuto;
  SkeletonDetail detail = SkeletonDetail::kBody;
  uint32_t mirror = SINEW_MIRROR_AUTO, spine_count = 0;
  std::optional<Axis> up;  // none: found
  uint32_t front = SINEW_FRONT_AUTO;
  uint32_t category = 0;          // sinew_category; not with kShape and kRegions
  bool category_guessed = false;  // guessed, not given: the shape may still replace doubtful votes
  bool toes = true, ends = true, bind = true, keep_lengths = false;
  std::string to_pose;  // the rest pose of the result: "t", "a" or a file in that pose; empty: unchanged. Needs `bind`
  bool pose_preferred = false;  // see RestPose::preferred
  bool cut = false;             // cuts fused parts open; `to_pose` implies it. Needs `bind`
  bool gate = false;            // measure the result: RiggedCharacter::gate
  uint32_t influence_count = 4, thread_count = 1;
  uint32_t rigid_parts = SINEW_RIGID_PARTS_AUTO, softness_percent = 100, surface_vertices = 32768;
  std::vector<SkeletonEdit> edits;
  std::string skeleton;  // the user's own skeleton instead of the predicted one: its file or template:NAME; empty: none
  std::vector<Joint> own;             // its joints if they are already read; `skeleton` is then a name for messages
  sinew_progress progress = nullptr;  // of the bind
  void* progress_user = nullptr;
};

// Models opened for their tasks; unused ones may be null: hands for kBody (a hand without a body is then not
// recognized), bind without a bind, rig for shape and regions, front if it is given or taken from the votes.
struct RigModels {
  const sinew_model *rig = nullptr, *bind = nullptr, *hands = nullptr, *front = nullptr;
};

struct RiggedCharacter {
  Character character;
  PredictedSkeleton skeleton;
  std::optional<FittedSkeleton> fitted;  // with RigJobOptions::skeleton
  std::vector<LimbDoubt> doubtful;       // for votes: limbs that may be wrong, as joints of `skeleton`
  Seams seams;                           // with RigJobOptions::bind
  GateFigures gate_figures;              // with RigJobOptions::gate
  std::vector<std::string> gate;         // the same: failures, one line each, also in the notes
  double bind_seconds = 0;
};

// Returns whether votes are so uncertain that rig_character() checks by RigModels::hands for a hand without a body.
bool may_be_lone_hand(const RigJobOptions& options, const PredictedSkeleton& skeleton);

// Predicts the initial skeleton of rig_character() by the method; finds up and front unless the job has them. Adds
// warnings to the notes.
PredictedSkeleton predict_for_job(const RigJobOptions& options, const RigModels& models, Character* mesh);

// Rigs a mesh. A skeleton of `mesh` is removed, with a note. Throws Error.
RiggedCharacter rig_character(Character mesh, const RigJobOptions& options, const RigModels& models);
// The same for a skeleton from another source.
//   by_names  classifies its joints by name instead of its classes
RiggedCharacter rig_character(Character mesh, PredictedSkeleton predicted, bool by_names, const RigJobOptions& options,
                              const RigModels& models);

// Rigs by the bundled models with default options, for jobs that need a skeleton first. Throws Error.
Character rig_bare_mesh(Character mesh);

}  // namespace sinew
#endif
