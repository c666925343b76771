// SPDX-License-Identifier: MIT
// What `sinew bind` does with one character by default: the hierarchy and the fit, which joints, hints, an example, a studio's style.
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

// Who binds: the model with the name that a summary gives it, or heat alone where `model` is null.
struct Binder {
  const sinew_model* model = nullptr;
  std::string name = "heat";
  uint32_t method = SINEW_METHOD_HEAT;  // sinew_method without a model
};

// Vertices' weights that steer a bind, of a character with the same vertices; joints are matched by name.
struct BindHints {
  std::string name;  // the file, for messages
  std::vector<Joint> joints;
  std::vector<std::vector<Influence>> influences;  // [V] rows of painted vertices, others are empty
};

struct BindJobOptions {
  JointsFrom joints = JointsFrom::kAuto;  // of a skeleton of another file than the mesh's: kNames
  uint32_t influence_count = 4, thread_count = 1;
  Axis up_axis = Axis::kY;
  uint32_t rigid_parts = SINEW_RIGID_PARTS_AUTO, softness_percent = 100, surface_vertices = 32768;
  bool keep_tips = false, bind_props = false, fit = false, symmetric = false;
  bool cut = false;   // what has grown together is opened: see cut_seams()
  bool seams = true;  // no weight across what has grown together
  std::string
      to_pose;  // the rest pose of what is written: "t", "a" or a file that stands so; empty: as it stands. Cuts as well
  const JointChoice* choice = nullptr;  // of prepare_joints() before, where the weights of now are no more the file's
  std::vector<size_t>
      restored_joints;  // joints that may get weight though the choice left them out; `joint_flags` come after it
  std::vector<uint8_t> joint_flags;  // [J] SINEW_JOINT_* of the user, or empty
  std::vector<uint8_t> scenery;      // PredictedSkeleton::scenery
  std::vector<uint8_t> locked;       // [V] non-zero: keeps its weights; or empty
  std::vector<uint8_t> hinted;       // [V] the same, and they steer their surroundings; or empty
  const BindHints* hints = nullptr;
  const Character* like = nullptr;  // a bound character whose weights show how they are wanted
  std::string mesh;                 // file of the character, for messages
  sinew_progress progress = nullptr;
  void* progress_user = nullptr;
};

// What is done once with a file's skeleton: gives flat joint lists a hierarchy, brings the skeleton into the mesh or warns, all told in the
// character's notes. Returns which joints may get weight. Throws Error.
JointChoice prepare_joints(JointsFrom from, bool fit, Character* character);

// A character that is bound any number of times, each time with more answers.
class BindJob {
 public:
  // Prepares the joints unless they have a choice, and puts rows of hints into the character. `character` must outlive the job, the choice
  // need not. Throws Error.
  BindJob(const BindJobOptions& options, const Binder& binder, Character* character);

  // The character is as it was. Throws Error.
  CharacterBind bind(const std::vector<sinew_answer>& answers, uint32_t question_count);
  // Gives the character the weights of a bind, opens its seams and puts it into another rest pose, as the options say. The bind keeps what
  // is told about it, with a confidence for every vertex that there is now. Throws Error; the character is as it was then.
  void apply(CharacterBind* bound);
  // Answers of a style for the parts that a bind without them asks about.
  std::vector<sinew_answer> answers_of(const Style& style);
  // The rules that answers make, with `style`'s before them. Throws Error, which begins with `path`, where there are none.
  Style learned(Style style, const std::vector<sinew_answer>& answers, const std::string& path);
  // The bind without answers, with all its questions: what a style is matched with and made of. Made when it is first asked for.
  const CharacterBind& proposed();

  const JointChoice& choice() const { return choice_; }  // of the last bind

 private:
  BindJobOptions job_;
  CharacterBindOptions options_;
  Character* character_;
  JointChoice chosen_, choice_;  // before answers take joints back, and after
  CharacterBind proposed_;
  bool has_proposed_ = false;
};

// Lines about joints that get no weight, folded tips, attached meshes.
std::vector<std::string> bind_notes(const Character& character, const JointChoice& choice, const CharacterBind& bound);

}  // namespace sinew
#endif
