// SPDX-License-Identifier: MIT
// The layer list of engine/src/model/layers.hpp, run forward and backward, in float (training) or double (gradient tests).
#ifndef SINEW_TRAINER_NETWORK_LAYER_RUNNER_HPP
#define SINEW_TRAINER_NETWORK_LAYER_RUNNER_HPP

#include <cstdint>
#include <memory>
#include <vector>

#include "sinew_formats/float_network.hpp"
#include "sinew_trainer/sample.hpp"

namespace sinew {

class Team;
template <class Scalar>
struct FloatLayers;

template <class Scalar>
struct LinearBlock {
  std::vector<Scalar> weights;  // [out x in] row-major
  std::vector<Scalar> bias;     // [out]
};
// Zeros in the shapes of a network's parameters.
template <class Scalar>
std::vector<LinearBlock<Scalar>> zero_blocks(const FloatNetwork& network);
template <class Scalar>
std::vector<LinearBlock<Scalar>> copy_blocks(const FloatNetwork& network);

struct DropoutOptions {
  float activations = 0;  // share of the outputs of ReLU layers set to 0, the others scaled up
  float features = 0;     // probability of an input channel to be 0 for the whole sample
  float noise = 0;        // standard deviation of what is added to a channel of every second sample
  // Channels of each input: never dropped, and always 0. Inputs behind the last entry have none.
  std::vector<std::vector<uint32_t>> kept, absent;
  uint64_t seed = 0;
};

// Computes outputs of a sample, and gradients of parameters. One instance per thread; its memory is reused from call
// to call. The same input gives the same bytes on one machine.
template <class Scalar>
class SampleRunner {
 public:
  SampleRunner() = default;
  virtual ~SampleRunner() = default;
  SampleRunner(const SampleRunner&) = delete;
  SampleRunner& operator=(const SampleRunner&) = delete;

  // Threads that take rows of large layers while they are idle; null = none. Changes no number.
  virtual void set_team(Team* team) = 0;
  // `shape` has passed the task's check; its parameters are not read. Throws Error when network and sample do not fit
  // together.
  virtual const std::vector<Scalar>& forward(const FloatNetwork& shape,
                                             const std::vector<LinearBlock<Scalar>>& parameters,
                                             const NetworkSample& sample, const DropoutOptions& dropout) = 0;
  // After forward() with the same arguments. d_outputs as forward() returned; adds into gradients.
  virtual void backward(const FloatNetwork& shape, const std::vector<LinearBlock<Scalar>>& parameters,
                        const std::vector<Scalar>& d_outputs, std::vector<LinearBlock<Scalar>>* gradients) = 0;
};

// The layer list alone. Outputs are the last layer's rows: [U x C] or, in a domain with slots, [U x K x C] with absent slots
// 0. `shape` gives inputs, buffers and layers and has passed check_network().
template <class Scalar>
class LayerRunner : public SampleRunner<Scalar> {
 public:
  LayerRunner();
  ~LayerRunner() override;

  void set_team(Team* team) override;
  const std::vector<Scalar>& forward(const FloatNetwork& shape, const std::vector<LinearBlock<Scalar>>& parameters,
                                     const NetworkSample& sample, const DropoutOptions& dropout) override;
  void backward(const FloatNetwork& shape, const std::vector<LinearBlock<Scalar>>& parameters,
                const std::vector<Scalar>& d_outputs, std::vector<LinearBlock<Scalar>>* gradients) override;
  // Copies a buffer after forward(): [U x channels] or [U x K x channels], absent rows 0.
  void copy_buffer(const FloatNetwork& shape, uint16_t index, std::vector<Scalar>* out) const;

 private:
  std::unique_ptr<FloatLayers<Scalar>> state_;
};

extern template class LayerRunner<float>;
extern template class LayerRunner<double>;

}  // namespace sinew
#endif
