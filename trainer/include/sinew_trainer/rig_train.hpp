// SPDX-License-Identifier: MIT
// Training runs for skeleton prediction (task "rig").
#ifndef SINEW_TRAINER_RIG_TRAIN_HPP
#define SINEW_TRAINER_RIG_TRAIN_HPP

#include <map>
#include <string>

#include "sinew_trainer/train.hpp"

namespace sinew {

// Read from and written to JSON (unknown keys are an Error). trainer/configs/votes.json, votes_more.json and
// votes_grown.json trained the bundled model.
struct RigTrainConfig : RunConfig {
  RigTrainConfig();
  std::string architecture = "votes";  // or "slots", the published method, or "front", where a mesh faces
  uint32_t width = 64;                 // channels
  uint32_t rounds = 4;                 // of neighbors
  // "body": skeletons without fingers; "hands": the fingers of hands that were cut out (votes only).
  std::string part = "body";
  // Samples of a character beside two of itself: posed and stretched by its own weights, a third of them half as strongly.
  uint32_t variants = 12;
  // 0: every character has as many. Else so many at least, and of `variants` the share that a character is drawn with: n to the
  // power of family_power - 1 for one of n in its family.
  uint32_t least_variants = 0;
  // Bodies: shares of these, 0 to 1, in poses as meshes of strangers have (src/data/rig_pose.hpp), fused to one closed
  // shell (src/data/grown_shell.hpp), with double walls, and with specks (src/data/rough_surface.hpp), and as
  // pictures of them are (src/data/silhouette.hpp).
  double wide = 0, grown = 0, walls = 0, specks = 0, pictures = 0;
  // Synthetic characters of each body plan (trainer/data_sets/src/synth), as families of their own.
  uint32_t synthetic = 20;
  // Votes of bodies: so many things that are no body, each in several samples, as a family "thing" (src/data/thing_sample.hpp).
  uint32_t things = 0;
  // Slots: what the error of joints counts, 0 to 1; that of connections counts the rest.
  double balance = 0.7;
  // Slots: "published", plain mean absolute errors; or "balanced" (src/run/rig_loss.hpp).
  std::string losses = "published";
  // Characters that are not trained on, by name (a * at the end represents any rest), and why.
  std::map<std::string, std::string> leave_out;
};
inline bool is_hands(const RigTrainConfig& config) { return config.part == "hands"; }
// Defaults of the architecture "front".
RigTrainConfig front_train_config();
RigTrainConfig parse_rig_config(const std::string& json, const std::string& source);
std::string rig_config_json(const RigTrainConfig& config);

// As train(): samples of options.data_dir, checkpoint, log, --resume. Samples are made anew in every run, which takes less
// time than reading them; options.cache_dir is not used.
void train_rig(const RigTrainConfig& config, const TrainOptions& options);

}  // namespace sinew
#endif
