// SPDX-License-Identifier: MIT
// Recall of the engine's candidates: runs the stages that choose them, heat once and the rest for every number K.
#include "bind/pipeline.hpp"
#include "candidates/candidates.hpp"
#include "features/features.hpp"
#include "kernels/select.hpp"
#include "mesh/mesh.hpp"
#include "sinew/sinew.hpp"
#include "sinew_character/bind/engine_views.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_trainer/evaluate.hpp"
#include "sinew_trainer/fold_targets.hpp"

namespace sinew {
namespace {

// Mean over bound vertices of the share of weight on the vertex's candidates.
double share_on_candidates(const Character& character, const std::vector<uint32_t>& fold, const Mesh& mesh,
                           const uint16_t* candidates, uint32_t candidate_count) {
  double hit = 0;
  size_t bound = 0;
  for (size_t v = 0; v < character.influences.size(); ++v) {
    const uint16_t* const row = candidates + static_cast<size_t>(mesh.vertex_to_welded[v]) * candidate_count;
    double sum = 0, found = 0;
    for (const Influence& influence : character.influences[v]) {
      if (!(influence.weight > 0)) continue;
      sum += static_cast<double>(influence.weight);
      for (uint32_t k = 0; k < candidate_count; ++k) {
        if (row[k] == kNoJoint || (row[k] != influence.joint && fold[row[k]] != influence.joint)) continue;
        found += static_cast<double>(influence.weight);
        break;
      }
    }
    if (sum <= 0) continue;
    hit += found / sum;
    ++bound;
  }
  if (bound == 0) throw Error(character.name + ": no vertex has reference weights, so there is no recall");
  return hit / static_cast<double>(bound);
}

}  // namespace

std::vector<double> candidate_recall(const Character& character, const std::vector<uint32_t>& ks, uint32_t grid) {
  check_bindable(character);
  const EngineViews views(character, {});
  const std::vector<uint32_t> fold = fold_targets(character);
  Counts counts;
  const auto count = [&](uint32_t k) {
    throw_status(character, make_counts(views.mesh.vertex_count, views.mesh.face_count, views.mesh.corner_count,
                                        views.skeleton.joint_count, k, grid, &counts));
  };
  // Heat does not depend on K: it is solved once.
  count(1);
  PreparedBind p;
  const Kernels kernels = fastest_kernels();
  const auto solve = [&](Arena& arena) {
    return prepare(views.mesh, views.skeleton, 0, counts, PreparePurpose::kHeat, kernels, {}, arena, &p);
  };
  Arena measuring;
  throw_status(character, solve(measuring));
  const Workspace block(measuring.high_water());
  Arena arena(block.data(), block.size());
  throw_status(character, solve(arena));
  std::vector<double> recall;
  for (const uint32_t k : ks) {
    count(k);
    const auto find = [&](Arena& memory) {
      p.candidates.allocate(memory, counts);
      p.features.allocate(memory, counts);
      const sinew_status status = find_candidates(p.mesh, p.skeleton, counts, {}, memory, &p.candidates);
      if (status != SINEW_OK) return status;
      return build_features(p.mesh, p.skeleton, p.candidates, p.heat, counts, memory, &p.features);
    };
    Arena measuring_k;
    throw_status(character, find(measuring_k));
    const Workspace block_k(measuring_k.high_water());
    Arena arena_k(block_k.data(), block_k.size());
    throw_status(character, find(arena_k));
    recall.push_back(share_on_candidates(character, fold, p.mesh, p.features.joints, k));
  }
  return recall;
}

}  // namespace sinew
