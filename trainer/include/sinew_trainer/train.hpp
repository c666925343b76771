// SPDX-License-Identifier: MIT
// Training runs: data set cache, sampling by family, loss, optimizer, checkpoints.
#ifndef SINEW_TRAINER_TRAIN_HPP
#define SINEW_TRAINER_TRAIN_HPP

#include <atomic>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "sinew_formats/checkpoint.hpp"
#include "sinew_trainer/evaluate.hpp"
#include "sinew_trainer/network.hpp"
#include "sinew_trainer/sample.hpp"

namespace sinew {

class Ranks;  // ranks.hpp

// Options of a run of any task.
struct RunConfig {
  std::string optimizer = "adamw";  // "adamw", "adam", "sgd"
  double learning_rate = 1.5e-3, weight_decay = 0.02, momentum = 0.9, clip = 1.0, dropout = 0.05;
  double feature_dropout = 0.03;  // probability of an input channel to be missing from a whole sample
  double feature_noise = 0;       // standard deviation of what is added to an input channel of every second sample
  uint64_t steps = 2400;          // length of the cosine schedule
  uint32_t batch = 2;             // samples per step, one per thread
  uint64_t seed = 1;
  double average_decay = 0.999;  // running average of weights; 0 = off
  // Share of the weights of --init in the finished network. Between two networks of one start the path is smooth:
  // half of each keeps most of a new style and most of what was known.
  double init_share = 0;
  uint32_t validate_every = 300;  // steps
  // Stop after so many validations without a new best: of the score, or without validation samples of the mean loss since
  // the one before; 0 = off.
  uint32_t patience = 0;
  // Stop as soon as a validation's score, or without validation samples the mean loss since the one before, is below this;
  // 0 = off.
  double stop_below = 0;
  double variant_share = 0.4;  // how often one of a character's variants is drawn instead of the original
  double family_power = 0.5;   // a family of n characters is drawn in proportion to n^power
  std::map<std::string, double> family_shares;  // of all draws, for families that are not to follow that rule
};

// Options of a run for skin weights; read from and written to JSON (unknown keys are an Error). The defaults are
// those of the first runs; trainer/configs/field.json, which trained the bundled model, names what it has otherwise.
struct TrainConfig : RunConfig {
  std::string architecture = "field";
  FieldOptions field;
  // Features of a vertex and its candidates: "own", all features, heat weights among them; "published" (classic
  // only), positions, normals, Laplacian, curvatures, distances to joints and, with `spectral`, signatures.
  std::string attributes = "own";
  uint32_t block_layers = 1;  // of classic: linear layers with ReLU in each of its multi-layer perceptrons
  bool spectral = false;      // heat-kernel and wave-kernel signatures as vertex features as well
  // Input channels that the network does without (field only): "vertex.NAME", "pair.NAME", NAME as in
  // engine/src/features/channels.hpp; a * at the end represents any rest. The finished network's weights for them are
  // 0.
  std::vector<std::string> without;
  // Characters that are not trained on, by name (a * at the end represents any rest), and why: labels that teach wrong.
  std::map<std::string, std::string> leave_out;
  double loss_kl = 0.5, loss_l1 = 1.0, loss_regret = 2.0, loss_part = 0.5, loss_deformation = 10;
  // Share of the learned change of heat's logits that the finished network keeps (field only). Below 1 it is worse on
  // the families it was trained on and better on new ones: trainer/configs/RESULTS.md has the figures.
  double correction = 0.7;
  // Augmentation with recomputed features: variants made once per character and cached (rotate, mirror, scale,
  // jitter, decimation).
  uint32_t variants = 2;
  // Training characters with more vertices than this are decimated to about as many; 0 = off. Large characters cost the
  // most and teach the least per vertex. Validation and measurements always take them whole.
  uint32_t vertex_limit = 2000;
  // Synthetic characters of each body plan (trainer/data_sets/src/synth) beside those of the folder, as families of their
  // own.
  uint32_t synthetic = 12;
};
// Flags of the feature set that the configuration's networks and samples have.
uint32_t feature_flags(const TrainConfig& config);
TrainConfig parse_train_config(const std::string& json, const std::string& source);
std::string train_config_json(const TrainConfig& config);

struct TrainOptions {
  std::string data_dir, val_dir;  // val_dir may be empty
  std::string output;             // checkpoint path; log beside it as OUTPUT.csv
  std::string cache_dir;          // features; empty = OUTPUT.cache
  std::string init;               // checkpoint to start from, or empty
  bool resume = false;
  double minutes = 0;  // stop after so much wall time (the schedule is by time then); 0 = by steps
  uint32_t threads = 2;
  bool quiet = false;
  std::string label;                   // in front of progress lines, for runs side by side; empty = none
  std::vector<std::string> leave_out;  // families that are not drawn
  const std::atomic<uint32_t>* threads_now = nullptr;  // when set, read before every step: 1 .. `threads`
  Ranks* ranks = nullptr;                   // of mpirun: they share each batch, rank 0 alone writes files; null = one
  uint64_t stop_after = 0;                  // stop after so many steps of this call, to be resumed; 0 = off
  const std::atomic<bool>* stop = nullptr;  // set it (from a signal handler, say) to write the checkpoint and return
};
// Sources of a run's samples.
struct TrainingSet {
  std::vector<std::vector<Sample>> characters;  // each: the original, then its variants
  std::vector<std::string> families;            // [characters]
};
// The samples of options.data_dir from the cache; features that are missing there are made. Throws Error when none has
// weights.
TrainingSet load_training_set(const TrainConfig& config, const TrainOptions& options);

// Makes the features that the cache lacks, of data_dir and val_dir, and keeps nothing in memory: the part-th (from 0)
// of `parts` processes that fill one cache at the same time. Returns how many it made.
size_t fill_feature_cache(const TrainConfig& config, const TrainOptions& options, uint32_t part, uint32_t parts);

// Runs to the end; writes the checkpoint at every validation and at the end. With `resume` the output is read first and
// the result is, byte for byte on one machine, that of a run that was never interrupted (by steps; time is never the
// same twice). Threads and ranks change no number. Throws Error: other configuration than the resumed one, other shapes
// than `init`, no usable data.
void train(const TrainConfig& config, const TrainOptions& options);
// The same on samples that are loaded already, which several runs may share. options.data_dir is not read.
void train(const TrainConfig& config, const TrainOptions& options, const TrainingSet& set);
// The configuration a checkpoint was trained with, for --resume without --config.
TrainConfig checkpoint_config(const std::string& path);
// Another share of the correction for a finished network, without training again: `network` and its configuration
// change, what --resume goes on from does not. `source` names it in errors. Throws Error when the checkpoint has no
// configuration or its network no correction.
void change_correction(double correction, const std::string& source, Checkpoint* checkpoint);

// Loads (or makes and caches) the samples of a folder; both cores. Characters that fail are reported on stderr and left
// out.
std::vector<Sample> load_samples(const std::string& folder, uint32_t candidates, uint32_t grid,
                                 const std::string& cache_dir, uint32_t threads, bool quiet,
                                 uint32_t feature_flags = 0);

}  // namespace sinew
#endif
