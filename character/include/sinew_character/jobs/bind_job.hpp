// SPDX-License-Identifier: MIT
// The default job of `sinew bind` for one character: hierarchy, fit, choice of joints, hints, an example, a studio's
// style.
#ifndef SINEW_CHARACTER_BIND_JOB_HPP
#define SINEW_CHARACTER_BIND_JOB_HPP

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "sinew_character/bind/bind_character.hpp"
#include "sinew_character/style/style.hpp"
#include "sinew_formats/base/box.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

// The binder: a model with its name for summaries, or heat only if `model` is null.
struct Binder {
  const sinew_model* model = nullptr;
  std::string name = "heat";
  uint32_t method = SINEW_METHOD_HEAT;  // sinew_method without a model
};

// Weights of vertices that guide a bind, from a character with the same vertices; joints are matched by name.
struct BindHints {
  std::string name;  // the file, for messages
  std::vector<Joint> joints;
  std::vector<std::vector<Influence>> influences;  // [V] rows of given vertices; others are empty
};

struct BindJobOptions {
  JointsFrom joints = JointsFrom::kAuto;  // kNames if the skeleton is from another file than the mesh
  uint32_t influence_count = 4, thread_count = 1;
  Axis up_axis = Axis::kY;
  uint32_t rigid_parts = SINEW_RIGID_PARTS_AUTO, softness_percent = 100, surface_vertices = 32768;
  bool keep_tips = false, bind_props = false, fit = false, symmetric = false;
  bool cut = false;     // cut fused parts open: see cut_seams()
  bool seams = true;    // no weight across seams
  std::string to_pose;  // the rest pose of the result: "t", "a" or a file in that pose; empty: unchanged. Implies `cut`
  bool pose_preferred = false;  // see RestPose::preferred
  const JointChoice* choice =
      nullptr;  // result of an earlier prepare_joints(), if the weights have changed since the file was read
  std::vector<size_t>
      restored_joints;  // joints that may get weight although the choice left them out; `joint_flags` take precedence
  std::vector<uint8_t> joint_flags;  // [J] SINEW_JOINT_* of the user, or empty
  std::vector<uint8_t> scenery;      // PredictedSkeleton::scenery
  std::vector<uint8_t> locked;       // [V] non-zero: the vertex keeps its weights; or empty
  std::vector<uint8_t> hinted;       // [V] the same; its weights also guide its surroundings; or empty
  const BindHints* hints = nullptr;
  const Character* like = nullptr;  // a bound character as an example of weights
  std::string mesh;                 // file of the character, for messages
  sinew_progress progress = nullptr;
  void* progress_user = nullptr;
};

// Prepares a file's skeleton once: gives flat joint lists a hierarchy, and fits the skeleton into the mesh or warns,
// with notes in the character. Returns the joints that may get weight. Throws Error.
JointChoice prepare_joints(JointsFrom from, bool fit, Character* character);

// A character that can be bound repeatedly with different answers.
class BindJob {
 public:
  // Prepares the joints unless the options have a choice, and copies hints into the character. `character` must
  // outlive the job, the choice need not. Throws Error.
  BindJob(const BindJobOptions& options, const Binder& binder, Character* character);

  // Leaves the character unchanged. Throws Error.
  CharacterBind bind(const std::vector<sinew_answer>& answers, uint32_t question_count);
  // Gives the character the weights of a bind, cuts its seams and changes its rest pose, by the options. The bind
  // keeps its report, with a confidence for each vertex after the cut. Throws Error and then leaves the character
  // unchanged.
  void apply(CharacterBind* bound);
  // Answers of a style to the questions of a bind without answers.
  std::vector<sinew_answer> answers_of(const Style& style);
  // The rules of `style`, then those of the answers. Throws Error, which begins with `path`, if there are none.
  Style learned(Style style, const std::vector<sinew_answer>& answers, const std::string& path);
  // The bind without answers, with all its questions, for matching and making styles. Computed on first use.
  const CharacterBind& proposed();

  const JointChoice& choice() const { return choice_; }  // of the last bind

 private:
  BindJobOptions job_;
  CharacterBindOptions options_;
  Character* character_;
  JointChoice chosen_, choice_;  // before and after answers restore joints
  CharacterBind proposed_;
  bool has_proposed_ = false;
};

// Notes about joints without weight, tips merged into parents, and attached meshes.
std::vector<std::string> bind_notes(const Character& character, const JointChoice& choice, const CharacterBind& bound);

}  // namespace sinew
#endif
