// SPDX-License-Identifier: MIT
// The task of a training run. The run itself draws samples, steps and keeps the best weights, independent of the
// task.
#ifndef SINEW_TRAINER_RUN_TASK_HPP
#define SINEW_TRAINER_RUN_TASK_HPP

#include <memory>
#include <string>
#include <vector>

#include "network/layer_runner.hpp"
#include "sinew_formats/float_network.hpp"
#include "sinew_trainer/sample.hpp"

namespace sinew {

// Its functions may be called on several threads at a time. Samples are those that the run was given.
class TrainingTask {
 public:
  virtual ~TrainingTask() = default;

  // A network with seeded initial weights: its task number, inputs and layers.
  virtual FloatNetwork make_network() const = 0;
  // Throws Error when a network read from a file cannot be trained for this task.
  virtual void check(const FloatNetwork& network, const std::string& source) const { check_network(network, source); }
  // Changes the weights that a run starts from, made or given.
  virtual void prepare(FloatNetwork* /*network*/) const {}
  // The network that is validated and kept, of one that was trained.
  virtual FloatNetwork finished(const FloatNetwork& trained) const { return trained; }
  // Channels that are never dropped and channels that are always 0; shares and seed are the run's.
  virtual DropoutOptions channels() const { return {}; }

  // Runs the network on samples, for one thread.
  virtual std::unique_ptr<SampleRunner<float>> make_runner() const { return std::make_unique<LayerRunner<float>>(); }

  // Names of the numbers that loss() returns, for the log. The first is what training makes small.
  virtual std::vector<std::string> loss_names() const = 0;
  // The loss of a sample with the network's outputs of the runner's forward(). d_outputs: the gradient, overwritten.
  virtual std::vector<double> loss(const NetworkSample& sample, const std::vector<float>& outputs,
                                   std::vector<float>* d_outputs) const = 0;
  // The validation score: 0 or more, smaller is better.
  virtual std::string score_name() const = 0;
  virtual double score(const NetworkSample& sample, const std::vector<float>& outputs) const = 0;
  // The score to beat, of something that needs no training.
  virtual std::string baseline_name() const = 0;
  virtual double baseline_score(const NetworkSample& sample) const = 0;

  // The configuration as text for the checkpoint, and a saved one brought to the same form. A run is resumed only where
  // both are equal.
  virtual std::string config_text() const = 0;
  virtual std::string normalized_config(const std::string& saved, const std::string& /*source*/) const { return saved; }
};

// A task is asked about samples that it made itself, so their type is known.
template <class S>
const S& sample_as(const NetworkSample& sample) {
  return static_cast<const S&>(sample);
}

}  // namespace sinew
#endif
