// SPDX-License-Identifier: MIT
// The room's stub, which SINEW_PUBLISHED_METHODS=OFF compiles instead of its other sources: it defines what other rooms call.
// Calls of the interface ask has_published_methods() before they come here, so most answers are never seen.
#include "core/build.hpp"
#include "deform/correction.hpp"
#include "features/attributes.hpp"
#include "mapping/map.hpp"
#include "motion/reference_points.hpp"
#include "rig/published.hpp"
#include "transfer/published.hpp"

namespace sinew {
bool has_published_methods() { return false; }
sinew_status weigh_by_distance(const Mesh&, const Skeleton&, const uint8_t*, const Counts&, Arena&, HeatFields*) {
  return SINEW_ERROR_NOT_BUILT;
}
void build_attributes(const Mesh&, const Skeleton&, const Candidates&, Features*) {}
}  // namespace sinew

namespace sinew::mapping {
sinew_status map_branches(const MapPlan&, const Anatomy&, const Anatomy&, bool, Arena&, int32_t*, double*, double*) {
  return SINEW_OK;
}
}  // namespace sinew::mapping

namespace sinew::rigging {
sinew_status open_slots_model(const void*, size_t, sinew_model*) { return SINEW_ERROR_MODEL_VERSION; }
sinew_status plan_slots(const sinew_model*, SlotsPlan*) { return SINEW_ERROR_NOT_BUILT; }
sinew_status find_slots(const SlotsPlan&, const RigOptions&, const Mesh&, const Kernels&, const Progress&, Arena&,
                        Rig*) {
  return SINEW_ERROR_NOT_BUILT;
}
sinew_status grow_regions(const Mesh&, const Counts&, Arena&, FoldedTree*) { return SINEW_ERROR_NOT_BUILT; }
}  // namespace sinew::rigging

namespace sinew::motion {
sinew_status read_reference_options(const sinew_reference_options*, ReferenceOptions*, Progress*) {
  return SINEW_ERROR_NOT_BUILT;
}
size_t measure_reference_points(uint32_t, uint32_t, uint32_t, uint32_t) { return 0; }
sinew_status run_reference_points(sinew_retarget*, const sinew_motion_body*, const sinew_motion_body&,
                                  const ClipInputs&, const ReferenceOptions&, Arena&) {
  return SINEW_ERROR_NOT_BUILT;
}
}  // namespace sinew::motion

namespace sinew::deform {
sinew_status pose_published(const PosedJoints&, Arena&, Vec3d*, PoseCounts*) { return SINEW_ERROR_NOT_BUILT; }
sinew_status weigh_nodes_by_distance(Arena&, DeformRest*) { return SINEW_ERROR_NOT_BUILT; }
}  // namespace sinew::deform

namespace sinew::transferring {
void DistanceMatch::carry(const Rows&, uint32_t, const Rows&) const {}
sinew_status match_by_distances(const TransferPlan&, const Pair&, const Rows&, Arena&, DistanceMatch*) {
  return SINEW_ERROR_NOT_BUILT;
}
sinew_status find_corresponding_points(const TransferPlan&, const TransferInput&, Arena&, uint32_t*, float*) {
  return SINEW_ERROR_NOT_BUILT;
}
}  // namespace sinew::transferring
