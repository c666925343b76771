/* SPDX-License-Identifier: MIT
 * Models: opened in place, and packed for this kind of processor. */
#ifndef SINEW_MODEL_H
#define SINEW_MODEL_H

#include "sinew/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A model that was checked. Plain values and pointers into the caller's bytes, which must outlive it.
 * Fill it with sinew_model_open() only; copies are fine. */
typedef struct sinew_model {
  const uint8_t* bytes;
  size_t size_bytes;
  uint32_t format_version;
  uint32_t candidate_count;  /* K the network was trained with */
  uint32_t grid_size;        /* voxel cells along the longest side it was trained with */
  uint32_t feature_set;      /* version of the feature list; bit 16: spectral channels as well */
  uint32_t fixed_candidates; /* non-zero: its layers are tied to candidate_count */
  uint32_t layer_count;
  uint32_t parameter_count;
  uint32_t checksum;
  uint32_t confidence_offset; /* of its confidence table in bytes; 0 = it has none */
  uint32_t confidence_count;  /* entries of the table */
  const void* rearranged;     /* its weights as vector kernels read them, by sinew_model_rearrange(); null = nowhere */
} sinew_model;

/* Checks magic, version, checksum, sizes, shapes, shifts and accumulator proofs, then fills *model.
 *   bytes   in   the whole file, 8-byte aligned; read-only memory is fine; used in place, never copied
 * Returns SINEW_OK or one of SINEW_ERROR_MODEL_*; *model is untouched on failure. */
sinew_status sinew_model_open(const void* bytes, size_t size_bytes, sinew_model* model);

/* On demand: rearranges an opened model's weights for vector kernels, once. Otherwise every bind does it anew, in its
 * workspace, which is smaller by as much with a rearranged model.
 *   memory        out, 64-byte aligned; belongs to the caller, who keeps it for as long as the model is used. Binds
 * only read it, on as many threads as they like memory_bytes  at least sinew_model_rearranged_size(): about the model's
 * size; 0 in builds whose kernels all read the model's own bytes (SINEW_SMALL_CODE), where this does nothing Returns
 * SINEW_OK, SINEW_ERROR_ARGUMENT or SINEW_ERROR_WORKSPACE; nothing is written on failure. */
size_t sinew_model_rearranged_size(const sinew_model* model);
sinew_status sinew_model_rearrange(sinew_model* model, void* memory, size_t memory_bytes);

#ifdef __cplusplus
}
#endif
#endif
