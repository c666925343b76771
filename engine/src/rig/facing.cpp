// SPDX-License-Identifier: MIT
// Runs of the votes' network on one set of points for each direction.
#include "rig/facing.hpp"

#include "core/vector_math.hpp"

namespace sinew::rigging {
namespace {

// What another direction has to gain, Q10 of log2: of quarters and halves, and of steps.
constexpr int64_t kRotationGain = 60, kStepGain = 30;
constexpr int32_t kMostSteps = 2;
constexpr double kStepCosine = 0.9659258262890683, kStepSine = 0.25881904510252074;  // of 15 degrees

// How far off the votes of a set think they are: mean of log2, Q10. Small is good.
int64_t doubt_of(const int16_t* outputs) {
  int64_t sum = 0;
  for (uint32_t i = 0; i < kSetPoints; ++i) {
    const int16_t* const row = outputs + size_t{i} * kRigOutputs;
    sum += int64_t{row[kRigStartSpread]} + row[kRigEndSpread];
  }
  return sum / (2 * kSetPoints);
}

}  // namespace

sinew_status choose_facing(const RigPlan& plan, const Kernels& kernels, Arena& arena, PointVoter* voter,
                           MirrorFrame* frame, Mesh* mesh, bool* turned) {
  const uint32_t step = frame->folded ? 2 : 1;
  int64_t least = INT64_MAX;
  uint32_t best = 0, at = 0;
  for (uint32_t tried = step; tried <= 4; tried += step) {  // the way that it has comes last: mostly it stays so
    const uint32_t quarters = tried % 4;
    if (!arena.measuring()) turn_frame(quarters + 4 - at, frame, mesh);
    at = quarters;
    if (!build_interior(*mesh, arena, &voter->interior)) return SINEW_ERROR_WORKSPACE;
    const sinew_status status = voter->run(plan.model, plan.network, kernels, *mesh, 0, {}, arena);
    if (status != SINEW_OK) return status;
    if (arena.measuring()) return SINEW_OK;
    const int64_t doubt = doubt_of(voter->outputs) + (quarters == 0 ? 0 : kRotationGain);
    if (doubt < least || (quarters == 0 && doubt == least)) {
      least = doubt;
      best = quarters;
    }
  }
  *turned = best != at;
  if (!*turned) return SINEW_OK;
  turn_frame(best + 4 - at, frame, mesh);
  return build_interior(*mesh, arena, &voter->interior) ? SINEW_OK : SINEW_ERROR_WORKSPACE;
}

bool place_frame(const RigPlan& plan, const UprightMesh& upright, Arena& arena, Mesh* mesh, MirrorFrame* frame) {
  int32_t middles[2] = {0, 0};
  if (!arena.measuring()) {
    const float zero[3] = {0, 0, 0};
    const Vec3i middle = quantize_point(upright.quantizer, zero);
    middles[0] = middle.x;
    middles[1] = middle.z;
  }
  if (!find_mirror_frame(*mesh, plan.mirroring, middles, plan.front.may_turn(), arena, frame)) return false;
  if (!arena.measuring()) apply_mirror_frame(*frame, mesh);
  return true;
}

namespace {

// A mesh that can be stood up anew, a step further.
struct Refiner {
  const RigPlan& plan;
  const sinew_mesh& input;
  const Kernels& kernels;
  Arena& arena;
  Mesh& mesh;
  UprightMesh& upright;
  MirrorFrame& frame;
  Turn found;  // before any step
  PointVoter voter;

  sinew_status turn_to(int32_t steps) {
    double s = static_cast<double>(found.sine), c = static_cast<double>(found.cosine);
    for (int32_t i = 0; i < (steps < 0 ? -steps : steps); ++i) {
      const double sine = steps < 0 ? -kStepSine : kStepSine, next = s * kStepCosine + c * sine;
      c = c * kStepCosine - s * sine;
      s = next;
    }
    upright.front.turn.sine = to_float(s);
    upright.front.turn.cosine = to_float(c);
    const sinew_status status = stand_again(input, plan.counts, arena, &mesh, &upright);
    if (status != SINEW_OK) return status;
    return place_frame(plan, upright, arena, &mesh, &frame) ? SINEW_OK : SINEW_ERROR_WORKSPACE;
  }

  sinew_status ask(int64_t* doubt) {
    if (!build_interior(mesh, arena, &voter.interior)) return SINEW_ERROR_WORKSPACE;
    const sinew_status status = voter.run(plan.model, plan.network, kernels, mesh, 0, {}, arena);
    if (status == SINEW_OK && !arena.measuring()) *doubt = doubt_of(voter.outputs);
    return status;
  }
};

}  // namespace

sinew_status refine_front(const RigPlan& plan, const sinew_mesh& input, const Kernels& kernels, Arena& arena,
                          Mesh* mesh, UprightMesh* upright, MirrorFrame* frame) {
  const ArenaScope scope(arena);
  Refiner refiner{plan, input, kernels, arena, *mesh, *upright, *frame, upright->front.turn, {}};
  refiner.voter.other = plan.other;
  if (!refiner.voter.allocate(arena)) return SINEW_ERROR_WORKSPACE;
  if (!arena.measuring() && (!upright->known || frame->folded)) return SINEW_OK;
  int64_t least = 0;
  sinew_status status = refiner.ask(&least);
  if (arena.measuring()) return status == SINEW_OK ? refiner.turn_to(0) : status;
  int32_t best = 0, at = 0;
  constexpr int32_t kSides[2] = {-1, 1};
  for (const int32_t side : kSides) {
    for (int32_t steps = side; steps >= -kMostSteps && steps <= kMostSteps && status == SINEW_OK; steps += side) {
      if (steps != side && best != steps - side) break;
      int64_t doubt = 0;
      status = refiner.turn_to(at = steps);
      if (status == SINEW_OK) status = refiner.ask(&doubt);
      if (status != SINEW_OK || doubt + (best == 0 ? kStepGain : 0) >= least) continue;
      best = steps;
      least = doubt;
    }
  }
  return status == SINEW_OK && at != best ? refiner.turn_to(best) : status;
}

}  // namespace sinew::rigging
