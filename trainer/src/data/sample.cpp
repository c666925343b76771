// SPDX-License-Identifier: MIT
// Training samples: the engine's own features of a character beside the truth.
#include "sinew_trainer/sample.hpp"

#include <algorithm>
#include <cmath>

#include "bind/pipeline.hpp"
#include "kernels/select.hpp"
#include "sinew/sinew.hpp"
#include "sinew_character/bind/engine_views.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_trainer/fold_targets.hpp"
#include "weights/influences.hpp"

namespace sinew {
namespace {

template <class T>
std::vector<T> copy(const T* data, size_t count) {
  return std::vector<T>(data, data + count);
}

// Mean reference weights of the caller's vertices in each welded vertex, dense over joints is too large: per vertex
// pairs.
struct WeldedTruth {
  std::vector<std::vector<std::pair<uint32_t, double>>> rows;  // [U] (joint, summed weight)
  std::vector<float> bound;                                    // [U] caller's vertices that have weights
};

WeldedTruth weld_truth(const Character& character, const std::vector<uint32_t>& vertex_to_welded, uint32_t welded) {
  WeldedTruth truth;
  truth.rows.resize(welded);
  truth.bound.assign(welded, 0.0f);
  for (size_t v = 0; v < character.influences.size(); ++v) {
    double sum = 0;
    for (const Influence& i : character.influences[v]) sum += i.weight;
    if (sum <= 0.5) continue;  // the yardstick leaves unbound vertices out
    auto& row = truth.rows[vertex_to_welded[v]];
    for (const Influence& i : character.influences[v]) {
      auto at = std::find_if(row.begin(), row.end(), [&](const auto& e) { return e.first == i.joint; });
      if (at == row.end()) at = row.insert(row.end(), {i.joint, 0.0});
      at->second += i.weight / sum;
    }
    truth.bound[vertex_to_welded[v]] += 1.0f;
  }
  return truth;
}

// Puts the truth of one vertex on its candidates. A joint's weight goes to the joint itself when it is a candidate,
// else to its first candidate end marker (whose weight folds to the joint), else it is missing.
void write_targets(const WeldedTruth& truth, Sample* s) {
  const size_t k = s->candidates;
  for (size_t u = 0; u < s->vertices; ++u) {
    const uint16_t* candidate = &s->candidate[u * k];
    for (const auto& [joint, sum] : truth.rows[u]) {
      const float weight = static_cast<float>(sum / truth.bound[u]);
      size_t slot = k;
      for (size_t i = 0; i < k && slot == k; ++i) {
        if (candidate[i] == joint) slot = i;
      }
      for (size_t i = 0; i < k && slot == k; ++i) {
        if (candidate[i] != kNoJoint && s->fold[candidate[i]] == joint) slot = i;
      }
      if (slot < k) {
        s->target[u * k + slot] += weight;
      } else {
        s->missing[u] += weight;
      }
    }
  }
}

}  // namespace

Sample make_sample(const Character& character, uint32_t candidates, uint32_t grid, uint32_t feature_flags) {
  check_bindable(character);
  const EngineViews views(character, {});
  Counts counts;
  throw_status(character, make_counts(views.mesh.vertex_count, views.mesh.face_count, views.mesh.corner_count,
                                      views.skeleton.joint_count, candidates, grid, &counts));
  counts.feature_flags = feature_flags & kFeatureFlags;
  PreparedBind p;
  const Kernels kernels = fastest_kernels();
  const auto run = [&](Arena& arena) {
    return prepare(views.mesh, views.skeleton, 0, counts, PreparePurpose::kNetwork, kernels, {}, arena, &p);
  };
  Arena measuring;
  throw_status(character, run(measuring));
  const Workspace block(measuring.high_water());
  Arena arena(block.data(), block.size());
  throw_status(character, run(arena));

  Sample s;
  s.name = character.name;
  s.family = family_of(character.name);
  s.vertices = p.mesh.welded_count;
  s.candidates = candidates;
  s.part_count = p.mesh.part_count;
  s.joints = p.skeleton.joint_count;
  const size_t pairs = static_cast<size_t>(s.vertices) * candidates;
  s.inputs.resize(2);
  NetworkSample::Input &vertex = s.inputs[kVertexInput], &pair = s.inputs[kPairInput];
  vertex.channels = p.features.vertex_channels;
  vertex.rows = copy(p.features.vertex, static_cast<size_t>(s.vertices) * vertex.channels);
  pair.channels = pair_channels(counts.feature_flags);
  pair.rows = copy(p.features.pair, pairs * pair.channels);
  s.candidate = copy(p.features.joints, pairs);
  s.row_offsets = copy(p.mesh.row_offsets, static_cast<size_t>(s.vertices) + 1);
  s.col_indices = copy(p.mesh.col_indices, s.row_offsets.back());
  s.part = copy(p.mesh.part, s.vertices);
  s.part_offsets = copy(p.mesh.part_offsets, static_cast<size_t>(s.part_count) + 1);
  s.part_vertices = copy(p.mesh.part_vertices, s.vertices);
  s.vertex_to_welded = copy(p.mesh.vertex_to_welded, character.vertices.size());
  s.fold = fold_targets(character);
  const auto add_position = [](const Vec3i& at, std::vector<float>* out) {
    for (const int32_t x : {at.x, at.y, at.z}) out->push_back(static_cast<float>(x) / static_cast<float>(kSide));
  };
  for (uint32_t u = 0; u < s.vertices; ++u) add_position(p.mesh.positions[u], &s.positions);
  for (uint32_t j = 0; j < s.joints; ++j) add_position(p.skeleton.positions[j], &s.joint_positions);
  s.parents = copy(p.skeleton.parents, s.joints);
  s.target.assign(pairs, 0.0f);
  s.missing.assign(s.vertices, 0.0f);
  s.heat.assign(pairs, 0.0f);
  const WeldedTruth truth = weld_truth(character, s.vertex_to_welded, s.vertices);
  s.importance = truth.bound;
  for (uint32_t u = 0; u < s.vertices; ++u) {
    s.owner.push_back(p.part_owners[p.mesh.part[u]]);
    if (s.owner[u] != kNoJoint) s.importance[u] = 0;
  }
  write_targets(truth, &s);
  for (uint32_t u = 0; u < s.vertices; ++u) {
    uint16_t joints[kHeatSlots], weights[kHeatSlots];
    const uint32_t count = finish_heat_row(p.heat.field[kFieldRule], u, joints, weights);
    for (uint32_t i = 0; i < count; ++i) {
      for (size_t k = 0; k < candidates; ++k) {
        if (s.candidate[u * candidates + k] == joints[i]) {
          s.heat[u * candidates + k] = static_cast<float>(weights[i]) / 32768.0f;
        }
      }
    }
  }
  return s;
}

std::vector<std::vector<Influence>> sample_influences(const Sample& sample, const std::vector<float>& probabilities,
                                                      uint32_t keep) {
  const size_t k = sample.candidates;
  std::vector<std::vector<Influence>> welded(sample.vertices);
  for (size_t u = 0; u < sample.vertices; ++u) {
    if (!sample.owner.empty() && sample.owner[u] != kNoJoint) {
      welded[u] = {{sample.owner[u], 1.0f}};
      continue;
    }
    uint32_t weights[SINEW_MAX_CANDIDATES] = {};
    for (size_t i = 0; i < k; ++i) {
      weights[i] = static_cast<uint32_t>(std::lround(std::clamp(probabilities[u * k + i], 0.0f, 1.0f) * 65536.0f));
    }
    prune_q16(weights, sample.candidates);
    uint16_t joints[SINEW_MAX_INFLUENCES], kept[SINEW_MAX_INFLUENCES];
    keep_largest(&sample.candidate[u * k], weights, sample.candidates, keep, 65535, joints, kept);
    for (uint32_t i = 0; i < keep; ++i) {
      if (kept[i] > 0) welded[u].push_back({joints[i], static_cast<float>(kept[i]) / 65535.0f});
    }
  }
  std::vector<std::vector<Influence>> rows;
  rows.reserve(sample.vertex_to_welded.size());
  for (uint32_t u : sample.vertex_to_welded) rows.push_back(welded[u]);
  return rows;
}

}  // namespace sinew
