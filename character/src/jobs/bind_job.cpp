// SPDX-License-Identifier: MIT
// A character from what its file says to its weights.
#include "sinew_character/jobs/bind_job.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "sinew_character/bind/engine_views.hpp"
#include "sinew_character/bind/transfer.hpp"
#include "sinew_character/check/check.hpp"
#include "sinew_character/motion/motion_map.hpp"
#include "sinew_character/pose/rest_pose.hpp"
#include "sinew_character/rig/skeleton_repair.hpp"
#include "sinew_formats/base/thread_pool.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/print.hpp"

namespace sinew {
namespace {

// Rows of the hints go where the mesh's own are.
void set_hints(const BindHints& painted, Character* character, std::vector<uint8_t>* hints) {
  std::vector<uint32_t> joint_of(painted.joints.size());
  for (size_t j = 0; j < painted.joints.size(); ++j) {
    const auto at = std::find_if(character->joints.begin(), character->joints.end(),
                                 [&](const Joint& joint) { return joint.name == painted.joints[j].name; });
    joint_of[j] = static_cast<uint32_t>(at - character->joints.begin());
  }
  hints->assign(character->vertices.size(), 0);
  character->influences.resize(character->vertices.size());
  size_t count = 0;
  for (size_t v = 0; v < painted.influences.size(); ++v) {
    if (painted.influences[v].empty()) continue;
    std::vector<Influence> row = painted.influences[v];
    for (Influence& influence : row) {
      if (joint_of[influence.joint] == character->joints.size()) {
        throw Error(painted.name + ": vertex " + std::to_string(v) + " is painted with joint " +
                    painted.joints[influence.joint].name + ", which the skeleton does not have");
      }
      influence.joint = joint_of[influence.joint];
    }
    character->influences[v] = std::move(row);
    (*hints)[v] = 1;
    ++count;
  }
  if (count == 0) throw Error(painted.name + ": has weights of no vertex; expected skin lines for some vertices");
}

// Weights of `job.like` that fit become hints.
void add_hints_like(const BindJobOptions& job, const Binder& binder, Character* character,
                    std::vector<uint8_t>* hints) {
  constexpr uint8_t kSure = 128;        // of 255
  constexpr uint32_t kCarried = 32768;  // half of a part's weights
  const Character& source = *job.like;
  Character target = *character;
  target.influences.clear();
  std::string mapped_by;
  const JointMapping mapping = find_joint_map(source, "", job.mesh, target, &mapped_by);
  TransferOptions options;
  options.model = binder.model;
  options.influence_count = job.influence_count;
  options.up_axis = options.source_up_axis = job.up_axis;
  options.thread_count = job.thread_count;
  ThreadPool pool(job.thread_count);
  options.parallel_for = ThreadPool::parallel_for;
  options.parallel_user = &pool;
  const TransferResult carried = transfer(source, target, mapping, options);
  hints->resize(character->vertices.size(), 0);
  character->influences.resize(character->vertices.size());
  size_t count = 0;
  for (size_t v = 0; v < hints->size(); ++v) {
    if ((*hints)[v] != 0 || (!job.locked.empty() && job.locked[v] != 0) || carried.confidence[v] < kSure ||
        carried.parts.at(carried.vertex_parts[v]).carried_q16 < kCarried)
      continue;
    character->influences[v] = carried.influences[v];
    (*hints)[v] = 1;
    ++count;
  }
  if (count == 0) hints->clear();
  character->notes.push_back(
      "like " + source.name + ": " + std::to_string(mapped_count(mapping)) + " joints mapped by " + mapped_by +
      print(", %.0f %% of the vertices keep its weights and guide the others",
            100.0 * static_cast<double>(count) / static_cast<double>(character->vertices.size())) +
      (count == 0 ? ": does not fit, or equals what sinew bind gives anyway" : ""));
}

// Joints that the user binds vertices to, by hints and by answers.
std::vector<size_t> answered_joints(const Character& character, const std::vector<uint8_t>& hints,
                                    const std::vector<sinew_answer>& answers) {
  std::vector<size_t> joints;
  for (const sinew_answer& answer : answers)
    if (answer.kind == SINEW_ANSWER_RIGID) joints.push_back(answer.joint);
  for (size_t v = 0; v < hints.size(); ++v) {
    if (hints[v] == 0) continue;
    for (const Influence& influence : character.influences[v]) joints.push_back(influence.joint);
  }
  std::sort(joints.begin(), joints.end());
  joints.erase(std::unique(joints.begin(), joints.end()), joints.end());
  return joints;
}

// Warns of a skeleton that lies elsewhere than its mesh, or mends it.
void bring_into_mesh(bool mend, Character* character) {
  const std::optional<SkeletonFit> fit = find_skeleton_fit(*character);
  if (!fit) return;
  if (mend) {
    apply_skeleton_fit(*fit, &character->joints);
    character->notes.push_back(fit->what + "; corrected by --fit");
  } else {
    character->notes.push_back("warning: " + fit->what + ", so the weights are probably wrong; correct it with --fit");
  }
}

// "slot: handslot.l, handslot.r; root: root", the reasons in the order of their first joint; --json names every joint.
std::string left_out_text(const Character& character, const JointChoice& choice) {
  constexpr size_t kMostNames = 200;  // of a reason
  std::vector<std::pair<std::string, std::vector<std::string>>> names;
  for (const LeftOutJoint& left : choice.left_out) {
    auto at = std::find_if(names.begin(), names.end(), [&](const auto& entry) { return entry.first == left.why; });
    if (at == names.end()) at = names.insert(names.end(), {left.why, {}});
    at->second.push_back(character.joints[left.joint].name);
  }
  std::string text;
  for (const auto& [why, joints] : names) {
    text += (text.empty() ? "" : "; ") + why + ": ";
    for (size_t j = 0; j < joints.size() && j < kMostNames; ++j) text += (j == 0 ? "" : ", ") + joints[j];
    if (joints.size() > kMostNames) text += " and " + std::to_string(joints.size() - kMostNames) + " more";
  }
  return text;
}

}  // namespace

JointChoice prepare_joints(JointsFrom from, bool fit, Character* character) {
  check_bindable(*character);  // before anything that takes longer the more joints there are
  if (const size_t given = infer_parents(&character->joints); given > 0)
    character->notes.push_back(std::to_string(given) +
                               " joints had no parent and got the nearest one along the body; check the hierarchy");
  bring_into_mesh(fit, character);
  return choose_joints(*character, from);
}

BindJob::BindJob(const BindJobOptions& job, const Binder& binder, Character* character)
    : job_(job), character_(character) {
  // Hints are no weights of the file: the choice comes first.
  chosen_ = job.choice != nullptr ? *job.choice : prepare_joints(job.joints, job.fit, character);
  job_.choice = nullptr;
  restore_joints(job.restored_joints, {}, &chosen_);
  apply_joint_flags(job.joint_flags, &chosen_);
  options_.keep_tips = job.keep_tips;
  options_.bind_props = job.bind_props;
  options_.scenery = job.scenery;
  BindOptions& options = options_.bind;
  options.method = binder.model == nullptr ? binder.method : uint32_t{SINEW_METHOD_MODEL};
  options.model = binder.model;
  options.influence_count = job.influence_count;
  options.up_axis = job.up_axis;
  options.locked = job.locked;
  options.hints = job.hinted;
  if (job.hints != nullptr) set_hints(*job.hints, character, &options.hints);
  if (job.like != nullptr) add_hints_like(job, binder, character, &options.hints);
  options.symmetric = job.symmetric;
  options.rigid_parts = job.rigid_parts;
  options.surface_vertices = job.surface_vertices;
  options.softness_percent = job.softness_percent;
  options.thread_count = job.thread_count;
  options.progress = job.progress;
  options.progress_user = job.progress_user;
}

CharacterBind BindJob::bind(const std::vector<sinew_answer>& answers, uint32_t question_count) {
  const Character& character = *character_;
  CharacterBindOptions character_options = options_;
  character_options.keep_apart = job_.seams;
  BindOptions& options = character_options.bind;
  options.answers = answers;
  options.question_count = question_count;
  choice_ = chosen_;
  restore_joints(answered_joints(character, options.hints, answers), job_.joint_flags, &choice_);
  for (const sinew_answer& answer : answers) {
    if (answer.kind == SINEW_ANSWER_RIGID && (choice_.flags[answer.joint] & SINEW_JOINT_NEVER) != 0)
      throw Error("answer rigid:" + character.joints[answer.joint].name + ": --never or --joints " +
                  "excludes this joint");
  }
  ThreadPool pool(options.thread_count);
  options.parallel_for = ThreadPool::parallel_for;
  options.parallel_user = &pool;
  return bind_character(character, choice_, character_options);
}

void BindJob::apply(CharacterBind* bound) {
  Character bare = *character_;
  if (job_.up_axis == Axis::kZ) bare.up = Axis::kZ;
  bare.influences = std::move(bound->influences);
  bare.confidence = bound->confidence;
  if (job_.cut || !job_.to_pose.empty()) bound->doubled_vertices = cut_seams(bound->seams, &bare);
  bound->confidence = std::exchange(bare.confidence, {});
  if (!job_.to_pose.empty()) {
    RestPose pose = read_rest_pose(job_.to_pose);
    pose.preferred = job_.pose_preferred;
    bare = in_rest_pose(bare, pose, job_.up_axis);
  }
  *character_ = std::move(bare);
  add_checked_note(character_);
}

const CharacterBind& BindJob::proposed() {
  if (!has_proposed_) proposed_ = bind({}, SINEW_MAX_QUESTIONS);
  has_proposed_ = true;
  return proposed_;
}

std::vector<sinew_answer> BindJob::answers_of(const Style& style) {
  const CharacterBind& asked = proposed();
  return answer_by_style(style, *character_, {asked.questions, asked.vertex_parts, job_.up_axis}, choice_.flags);
}

Style BindJob::learned(Style style, const std::vector<sinew_answer>& answers, const std::string& path) {
  const JointChoice kept = choice_;
  const CharacterBind& asked = proposed();
  choice_ = kept;
  style.sheets.push_back(learn_style(*character_, {asked.questions, asked.vertex_parts, job_.up_axis}, answers));
  if (style.sheets.back().rules.empty())
    throw Error(path +
                ": no answer to save; answer parts with --ask, or with --answer for those that --questions lists");
  return style;
}

std::vector<std::string> bind_notes(const Character& character, const JointChoice& choice, const CharacterBind& bound) {
  std::vector<std::string> notes;
  if (!choice.left_out.empty())
    notes.push_back(std::to_string(choice.left_out.size()) + " joints get no weight (" +
                    left_out_text(character, choice) + "); --joints all lets all have weight");
  if (bound.folded_tips > 0)
    notes.push_back(std::to_string(bound.folded_tips) +
                    " joints at chain ends gave their weight to their parents; --keep-tips keeps it");
  if (bound.kept_meshes > 0)
    notes.push_back(std::to_string(bound.kept_meshes) + " attached meshes kept as they are; --bind-props binds them");
  if (!bound.seams.seams.empty()) notes.push_back(seams_text(character.joints, bound.seams, bound.doubled_vertices));
  return notes;
}

}  // namespace sinew
