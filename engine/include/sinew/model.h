/* SPDX-License-Identifier: MIT
 * Models: checked and used in place, and packed on demand for this kind of processor. */
#ifndef SINEW_MODEL_H
#define SINEW_MODEL_H

#include "sinew/types.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A checked model, written by sinew_model_open() and sinew_model_pack() only. It may be copied. It points into the
 * caller's bytes, which must outlive it. The size of the struct never changes: new members replace a part of
 * `reserved`. */
typedef struct sinew_model {
  const uint8_t* bytes; /* the whole file */
  size_t size_bytes;
  const void* packed; /* weights in the order of vector kernels, by sinew_model_pack(); null = not packed */
  uint32_t format_version;
  uint32_t candidate_count;  /* K that the network was trained with */
  uint32_t grid_size;        /* voxel cells along the longest side in training; 0 = depends on the vertex count */
  uint32_t feature_set;      /* version of the feature list; bit 16: spectral channels as well */
  uint32_t fixed_candidates; /* non-zero: the layers are tied to candidate_count */
  uint32_t layer_count;
  uint32_t parameter_count;
  uint32_t checksum;
  uint32_t confidence_offset; /* offset of the confidence table in bytes; 0 = none */
  uint32_t confidence_count;  /* entries of the table */
  uint32_t task;              /* 0: predicts skin weights; 1: predicts skeletons (of hands if feature_set is 2) */
  uint32_t input_count;       /* number of feature arrays that it reads */
  uint32_t reserved[14];      /* 0 */
} sinew_model;

/* Checks a model for sinew_bind(): magic, version, task, checksum, sizes, shapes, shifts and accumulator proofs. Then
 * fills *model.
 *   bytes   in   the whole file, 8-byte aligned; read-only memory is fine; used in place, never copied
 *   model   out  untouched on failure
 * Returns SINEW_OK, or
 *   SINEW_ERROR_ARGUMENT    `bytes` or `model` is null
 *   SINEW_ERROR_MODEL_TASK  it is for another call: open it with sinew_rig_model_open()
 *   SINEW_ERROR_MODEL_*     the file is invalid, see sinew_status */
SINEW_API sinew_status sinew_model_open(const void* bytes, size_t size_bytes, sinew_model* model);

/* Returns the bytes that sinew_model_pack() needs: about the model's size.
 *   size_bytes  out; 0 in builds whose kernels read the model's own bytes (SINEW_SMALL_CODE). Untouched on failure
 * Returns SINEW_OK, SINEW_ERROR_ARGUMENT (a pointer is null, or the model is not open). */
SINEW_API sinew_status sinew_model_pack_workspace_size(const sinew_model* model, size_t* size_bytes);

/* Packs an opened model's weights once, in the order that vector kernels read them. A bind with a model that is not
 * packed packs it in its workspace each time, which is then larger.
 *   memory        out  64-byte aligned; belongs to the caller, who keeps it while the model is in use. Any number of
 *                      binds may read it at once
 *   memory_bytes       at least sinew_model_pack_workspace_size(); where that is 0 the call does nothing
 * Returns SINEW_OK, or with nothing written
 *   SINEW_ERROR_ARGUMENT   `model` or `memory` is null, or the model is not open
 *   SINEW_ERROR_WORKSPACE  the memory is too small or not aligned */
SINEW_API sinew_status sinew_model_pack(sinew_model* model, void* memory, size_t memory_bytes);

#ifdef __cplusplus
}
#endif
#endif
