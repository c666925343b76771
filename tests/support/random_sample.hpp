// SPDX-License-Identifier: MIT
// Handmade training samples: a few strips of vertices with random features, absent slots, end joints and unbound
// vertices.
#ifndef SINEW_TESTS_RANDOM_SAMPLE_HPP
#define SINEW_TESTS_RANDOM_SAMPLE_HPP

#include <algorithm>
#include <numeric>
#include <random>
#include <vector>

#include "sinew_trainer/sample.hpp"

namespace sinew::testing {

struct RandomSampleOptions {
  uint32_t vertices = 24, candidates = 4, joints = 7, part_count = 3;
  uint32_t vertex_features = 5, pair_features = 6;
  uint64_t seed = 1;
  bool ragged = true;  // absent slots, isolated vertices, unbound vertices, missing weight
};

inline Sample random_sample(const RandomSampleOptions& o) {
  std::mt19937_64 random(o.seed);
  const auto uniform = [&] { return static_cast<float>(random() >> 40) / 16777216.0f; };
  Sample s;
  s.name = "random" + std::to_string(o.seed);
  s.family = "random";
  s.vertices = o.vertices;
  s.candidates = o.candidates;
  s.inputs = {{o.vertex_features, {}}, {o.pair_features, {}}};
  s.part_count = o.part_count;
  s.joints = o.joints;
  // Part c owns the vertices v with v % part_count == c; neighbors are the next and the third next of the same
  // part.
  s.row_offsets = {0};
  const auto linked = [&](uint32_t v, uint32_t u) {
    if (v % o.part_count != u % o.part_count || (o.ragged && (v == 0 || u == 0))) return false;
    const uint32_t gap = (v > u ? v - u : u - v) / o.part_count;
    return gap == 1 || gap == 3;
  };
  for (uint32_t v = 0; v < o.vertices; ++v) {
    for (uint32_t u = 0; u < o.vertices; ++u) {
      if (linked(v, u)) s.col_indices.push_back(u);
    }
    s.row_offsets.push_back(static_cast<uint32_t>(s.col_indices.size()));
    s.part.push_back(v % o.part_count);
    s.vertex_to_welded.push_back(v);
  }
  s.part_offsets = {0};
  for (uint32_t c = 0; c < o.part_count; ++c) {
    for (uint32_t v = c; v < o.vertices; v += o.part_count) s.part_vertices.push_back(v);
    s.part_offsets.push_back(static_cast<uint32_t>(s.part_vertices.size()));
  }
  s.fold.resize(o.joints);
  std::iota(s.fold.begin(), s.fold.end(), 0u);
  s.fold[o.joints - 1] = 0;  // end markers of joint 0
  if (o.joints > 3) s.fold[o.joints - 2] = 0;
  for (uint32_t v = 0; v < o.vertices; ++v) {
    for (uint32_t c = 0; c < o.vertex_features; ++c)
      s.inputs[0].rows.push_back(static_cast<int16_t>((uniform() * 2 - 1) * 12000));
    std::vector<uint16_t> joints(o.joints);
    std::iota(joints.begin(), joints.end(), uint16_t{0});
    std::shuffle(joints.begin(), joints.end(), random);
    const uint32_t present = o.ragged ? 1 + static_cast<uint32_t>(random() % o.candidates) : o.candidates;
    float total = 0, heat_total = 0;
    const size_t row = s.candidate.size();
    for (uint32_t k = 0; k < o.candidates; ++k) {
      const bool here = k < present;
      s.candidate.push_back(here ? joints[k] : uint16_t{0xFFFF});
      for (uint32_t c = 0; c < o.pair_features; ++c) {
        s.inputs[1].rows.push_back(here ? static_cast<int16_t>((uniform() * 2 - 1) * 12000) : int16_t{0});
      }
      s.target.push_back(here && uniform() < 0.7f ? uniform() : 0.0f);
      s.heat.push_back(here ? uniform() : 0.0f);
      total += s.target.back();
      heat_total += s.heat.back();
    }
    const float missing = o.ragged && v % 5 == 0 ? 0.1f : 0.0f;
    if (total <= 0) {
      s.target[row] = total = 1;
    }
    for (size_t k = row; k < row + o.candidates; ++k) {
      s.target[k] *= (1 - missing) / total;
      s.heat[k] /= heat_total;
    }
    s.missing.push_back(missing);
    s.importance.push_back(o.ragged && v % 7 == 3 ? 0.0f : 1.0f + static_cast<float>(v % 2));
  }
  for (uint32_t v = 0; v < 3 * o.vertices; ++v) s.positions.push_back(uniform());
  for (uint32_t j = 0; j < 3 * o.joints; ++j) s.joint_positions.push_back(uniform());
  for (uint32_t j = 0; j < o.joints; ++j) s.parents.push_back(j == 0 ? -1 : static_cast<int32_t>((j - 1) / 2));
  return s;
}

}  // namespace sinew::testing
#endif
