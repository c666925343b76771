// SPDX-License-Identifier: MIT
// The training loss with its analytic gradient, and the yardstick's L1 on samples for validation.
#include "run/loss.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "data/sample_index.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {
namespace {

// Which slots of a vertex count together: first[k] is the first slot whose joint folds to the same target.
struct FoldGroups {
  std::array<uint8_t, kMaxCandidates> first;

  FoldGroups(const Sample& sample, size_t row) {
    for (uint8_t k = 0; k < sample.candidates; ++k) {
      first[k] = k;
      if (sample.candidate[row + k] == kAbsent) continue;
      const uint32_t target = sample.fold[sample.candidate[row + k]];
      for (uint8_t i = 0; i < k; ++i) {
        if (sample.candidate[row + i] != kAbsent && sample.fold[sample.candidate[row + i]] == target) {
          first[k] = i;
          break;
        }
      }
    }
  }
};

template <class T>
T sign(T x) {
  return static_cast<T>((x > T(0)) - (x < T(0)));
}

double total_importance(const Sample& sample) {
  double total = 0;
  for (float i : sample.importance) total += static_cast<double>(i);
  if (total <= 0)
    throw Error(sample.name + ": no vertex has reference weights, so there is nothing to learn from or compare with");
  return total;
}

// How far a vertex sways from where it should be when joints turn.
template <class S>
class Lever {
 public:
  explicit Lever(const Sample& sample)
      : sample_(sample), subtree_(sample.joints, S(0)), mark_(sample.joints, UINT32_MAX) {}

  // off [K] p - t of the slots that lead a fold group, 0 elsewhere; slope [K] = d sway / d off.
  S sway(uint32_t v, const std::array<S, kMaxCandidates>& off, std::array<S, kMaxCandidates>* slope) {
    const size_t row = size_t{v} * sample_.candidates;
    touched_.clear();
    for_ancestors(row, off, [&](uint32_t joint, S amount, uint32_t) {
      if (mark_[joint] != v) {
        mark_[joint] = v;
        subtree_[joint] = 0;
        touched_.push_back(joint);
      }
      subtree_[joint] += amount;
    });
    S sum = S(1e-8);
    for (const uint32_t joint : touched_) {
      S square = 0;
      for (int axis = 0; axis < 3; ++axis) {
        const S d = static_cast<S>(sample_.positions[3 * size_t{v} + static_cast<size_t>(axis)]) -
                    static_cast<S>(sample_.joint_positions[3 * size_t{joint} + static_cast<size_t>(axis)]);
        square += d * d;
      }
      sum += subtree_[joint] * subtree_[joint] * square;
      subtree_[joint] *= square;
    }
    const S root = std::sqrt(sum);
    for_ancestors(row, off, [&](uint32_t joint, S, uint32_t slot) { (*slope)[slot] += subtree_[joint] / root; });
    return root;
  }

 private:
  template <class Visit>
  void for_ancestors(size_t row, const std::array<S, kMaxCandidates>& off, Visit&& visit) const {
    for (uint32_t k = 0; k < sample_.candidates; ++k) {
      if (sample_.candidate[row + k] == kAbsent) continue;
      for (int32_t joint = static_cast<int32_t>(sample_.fold[sample_.candidate[row + k]]); joint >= 0;
           joint = sample_.parents[static_cast<size_t>(joint)]) {
        visit(static_cast<uint32_t>(joint), off[k], k);
      }
    }
  }

  const Sample& sample_;
  std::vector<S> subtree_;
  std::vector<uint32_t> mark_, touched_;
};

}  // namespace

template <class S>
LossTerms weight_loss(const Sample& sample, const LossWeights& weights, const std::vector<S>& logits,
                      std::vector<S>* d_logits) {
  const uint32_t slots = sample.candidates;
  const double total = total_importance(sample);
  LossTerms terms;
  std::vector<S> probability(logits.size(), S(0));
  // d loss / d (weight of the slot's fold group), without the part term; and target / group sum * p, kept apart because
  // it stays finite when the group's probability underflows.
  std::vector<S> slope(d_logits ? logits.size() : 0, S(0)), kl_pull(d_logits ? logits.size() : 0, S(0));
  if (d_logits != nullptr) d_logits->assign(logits.size(), S(0));
  std::vector<uint32_t> mark(sample.joints, UINT32_MAX);
  std::vector<S> part_error(sample.joints, S(0));  // importance-weighted sum of p - t of the part, by folded joint
  std::vector<uint32_t> part_joints;
  Lever<S> lever(sample);

  for (uint32_t part = 0; part < sample.part_count; ++part) {
    part_joints.clear();
    const uint32_t begin = sample.part_offsets[part], end = sample.part_offsets[part + 1];
    for (uint32_t i = begin; i < end; ++i) {
      const uint32_t v = sample.part_vertices[i];
      const S importance = static_cast<S>(sample.importance[v]);
      const size_t row = size_t{v} * slots;
      S largest = -INFINITY;
      for (size_t k = row; k < row + slots; ++k) {
        if (sample.candidate[k] != kAbsent) largest = std::max(largest, logits[k]);
      }
      if (!(importance > S(0)) || largest == -INFINITY) continue;
      const FoldGroups groups(sample, row);
      std::array<S, kMaxCandidates> group{}, target{}, heat{};
      S sum = 0, heat_left = 1, target_sum = 0;
      for (uint32_t k = 0; k < slots; ++k) {
        if (sample.candidate[row + k] == kAbsent) continue;
        probability[row + k] = std::exp(logits[row + k] - largest);
        sum += probability[row + k];
      }
      for (uint32_t k = 0; k < slots; ++k) {
        const uint32_t g = groups.first[k];
        probability[row + k] /= sum;
        group[g] += probability[row + k];
        target[g] += static_cast<S>(sample.target[row + k]);
        target_sum += static_cast<S>(sample.target[row + k]);
        heat[g] += static_cast<S>(sample.heat[row + k]);
        heat_left -= static_cast<S>(sample.heat[row + k]);
      }
      const S missing = static_cast<S>(sample.missing[v]);
      S l1 = missing, heat_l1 = std::abs(heat_left - missing), kl = 0;
      const S log_sum = std::log(sum);
      for (uint32_t k = 0; k < slots; ++k) {
        if (sample.candidate[row + k] == kAbsent || groups.first[k] != k) continue;
        l1 += std::abs(group[k] - target[k]);
        heat_l1 += std::abs(heat[k] - target[k]);
        if (target[k] > S(0)) {
          S group_largest = -INFINITY, group_sum = 0;
          for (uint32_t i2 = k; i2 < slots; ++i2) {
            if (groups.first[i2] == k) group_largest = std::max(group_largest, logits[row + i2]);
          }
          for (uint32_t i2 = k; i2 < slots; ++i2) {
            if (groups.first[i2] == k) group_sum += std::exp(logits[row + i2] - group_largest);
          }
          kl += target[k] * (std::log(target[k]) - (group_largest - largest + std::log(group_sum) - log_sum));
          if (d_logits != nullptr) {
            for (uint32_t i2 = k; i2 < slots; ++i2) {
              if (groups.first[i2] == k)
                kl_pull[row + i2] = target[k] * std::exp(logits[row + i2] - group_largest) / group_sum;
            }
          }
        }
        const uint32_t joint = sample.fold[sample.candidate[row + k]];
        if (mark[joint] != part) {
          mark[joint] = part;
          part_error[joint] = 0;
          part_joints.push_back(joint);
        }
        part_error[joint] += importance * (group[k] - target[k]);
      }
      const bool worse = l1 > heat_l1;
      std::array<S, kMaxCandidates> sway{};
      if (weights.deformation > 0) {
        std::array<S, kMaxCandidates> off{};
        for (uint32_t k = 0; k < slots; ++k) {
          if (sample.candidate[row + k] != kAbsent && groups.first[k] == k) off[k] = group[k] - target[k];
        }
        terms.deformation += static_cast<double>(importance * lever.sway(v, off, &sway));
      }
      terms.l1 += static_cast<double>(importance * l1);
      terms.kl += static_cast<double>(importance * kl);
      if (worse) terms.regret += static_cast<double>(importance * (l1 - heat_l1));
      if (d_logits != nullptr) {
        const S pull = static_cast<S>(weights.l1) + (worse ? static_cast<S>(weights.regret) : S(0));
        for (uint32_t k = 0; k < slots; ++k) {
          const uint32_t g = groups.first[k];
          slope[row + k] = pull * sign(group[g] - target[g]) + static_cast<S>(weights.deformation) * sway[g];
          kl_pull[row + k] = static_cast<S>(weights.kl) * (probability[row + k] * target_sum - kl_pull[row + k]);
        }
      }
    }
    for (uint32_t joint : part_joints) terms.part += static_cast<double>(std::abs(part_error[joint]));
    if (d_logits == nullptr) continue;
    for (uint32_t i = begin; i < end; ++i) {
      const uint32_t v = sample.part_vertices[i];
      const size_t row = size_t{v} * slots;
      if (!(sample.importance[v] > 0)) continue;
      const S scale = static_cast<S>(static_cast<double>(sample.importance[v]) / total);
      S mean = 0;
      for (size_t k = row; k < row + slots; ++k) {
        if (sample.candidate[k] == kAbsent) continue;
        slope[k] += static_cast<S>(weights.part) * sign(part_error[sample.fold[sample.candidate[k]]]);
        mean += slope[k] * probability[k];
      }
      for (size_t k = row; k < row + slots; ++k) {
        if (sample.candidate[k] != kAbsent) (*d_logits)[k] = scale * (probability[k] * (slope[k] - mean) + kl_pull[k]);
      }
    }
  }
  terms.l1 /= total;
  terms.kl /= total;
  terms.regret /= total;
  terms.part /= total;
  terms.deformation /= total;
  terms.total = weights.kl * terms.kl + weights.l1 * terms.l1 + weights.regret * terms.regret +
                weights.part * terms.part + weights.deformation * terms.deformation;
  return terms;
}
template LossTerms weight_loss<float>(const Sample&, const LossWeights&, const std::vector<float>&,
                                      std::vector<float>*);
template LossTerms weight_loss<double>(const Sample&, const LossWeights&, const std::vector<double>&,
                                       std::vector<double>*);

double sample_l1(const Sample& sample, const std::vector<float>& probabilities, uint32_t keep) {
  const uint32_t slots = sample.candidates;
  double error = 0;
  for (uint32_t v = 0; v < sample.vertices; ++v) {
    if (!(sample.importance[v] > 0)) continue;
    const size_t row = size_t{v} * slots;
    std::array<uint32_t, kMaxCandidates> order;
    for (uint32_t k = 0; k < slots; ++k) order[k] = k;
    const auto larger = [&](uint32_t a, uint32_t b) {
      const float pa = probabilities[row + a], pb = probabilities[row + b];
      return pa != pb ? pa > pb : sample.candidate[row + a] < sample.candidate[row + b];
    };
    std::sort(order.begin(), order.begin() + slots, larger);
    std::array<double, kMaxCandidates> weight{};
    double sum = 0;
    for (uint32_t i = 0; i < std::min(keep, slots); ++i)
      sum += weight[order[i]] = static_cast<double>(probabilities[row + order[i]]);
    const FoldGroups groups(sample, row);
    std::array<double, kMaxCandidates> difference{};
    for (uint32_t k = 0; k < slots; ++k) {
      difference[groups.first[k]] += (sum > 0 ? weight[k] / sum : 0.0) - static_cast<double>(sample.target[row + k]);
    }
    double l1 = static_cast<double>(sample.missing[v]);
    for (uint32_t k = 0; k < slots; ++k) l1 += std::abs(difference[k]);
    error += static_cast<double>(sample.importance[v]) * l1;
  }
  return error / total_importance(sample);
}

}  // namespace sinew
