/* SPDX-License-Identifier: MIT
 * Shared by all calls: version, limits, status, kernels, callbacks, and the mesh.
 *
 * Structs that grow (options, outputs, sinew_skeleton) begin with `struct_size`, the caller's sizeof, which SINEW_INIT()
 * sets; all other members are then 0. New members are added at the end, and their value 0 keeps the old behavior:
 *   a caller with an older header has a shorter struct: missing members count as 0 and are not written
 *   a caller with a newer header has a longer struct: members unknown to this library must be 0, else the call
 *   returns SINEW_ERROR_VERSION
 * Structs without a struct_size never change; sinew_model and sinew_deformer, which the library fills, have reserved
 * members. New inputs become options.
 *
 * sinew_X_workspace_size() returns the number of bytes that sinew_X() needs, as a pure function of its arguments. The
 * caller gives sinew_X() at least that many, aligned to SINEW_WORKSPACE_ALIGNMENT: either a `workspace`, which is
 * scratch until the call returns, or a `memory`, which holds the created object. */
#ifndef SINEW_TYPES_H
#define SINEW_TYPES_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Export attribute of all functions. A program that links the shared library defines SINEW_SHARED (the CMake package
 * and pkg-config do so); the library's own build defines SINEW_BUILDING as well. */
#if !defined(SINEW_SHARED)
#define SINEW_API
#elif !defined(_WIN32)
#define SINEW_API __attribute__((visibility("default")))
#elif defined(SINEW_BUILDING)
#define SINEW_API __declspec(dllexport)
#else
#define SINEW_API __declspec(dllimport)
#endif

/* Initial value of a struct that grows: struct_size is set, everything else is 0.
 *   sinew_bind_options options = SINEW_INIT(sinew_bind_options); */
#ifdef __cplusplus
extern "C++" {
template <class Struct>
constexpr Struct sinew_sized() {
  Struct value = Struct();
  value.struct_size = static_cast<uint32_t>(sizeof(Struct));
  return value;
}
}
#define SINEW_INIT(type) (sinew_sized<type>())
#else
#define SINEW_INIT(type) \
  { .struct_size = sizeof(type) }
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
  SINEW_ERROR_ARGUMENT = -1,         /* a pointer is null, struct_size is not set, or an option is out of range: see
                                      * the call's comment */
  SINEW_ERROR_WORKSPACE = -2,        /* the block is too small or not aligned to 64: ask the call's size query */
  SINEW_ERROR_COUNT = -3,            /* more vertices, joints or corners than the limits above, or none at all;
                                      * fewer than two corners a face */
  SINEW_ERROR_NOT_FINITE = -4,       /* a position is NaN or infinite: clean the mesh */
  SINEW_ERROR_INDEX = -5,            /* a face names a vertex, or a parent a joint, that does not exist; a face
                                      * has fewer than two corners */
  SINEW_ERROR_HIERARCHY = -6,        /* joint parents form a cycle */
  SINEW_ERROR_NO_JOINT = -7,         /* every joint is marked SINEW_JOINT_NEVER: clear at least one */
  SINEW_ERROR_CANCELLED = -8,        /* the progress callback asked to stop; outputs are untouched */
  SINEW_ERROR_MODEL_MAGIC = -9,      /* not a sinew model file */
  SINEW_ERROR_MODEL_VERSION = -10,   /* a model format this library does not know: update the library */
  SINEW_ERROR_MODEL_TRUNCATED = -11, /* the file is shorter or longer than its header says: fetch it again */
  SINEW_ERROR_MODEL_CHECKSUM = -12,  /* bytes changed since the file was written: fetch it again */
  SINEW_ERROR_MODEL_LAYOUT = -13,    /* sizes, offsets, shapes or layer order contradict each other */
  SINEW_ERROR_MODEL_OVERFLOW = -14,  /* an accumulator bound cannot be proven: quantize again */
  SINEW_ERROR_MODEL_ALIGNMENT = -15, /* model bytes must start at an address divisible by 8 */
  SINEW_ERROR_RANGE = -16,           /* a joint index, weight or pose is outside its stated range */
  SINEW_ERROR_KERNEL = -17,          /* the library was built without this kernel, or the processor cannot run it:
                                      * call sinew_kernel_select(), or use 0 */
  SINEW_ERROR_VERSION = -18,    /* an option is set that this library does not know: update the library, or use 0 */
  SINEW_ERROR_MODEL_TASK = -19, /* the model is for another task than this call: see sinew_model::task */
  SINEW_ERROR_NOT_BUILT = -20,  /* this library was built without the requested feature: with SINEW_SMALL_CODE,
                                      * or with SINEW_PUBLISHED_METHODS off (sinew/published.h) */
  SINEW_ERROR_CHAIN = -21       /* joints of a spring chain are not a chain of children, or two chains rotate one joint:
                           * order them from the root down, leave out one of the chains */
} sinew_status;

/* One line of English for a status; never null. */
SINEW_API const char* sinew_status_text(sinew_status status);
/* "major.minor.patch" of the library. */
SINEW_API const char* sinew_version(void);

/* Kernels: the same arithmetic with different instructions. All give the same bytes and differ in speed only. Numbers
 * are never reused. */
typedef enum sinew_kernel {
  SINEW_KERNEL_AUTO = 0,    /* the fastest that this processor runs; detected in every call, without global state */
  SINEW_KERNEL_REF = 1,     /* plain C++, on every processor */
  SINEW_KERNEL_AVX2 = 2,    /* x86-64 with AVX2 */
  SINEW_KERNEL_AVXVNNI = 3, /* x86-64 with AVX-VNNI (256 bits) */
  SINEW_KERNEL_VNNI = 4,    /* x86-64 with AVX-512 F, BW, DQ, VL and VNNI */
  SINEW_KERNEL_SIMD128 = 5, /* WebAssembly with its 128-bit SIMD */
  SINEW_KERNEL_NEON = 6,    /* ARM64 */
  SINEW_KERNEL_DSP = 7      /* 32-bit Arm with smlad: Cortex-M4, M7, M33, M55, Cortex-A */
} sinew_kernel;

/* "auto", "ref", "avx2", ... for 0, 1, 2, ...; null after the last, so that tools can list or parse them. */
SINEW_API const char* sinew_kernel_name(uint32_t kernel);
/* Returns the kernel that a call runs for options.kernel = kernel: the same, or the choice for SINEW_KERNEL_AUTO.
 * Returns 0 if this library was built without it or this processor lacks it. */
SINEW_API uint32_t sinew_kernel_select(uint32_t kernel);

/* Progress callback, called with the share of the work that is done, 0..1000. It returns 0 to continue; any other
 * value stops the call, which then returns SINEW_ERROR_CANCELLED. */
typedef int (*sinew_progress)(void* user, uint32_t done_permille);

/* Runs work on the caller's threads. It calls body(body_data, i) exactly once for each i in 0 .. count-1, in any
 * order, on any threads and in parallel or not, and returns when all of them have returned and their writes are
 * visible to its caller. count is at most the thread_count of the options. Bodies never call back and never wait for
 * one another, so a job system, a thread pool, OpenMP or a plain loop will do. */
typedef void (*sinew_parallel_for)(void* user, uint32_t count, void (*body)(void* body_data, uint32_t index),
                                   void* body_data);

/* Bits of the member `without` of options: what a call leaves out. The comment of each `without` lists its bits; any
 * other bit is SINEW_ERROR_ARGUMENT. Numbers are never reused. */
typedef enum sinew_without {
  SINEW_WITHOUT_TOES = 1,          /* toe joints */
  SINEW_WITHOUT_ENDS = 2,          /* bone ends */
  SINEW_WITHOUT_BIND = 4,          /* weights of a new skeleton */
  SINEW_WITHOUT_NAMES = 8,         /* joints' names */
  SINEW_WITHOUT_RANGE = 16,        /* the natural range of knees and elbows */
  SINEW_WITHOUT_CONTACTS = 32,     /* contacts with the floor, or of the two sides of a bend */
  SINEW_WITHOUT_TWIST_SPREAD = 64, /* spreading of twist along a bone */
  SINEW_WITHOUT_SMOOTHING = 128,   /* smoothing of bends */
  SINEW_WITHOUT_POSES = 256,       /* test poses */
  SINEW_WITHOUT_CLIPS = 512        /* animations */
} sinew_without;

/* A polygon mesh, borrowed for the time of a call. Any topology is legal. face_count may be 0. */
typedef struct sinew_mesh {
  const float* positions;        /* [vertex_count x 3] any unit, rest pose */
  uint32_t vertex_count;         /* 1 .. SINEW_MAX_VERTICES */
  const uint32_t* face_offsets;  /* [face_count + 1] CSR offsets into face_vertices; null = every face is a triangle.
                                  * A face with two corners is ignored, one with fewer is SINEW_ERROR_INDEX */
  const uint32_t* face_vertices; /* [corner_count] vertex indices */
  uint32_t face_count;
  uint32_t corner_count; /* length of face_vertices */
} sinew_mesh;

#ifdef __cplusplus
}
#endif
#endif
