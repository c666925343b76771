/* SPDX-License-Identifier: MIT
 * The structs that grow as the first release, 0.1, laid them out: what a program brings that was compiled then. They
 * stay as they are. */
#ifndef SINEW_TESTS_FIRST_RELEASE_H
#define SINEW_TESTS_FIRST_RELEASE_H

#include <stddef.h>
#include <stdint.h>

typedef struct sinew_options_0_1 {
  uint32_t struct_size;
  uint32_t method;
  uint32_t influence_count;
  uint32_t weight_format;
  uint32_t up_axis;
  uint32_t candidate_count;
  uint32_t grid_size;
  uint32_t surface_vertices;
  uint32_t symmetric;
  uint32_t rigid_parts;
  uint32_t softness_percent;
  uint32_t weights_in_place;
  uint32_t kernel;
  uint32_t thread_count;
  const uint8_t* locked;
  const uint8_t* hints;
  void (*parallel_for)(void* user, uint32_t count, void (*body)(void* body_data, uint32_t index), void* body_data);
  void* parallel_user;
  int (*progress)(void* user, uint32_t done_permille);
  void* progress_user;
} sinew_options_0_1;

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
  uint32_t up_axis;
  uint32_t mirror;
  uint32_t spine_count;
  uint32_t no_toes;
  uint32_t no_ends;
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
  uint32_t quarter_turns;
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
  uint32_t no_twist_spread;
  uint32_t no_contact;
  uint32_t no_smoothing;
} sinew_deform_options_0_1;

typedef struct sinew_deform_outputs_0_1 {
  uint32_t struct_size;
  uint32_t corrected;
  float* positions;
  uint32_t active_tetrahedra;
  uint32_t inverted_tetrahedra;
} sinew_deform_outputs_0_1;

#endif
