// SPDX-License-Identifier: MIT
// The skeleton that the character on the page has: the file's, a predicted one, an edited one.
#ifndef SINEW_WEB_RIGS_HPP
#define SINEW_WEB_RIGS_HPP

#include <cstdint>
#include <optional>
#include <vector>

#include "sinew_character/bind/bind_character.hpp"
#include "sinew_character/predict/edit_skeleton.hpp"
#include "sinew_character/predict/predict_skeleton.hpp"
#include "sinew_formats/character.hpp"

namespace sinew::web {

struct Rig {
  std::vector<Joint> joints;
  JointChoice choice;
  std::optional<PredictedSkeleton> skeleton;  // what edits change; none for a skin of a glTF, which keeps its joints
  bool predicted = false;                     // by the model, and then edited or not
};

// The rig of a mesh's file: its joints as they are, or none. `choice` is of these joints.
Rig rig_of_file(const Character& character, JointChoice choice);
// A predicted rig, bound as `sinew rig` binds it: every joint but bone ends, and those keep no weight.
Rig predicted_rig(const Character& character, PredictedSkeleton skeleton);

class Rigs {
 public:
  // A character that was opened; what was there before is forgotten.
  void start(Rig rig);
  const Rig& now() const { return now_; }
  // Another one; with `continues` in the place of the present one, as all moves of a drag are one step.
  void put(Rig rig, bool continues);
  // The present rig with these edits. `continues`: edits apply to the rig before the present step.
  // Throws Error as edit_skeleton() does, and for a rig that is not edited; then nothing has changed.
  void edit(const Character& character, const std::vector<SkeletonEdit>& edits, bool mirror, bool continues);

 private:
  Rig now_;
  std::optional<Rig> before_;
};

}  // namespace sinew::web
#endif
