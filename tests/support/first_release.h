/* SPDX-License-Identifier: MIT
 * The structs that grow as the first release, 0.1, laid them out: what a program brings that was compiled then. They
 * stay as they are. */
#ifndef SINEW_TESTS_FIRST_RELEASE_H
#define SINEW_TESTS_FIRST_RELEASE_H

#include <stddef.h>
#include <stdint.h>

typedef struct sinew_bind_options_0_1 {
  uint32_t struct_size;
  uint32_t method;
  uint32_t influence_count;
  uint32_t weight_format;
  uint32_t candidate_count;
  uint32_t grid_size;
  uint32_t surface_vertices;
  uint32_t symmetric;
  uint32_t rigid_parts;
  uint32_t softness_percent;
  uint32_t weights_in_place;
  uint32_t kernel;
  uint32_t thread_count;
  uint32_t reserved;
  const uint8_t* locked;
  const uint8_t* hints;
  void (*parallel_for)(void* user, uint32_t count, void (*body)(void* body_data, uint32_t index), void* body_data);
  void* parallel_user;
  int (*progress)(void* user, uint32_t done_permille);
  void* progress_user;
} sinew_bind_options_0_1;

typedef struct sinew_bind_outputs_0_1 {
  uint32_t struct_size;
  uint32_t symmetric_vertices;
  uint16_t* joint_indices;
  void* weights;
  uint8_t* confidence;
  size_t used_bytes;
} sinew_bind_outputs_0_1;

typedef struct sinew_rig_options_0_1 {
  uint32_t struct_size;
  uint32_t up;
  uint32_t mirror;
  uint32_t spine_count;
  uint32_t without;
  uint32_t reserved;
  uint32_t weights_in_place;
  uint32_t kernel;
  int (*progress)(void* user, uint32_t done_permille);
  void* progress_user;
} sinew_rig_options_0_1;

typedef struct sinew_rig_outputs_0_1 {
  uint32_t struct_size;
  uint32_t joint_count;
  float* positions;
  int32_t* parents;
  uint8_t* flags;
  uint8_t* joint_classes;
  int32_t* partners;
  uint16_t* confidence;
  uint16_t* parent_confidence;
  char (*names)[32];
  uint32_t mirrored;
  uint32_t facing;
  float plane;
  float spread;
  size_t used_bytes;
} sinew_rig_outputs_0_1;

typedef struct sinew_deform_options_0_1 {
  uint32_t struct_size;
  uint32_t method;
  uint32_t cell_count;
  uint32_t round_count;
  uint32_t softness;
  uint32_t without;
  uint32_t thread_count;
  uint32_t body_contact;
} sinew_deform_options_0_1;

typedef struct sinew_deform_outputs_0_1 {
  uint32_t struct_size;
  uint32_t corrected;
  float* positions;
  uint32_t active_tetrahedra;
  uint32_t inverted_tetrahedra;
} sinew_deform_outputs_0_1;

typedef struct sinew_retarget_options_0_1 {
  uint32_t struct_size;
  uint32_t method;
  uint32_t in_place;
  float scale;
} sinew_retarget_options_0_1;

typedef struct sinew_contact_options_0_1 {
  uint32_t struct_size;
  float fps;
  int (*progress)(void* user, uint32_t permille);
  void* progress_user;
} sinew_contact_options_0_1;

typedef struct sinew_reference_options_0_1 {
  uint32_t struct_size;
  uint32_t area_power;
  uint32_t own_limb;
  uint32_t legs;
  float falloff;
  float least_cosine;
  int (*progress)(void* user, uint32_t permille);
  void* progress_user;
} sinew_reference_options_0_1;

typedef struct sinew_skeleton_0_1 {
  uint32_t struct_size;
  uint32_t joint_count;
  const float* positions;
  const int32_t* parents;
  const uint8_t* flags;
  const uint8_t* ends;
  const char* const* names;
  const float* rotations;
  uint32_t up;
  uint32_t reserved;
} sinew_skeleton_0_1;

typedef struct sinew_map_options_0_1 {
  uint32_t struct_size;
  uint32_t method;
  uint32_t pin_count;
  uint32_t reserved;
  const struct sinew_map_pin* pins;
} sinew_map_options_0_1;

typedef struct sinew_map_outputs_0_1 {
  uint32_t struct_size;
  uint32_t method;
  int32_t* sources;
  uint16_t* confidence;
  uint8_t* reasons;
  uint32_t mapped;
  uint32_t certainty;
  size_t used_bytes;
} sinew_map_outputs_0_1;

typedef struct sinew_transfer_options_0_1 {
  uint32_t struct_size;
  uint32_t method;
  uint32_t influence_count;
  uint32_t weight_format;
  uint32_t garment;
  uint32_t as_drawn;
  uint32_t weights_in_place;
  uint32_t kernel;
  uint32_t thread_count;
  uint32_t pair_count;
  const uint8_t* locked;
  const struct sinew_vertex_pair* pairs;
  void (*parallel_for)(void* user, uint32_t count, void (*body)(void* body_data, uint32_t index), void* body_data);
  void* parallel_user;
  int (*progress)(void* user, uint32_t done_permille);
  void* progress_user;
} sinew_transfer_options_0_1;

typedef struct sinew_transfer_outputs_0_1 {
  uint32_t struct_size;
  uint32_t part_capacity;
  uint16_t* joint_indices;
  void* weights;
  uint8_t* confidence;
  struct sinew_transfer_part* parts;
  uint32_t* vertex_parts;
  uint32_t part_count;
  uint32_t bound_by;
  uint32_t carried_q16;
  uint32_t style_q16;
  uint32_t mismatch_q16;
  uint32_t reference_count;
  size_t used_bytes;
} sinew_transfer_outputs_0_1;

typedef struct sinew_simplify_options_0_1 {
  uint32_t struct_size;
  uint32_t level;
  uint32_t joint_count;
  uint32_t reserved;
} sinew_simplify_options_0_1;

#endif
