// SPDX-License-Identifier: MIT
// A skeleton of the user's own, or a predicted one, in a mesh, and the bind of the mesh to it.
#ifndef SINEW_CHARACTER_OWN_SKELETON_HPP
#define SINEW_CHARACTER_OWN_SKELETON_HPP

#include <string>
#include <vector>

#include "sinew_character/bind/bind_character.hpp"
#include "sinew_character/predict/fit_skeleton.hpp"
#include "sinew_character/predict/predict_skeleton.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

bool is_template(const std::string& source);  // template:NAME
// Of a file or template:NAME. Throws Error.
std::vector<Joint> read_own_skeleton(const std::string& source);

// A skeleton put into a mesh, where `found` is; its floor is the mesh's. Throws Error that says what does not fit.
FittedSkeleton fit_into_mesh(const std::vector<Joint>& joints, const LabeledSkeleton& found, FitOptions options,
                             const Character& mesh);
// A user's own skeleton put where `found` is, in place of *skeleton. Its fingers go where those of *skeleton are, if that has some, and all of it
// where that is a hand without a body. A template has no limb beside the mesh. What its joints deform stays as it says.
//   source  its file, for messages
FittedSkeleton fit_own_skeleton(const std::vector<Joint>& own, const std::string& source, const LabeledSkeleton& found,
                                FitOptions options, const Character& mesh, PredictedSkeleton* skeleton);

// Binds a mesh to the skeleton that it was given: a user's own, whose names say which joints deform, or a predicted one,
// which becomes the character's and whose joints all do but for bone ends.
//   scenery  PredictedSkeleton::scenery
CharacterBind bind_to_own(BindOptions options, const Character& character, const std::vector<uint8_t>& scenery);
CharacterBind bind_to_prediction(const PredictedSkeleton& skeleton, const BindOptions& options, Character* character);
// The joints of a predicted skeleton that may get weight in a mesh, whatever joints that has.
JointChoice choose_predicted(const PredictedSkeleton& skeleton, const Character& mesh);

}  // namespace sinew
#endif
