// SPDX-License-Identifier: MIT
// Forward, loss and backward of a batch on several threads and ranks.
#include "run/batch_gradient.hpp"

#include <algorithm>
#include <chrono>
#include <numeric>

namespace sinew {
namespace {

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

// The largest first, so that threads and ranks end at about the same time.
std::vector<size_t> by_size(const std::vector<const NetworkSample*>& samples) {
  std::vector<size_t> order(samples.size());
  std::iota(order.begin(), order.end(), size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](size_t a, size_t b) { return samples[a]->vertices > samples[b]->vertices; });
  return order;
}

template <class Visit>
void visit_numbers(std::vector<LinearBlock<float>>& blocks, Visit&& visit) {
  for (LinearBlock<float>& block : blocks) {
    visit(block.weights);
    visit(block.bias);
  }
}

}  // namespace

BatchGradient::BatchGradient(const TrainingTask& task, const RunConfig& config, uint32_t threads, Ranks* ranks)
    : task_(task), dropout_(task.channels()), ranks_(ranks) {
  dropout_.activations = static_cast<float>(config.dropout);
  dropout_.features = static_cast<float>(config.feature_dropout);
  dropout_.noise = static_cast<float>(config.feature_noise);
  for (uint32_t t = 0; t < std::max(threads, 1u); ++t) {
    runners_.push_back(task.make_runner());
    runners_.back()->set_team(&team_);
  }
}

// Each goes to the rank that has the fewest vertices so far.
std::vector<uint32_t> BatchGradient::owners(const std::vector<const NetworkSample*>& samples) const {
  std::vector<uint32_t> owner(samples.size(), 0);
  if (ranks_ == nullptr || ranks_->size() == 1) return owner;
  std::vector<uint64_t> load(ranks_->size(), 0);
  for (const size_t i : by_size(samples)) {
    owner[i] = static_cast<uint32_t>(std::min_element(load.begin(), load.end()) - load.begin());
    load[owner[i]] += samples[i]->vertices;
  }
  return owner;
}

const std::vector<LinearBlock<float>>& BatchGradient::run(const FloatNetwork& network,
                                                          const std::vector<BatchItem>& items, uint32_t threads,
                                                          std::vector<std::vector<double>>* losses) {
  const double start = now();
  while (slots_.size() < items.size()) {
    slots_.emplace_back();
    slots_.back().gradients = zero_blocks<float>(network);
  }
  slots_.resize(items.size());
  std::vector<const NetworkSample*> samples;
  for (const BatchItem& item : items) samples.push_back(item.sample);
  const std::vector<uint32_t> owner = owners(samples);
  const uint32_t rank = ranks_ == nullptr ? 0 : ranks_->rank();
  std::vector<size_t> mine;
  for (const size_t i : by_size(samples)) {
    if (owner[i] == rank) mine.push_back(i);
  }
  const std::vector<LinearBlock<float>> parameters = copy_blocks<float>(network);
  team_.run(mine.size(), std::min<uint32_t>(threads, static_cast<uint32_t>(runners_.size())),
            [&](size_t i, unsigned thread) {
              Slot& slot = slots_[mine[i]];
              const BatchItem& item = items[mine[i]];
              DropoutOptions dropout = dropout_;
              dropout.seed = item.seed;
              const std::vector<float>& outputs = runners_[thread]->forward(network, parameters, *item.sample, dropout);
              slot.losses = task_.loss(*item.sample, outputs, &slot.d_outputs);
              visit_numbers(slot.gradients, [](std::vector<float>& v) { std::fill(v.begin(), v.end(), 0.0f); });
              runners_[thread]->backward(network, parameters, slot.d_outputs, &slot.gradients);
            });
  if (ranks_ != nullptr && ranks_->size() > 1) exchange(owner);
  losses->clear();
  for (const Slot& slot : slots_) losses->push_back(slot.losses);

  std::vector<LinearBlock<float>>& sum = slots_[0].gradients;
  const float share = 1.0f / static_cast<float>(items.size());
  for (size_t block = 0; block < sum.size(); ++block) {
    const auto mean = [&](auto member) {
      std::vector<float>& total = sum[block].*member;
      for (size_t i = 1; i < slots_.size(); ++i) {
        const std::vector<float>& other = slots_[i].gradients[block].*member;
        for (size_t k = 0; k < total.size(); ++k) total[k] += other[k];
      }
      for (float& g : total) g *= share;
    };
    mean(&LinearBlock<float>::weights);
    mean(&LinearBlock<float>::bias);
  }
  wall_seconds_ += now() - start;
  return sum;
}

// Every rank gets every item's gradient, so that all add them in the same order. Sending sums would move less, but what
// a network this small costs there is a thousandth of a step.
void BatchGradient::exchange(const std::vector<uint32_t>& owner) {
  size_t numbers = 0;
  visit_numbers(slots_[0].gradients, [&](const std::vector<float>& v) { numbers += v.size(); });
  std::vector<float> gradients;
  std::vector<double> losses;
  const size_t loss_count = task_.loss_names().size();
  std::vector<size_t> counts(ranks_->size(), 0), loss_counts(ranks_->size(), 0);
  for (size_t i = 0; i < slots_.size(); ++i) {
    counts[owner[i]] += numbers;
    loss_counts[owner[i]] += loss_count;
    if (owner[i] != ranks_->rank()) continue;
    visit_numbers(slots_[i].gradients,
                  [&](const std::vector<float>& v) { gradients.insert(gradients.end(), v.begin(), v.end()); });
    losses.insert(losses.end(), slots_[i].losses.begin(), slots_[i].losses.end());
  }
  gradients = ranks_->gather(gradients, counts);
  losses = ranks_->gather(losses, loss_counts);
  size_t at = 0, loss_at = 0;
  for (uint32_t rank = 0; rank < ranks_->size(); ++rank) {
    for (size_t i = 0; i < slots_.size(); ++i) {
      if (owner[i] != rank) continue;
      visit_numbers(slots_[i].gradients, [&](std::vector<float>& v) {
        std::copy_n(gradients.begin() + static_cast<std::ptrdiff_t>(at), v.size(), v.begin());
        at += v.size();
      });
      slots_[i].losses.resize(loss_count);
      for (double& loss : slots_[i].losses) loss = losses[loss_at++];
    }
  }
}

std::vector<double> BatchGradient::scores(const FloatNetwork& network, const std::vector<const NetworkSample*>& samples,
                                          uint32_t threads) {
  const std::vector<uint32_t> owner = owners(samples);
  const uint32_t rank = ranks_ == nullptr ? 0 : ranks_->rank();
  std::vector<size_t> mine;
  for (const size_t i : by_size(samples)) {
    if (owner[i] == rank) mine.push_back(i);
  }
  const std::vector<LinearBlock<float>> parameters = copy_blocks<float>(network);
  std::vector<double> result(samples.size(), 0.0);
  team_.run(mine.size(), std::min<uint32_t>(threads, static_cast<uint32_t>(runners_.size())),
            [&](size_t i, unsigned thread) {
              const NetworkSample& sample = *samples[mine[i]];
              result[mine[i]] = task_.score(sample, runners_[thread]->forward(network, parameters, sample, {}));
            });
  if (ranks_ != nullptr) ranks_->maximum(&result);  // what other ranks did is 0 here, and no score is below 0
  return result;
}

}  // namespace sinew
