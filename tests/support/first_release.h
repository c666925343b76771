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

#endif
