// SPDX-License-Identifier: MIT
// Forward, loss and backward of a batch on several threads and ranks.
#include "run/batch_gradient.hpp"

#include <algorithm>
#include <chrono>
#include <numeric>

#include "features/features.hpp"
#include "sinew_trainer/network.hpp"

namespace sinew {
namespace {

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

// The largest first, so that threads and ranks end at about the same time.
std::vector<size_t> by_size(const std::vector<const Sample*>& samples) {
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

BatchGradient::BatchGradient(const TrainConfig& config, uint32_t threads, Ranks* ranks)
    : config_(config),
      loss_{config.loss_kl, config.loss_l1, config.loss_regret, config.loss_part, config.loss_deformation},
      absent_(absent_channels(config.without, "configuration")),
      ranks_(ranks) {
  for (uint32_t t = 0; t < std::max(threads, 1u); ++t) {
    runners_.push_back(std::make_unique<LayerRunner<float>>());
    runners_.back()->set_team(&team_);
  }
}

// Each goes to the rank that has the fewest vertices so far.
std::vector<uint32_t> BatchGradient::owners(const std::vector<const Sample*>& samples) const {
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
                                                          std::vector<LossTerms>* terms) {
  const double start = now();
  while (slots_.size() < items.size()) {
    slots_.emplace_back();
    slots_.back().gradients = zero_blocks<float>(network);
  }
  slots_.resize(items.size());
  std::vector<const Sample*> samples;
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
              DropoutOptions dropout;
              dropout.activations = static_cast<float>(config_.dropout);
              dropout.features = static_cast<float>(config_.feature_dropout);
              dropout.kept_pair_features = {kPairLogRule, kPairLogParts};
              dropout.absent_vertex_features = absent_.vertex;
              dropout.absent_pair_features = absent_.pair;
              dropout.seed = item.seed;
              const std::vector<float>& logits = runners_[thread]->forward(network, parameters, *item.sample, dropout);
              slot.terms = weight_loss(*item.sample, loss_, logits, &slot.d_logits);
              visit_numbers(slot.gradients, [](std::vector<float>& v) { std::fill(v.begin(), v.end(), 0.0f); });
              runners_[thread]->backward(network, parameters, slot.d_logits, &slot.gradients);
            });
  if (ranks_ != nullptr && ranks_->size() > 1) exchange(owner);
  terms->clear();
  for (const Slot& slot : slots_) terms->push_back(slot.terms);

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
  std::vector<double> terms;
  std::vector<size_t> counts(ranks_->size(), 0), term_counts(ranks_->size(), 0);
  for (size_t i = 0; i < slots_.size(); ++i) {
    counts[owner[i]] += numbers;
    term_counts[owner[i]] += slots_[i].terms.all().size();
    if (owner[i] != ranks_->rank()) continue;
    visit_numbers(slots_[i].gradients,
                  [&](const std::vector<float>& v) { gradients.insert(gradients.end(), v.begin(), v.end()); });
    for (const double* term : slots_[i].terms.all()) terms.push_back(*term);
  }
  gradients = ranks_->gather(gradients, counts);
  terms = ranks_->gather(terms, term_counts);
  size_t at = 0, term_at = 0;
  for (uint32_t rank = 0; rank < ranks_->size(); ++rank) {
    for (size_t i = 0; i < slots_.size(); ++i) {
      if (owner[i] != rank) continue;
      visit_numbers(slots_[i].gradients, [&](std::vector<float>& v) {
        std::copy_n(gradients.begin() + static_cast<std::ptrdiff_t>(at), v.size(), v.begin());
        at += v.size();
      });
      for (double* term : slots_[i].terms.all()) *term = terms[term_at++];
    }
  }
}

std::vector<double> BatchGradient::sample_scores(const FloatNetwork& network, const std::vector<Sample>& samples,
                                                 uint32_t threads, uint32_t keep) {
  std::vector<const Sample*> pointers;
  for (const Sample& sample : samples) pointers.push_back(&sample);
  const std::vector<uint32_t> owner = owners(pointers);
  const uint32_t rank = ranks_ == nullptr ? 0 : ranks_->rank();
  std::vector<size_t> mine;
  for (const size_t i : by_size(pointers)) {
    if (owner[i] == rank) mine.push_back(i);
  }
  const std::vector<LinearBlock<float>> parameters = copy_blocks<float>(network);
  std::vector<double> scores(samples.size(), 0.0);
  team_.run(mine.size(), std::min<uint32_t>(threads, static_cast<uint32_t>(runners_.size())),
            [&](size_t i, unsigned thread) {
              const Sample& sample = samples[mine[i]];
              const std::vector<float>& logits = runners_[thread]->forward(network, parameters, sample, {});
              scores[mine[i]] = sample_l1(sample, softmax(sample, logits), keep);
            });
  if (ranks_ != nullptr) ranks_->maximum(&scores);  // what other ranks did is 0 here, and no L1 is below 0
  return scores;
}

}  // namespace sinew
