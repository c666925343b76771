// SPDX-License-Identifier: MIT
// Finds or takes the rotation of the options and builds the rotated mesh in the grid.
#include "front/upright_mesh.hpp"

#include "core/read_skeleton.hpp"

namespace sinew::rigging {
namespace {

Turn given_turn(uint32_t front, uint32_t up_axis) {
  constexpr float kFronts[7][3] = {{0, 0, 1}, {0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}};
  return Turn::of(kFronts[front], up_axis);
}

sinew_status build(const sinew_mesh& input, uint32_t up_axis, const Counts& counts, Arena& arena,
                   GridQuantizer* quantizer, Mesh* mesh) {
  if (!arena.measuring()) {
    const sinew_status status = make_grid_quantizer(input.positions, input.vertex_count, up_axis, quantizer);
    if (status != SINEW_OK) return status;
  }
  return build_mesh(input, *quantizer, counts, arena, mesh);
}

}  // namespace

sinew_status plan_front(const sinew_rig_options& options, FrontPlan* plan) {
  *plan = FrontPlan();
  if (read_up_axis(options.up, &plan->up_axis) != SINEW_OK || options.front > SINEW_FRONT_MINUS_Y ||
      options.axes_known > 1)
    return SINEW_ERROR_ARGUMENT;
  if (options.front_model != nullptr) {
    if (options.front_model->bytes == nullptr) return SINEW_ERROR_ARGUMENT;
    if (options.front_model->task != kTaskRig || options.front_model->feature_set != kFrontFeatureSet)
      return SINEW_ERROR_MODEL_TASK;
    plan->model = *options.front_model;
  }
  plan->given = options.front;
  plan->axes_known = options.axes_known != 0;
  plan->find_up = options.up == SINEW_UP_AUTO && options.front_model != nullptr && !plan->axes_known;
  // A front along y or z excludes that axis as up.
  const bool along_y = options.front >= SINEW_FRONT_PLUS_Y;
  const bool along_z = options.front == SINEW_FRONT_PLUS_Z || options.front == SINEW_FRONT_MINUS_Z;
  if ((along_y && options.up == SINEW_UP_Y) || (along_z && options.up == SINEW_UP_Z)) return SINEW_ERROR_ARGUMENT;
  if (along_y) plan->up_axis = 1;
  if (along_y || along_z) plan->find_up = false;
  return SINEW_OK;
}

sinew_status stand_upright(const FrontPlan& plan, const sinew_mesh& input, const Counts& counts, const Kernels& kernels,
                           Arena& arena, Mesh* mesh, UprightMesh* upright) {
  Front& front = upright->front;
  front.turn.up_axis = plan.up_axis;
  upright->mesh = input;
  const uint32_t seen_up = plan.find_up ? 0 : plan.up_axis;
  if (plan.asks()) {
    sinew_status status = build(input, seen_up, counts, arena, &upright->quantizer, mesh);
    if (status != SINEW_OK) return status;
    FrontQuestion question;
    question.model = &plan.model;
    question.network = plan.network;
    question.up_axis = plan.up_axis;
    question.find_up = plan.find_up;
    question.axes_known = plan.axes_known;
    status = find_front(question, kernels, *mesh, arena, &front);
    if (status != SINEW_OK) return status;
  }
  if (plan.given != SINEW_FRONT_AUTO) {
    front.turn = given_turn(plan.given, front.turn.up_axis);
    front.confidence = 1;
    front.clear = true;
  }
  upright->known = front.clear;
  upright->up_axis = front.turn.up_axis;
  float* const turned = plan.may_turn() ? arena.alloc<float>(size_t{3} * counts.vertices) : nullptr;
  if (!arena.ok()) return SINEW_ERROR_WORKSPACE;
  if (turned != nullptr && !front.turn.nothing()) {
    upright->mesh = turn_mesh(input, front.turn, turned);
    upright->up_axis = 0;
  }
  const bool seen = plan.asks() && front.turn.nothing() && front.turn.up_axis == seen_up && !arena.measuring();
  return seen ? SINEW_OK : build(upright->mesh, upright->up_axis, counts, arena, &upright->quantizer, mesh);
}

void write_front(const UprightMesh& upright, uint32_t quarters, double plane, sinew_rig_outputs* outputs) {
  const Turn& turn = upright.front.turn;
  const float s = turn.sine, c = turn.cosine;
  Turn faces = turn;
  const float sines[4] = {s, c, -s, -c}, cosines[4] = {c, -s, -c, s};
  faces.sine = sines[quarters % 4];
  faces.cosine = cosines[quarters % 4];
  faces.direction(outputs->front);
  const double x = static_cast<double>(faces.sine), z = static_cast<double>(faces.cosine);
  const bool sideways = (x < 0 ? -x : x) > (z < 0 ? -z : z);
  outputs->facing = sideways ? (x > 0 ? 1u : 3u) : (z > 0 ? 0u : 2u);
  // The plane's axis in the upright mesh is x, or z for odd quarters; here it points to positive x, or to positive z.
  const bool odd = (quarters & 1) != 0;
  const double across_x = static_cast<double>(odd ? s : c), across_z = static_cast<double>(odd ? c : -s);
  outputs->plane = to_float(across_x < 0 || (across_x == 0 && across_z < 0) ? -plane : plane);
  outputs->up = turn.up_axis == 0 ? SINEW_UP_Y : SINEW_UP_Z;
  outputs->front_confidence = upright.front.confidence;
  outputs->up_confidence = upright.front.up_confidence;
}

}  // namespace sinew::rigging
