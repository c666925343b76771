// SPDX-License-Identifier: MIT
// The match of a transfer by itself, in the caller's vertices.
#include "transfer/published.hpp"
#include "transfer/rebind.hpp"

namespace sinew::transferring {

sinew_status find_corresponding_points(const TransferPlan& plan, const TransferInput& input, Arena& arena,
                                       uint32_t* vertices, float* shares) {
  Pair pair;
  OwnRows rows;
  Match match;
  (void)pair.allocate(arena, plan);
  uint32_t* const scratch = arena.alloc<uint32_t>(size_t{2} * plan.source.joints);
  uint32_t* const caller = arena.alloc<uint32_t>(plan.source.vertices);  // [welded] a vertex of the caller's
  (void)rows.allocate(arena, plan.source);
  if (!match.allocate(arena, plan.target)) return SINEW_ERROR_WORKSPACE;
  const sinew_bound_character& source = input.source;
  sinew_status status = pair.build(plan, input, arena);
  if (status != SINEW_OK) return status;
  if (!arena.measuring()) {
    pair.map.complete(source.joint_map, pair.source_joints, pair.target_joints, scratch);
    rows.gather(pair.source, source.skin.joint_indices, source.skin.weights, source.skin.weight_format,
                source.skin.influence_count);
  }
  status = find_match(plan, input, pair, rows.rows(), arena, &match);
  if (status != SINEW_OK || arena.measuring()) return status;
  for (uint32_t v = plan.source.vertices; v-- > 0;) caller[pair.source.vertex_to_welded[v]] = v;
  for (uint32_t v = 0; v < plan.target.vertices; ++v) {
    const MatchedPoint& point = match.points[pair.target.vertex_to_welded[v]];
    for (size_t k = 0; k < 3; ++k) {
      vertices[size_t{3} * v + k] = caller[point.corners[k]];
      shares[size_t{3} * v + k] = static_cast<float>(point.shares[k]);
    }
  }
  return SINEW_OK;
}

}  // namespace sinew::transferring
