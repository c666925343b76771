// SPDX-License-Identifier: MIT
// The C API: argument checks of plans that retarget motion.
#include "sinew/motion.h"

#include <stddef.h>

#include "api/arguments.hpp"
#include "core/build.hpp"
#include "core/struct_size.hpp"
#include "motion/contacts.hpp"
#include "motion/reference_points.hpp"
#include "motion/retarget.hpp"
#include "motion/retarget_stream.hpp"
#include "sinew/joint_limits.h"
#include "sinew/motion_clips.h"
#include "sinew/published.h"

static_assert(sizeof(sinew_retarget_options) == 6 * sizeof(uint32_t), "a hole in sinew_retarget_options");
static_assert(sizeof(sinew_floor) == 6 * sizeof(uint32_t) + sizeof(void*), "sinew_floor never changes");
static_assert(sizeof(sinew_retarget_stream_options) == 6 * sizeof(uint32_t) + 2 * sizeof(void*),
              "a hole in sinew_retarget_stream_options");
static_assert(sizeof(sinew_limb_quality) == 12 * sizeof(uint32_t), "sinew_limb_quality never changes");
static_assert(sizeof(sinew_joint_limit) == 18 * sizeof(uint32_t), "sinew_joint_limit never changes");
static_assert(sizeof(sinew_contact_spot) == 6 * sizeof(uint32_t), "sinew_contact_spot never changes");
static_assert(sizeof(sinew_reference_options) == 10 * sizeof(uint32_t) + 2 * sizeof(void*),
              "a hole in sinew_reference_options");

namespace {

// Without its triangles, which are the target's.
sinew_status check_source_body(const sinew_motion_body& source, uint32_t joint_count) {
  sinew_motion_body same = source;
  same.triangle_count = 0;
  return sinew::motion::check_body(same, joint_count);
}

// The common part of calls on whole clips.
sinew_status check_clip(const sinew_retarget* plan, const sinew_motion_body* source, const sinew_motion_body* target,
                        const sinew_motion_clip* clip, const void* workspace) {
  if (plan == nullptr || target == nullptr || clip == nullptr || workspace == nullptr ||
      (source != nullptr && source->vertex_count != target->vertex_count)) {
    return SINEW_ERROR_ARGUMENT;
  }
  if (clip->frame_count > 0 && (clip->source_rotations == nullptr || clip->source_translations == nullptr ||
                                clip->rotations == nullptr || clip->translations == nullptr)) {
    return SINEW_ERROR_ARGUMENT;
  }
  sinew_status status = sinew::motion::check_body(*target, plan->target.count);
  if (status == SINEW_OK && source != nullptr) status = check_source_body(*source, plan->source.count);
  if (status != SINEW_OK) return status;
  if (!sinew::motion::is_finite(static_cast<double>(clip->ground))) return SINEW_ERROR_NOT_FINITE;
  return sinew::is_aligned(workspace) ? SINEW_OK : SINEW_ERROR_WORKSPACE;
}

sinew::motion::ClipInputs clip_inputs(const sinew_motion_clip& clip, double fps, sinew::Progress progress) {
  sinew::motion::ClipInputs inputs;
  inputs.frames = clip.frame_count;
  inputs.source_rotations = clip.source_rotations;
  inputs.source_translations = clip.source_translations;
  inputs.ground = static_cast<double>(clip.ground);
  inputs.fps = fps;
  inputs.rotations = clip.rotations;
  inputs.translations = clip.translations;
  inputs.progress = progress;
  return inputs;
}

sinew_status read_contacts(const sinew_retarget* plan, const sinew_motion_body* source, const sinew_motion_body* target,
                           const sinew_motion_clip* clip, const sinew_contact_options* options, const void* workspace,
                           sinew::motion::ClipInputs* inputs) {
  sinew_contact_options own = SINEW_INIT(sinew_contact_options);
  constexpr uint32_t kFirstSize = offsetof(sinew_contact_options, floor);  // the struct of the first release
  sinew_status status = options == nullptr ? SINEW_OK : sinew::read_struct(options, kFirstSize, sizeof own, &own);
  if (status == SINEW_OK) status = check_clip(plan, source, target, clip, workspace);
  if (status != SINEW_OK) return status;
  const double fps = own.fps == 0 ? 30.0 : static_cast<double>(own.fps);
  if (!(fps >= 1 && fps <= 1000)) return SINEW_ERROR_ARGUMENT;
  *inputs = clip_inputs(*clip, fps, sinew::Progress{own.progress, own.progress_user});
  return inputs->floor.take(own.floor);
}

// spots: or null.
sinew_status measure(sinew_retarget* plan, const sinew_motion_body* source, const sinew_motion_body* target,
                     const sinew_motion_clip* clip, const sinew_contact_options* options, void* workspace,
                     size_t workspace_bytes, sinew_limb_quality* limbs, uint32_t* limb_count,
                     sinew_contact_spot* spots) {
  if (limbs == nullptr || limb_count == nullptr) return SINEW_ERROR_ARGUMENT;
  sinew::motion::ClipInputs inputs;
  const sinew_status status = read_contacts(plan, source, target, clip, options, workspace, &inputs);
  if (status != SINEW_OK) return status;
  sinew::Arena arena(workspace, workspace_bytes);
  return sinew::motion::measure_clip(plan, source, *target, inputs, arena, limbs, limb_count, spots);
}

}  // namespace

extern "C" {

sinew_status sinew_retarget_create_workspace_size(uint32_t source_joints, uint32_t target_joints, size_t* size_bytes) {
  if (size_bytes == nullptr) return SINEW_ERROR_ARGUMENT;
  *size_bytes = 0;
  if (source_joints == 0 || target_joints == 0 || source_joints > SINEW_MAX_JOINTS || target_joints > SINEW_MAX_JOINTS)
    return SINEW_ERROR_COUNT;
  *size_bytes = sinew::motion::measure_plan(source_joints, target_joints);
  return SINEW_OK;
}

sinew_status sinew_retarget_create(const sinew_skeleton* source, const sinew_skeleton* target, const int32_t* map,
                                   const uint8_t* target_classes, const sinew_retarget_options* options, void* memory,
                                   size_t memory_bytes, sinew_retarget** plan) {
  if (source == nullptr || target == nullptr || map == nullptr || memory == nullptr || plan == nullptr) {
    return SINEW_ERROR_ARGUMENT;
  }
  sinew_skeleton from, to;
  sinew::motion::RetargetOptions own;
  sinew_status status = sinew::read_skeleton(source, &from);
  if (status == SINEW_OK) status = sinew::read_skeleton(target, &to);
  if (status == SINEW_OK) status = sinew::motion::read_retarget_options(options, &own);
  size_t bytes = 0;
  if (status == SINEW_OK) status = sinew_retarget_create_workspace_size(from.joint_count, to.joint_count, &bytes);
  if (status != SINEW_OK) return status;
  if (memory_bytes < bytes || !sinew::is_aligned(memory)) return SINEW_ERROR_WORKSPACE;
  return sinew::motion::create_plan(from, to, map, target_classes, own, memory, memory_bytes, plan);
}

sinew_status sinew_retarget_height(sinew_retarget* plan, const float* rotations, const float* translations,
                                   float* height) {
  if (plan == nullptr || rotations == nullptr || translations == nullptr || height == nullptr)
    return SINEW_ERROR_ARGUMENT;
  return sinew::motion::source_height(plan, rotations, translations, height);
}

sinew_status sinew_retarget_ground(const sinew_retarget* plan, float* heights, size_t count, float* ground) {
  if (plan == nullptr || ground == nullptr || (heights == nullptr && count > 0)) return SINEW_ERROR_ARGUMENT;
  return sinew::motion::standing_height(*plan, heights, count, ground);
}

sinew_status sinew_retarget_frame(sinew_retarget* plan, const float* rotations, const float* translations, float ground,
                                  float* out_rotations, float* out_translations) {
  if (plan == nullptr || rotations == nullptr || translations == nullptr || out_rotations == nullptr ||
      out_translations == nullptr) {
    return SINEW_ERROR_ARGUMENT;
  }
  return sinew::motion::retarget_frame(plan, rotations, translations, ground, out_rotations, out_translations);
}

sinew_status sinew_retarget_contacts_workspace_size(const sinew_retarget* plan, const sinew_motion_body* target,
                                                    uint32_t frame_count, size_t* size_bytes) {
  if (size_bytes == nullptr) return SINEW_ERROR_ARGUMENT;
  *size_bytes = 0;
  if (plan == nullptr || target == nullptr) return SINEW_ERROR_ARGUMENT;
  *size_bytes = sinew::motion::measure_contacts(plan->source.count, plan->target.count, target->vertex_count,
                                                target->triangle_count, frame_count);
  return *size_bytes == 0 ? SINEW_ERROR_COUNT : SINEW_OK;
}

sinew_status sinew_retarget_contacts(sinew_retarget* plan, const sinew_motion_body* source,
                                     const sinew_motion_body* target, const sinew_motion_clip* clip,
                                     const sinew_contact_options* options, void* workspace, size_t workspace_bytes) {
  sinew::motion::ClipInputs inputs;
  const sinew_status status = read_contacts(plan, source, target, clip, options, workspace, &inputs);
  if (status != SINEW_OK) return status;
  sinew::Arena arena(workspace, workspace_bytes);
  return sinew::motion::run_contacts(plan, source, *target, inputs, arena);
}

sinew_status sinew_retarget_keep_range(sinew_retarget* plan, const sinew_motion_body* target,
                                       const sinew_motion_clip* clip, void* workspace, size_t workspace_bytes) {
  const sinew_status status = check_clip(plan, nullptr, target, clip, workspace);
  if (status != SINEW_OK) return status;
  const sinew::motion::ClipInputs inputs = clip_inputs(*clip, 30, {});
  sinew::Arena arena(workspace, workspace_bytes);
  return sinew::motion::keep_range(plan, *target, inputs, arena);
}

sinew_status sinew_keep_joint_limits(const sinew_joint_limit* limits, uint32_t limit_count, uint32_t joint_count,
                                     uint32_t frame_count, float* rotations) {
  if ((limits == nullptr && limit_count > 0) || (rotations == nullptr && frame_count > 0)) return SINEW_ERROR_ARGUMENT;
  if (joint_count == 0 || joint_count > SINEW_MAX_JOINTS) return SINEW_ERROR_COUNT;
  return sinew::motion::keep_joint_limits(limits, limit_count, joint_count, frame_count, rotations);
}

sinew_status sinew_retarget_measure(sinew_retarget* plan, const sinew_motion_body* source,
                                    const sinew_motion_body* target, const sinew_motion_clip* clip,
                                    const sinew_contact_options* options, void* workspace, size_t workspace_bytes,
                                    sinew_limb_quality* limbs, uint32_t* limb_count) {
  return measure(plan, source, target, clip, options, workspace, workspace_bytes, limbs, limb_count, nullptr);
}

sinew_status sinew_retarget_spots(sinew_retarget* plan, const sinew_motion_body* source,
                                  const sinew_motion_body* target, const sinew_motion_clip* clip,
                                  const sinew_contact_options* options, void* workspace, size_t workspace_bytes,
                                  sinew_limb_quality* limbs, uint32_t* limb_count, sinew_contact_spot* spots) {
  if (spots == nullptr) return SINEW_ERROR_ARGUMENT;
  return measure(plan, source, target, clip, options, workspace, workspace_bytes, limbs, limb_count, spots);
}

sinew_status sinew_retarget_reference_points_workspace_size(const sinew_retarget* plan, const sinew_motion_body* target,
                                                            size_t* size_bytes) {
  if (size_bytes == nullptr) return SINEW_ERROR_ARGUMENT;
  *size_bytes = 0;
  if (plan == nullptr || target == nullptr) return SINEW_ERROR_ARGUMENT;
  if (!sinew::has_published_methods()) return SINEW_ERROR_NOT_BUILT;
  *size_bytes = sinew::motion::measure_reference_points(plan->source.count, plan->target.count, target->vertex_count,
                                                        target->triangle_count);
  return *size_bytes == 0 ? SINEW_ERROR_COUNT : SINEW_OK;
}

sinew_status sinew_retarget_reference_points(sinew_retarget* plan, const sinew_motion_body* source,
                                             const sinew_motion_body* target, const sinew_motion_clip* clip,
                                             const sinew_reference_options* options, void* workspace,
                                             size_t workspace_bytes) {
  sinew::motion::ReferenceOptions own;
  sinew::Progress progress = {};
  sinew_status status = sinew::motion::read_reference_options(options, &own, &progress);
  if (status == SINEW_OK) status = check_clip(plan, source, target, clip, workspace);
  if (status != SINEW_OK) return status;
  const sinew::motion::ClipInputs inputs = clip_inputs(*clip, 30, progress);
  sinew::Arena arena(workspace, workspace_bytes);
  return sinew::motion::run_reference_points(plan, source, *target, inputs, own, arena);
}

sinew_status sinew_retarget_stream_workspace_size(uint32_t source_joints, uint32_t target_joints,
                                                  uint32_t body_vertices, uint32_t body_triangles, size_t* size_bytes) {
  const sinew_status status = sinew_retarget_create_workspace_size(source_joints, target_joints, size_bytes);
  if (status != SINEW_OK) return status;
  *size_bytes = 0;
  if (body_vertices > SINEW_MAX_VERTICES || body_triangles > sinew::motion::kMostTriangles) return SINEW_ERROR_COUNT;
  *size_bytes = sinew::motion::measure_stream(source_joints, target_joints, body_vertices, body_triangles);
  return *size_bytes == 0 ? SINEW_ERROR_COUNT : SINEW_OK;
}

sinew_status sinew_retarget_stream_create(const sinew_skeleton* source, const sinew_skeleton* target,
                                          const int32_t* map, const uint8_t* target_classes,
                                          const sinew_retarget_options* plan_options, const sinew_motion_body* body,
                                          const sinew_retarget_stream_options* options, void* memory,
                                          size_t memory_bytes, sinew_retarget_stream** stream) {
  if (source == nullptr || target == nullptr || map == nullptr || memory == nullptr || stream == nullptr)
    return SINEW_ERROR_ARGUMENT;
  sinew_skeleton from, to;
  sinew::motion::RetargetOptions own;
  sinew::motion::StreamOptions live;
  sinew_status status = sinew::read_skeleton(source, &from);
  if (status == SINEW_OK) status = sinew::read_skeleton(target, &to);
  if (status == SINEW_OK) status = sinew::motion::read_retarget_options(plan_options, &own);
  if (status == SINEW_OK) status = sinew::motion::read_stream_options(options, &live);
  size_t bytes = 0;
  const uint32_t vertices = body == nullptr ? 0 : body->vertex_count;
  const uint32_t triangles = body == nullptr ? 0 : body->triangle_count;
  if (status == SINEW_OK && live.source != nullptr && live.source->vertex_count != vertices)
    status = SINEW_ERROR_ARGUMENT;
  if (status == SINEW_OK)
    status = sinew_retarget_stream_workspace_size(from.joint_count, to.joint_count, vertices, triangles, &bytes);
  if (status == SINEW_OK && body != nullptr) status = sinew::motion::check_body(*body, to.joint_count);
  if (status == SINEW_OK && live.source != nullptr) status = check_source_body(*live.source, from.joint_count);
  if (status != SINEW_OK) return status;
  if (memory_bytes < bytes || !sinew::is_aligned(memory)) return SINEW_ERROR_WORKSPACE;
  return sinew::motion::create_stream(from, to, map, target_classes, own, body, live, memory, memory_bytes, stream);
}

sinew_status sinew_retarget_stream_frame(sinew_retarget_stream* stream, const float* rotations,
                                         const float* translations, float* out_rotations, float* out_translations) {
  if (stream == nullptr || rotations == nullptr || translations == nullptr || out_rotations == nullptr ||
      out_translations == nullptr) {
    return SINEW_ERROR_ARGUMENT;
  }
  return sinew::motion::stream_frame(stream, rotations, translations, out_rotations, out_translations);
}

sinew_status sinew_retarget_stream_restart(sinew_retarget_stream* stream) {
  if (stream == nullptr) return SINEW_ERROR_ARGUMENT;
  sinew::motion::restart_stream(stream);
  return SINEW_OK;
}

}  // extern "C"
