// SPDX-License-Identifier: MIT
// Host-side use of the engine: a Character goes in, influences come out; and the engine's features for training.
#ifndef SINEW_TRAINER_BINDER_HPP
#define SINEW_TRAINER_BINDER_HPP

#include <cstdint>
#include <string>
#include <vector>

#include "sinew/sinew.h"
#include "sinew_formats/character.hpp"
#include "sinew_formats/checkpoint.hpp"
#include "sinew_trainer/network_sample.hpp"

namespace sinew {

struct BindOptions {
  sinew_method method = SINEW_METHOD_HEAT;
  const sinew_model* model = nullptr;
  uint32_t influence_count = 4;
  uint32_t up_axis = 0;
  std::vector<uint8_t> joint_flags;     // [J] SINEW_JOINT_* or empty
  std::vector<uint8_t> locked;          // [V] or empty; locked rows come from character.influences
  std::vector<uint8_t> hints;           // [V] or empty; the same, and their rows steer the vertices around them
  uint32_t rigid_parts = 0;             // sinew_rigid_parts
  uint32_t softness_percent = 100;      // of the model's weights
  uint32_t surface_vertices = 0;        // see sinew_options
  bool symmetric = false;               // mirrored vertices get mirrored rows
  uint32_t kernel = SINEW_KERNEL_AUTO;  // AUTO asks kernel_from_environment()
  sinew_progress progress = nullptr;
  void* progress_user = nullptr;
  uint32_t thread_count = 1;                  // pieces that the engine cuts its work into
  sinew_parallel_for parallel_for = nullptr;  // who runs them, see sinew_options
  void* parallel_user = nullptr;
};
struct BindResult {
  std::vector<std::vector<Influence>> influences;  // [V], weights unorm16 / 65535
  std::vector<uint8_t> confidence;                 // [V] 0..255, see sinew_options
  uint32_t symmetric_vertices = 0;                 // with BindOptions::symmetric
  size_t workspace_bytes = 0, used_bytes = 0;
  double seconds = 0;
};
// sinew_kernel that the environment variable SINEW_KERNEL names (ref, avx2, vnni, ...); AUTO without it. Throws Error,
// naming those that run here, for one that is unknown or that this build or processor lacks.
uint32_t kernel_from_environment();

// Through sinew.h alone. Throws Error with the status text and the character's name.
BindResult bind(const Character& character, const BindOptions& options);

// What bind's network sees of one character, plus the truth: one training sample. Its inputs are the engine's vertex and
// pair features (kVertexInput and kPairInput of features/features.hpp).
struct Sample : NetworkSample {
  std::vector<float> target;   // [U x K] reference weight of each candidate. A joint that is no candidate but whose end
                               // marker is (fold[end] == joint) has its weight on the first such end marker
  std::vector<uint32_t> fold;  // [J] fold_targets of the character
  std::vector<float> missing;  // [U] reference weight no candidate has
  std::vector<float>
      importance;           // [U] caller's vertices welded into this one (0 when unbound): the yardstick counts those
  std::vector<float> heat;  // [U x K] the finished rule field at the candidates (sums to <= 1)
  std::vector<uint32_t> vertex_to_welded;  // [V]
  std::vector<float> positions;            // [U x 3] in sides of the grid, 0..1
  std::vector<float> joint_positions;      // [J x 3] likewise
  std::vector<int32_t> parents;            // [J] -1 for roots
};
// Runs the engine's stages 1 to 7 on a character. feature_flags: of a network's feature set (other bits are ignored).
// Throws Error.
Sample make_sample(const Character& character, uint32_t candidates, uint32_t grid, uint32_t feature_flags = 0);

// Network output (probabilities per candidate [U x K]) to influences per caller vertex, `keep` largest, as the engine
// rounds.
std::vector<std::vector<Influence>> sample_influences(const Sample& sample, const std::vector<float>& probabilities,
                                                      uint32_t keep);
// One row cut to its `keep` largest and rounded to unorm16 / 65535 exactly as the engine rounds; empty for an empty
// row.
std::vector<Influence> round_influences(const std::vector<Influence>& row, uint32_t keep);

}  // namespace sinew
#endif
