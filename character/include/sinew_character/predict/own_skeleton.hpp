// SPDX-License-Identifier: MIT
// The user's own skeleton, or a predicted one, in a mesh, and the bind of the mesh to it.
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
// Reads a skeleton from a file or template:NAME. Throws Error.
std::vector<Joint> read_own_skeleton(const std::string& source);

// Fits a skeleton into a mesh, to `found`, with the mesh's floor. Throws Error with the reason if it does not fit.
FittedSkeleton fit_into_mesh(const std::vector<Joint>& joints, const LabeledSkeleton& found, FitOptions options,
                             const Character& mesh);
// Replaces *skeleton by the user's own skeleton, fitted to `found`. Its fingers are fitted to those of *skeleton if
// it has any, and all of it if *skeleton is a hand without a body. Limbs of a template outside the mesh are removed.
// Its deform flags are kept.
//   source  file of the skeleton, for messages
FittedSkeleton fit_own_skeleton(const std::vector<Joint>& own, const std::string& source, const LabeledSkeleton& found,
                                FitOptions options, const Character& mesh, PredictedSkeleton* skeleton);

// Binds a mesh to its skeleton: the user's own, where names determine the deforming joints, or a predicted one, which
// becomes the character's and where all joints but bone ends deform.
//   scenery  PredictedSkeleton::scenery
CharacterBind bind_to_own(BindOptions options, const Character& character, const std::vector<uint8_t>& scenery);
CharacterBind bind_to_prediction(const PredictedSkeleton& skeleton, const BindOptions& options, Character* character);
// Chooses the joints of a predicted skeleton that may get weight in a mesh.
JointChoice choose_predicted(const PredictedSkeleton& skeleton, const Character& mesh);

}  // namespace sinew
#endif
