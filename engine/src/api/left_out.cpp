// SPDX-License-Identifier: MIT
// The C API: what a library for microcontrollers leaves out (SINEW_SMALL_CODE).
#include "sinew/joint_limits.h"
#include "sinew/published.h"
#include "sinew/sinew.h"

namespace {
sinew_status no_size(size_t* size_bytes) {
  if (size_bytes != nullptr) *size_bytes = 0;
  return SINEW_ERROR_NOT_BUILT;
}
}  // namespace

extern "C" {

sinew_status sinew_rig_model_open(const void*, size_t, sinew_model*) { return SINEW_ERROR_NOT_BUILT; }
sinew_status sinew_rig_workspace_size(const sinew_model*, uint32_t, uint32_t, uint32_t, const sinew_rig_options*,
                                      size_t* size_bytes) {
  return no_size(size_bytes);
}
sinew_status sinew_rig(const sinew_model*, const sinew_mesh*, const sinew_rig_options*, void*, size_t,
                       sinew_rig_outputs*) {
  return SINEW_ERROR_NOT_BUILT;
}
sinew_status sinew_rig_details_workspace_size(const sinew_model*, uint32_t, uint32_t, uint32_t, uint32_t,
                                              const sinew_rig_options*, size_t* size_bytes) {
  return no_size(size_bytes);
}
sinew_status sinew_rig_details(const sinew_model*, const sinew_mesh*, uint32_t, const sinew_rig_options*, void*, size_t,
                               sinew_rig_outputs*) {
  return SINEW_ERROR_NOT_BUILT;
}
sinew_status sinew_map_workspace_size(uint32_t, uint32_t, size_t* size_bytes) { return no_size(size_bytes); }
sinew_status sinew_map(const sinew_skeleton*, const sinew_skeleton*, const sinew_map_options*, void*, size_t,
                       sinew_map_outputs*) {
  return SINEW_ERROR_NOT_BUILT;
}
sinew_status sinew_limb_classes_workspace_size(uint32_t, uint32_t, size_t* size_bytes) { return no_size(size_bytes); }
sinew_status sinew_limb_classes(const sinew_skeleton*, const sinew_skeleton*, const int32_t*, void*, size_t, uint8_t*) {
  return SINEW_ERROR_NOT_BUILT;
}
sinew_status sinew_joint_classes_workspace_size(uint32_t, size_t* size_bytes) { return no_size(size_bytes); }
sinew_status sinew_joint_classes(const sinew_skeleton*, const uint8_t*, void*, size_t, sinew_joint_verdicts*) {
  return SINEW_ERROR_NOT_BUILT;
}
int32_t sinew_joint_side(const char*) { return 0; }
sinew_status sinew_joint_other_side(const char*, char*, size_t) { return SINEW_ERROR_NOT_BUILT; }
const char* sinew_naming_text(uint32_t) { return nullptr; }
sinew_status sinew_joint_standard_name(uint32_t, uint32_t, int32_t, uint32_t, char*) { return SINEW_ERROR_NOT_BUILT; }
sinew_status sinew_deform_create_workspace_size(const sinew_mesh*, uint32_t, uint32_t, const sinew_deform_options*,
                                                size_t* size_bytes) {
  return no_size(size_bytes);
}
sinew_status sinew_deform_create(const sinew_mesh*, const sinew_skeleton*, const sinew_skin*,
                                 const sinew_deform_options*, void*, size_t, sinew_deformer*) {
  return SINEW_ERROR_NOT_BUILT;
}
sinew_status sinew_deform_pose(const sinew_deformer*, const float*, void*, size_t, sinew_deform_outputs*) {
  return SINEW_ERROR_NOT_BUILT;
}
sinew_status sinew_simplify_workspace_size(uint32_t, size_t* size_bytes) { return no_size(size_bytes); }
sinew_status sinew_simplify(const sinew_skeleton*, const float*, const uint8_t*, const sinew_simplify_options*, void*,
                            size_t, uint32_t*) {
  return SINEW_ERROR_NOT_BUILT;
}
sinew_status sinew_transfer_workspace_size(const sinew_model*, const sinew_bound_character*, const sinew_mesh*,
                                           const sinew_skeleton*, const sinew_transfer_options*, size_t* size_bytes) {
  return no_size(size_bytes);
}
sinew_status sinew_transfer(const sinew_model*, const sinew_bound_character*, const sinew_mesh*, const sinew_skeleton*,
                            const sinew_transfer_options*, void*, size_t, sinew_transfer_outputs*) {
  return SINEW_ERROR_NOT_BUILT;
}
sinew_status sinew_retarget_create_workspace_size(uint32_t, uint32_t, size_t* size_bytes) {
  return no_size(size_bytes);
}
sinew_status sinew_retarget_create(const sinew_skeleton*, const sinew_skeleton*, const int32_t*, const uint8_t*,
                                   const sinew_retarget_options*, void*, size_t, sinew_retarget**) {
  return SINEW_ERROR_NOT_BUILT;
}
sinew_status sinew_retarget_height(sinew_retarget*, const float*, const float*, float*) {
  return SINEW_ERROR_NOT_BUILT;
}
sinew_status sinew_retarget_ground(const sinew_retarget*, float*, size_t, float*) { return SINEW_ERROR_NOT_BUILT; }
sinew_status sinew_retarget_frame(sinew_retarget*, const float*, const float*, float, float*, float*) {
  return SINEW_ERROR_NOT_BUILT;
}
sinew_status sinew_retarget_keep_range(sinew_retarget*, const sinew_motion_body*, const sinew_motion_clip*, void*,
                                       size_t) {
  return SINEW_ERROR_NOT_BUILT;
}
sinew_status sinew_keep_joint_limits(const sinew_joint_limit*, uint32_t, uint32_t, uint32_t, float*) {
  return SINEW_ERROR_NOT_BUILT;
}
sinew_status sinew_retarget_measure(sinew_retarget*, const sinew_motion_body*, const sinew_motion_body*,
                                    const sinew_motion_clip*, const sinew_contact_options*, void*, size_t,
                                    sinew_limb_quality*, uint32_t*) {
  return SINEW_ERROR_NOT_BUILT;
}
sinew_status sinew_retarget_spots(sinew_retarget*, const sinew_motion_body*, const sinew_motion_body*,
                                  const sinew_motion_clip*, const sinew_contact_options*, void*, size_t,
                                  sinew_limb_quality*, uint32_t*, sinew_contact_spot*) {
  return SINEW_ERROR_NOT_BUILT;
}
sinew_status sinew_retarget_reference_points_workspace_size(const sinew_retarget*, const sinew_motion_body*,
                                                            size_t* size_bytes) {
  return no_size(size_bytes);
}
sinew_status sinew_retarget_reference_points(sinew_retarget*, const sinew_motion_body*, const sinew_motion_body*,
                                             const sinew_motion_clip*, const sinew_reference_options*, void*, size_t) {
  return SINEW_ERROR_NOT_BUILT;
}
sinew_status sinew_corresponding_points_workspace_size(const sinew_bound_character*, const sinew_mesh*,
                                                       const sinew_skeleton*, size_t* size_bytes) {
  return no_size(size_bytes);
}
sinew_status sinew_corresponding_points(const sinew_bound_character*, const sinew_mesh*, const sinew_skeleton*, void*,
                                        size_t, uint32_t*, float*) {
  return SINEW_ERROR_NOT_BUILT;
}
sinew_status sinew_retarget_contacts_workspace_size(const sinew_retarget*, const sinew_motion_body*, uint32_t,
                                                    size_t* size_bytes) {
  return no_size(size_bytes);
}
sinew_status sinew_retarget_contacts(sinew_retarget*, const sinew_motion_body*, const sinew_motion_body*,
                                     const sinew_motion_clip*, const sinew_contact_options*, void*, size_t) {
  return SINEW_ERROR_NOT_BUILT;
}
sinew_status sinew_retarget_stream_workspace_size(uint32_t, uint32_t, uint32_t, uint32_t, size_t* size_bytes) {
  return no_size(size_bytes);
}
sinew_status sinew_retarget_stream_create(const sinew_skeleton*, const sinew_skeleton*, const int32_t*, const uint8_t*,
                                          const sinew_retarget_options*, const sinew_motion_body*,
                                          const sinew_retarget_stream_options*, void*, size_t,
                                          sinew_retarget_stream**) {
  return SINEW_ERROR_NOT_BUILT;
}
sinew_status sinew_retarget_stream_frame(sinew_retarget_stream*, const float*, const float*, float*, float*) {
  return SINEW_ERROR_NOT_BUILT;
}
sinew_status sinew_retarget_stream_restart(sinew_retarget_stream*) { return SINEW_ERROR_NOT_BUILT; }
sinew_status sinew_springs_workspace_size(uint32_t, uint32_t, uint32_t, uint32_t, uint32_t, size_t* size_bytes) {
  return no_size(size_bytes);
}
sinew_status sinew_springs_create(const sinew_skeleton*, const sinew_spring_set*, const sinew_springs_options*, void*,
                                  size_t, sinew_springs**) {
  return SINEW_ERROR_NOT_BUILT;
}
sinew_status sinew_springs_frame(sinew_springs*, float, const float*, const float*, float*) {
  return SINEW_ERROR_NOT_BUILT;
}
sinew_status sinew_springs_restart(sinew_springs*) { return SINEW_ERROR_NOT_BUILT; }

}  // extern "C"
