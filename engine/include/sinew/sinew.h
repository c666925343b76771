/* SPDX-License-Identifier: MIT
 * sinew: predicts skin weights of a mesh for a skeleton, in integers, inside one block of memory.
 * This C99 header is the whole public interface of the engine. Every function is reentrant: there are no globals.
 *
 * Way of a call:
 *   1. sinew_model_open()           checks every byte of a model file in place (skip it for SINEW_METHOD_HEAT);
 *      sinew_model_rearrange()      on demand, makes its weights ready for this kind of processor once for many binds
 *   2. sinew_bind_workspace_size()  says how many bytes sinew_bind() needs
 *   3. sinew_bind()                 predicts; rows of weights sum exactly
 *   4. sinew_skin_linear() / sinew_skin_dual_quaternion() pose the mesh with the result
 */
#ifndef SINEW_SINEW_H
#define SINEW_SINEW_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define SINEW_VERSION_MAJOR 0
#define SINEW_VERSION_MINOR 1
#define SINEW_VERSION_PATCH 0

#define SINEW_MAX_INFLUENCES 12u
#define SINEW_MAX_CANDIDATES 16u
#define SINEW_MAX_JOINTS 4096u
#define SINEW_MAX_VERTICES 4000000u
#define SINEW_WORKSPACE_ALIGNMENT 64u
#define SINEW_MAX_THREADS 64u

/* 0 is success; numbers are never reused. */
typedef enum sinew_status {
  SINEW_OK = 0,
  SINEW_ERROR_ARGUMENT = -1,         /* a pointer is null or an option is out of its range: see the call's comment */
  SINEW_ERROR_WORKSPACE = -2,        /* the block is too small or not aligned to 64: ask sinew_bind_workspace_size() */
  SINEW_ERROR_COUNT = -3,            /* more vertices, joints or corners than the limits above, or none at all;
                                      * fewer than two corners a face */
  SINEW_ERROR_NOT_FINITE = -4,       /* a position is NaN or infinite: clean the mesh */
  SINEW_ERROR_INDEX = -5,            /* a face names a vertex, or a parent a joint, that does not exist; a face
                                      * has fewer than two corners */
  SINEW_ERROR_HIERARCHY = -6,        /* joint parents form a cycle */
  SINEW_ERROR_NO_JOINT = -7,         /* every joint is marked SINEW_JOINT_NEVER: leave at least one usable */
  SINEW_ERROR_CANCELLED = -8,        /* the progress callback asked to stop; outputs are untouched */
  SINEW_ERROR_MODEL_MAGIC = -9,      /* not a sinew model file */
  SINEW_ERROR_MODEL_VERSION = -10,   /* a model format this library does not know: update the library */
  SINEW_ERROR_MODEL_TRUNCATED = -11, /* the file is shorter or longer than its header says: fetch it again */
  SINEW_ERROR_MODEL_CHECKSUM = -12,  /* bytes changed since the file was written: fetch it again */
  SINEW_ERROR_MODEL_LAYOUT = -13,    /* sizes, offsets, shapes or layer order contradict each other */
  SINEW_ERROR_MODEL_OVERFLOW = -14,  /* an accumulator bound cannot be proven: quantise again */
  SINEW_ERROR_MODEL_ALIGNMENT = -15, /* model bytes must start at an address divisible by 8 */
  SINEW_ERROR_RANGE = -16,           /* a joint index, weight or pose is outside its stated range */
  SINEW_ERROR_MODEL_TASK = -19,      /* the model is made for another task than this call: sinew_model::task */
  SINEW_ERROR_KERNEL = -17           /* sinew_options::kernel names kernels that this library was built without or this
                                      * processor cannot run: ask sinew_kernel_select(), or leave it 0 */
} sinew_status;

/* One line of English for a status; never null. */
const char* sinew_status_text(sinew_status status);
/* "major.minor.patch" of the library. */
const char* sinew_version(void);

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
  uint32_t task;              /* what it predicts: 0 = skin weights, for sinew_bind() */
  uint32_t input_count;       /* arrays of features that it reads */
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

/* A polygon mesh, borrowed. Any topology is legal. face_count may be 0. */
typedef struct sinew_mesh {
  const float* positions;        /* [vertex_count x 3] any unit, rest pose */
  uint32_t vertex_count;         /* 1 .. SINEW_MAX_VERTICES */
  const uint32_t* face_offsets;  /* [face_count + 1] CSR offsets into face_vertices; null = every face is a triangle.
                                  * A face of two corners is ignored, one of fewer is SINEW_ERROR_INDEX */
  const uint32_t* face_vertices; /* [corner_count] vertex indices */
  uint32_t face_count;
  uint32_t corner_count; /* length of face_vertices */
} sinew_mesh;

#define SINEW_JOINT_NEVER 1u   /* flag: this joint must get no weight */
#define SINEW_JOINT_DEFORMS 2u /* flag: this joint is known to deform. If any joint has it, all others are NEVER */

typedef struct sinew_skeleton {
  const float* positions; /* [joint_count x 3] same space as the mesh */
  const int32_t* parents; /* [joint_count] parent index or -1; any order */
  const uint8_t* flags;   /* [joint_count] SINEW_JOINT_* bits, or null */
  uint32_t joint_count;   /* 1 .. SINEW_MAX_JOINTS */
} sinew_skeleton;

typedef enum sinew_method {
  SINEW_METHOD_MODEL = 0, /* the network of the model */
  SINEW_METHOD_HEAT = 1   /* heat fields alone; model may be null */
} sinew_method;

typedef enum sinew_weight_format {
  SINEW_WEIGHT_UNORM16 = 0, /* uint16_t, a row sums to exactly 65535 */
  SINEW_WEIGHT_UNORM8 = 1,  /* uint8_t, a row sums to exactly 255 */
  SINEW_WEIGHT_FLOAT = 2    /* float, unorm16 / 65535 */
} sinew_weight_format;

/* Whether a connected component moves as one piece. Artists bind the same geometry both ways. */
typedef enum sinew_rigid_parts {
  SINEW_RIGID_PARTS_AUTO = 0,   /* as the model or the heat field says */
  SINEW_RIGID_PARTS_ALWAYS = 1, /* every component gets one joint: the one with most of its weight */
  SINEW_RIGID_PARTS_NEVER = 2   /* components that the model alone makes rigid (19/20 of the weight on one joint, but
                                 * not in the heat field) get the heat field's weights */
} sinew_rigid_parts;

/* Kernels: the same arithmetic with different instructions. Every one gives the same bytes; they differ in speed only.
 * Numbers are never reused. */
typedef enum sinew_kernel {
  SINEW_KERNEL_AUTO = 0,    /* the fastest that this processor runs; found anew in every call, nothing is remembered */
  SINEW_KERNEL_REF = 1,     /* plain C++, on every processor */
  SINEW_KERNEL_AVX2 = 2,    /* x86-64 with AVX2 */
  SINEW_KERNEL_AVXVNNI = 3, /* x86-64 with AVX-VNNI (256 bits) */
  SINEW_KERNEL_VNNI = 4,    /* x86-64 with AVX-512 F, BW, DQ, VL and VNNI */
  SINEW_KERNEL_SIMD128 = 5, /* WebAssembly with its 128-bit SIMD */
  SINEW_KERNEL_NEON = 6,    /* ARM64 */
  SINEW_KERNEL_DSP = 7      /* 32-bit Arm with smlad: Cortex-M4, M7, M33, M55, Cortex-A */
} sinew_kernel;

/* "auto", "ref", "avx2", ... for 0, 1, 2, ...; null behind the last, so that tools can list or parse them. */
const char* sinew_kernel_name(uint32_t kernel);
/* What sinew_bind() would run with for options.kernel = kernel: itself, or the choice for SINEW_KERNEL_AUTO. 0 when
 * this library was built without it or this processor lacks it. */
uint32_t sinew_kernel_select(uint32_t kernel);

/* Called now and then with a share of work done, 0..1000. Return non-zero to cancel. */
typedef int (*sinew_progress)(void* user, uint32_t done_permille);

/* The caller's threads. Calls body(body_data, i) exactly once for each i in 0 .. count-1, in any order and on any
 * threads, several at a time or none, and returns when all of them have returned; what they wrote must be visible to
 * its caller then. count is at most sinew_options::thread_count. Bodies never call back and never wait for one another,
 * so a job system, a pool, OpenMP and a plain loop all do. */
typedef void (*sinew_parallel_for)(void* user, uint32_t count, void (*body)(void* body_data, uint32_t index),
                                   void* body_data);

/* All zero means defaults. */
typedef struct sinew_options {
  uint32_t version;         /* 0 */
  uint32_t method;          /* sinew_method */
  uint32_t influence_count; /* 1..12 influences a vertex keeps; 0 = 4 */
  uint32_t candidate_count; /* 1..16 joints a vertex is scored against; 0 = the model's own. Heat scores all joints. A
                             * model whose layers are tied to its own count refuses another (SINEW_ERROR_ARGUMENT) */
  uint32_t grid_size;       /* 16..128 voxel cells along the longest side; 0 = the model's own. Heat needs no grid */
  uint32_t up_axis;         /* 0 = Y is up, 1 = Z is up */
  uint32_t weight_format;   /* sinew_weight_format */
  uint32_t symmetric;       /* 1: vertices that are each other's mirror image get mirrored rows, to the last bit (on the
                             * mirror plane itself up to the one step that an odd sum leaves over). The plane is x = c,
                             * found by itself; a character that has none stays as it is, see symmetric_vertices */
  uint32_t rigid_parts;     /* sinew_rigid_parts; locked vertices and hints have the last word */
  uint32_t softness_percent; /* 25..400: how softly the model's weights blend, 200 twice as softly; 0 = 100. Not for
                              * SINEW_METHOD_HEAT */
  const uint8_t* locked;     /* [vertex_count] non-zero: this vertex keeps the row already in the output; or null */
  sinew_progress progress;   /* or null */
  void* progress_user;
  /* [vertex_count] non-zero: a hint. The vertex keeps the row already in the output, as if it were locked, and the row
   * steers its surroundings: what was given minus what was predicted is spread over the connected part of the mesh,
   * weaker with distance. Or null. Given to sinew_bind_workspace_size() too: it asks for more then. */
  const uint8_t* hints;
  /* [vertex_count] out: how sure the strongest joint is the one an artist would choose, 0..255 = 0..100 %. The
   * strongest joint's share of the prediction, through the model's table of measured shares of hits if it has one
   * (sinew_model::confidence_count). 255 for locked and hinted vertices. Or null. */
  uint8_t* confidence;
  /* out, with `symmetric`: how many vertices have a mirror image (themselves, on the plane); 0: no mirror plane was
   * found and symmetric did nothing. Or null. */
  uint32_t* symmetric_vertices;
  uint32_t kernel;           /* sinew_kernel; another than AUTO is for tests and measurements */
  uint32_t weights_in_place; /* 1: the model's weights are read where they lie instead of being rearranged.
                              * Saves about the model's size, for small devices; slower where kernels want
                              * them rearranged. Given to sinew_bind_workspace_size() too */
  /* How the caller lends its threads, or null: everything runs on the calling thread. The progress callback is called
   * there in any case, between two calls of parallel_for. The result does not depend on either. */
  sinew_parallel_for parallel_for;
  void* parallel_user;
  uint32_t thread_count; /* 1..64 pieces that work is cut into, as many as threads are to be busy; 0 = 1. Every piece
                          * has scratch of its own: given to sinew_bind_workspace_size() too */
  /* 16..SINEW_MAX_VERTICES: a mesh with more welded vertices is bound on a surface reduced to at most as many, and its
   * rows are interpolated on it; 0 = 32768. Time and most of the workspace hardly grow from there on. Given to
   * sinew_bind_workspace_size() too. */
  uint32_t surface_vertices;
} sinew_options;

/* Bytes sinew_bind() needs for meshes of at most these counts that have no more than corner_count - 2 face_count
 * triangles once polygons are cut. A pure function of its arguments: the same on every host.
 *   model  may be null for SINEW_METHOD_HEAT; less is needed with a rearranged one
 * Returns SINEW_OK, SINEW_ERROR_ARGUMENT or SINEW_ERROR_COUNT; *size_bytes is 0 on failure. */
sinew_status sinew_bind_workspace_size(const sinew_model* model, uint32_t vertex_count, uint32_t face_count,
                                       uint32_t corner_count, uint32_t joint_count, const sinew_options* options,
                                       size_t* size_bytes);

/* Predicts skin weights.
 *   workspace  scratch, 64-byte aligned, size from sinew_bind_workspace_size(); content is undefined afterwards
 *   joints     out [vertex_count x N] uint16 joint indices, N = influence_count, sorted by falling weight, ties by
 *              lower joint index; unused slots are joint 0 with weight 0; no joint twice in a row
 *   weights    out [vertex_count x N] in weight_format; no row is empty
 *   used_bytes out, may be null: high-water mark of the workspace
 * For locked and hinted vertices both outputs are input and stay as they are: joint indices must exist, and a hint's
 * weights must be finite, not negative and not all 0 (SINEW_ERROR_RANGE).
 * Returns SINEW_OK or a status; outputs are untouched on failure. Same bytes on every platform. */
sinew_status sinew_bind(const sinew_model* model, const sinew_mesh* mesh, const sinew_skeleton* skeleton,
                        const sinew_options* options, void* workspace, size_t workspace_bytes, uint16_t* joints,
                        void* weights, size_t* used_bytes);

/* Deforms rest positions with linear blend skinning.
 *   positions  in  [vertex_count x 3] float
 *   joints, weights in [vertex_count x influence_count], weights unorm16 (rows sum to 65535)
 *   palette    in  [joint_count x 12] row-major 3x4, pose times inverse bind per joint
 *   out        out [vertex_count x 3]; may be equal to positions
 * Float arithmetic in a fixed order (it is no part of the bit-exact result path).
 * Returns SINEW_OK, SINEW_ERROR_ARGUMENT, or SINEW_ERROR_RANGE when a joint index is >= joint_count. */
sinew_status sinew_skin_linear(const float* positions, uint32_t vertex_count, const uint16_t* joints,
                               const uint16_t* weights, uint32_t influence_count, const float* palette,
                               uint32_t joint_count, float* out);

/* The same with dual quaternion skinning (Kavan et al. 2008): rotations blend without the candy-wrapper collapse.
 *   palette  in [joint_count x 12] as above; the 3x3 part must be a rotation (uniform scale 1). */
sinew_status sinew_skin_dual_quaternion(const float* positions, uint32_t vertex_count, const uint16_t* joints,
                                        const uint16_t* weights, uint32_t influence_count, const float* palette,
                                        uint32_t joint_count, float* out);

#ifdef __cplusplus
}
#endif
#endif
