// SPDX-License-Identifier: MIT
// What sinew rig lets a user say about the skeleton: edits, and one of their own.
#ifndef SINEW_CLI_RIG_SKELETON_HPP
#define SINEW_CLI_RIG_SKELETON_HPP

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sinew_character/bind_character.hpp"
#include "sinew_character/edit_skeleton.hpp"
#include "sinew_character/fit_skeleton.hpp"
#include "sinew_character/label_skeleton.hpp"
#include "sinew_formats/character.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace sinew::cli {

// --move, --add, --remove, --parent, --rename: each any number of times.
class EditOptions {
 public:
  explicit EditOptions(CLI::App* sub);  // declares them
  // As on the command line. Throws UsageError.
  std::vector<SkeletonEdit> in_order() const;

 private:
  struct One {
    EditKind kind;
    CLI::Option* option;
    std::shared_ptr<std::vector<std::string>> texts;
  };
  CLI::App* sub_;
  std::vector<One> options_;
};

// Throws UsageError for a template that does not exist and for a mesh. Called before any work.
void check_skeleton_source(const std::string& source);

// A skeleton put into a mesh, where `found` is; its floor is the mesh's. Throws Error that says what does not fit.
FittedSkeleton fit_into_mesh(const std::vector<Joint>& joints, const LabelledSkeleton& found, FitOptions options,
                             const Character& mesh);
// The skeleton of a file or template:NAME put where `found` is, in place of *skeleton. What its joints deform stays as the
// file says.
FittedSkeleton fit_own_skeleton(const std::string& source, const LabelledSkeleton& found, FitOptions options,
                                const Character& mesh, PredictedSkeleton* skeleton);

// Binds a mesh to the skeleton that it was given: a user's own, whose names say which joints deform, or a predicted one,
// which becomes the character's and whose joints all do but for bone ends.
CharacterBind bind_to_own(BindOptions options, const Character& character);
CharacterBind bind_to_prediction(const PredictedSkeleton& skeleton, const BindOptions& options, Character* character);

}  // namespace sinew::cli
#endif
