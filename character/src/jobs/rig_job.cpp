// SPDX-License-Identifier: MIT
// A bare mesh with a skeleton and weights.
#include "sinew_character/jobs/rig_job.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "jobs/sheet_skeleton.hpp"
#include "predict/fit_details.hpp"
#include "sinew/published.h"
#include "sinew_character/check/check.hpp"
#include "sinew_character/models/models.hpp"
#include "sinew_character/pose/rest_pose.hpp"
#include "sinew_character/predict/lone_hand.hpp"
#include "sinew_character/predict/own_skeleton.hpp"
#include "sinew_character/predict/part_skeleton.hpp"
#include "sinew_character/predict/predict_details.hpp"
#include "sinew_character/predict/scenery.hpp"
#include "sinew_character/predict/vehicle_skeleton.hpp"
#include "sinew_character/rig/mesh_surface.hpp"
#include "sinew_character/springs/make_chains.hpp"
#include "sinew_formats/base/box.hpp"
#include "sinew_formats/base/thread_pool.hpp"
#include "sinew_formats/document_form.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {
namespace {

uint32_t engine_method(RigMethod method) {
  if (method == RigMethod::kSlots) return SINEW_RIG_SLOTS;
  if (method == RigMethod::kRegions) return SINEW_RIG_REGIONS;
  return method == RigMethod::kShape ? SINEW_RIG_SHAPE : SINEW_RIG_VOTES;
}

// Where up or front was found and might as well be another, one line.
void say_direction(const RigJobOptions& job, const PredictedSkeleton& skeleton, std::vector<std::string>* notes) {
  const bool up = !job.up && skeleton.up_confidence < kCoinToss;
  const bool front =
      job.front == SINEW_FRONT_AUTO && skeleton.front_confidence > 0 && skeleton.front_confidence < kCoinToss;
  if (!up && !front) return;
  notes->push_back(std::string("warning: ") + (up ? "the up axis" : "the front") +
                   (up && front ? " and the front" : "") +
                   " of this mesh is uncertain, so left and right may be exchanged; give " + (up ? "--up y or z" : "") +
                   (up && front ? " and " : "") + (front ? "--front, as in --front +z" : ""));
}

// A mesh with uncertain votes may be a hand: below that spread none of the training characters' hands is.
constexpr float kHandSpread = 0.055f;

// A hand without a body, with a note that it is a guess.
bool put_lone_hand(const RigModels& models, const SkeletonOptions& options, Character* character,
                   PredictedSkeleton* skeleton) {
  std::optional<LoneHand> hand = find_lone_hand(*character, *models.hands, options);
  if (!hand) return false;
  take_the_place_of(*skeleton, &hand->skeleton);
  hand->skeleton.front = skeleton->front;
  hand->skeleton.spread = skeleton->spread;
  *skeleton = std::move(hand->skeleton);
  character->notes.push_back(
      std::string("warning: this mesh looks like a ") + (hand->right ? "right" : "left") + " hand without a body" +
      (hand->thumb ? "" : ", without a thumb") +
      (hand->side_known ? "" : ", and its side is uncertain: a right hand turned over looks the same") +
      "; look for a body with --method votes");
  return true;
}

// How much surer votes are of what is left than of the whole where the rest is scenery.
constexpr float kSceneryGain = 0.15f;

// The ground, the backdrop or the pedestal of a body is no part of it. Whether parts are such, votes say; of a base that is one with its
// figure its shape is proof enough: one of 500 characters of train and val is taken for one, the feet of a chicken of boxes.
void leave_scenery_out(const SkeletonOptions& options, Character* character, PredictedSkeleton* skeleton) {
  if (!skeleton->usable || *skeleton->usable + kSceneryGain > 1) return;
  for (const bool fused : {false, true}) {
    std::vector<uint8_t> scenery = (fused ? find_fused_base : find_scenery)(*character, skeleton->up_axis);
    if (scenery.empty()) continue;
    PredictedSkeleton body = predict_skeleton(part_without(*character, scenery).character, options);
    body.seconds += skeleton->seconds;
    if (!fused && (!body.usable || *body.usable < *skeleton->usable + kSceneryGain)) continue;
    const auto vertices = std::count(scenery.begin(), scenery.end(), uint8_t{1});
    character->notes.push_back("taken as ground, a pedestal or a backdrop, a guess: " + std::to_string(vertices) +
                               " of " + std::to_string(scenery.size()) +
                               " vertices; they follow the root without joints of their own");
    *skeleton = std::move(body);
    skeleton->scenery = std::move(scenery);
    return;
  }
}

// Below this votes give way to the parts of a body that is made of them: of 14 such characters of train the distance to the artist's joints
// falls from 8.8 to 7.4 % of the size, and IoU rises from 29 to 44 %.
constexpr float kUnsureUsable = 0.25f;

PredictedSkeleton skeleton_of_parts(PartSkeleton parts, Axis up) {
  PredictedSkeleton made = skeleton_from_joints(parts.joints);
  made.front = parts.front;
  made.up_axis = up;
  made.rigid_joints = std::move(parts.joint_of);
  return made;
}

// Machines on wheels: no model says anything of them.
PredictedSkeleton vehicle_for_job(const RigJobOptions& job, Character* character) {
  if (job.method != RigMethod::kAuto) throw Error("a vehicle's joints are found from its parts; leave out the method");
  constexpr std::array<float, 3> kFronts[] = {{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}};
  std::optional<std::array<float, 3>> front;
  if (job.front != SINEW_FRONT_AUTO) front = kFronts[job.front - SINEW_FRONT_PLUS_Z];
  PredictedSkeleton made =
      skeleton_of_parts(vehicle_skeleton(*character, job.up.value_or(Axis::kY), front), job.up.value_or(Axis::kY));
  made.up_confidence = job.up ? 1 : kCoinToss;
  made.front_confidence = front ? 1 : kCoinToss;
  const size_t moving = made.joints.size() - 1;
  character->notes.push_back(
      moving == 0
          ? "warning: no wheel, turret or door is a separate part, so the vehicle has one joint; separate the parts "
            "that move"
          : "a vehicle of " + std::to_string(moving) + " moving parts, guessed from their shapes and positions" +
                (front ? "" : "; the front is a guess too, give it with --front, as in --front +z"));
  return made;
}

// One joint for what is no body.
PredictedSkeleton root_alone(const Character& mesh, const PredictedSkeleton& votes) {
  const Box box = box_of(mesh.vertices);
  Vec3 at = {0.5f * (box.low.x + box.high.x), 0.5f * (box.low.y + box.high.y), 0.5f * (box.low.z + box.high.z)};
  (votes.up_axis == Axis::kZ ? at.z : at.y) = votes.up_axis == Axis::kZ ? box.low.z : box.low.y;
  PartSkeleton root;
  root.joints.push_back({"Root", at, -1, true});
  root.joint_of.assign(mesh.vertices.size(), 0);
  root.front = votes.front;
  PredictedSkeleton made = skeleton_of_parts(std::move(root), votes.up_axis);
  take_the_place_of(votes, &made);
  made.front_confidence = votes.front_confidence;
  made.spread = votes.spread;
  made.usable = votes.usable;
  return made;
}

// A skeleton of the mesh's solid parts. False where it is not made of such, or votes know it well.
bool take_parts(const RigJobOptions& job, Character* character, PredictedSkeleton* skeleton) {
  if (job.method != RigMethod::kAuto || !skeleton->usable || *skeleton->usable >= kUnsureUsable) return false;
  if (!skeleton->scenery.empty()) return false;
  const bool front_sure = job.front != SINEW_FRONT_AUTO || skeleton->front_confidence >= kCoinToss;
  std::optional<PartSkeleton> parts = part_skeleton(*character, skeleton->up_axis, skeleton->front, front_sure);
  if (!parts) return false;
  const bool front_seen = parts->front_seen;
  PredictedSkeleton made = skeleton_of_parts(std::move(*parts), skeleton->up_axis);
  take_the_place_of(*skeleton, &made);
  made.front_confidence = front_seen ? kCoinToss : skeleton->front_confidence;
  *skeleton = std::move(made);
  const auto moving = std::count(skeleton->ends.begin(), skeleton->ends.end(), uint8_t{0});
  character->notes.push_back(
      "taken as a body of solid parts, a guess: " + std::to_string(moving) +
      " joints at the contacts of parts, named by position; look for another body with --method votes");
  say_direction(job, *skeleton, &character->notes);
  return true;
}

// Parts of the skeleton besides a body: fingers, and a face.
LabeledSkeleton add_details(const RigJobOptions& job, const sinew_model& hands, RiggedCharacter* rigged) {
  SkeletonOptions options;
  options.up_axis = rigged->skeleton.up_axis;
  for (std::string& note : predict_details(rigged->character, job.detail, hands, options, &rigged->skeleton))
    rigged->character.notes.push_back(std::move(note));
  LabeledSkeleton found = {rigged->skeleton.joints, rigged->skeleton.classes, rigged->skeleton.ends};
  for (uint8_t& one : found.classes)
    if (is_finger_class(one) || is_face_class(one) || is_prop_class(one)) one = kClassDetail;
  return found;
}

void put_own(const RigJobOptions& job, const RigModels& models, const LabeledSkeleton& found, RiggedCharacter* rigged) {
  FitOptions options;
  options.up_axis = rigged->skeleton.up_axis;
  options.keep_lengths = job.keep_lengths;
  const std::vector<Joint> own = job.own.empty() ? read_own_skeleton(job.skeleton) : job.own;
  if (job.detail == SkeletonDetail::kBody && models.hands != nullptr && has_fingers(own) &&
      !is_lone_hand(rigged->skeleton)) {
    SkeletonOptions hands;
    hands.up_axis = rigged->skeleton.up_axis;
    (void)predict_hands(rigged->character, *models.hands, hands, &rigged->skeleton);
  }
  rigged->fitted = fit_own_skeleton(own, job.skeleton, found, options, rigged->character, &rigged->skeleton);
  if (2 * rigged->fitted->matched < rigged->fitted->matchable)
    rigged->character.notes.push_back("warning: most joints of " + job.skeleton +
                                      " match nothing in this mesh; check them before use");
}

// Parts move as wholes. False where the skeleton is another one than that of the parts.
bool bind_parts(const RigJobOptions& job, RiggedCharacter* rigged) {
  const std::vector<uint32_t>& joints = rigged->skeleton.rigid_joints;
  if (joints.empty() || rigged->fitted || !job.edits.empty()) return false;
  rigged->character.influences.clear();
  for (const uint32_t joint : joints) rigged->character.influences.push_back({{joint, 1.0f}});
  return true;
}

void bind_rigged(const RigJobOptions& job, const RigModels& models, RiggedCharacter* rigged) {
  if (bind_parts(job, rigged)) return;
  BindOptions options;
  options.method = SINEW_METHOD_MODEL;
  options.model = models.bind;
  options.influence_count = job.influence_count;
  options.up_axis = rigged->skeleton.up_axis;
  options.rigid_parts = rigged->skeleton.rigid_joints.empty() ? job.rigid_parts : uint32_t{SINEW_RIGID_PARTS_ALWAYS};
  options.surface_vertices = job.surface_vertices;
  options.softness_percent = job.softness_percent;
  options.thread_count = job.thread_count;
  options.progress = job.progress;
  options.progress_user = job.progress_user;
  ThreadPool pool(job.thread_count);
  options.parallel_for = ThreadPool::parallel_for;
  options.parallel_user = &pool;
  Character& character = rigged->character;
  CharacterBind result = rigged->fitted ? bind_to_own(options, character, rigged->skeleton.scenery)
                                        : bind_to_prediction(rigged->skeleton, options, &character);
  character.influences = std::move(result.influences);
  rigged->bind_seconds = result.seconds;
  rigged->seams = std::move(result.seams);
  if (rigged->seams.seams.empty()) return;
  const size_t doubled = job.cut || !job.to_pose.empty() ? cut_seams(rigged->seams, &character) : 0;
  character.notes.push_back(seams_text(character.joints, rigged->seams, doubled));
}

// Chains for garments, in the character and in the skeleton that was predicted for it.
void lay_chains(const RigJobOptions& job, RiggedCharacter* rigged) {
  PredictedSkeleton& skeleton = rigged->skeleton;
  const size_t before = rigged->character.joints.size();
  for (const MadeChains& made : make_chains(job.influence_count, &rigged->character)) {
    rigged->character.notes.push_back(made_chains_text(made, rigged->character.joints));
    skeleton.confidence.resize(skeleton.confidence.size() + made.joints, made.certainty);
    skeleton.parent_confidence.resize(skeleton.parent_confidence.size() + made.joints, made.certainty);
  }
  skeleton.joints.insert(skeleton.joints.end(), rigged->character.joints.begin() + static_cast<std::ptrdiff_t>(before),
                         rigged->character.joints.end());
  const size_t count = skeleton.joints.size();
  skeleton.classes.resize(count, SINEW_CLASS_OTHER);
  skeleton.ends.resize(count, 0);
  skeleton.partners.resize(count, -1);
}

// The mesh and both of its skeletons in another rest pose.
void put_into_pose(const RestPose& pose, RiggedCharacter* rigged) {
  rigged->character = in_rest_pose(rigged->character, pose, rigged->skeleton.up_axis);
  std::map<std::string, Vec3> positions;
  for (const Joint& joint : rigged->character.joints) positions[joint.name] = joint.position;
  for (Joint& joint : rigged->skeleton.joints)
    if (const auto found = positions.find(joint.name); found != positions.end()) joint.position = found->second;
  if (rigged->fitted) rigged->fitted->joints = rigged->character.joints;
}

// Limbs that may be wrong by their votes, by name.
void say_doubts(RiggedCharacter* rigged) {
  rigged->doubtful = doubtful_limbs(rigged->skeleton);
  if (!rigged->doubtful.empty()) rigged->character.notes.push_back(doubts_text(rigged->doubtful));
}

void measure_gate(const RigJobOptions& job, RiggedCharacter* rigged) {
  rigged->gate_figures = gate_figures(rigged->character, rigged->skeleton);
  rigged->gate = gate_failures(rigged->gate_figures, job.bind);
  for (const std::string& line : rigged->gate) rigged->character.notes.push_back("gate: " + line);
}

}  // namespace

bool may_be_lone_hand(const RigJobOptions& job, const PredictedSkeleton& skeleton) {
  return job.method == RigMethod::kAuto && job.category == SINEW_CATEGORY_ANY && skeleton.spread > kHandSpread;
}

PredictedSkeleton predict_for_job(const RigJobOptions& job, const RigModels& models, Character* character) {
  if (job.category == SINEW_CATEGORY_VEHICLE) return vehicle_for_job(job, character);
  SkeletonOptions options;
  options.method = engine_method(job.method);
  if (options.method == SINEW_RIG_VOTES || options.method == SINEW_RIG_SLOTS) options.model = models.rig;
  options.category = job.category;
  options.axes_known = character->gltf != nullptr;  // y up, +z front
  options.up_axis = job.up.value_or(Axis::kY);
  const bool published = job.method == RigMethod::kSlots || job.method == RigMethod::kRegions;
  if (!published && models.front != nullptr) {
    options.front_model = models.front;
    options.find_up = !job.up;
  }
  options.front = job.front;
  options.mirror = job.mirror;
  options.spine_count = job.spine_count;
  options.toes = job.toes;
  options.ends = job.ends;
  PredictedSkeleton skeleton = predict_skeleton(*character, options);
  if (job.method == RigMethod::kAuto) {
    std::optional<PredictedSkeleton> sheet = sheet_skeleton(job, models, skeleton, character);
    if (sheet) {
      say_direction(job, *sheet, &character->notes);
      return *std::move(sheet);
    }
  }
  leave_scenery_out(options, character, &skeleton);
  if (take_parts(job, character, &skeleton)) return skeleton;
  if (models.hands != nullptr && may_be_lone_hand(job, skeleton) &&
      put_lone_hand(models, options, character, &skeleton))
    return skeleton;
  const bool told = job.category != SINEW_CATEGORY_ANY && !job.category_guessed;
  if (job.method == RigMethod::kAuto && !told && skeleton.spread > kNoBodySpread) {
    skeleton = root_alone(*character, skeleton);
    character->notes.push_back(
        "warning: this mesh matches no body, a guess, so it has one joint; find wheels and doors with --class vehicle, "
        "joints along the medial axis with --method shape, or the model's guess with --method votes");
  } else if (job.method == RigMethod::kSlots && skeleton.spread > kDoubtfulSlots) {
    character->notes.push_back(
        "warning: this mesh is unlike the training data, so joints may be wrong; check them, or try --method shape");
  } else if (skeleton.usable && *skeleton.usable < kDoubtfulUsable) {
    character->notes.push_back(
        "warning: this mesh is unlike the training data, so its joints may be wrong (usable with a probability of " +
        std::to_string(std::lround(100 * *skeleton.usable)) + " %); check them, or try --method shape");
  } else if (options.method == SINEW_RIG_VOTES && weak_parents(skeleton) > kMostGuessed) {
    character->notes.push_back("warning: most parents of joints are guesses; check the hierarchy");
  }
  say_direction(job, skeleton, &character->notes);
  return skeleton;
}

RiggedCharacter rig_character(Character mesh, PredictedSkeleton predicted, bool by_names, const RigJobOptions& job,
                              const RigModels& models) {
  if (!job.to_pose.empty() && !job.bind) throw Error("another rest pose needs weights; leave out --no-bind");
  if (job.cut && !job.bind) throw Error("seams need weights; leave out --no-bind");
  std::optional<RestPose> pose =
      job.to_pose.empty() ? std::nullopt : std::optional<RestPose>(read_rest_pose(job.to_pose));
  if (pose) pose->preferred = job.pose_preferred;
  RiggedCharacter rigged;
  rigged.character = std::move(mesh);
  rigged.skeleton = std::move(predicted);
  LabeledSkeleton found = by_names
                              ? label_skeleton(rigged.skeleton.joints)
                              : LabeledSkeleton{rigged.skeleton.joints, rigged.skeleton.classes, rigged.skeleton.ends};
  Character& character = rigged.character;
  character.up = rigged.skeleton.up_axis;
  if (job.detail != SkeletonDetail::kBody) found = add_details(job, *models.hands, &rigged);
  if (!job.skeleton.empty()) put_own(job, models, found, &rigged);
  edit_skeleton(job.edits, job.mirror != SINEW_MIRROR_NEVER, &rigged.skeleton);
  if (rigged.skeleton.usable) say_doubts(&rigged);
  if (!character.joints.empty())
    character.notes.push_back(
        "the file's own skeleton of " + std::to_string(character.joints.size()) + " joints was left out" +
        (has_vrm_data(character) ? ", with the VRM's bones and springs" : "") + "; sinew bind keeps it");
  character.joints = rigged.fitted && job.edits.empty() ? rigged.fitted->joints : rigged.skeleton.joints;
  character.influences.clear();
  if (job.bind) bind_rigged(job, models, &rigged);
  if (job.bind && job.detail == SkeletonDetail::kFull && !rigged.fitted) lay_chains(job, &rigged);
  if (pose) put_into_pose(*pose, &rigged);
  if (job.gate) measure_gate(job, &rigged);
  if (job.bind) add_checked_note(&character);
  return rigged;
}

RiggedCharacter rig_character(Character mesh, const RigJobOptions& job, const RigModels& models) {
  PredictedSkeleton predicted = predict_for_job(job, models, &mesh);
  return rig_character(std::move(mesh), std::move(predicted), false, job, models);
}

Character rig_bare_mesh(Character mesh) {
  const std::unique_ptr<LoadedModel> rig = load_model("", ModelUse::kRig), bind = load_model(""),
                                     hands = load_model("", ModelUse::kHands), front = load_front_model();
  const RigModels models = {&rig->model, &bind->model, &hands->model, front ? &front->model : nullptr};
  return rig_character(std::move(mesh), {}, models).character;
}

}  // namespace sinew
