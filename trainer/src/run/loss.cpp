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
  if (total <= 0) throw Error(sample.name + ": no vertex has reference weights to train on or compare with");
  return total;
}

// Position error of a vertex when joints rotate.
template <class S>
class VertexSway {
 public:
  explicit VertexSway(const Sample& sample)
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

// One row of a sample: what its fold groups have, want and had from heat. Entries of a group are at its first slot.
template <class S>
struct LossRow {
  uint32_t vertex = 0;
  size_t first = 0;  // of its slots in logits
  S largest = -INFINITY, sum = 0, target_sum = 0, heat_left = 1;
  std::array<S, kMaxCandidates> group{}, target{}, heat{}, sway{};
};

// The loss of a sample part by part, and d loss / d logits where it is asked for.
template <class S>
class WeightLoss {
 public:
  WeightLoss(const Sample& sample, const LossWeights& weights, const std::vector<S>& logits, std::vector<S>* d_logits)
      : sample_(sample),
        weights_(weights),
        logits_(logits),
        d_logits_(d_logits),
        slots_(sample.candidates),
        total_(total_importance(sample)),
        probability_(logits.size(), S(0)),
        slope_(d_logits ? logits.size() : 0, S(0)),
        kl_pull_(d_logits ? logits.size() : 0, S(0)),
        mark_(sample.joints, UINT32_MAX),
        part_error_(sample.joints, S(0)),
        lever_(sample) {
    if (d_logits != nullptr) d_logits->assign(logits.size(), S(0));
  }

  LossTerms run() {
    for (uint32_t part = 0; part < sample_.part_count; ++part) {
      part_joints_.clear();
      const uint32_t begin = sample_.part_offsets[part], end = sample_.part_offsets[part + 1];
      for (uint32_t i = begin; i < end; ++i) add_row(sample_.part_vertices[i], part);
      for (uint32_t joint : part_joints_) terms_.part += static_cast<double>(std::abs(part_error_[joint]));
      if (d_logits_ == nullptr) continue;
      for (uint32_t i = begin; i < end; ++i) write_gradient(sample_.part_vertices[i]);
    }
    terms_.l1 /= total_;
    terms_.kl /= total_;
    terms_.regret /= total_;
    terms_.part /= total_;
    terms_.deformation /= total_;
    terms_.total = weights_.kl * terms_.kl + weights_.l1 * terms_.l1 + weights_.regret * terms_.regret +
                   weights_.part * terms_.part + weights_.deformation * terms_.deformation;
    return terms_;
  }

 private:
  bool present(size_t k) const { return sample_.candidate[k] != kAbsent; }

  void add_row(uint32_t v, uint32_t part) {
    const S importance = static_cast<S>(sample_.importance[v]);
    LossRow<S> row;
    row.vertex = v;
    row.first = size_t{v} * slots_;
    for (size_t k = row.first; k < row.first + slots_; ++k) {
      if (present(k)) row.largest = std::max(row.largest, logits_[k]);
    }
    if (!(importance > S(0)) || row.largest == -INFINITY) return;
    const FoldGroups groups(sample_, row.first);
    sum_groups(groups, &row);
    const S missing = static_cast<S>(sample_.missing[v]);
    S l1 = missing, heat_l1 = std::abs(row.heat_left - missing), kl = 0;
    const S log_sum = std::log(row.sum);
    for (uint32_t k = 0; k < slots_; ++k) {
      if (!present(row.first + k) || groups.first[k] != k) continue;
      l1 += std::abs(row.group[k] - row.target[k]);
      heat_l1 += std::abs(row.heat[k] - row.target[k]);
      if (row.target[k] > S(0)) kl += divergence(groups, row, k, log_sum);
      add_part_error(sample_.fold[sample_.candidate[row.first + k]], part, importance * (row.group[k] - row.target[k]));
    }
    if (weights_.deformation > 0) add_deformation(groups, importance, &row);
    const bool worse = l1 > heat_l1;
    terms_.l1 += static_cast<double>(importance * l1);
    terms_.kl += static_cast<double>(importance * kl);
    if (worse) terms_.regret += static_cast<double>(importance * (l1 - heat_l1));
    if (d_logits_ != nullptr) add_slopes(groups, row, worse);
  }

  void sum_groups(const FoldGroups& groups, LossRow<S>* row) {
    for (size_t k = row->first; k < row->first + slots_; ++k) {
      if (!present(k)) continue;
      probability_[k] = std::exp(logits_[k] - row->largest);
      row->sum += probability_[k];
    }
    for (uint32_t k = 0; k < slots_; ++k) {
      const uint32_t g = groups.first[k];
      const size_t at = row->first + k;
      probability_[at] /= row->sum;
      row->group[g] += probability_[at];
      row->target[g] += static_cast<S>(sample_.target[at]);
      row->target_sum += static_cast<S>(sample_.target[at]);
      row->heat[g] += static_cast<S>(sample_.heat[at]);
      row->heat_left -= static_cast<S>(sample_.heat[at]);
    }
  }

  // The loss of the group that begins at slot k, which has a target. Notes its pull as well.
  S divergence(const FoldGroups& groups, const LossRow<S>& row, uint32_t k, S log_sum) {
    S largest = -INFINITY, sum = 0;
    for (uint32_t i = k; i < slots_; ++i) {
      if (groups.first[i] == k) largest = std::max(largest, logits_[row.first + i]);
    }
    for (uint32_t i = k; i < slots_; ++i) {
      if (groups.first[i] == k) sum += std::exp(logits_[row.first + i] - largest);
    }
    for (uint32_t i = k; i < slots_ && d_logits_ != nullptr; ++i) {
      if (groups.first[i] == k)
        kl_pull_[row.first + i] = row.target[k] * std::exp(logits_[row.first + i] - largest) / sum;
    }
    return row.target[k] * (std::log(row.target[k]) - (largest - row.largest + std::log(sum) - log_sum));
  }

  void add_part_error(uint32_t joint, uint32_t part, S error) {
    if (mark_[joint] != part) {
      mark_[joint] = part;
      part_error_[joint] = 0;
      part_joints_.push_back(joint);
    }
    part_error_[joint] += error;
  }

  void add_deformation(const FoldGroups& groups, S importance, LossRow<S>* row) {
    std::array<S, kMaxCandidates> off{};
    for (uint32_t k = 0; k < slots_; ++k) {
      if (present(row->first + k) && groups.first[k] == k) off[k] = row->group[k] - row->target[k];
    }
    terms_.deformation += static_cast<double>(importance * lever_.sway(row->vertex, off, &row->sway));
  }

  void add_slopes(const FoldGroups& groups, const LossRow<S>& row, bool worse) {
    const S pull = static_cast<S>(weights_.l1) + (worse ? static_cast<S>(weights_.regret) : S(0));
    for (uint32_t k = 0; k < slots_; ++k) {
      const uint32_t g = groups.first[k];
      const size_t at = row.first + k;
      slope_[at] = pull * sign(row.group[g] - row.target[g]) + static_cast<S>(weights_.deformation) * row.sway[g];
      kl_pull_[at] = static_cast<S>(weights_.kl) * (probability_[at] * row.target_sum - kl_pull_[at]);
    }
  }

  // After all rows of the part.
  void write_gradient(uint32_t v) {
    if (!(sample_.importance[v] > 0)) return;
    const size_t first = size_t{v} * slots_;
    const S scale = static_cast<S>(static_cast<double>(sample_.importance[v]) / total_);
    S mean = 0;
    for (size_t k = first; k < first + slots_; ++k) {
      if (!present(k)) continue;
      slope_[k] += static_cast<S>(weights_.part) * sign(part_error_[sample_.fold[sample_.candidate[k]]]);
      mean += slope_[k] * probability_[k];
    }
    for (size_t k = first; k < first + slots_; ++k) {
      if (present(k)) (*d_logits_)[k] = scale * (probability_[k] * (slope_[k] - mean) + kl_pull_[k]);
    }
  }

  const Sample& sample_;
  const LossWeights& weights_;
  const std::vector<S>& logits_;
  std::vector<S>* d_logits_;
  const uint32_t slots_;
  const double total_;
  LossTerms terms_;
  std::vector<S> probability_;
  // d loss / d (weight of the slot's fold group), without the part term; and target / group sum * p, kept apart because
  // it stays finite when the group's probability underflows.
  std::vector<S> slope_, kl_pull_;
  std::vector<uint32_t> mark_;
  std::vector<S> part_error_;  // importance-weighted sum of p - t of the part, by folded joint
  std::vector<uint32_t> part_joints_;
  VertexSway<S> lever_;
};

}  // namespace

template <class S>
LossTerms weight_loss(const Sample& sample, const LossWeights& weights, const std::vector<S>& logits,
                      std::vector<S>* d_logits) {
  return WeightLoss<S>(sample, weights, logits, d_logits).run();
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
