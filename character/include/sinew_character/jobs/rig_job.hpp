// SPDX-License-Identifier: MIT
// What `sinew rig` does with one mesh by default: a skeleton by the model or the shape, details, a user's own in its place, edits, weights.
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
  kAuto,  // votes, or where these know little a hand without a body, or where they know nothing the shape
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
  bool category_guessed = false;  // nobody said it: votes that know nothing still give way to the shape
  bool toes = true, ends = true, bind = true, keep_lengths = false;
  std::string
      to_pose;  // the rest pose of what is written: "t", "a" or a file that stands so; empty: as the mesh stands. Needs `bind`
  bool cut = false;   // what has grown together is opened; `to_pose` does so too. Needs `bind`
  bool gate = false;  // measure the result: RiggedCharacter::gate
  uint32_t influence_count = 4, thread_count = 1;
  uint32_t rigid_parts = SINEW_RIGID_PARTS_AUTO, softness_percent = 100, surface_vertices = 32768;
  std::vector<SkeletonEdit> edits;
  std::string skeleton;    // a user's own, in place of the predicted one: its file or template:NAME, empty: none
  std::vector<Joint> own;  // its joints where they were read already, `skeleton` is a name for messages then
  sinew_progress progress = nullptr;  // of the bind
  void* progress_user = nullptr;
};

// Opened for their tasks; those that a job does not need may be null: hands for the body alone (a lone hand is not told then), bind without one, rig for shape and
// regions, front where it is known or the votes are to tell.
struct RigModels {
  const sinew_model *rig = nullptr, *bind = nullptr, *hands = nullptr, *front = nullptr;
};

struct RiggedCharacter {
  Character character;
  PredictedSkeleton skeleton;
  std::optional<FittedSkeleton> fitted;  // with RigJobOptions::skeleton
  std::vector<LimbDoubt> doubtful;       // of votes: limbs that may be wrong, in joints of `skeleton`
  Seams seams;                           // with RigJobOptions::bind
  GateFigures gate_figures;              // with RigJobOptions::gate
  std::vector<std::string> gate;         // the same: what fails, a line each, told in the notes as well
  double bind_seconds = 0;
};

// Whether votes know so little that rig_character() asks RigModels::hands whether the mesh is a hand without a body.
bool may_be_lone_hand(const RigJobOptions& options, const PredictedSkeleton& skeleton);

// The skeleton that rig_character() begins with: by the method, up and front found where the job leaves them open. Doubts go into the notes.
PredictedSkeleton predict_for_job(const RigJobOptions& options, const RigModels& models, Character* mesh);

// Starts from a bare mesh, whatever skeleton `mesh` has: that goes, which the notes say. Throws Error.
RiggedCharacter rig_character(Character mesh, const RigJobOptions& options, const RigModels& models);
// The same from a skeleton that something else predicted.
//   by_names  its joints' names say what they are, else its classes
RiggedCharacter rig_character(Character mesh, PredictedSkeleton predicted, bool by_names, const RigJobOptions& options,
                              const RigModels& models);

// By the bundled models and every default, for jobs that need a skeleton on the way. Throws Error.
Character rig_bare_mesh(Character mesh);

}  // namespace sinew
#endif
