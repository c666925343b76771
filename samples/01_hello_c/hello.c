/* SPDX-License-Identifier: MIT
 * The smallest whole use of sinew: a bar with two bones is bound with the heat method and its rows of weights are
 * printed. */
#include <inttypes.h>
#include <sinew/sinew.h>
#include <stdio.h>
#include <stdlib.h>

/* A square bar along y: rings of 4 vertices at heights 0, 1, 2, 3 and 4, closed by a quad at both ends. */
enum { kRings = 5, kVertices = 4 * kRings, kFaces = 4 * (kRings - 1) + 2, kInfluences = 2 };

/* Two joints: the lower bone goes from the floor to the middle, the upper one stands on it. */
static const float kJointPositions[] = {0.0f, 0.1f, 0.0f, 0.0f, 2.0f, 0.0f};
static const int32_t kJointParents[] = {-1, 0};
/* Without this the lower joint would be taken for a root marker, as it stands on the floor and has no parent. */
static const uint8_t kJointFlags[] = {SINEW_JOINT_DEFORMS, SINEW_JOINT_DEFORMS};

int main(void) {
  static const float kCorner[4][2] = {{-0.5f, -0.5f}, {-0.5f, 0.5f}, {0.5f, 0.5f}, {0.5f, -0.5f}};
  float positions[3 * kVertices];
  uint32_t offsets[kFaces + 1], corners[4 * kFaces], face = 0;
  uint16_t joints[kVertices * kInfluences], weights[kVertices * kInfluences];

  for (uint32_t v = 0; v < kVertices; ++v) {
    positions[3 * v] = kCorner[v % 4][0];
    positions[3 * v + 1] = (float)(v / 4);
    positions[3 * v + 2] = kCorner[v % 4][1];
  }
  for (uint32_t ring = 0; ring + 1 < kRings; ++ring) {
    for (uint32_t side = 0; side < 4; ++side, ++face) {
      const uint32_t a = 4 * ring + side, b = 4 * ring + (side + 1) % 4;
      const uint32_t quad[4] = {a, b, b + 4, a + 4};
      for (int i = 0; i < 4; ++i) corners[4 * face + i] = quad[i];
    }
  }
  for (uint32_t i = 0; i < 4; ++i) {
    corners[4 * face + i] = 3 - i;                   /* bottom, seen from below */
    corners[4 * (face + 1) + i] = kVertices - 4 + i; /* top */
  }
  for (uint32_t f = 0; f <= kFaces; ++f) offsets[f] = 4 * f;

  const sinew_mesh mesh = {positions, kVertices, offsets, corners, kFaces, 4 * kFaces};
  sinew_skeleton skeleton = SINEW_INIT(sinew_skeleton);
  skeleton.positions = kJointPositions;
  skeleton.parents = kJointParents;
  skeleton.joint_count = 2;
  skeleton.flags = kJointFlags;
  sinew_bind_options options = SINEW_INIT(sinew_bind_options);
  options.method = SINEW_METHOD_HEAT;
  options.influence_count = kInfluences;

  /* One block of memory, given by the caller, is all the engine ever uses. */
  size_t bytes = 0;
  sinew_status status = sinew_bind_workspace_size(NULL, kVertices, kFaces, 4 * kFaces, 2, &options, &bytes);
  void* block = NULL;
  if (status == SINEW_OK) {
    /* C99 has no aligned_alloc(): a little more, and the first address in it that is aligned. */
    block = malloc(bytes + SINEW_WORKSPACE_ALIGNMENT);
    if (block == NULL) {
      fprintf(stderr, "hello: no memory for %zu bytes\n", bytes);
      return 1;
    }
    void* const workspace = (char*)block + (SINEW_WORKSPACE_ALIGNMENT - (uintptr_t)block % SINEW_WORKSPACE_ALIGNMENT) %
                                               SINEW_WORKSPACE_ALIGNMENT;
    sinew_bind_outputs outputs = SINEW_INIT(sinew_bind_outputs);
    outputs.joint_indices = joints;
    outputs.weights = weights;
    status = sinew_bind(NULL, &mesh, &skeleton, &options, workspace, bytes, &outputs);
    free(block);
  }
  if (status != SINEW_OK) {
    fprintf(stderr, "hello: %s\n", sinew_status_text(status));
    return 1;
  }

  printf("sinew %s, %zu bytes of workspace\n", sinew_version(), bytes);
  for (uint32_t v = 0; v < kVertices; ++v) {
    const uint16_t* j = &joints[v * kInfluences];
    const uint16_t* w = &weights[v * kInfluences];
    printf("vertex %2" PRIu32 " at height %.0f: joint %u %5u/65535, joint %u %5u/65535\n", v,
           (double)positions[3 * v + 1], j[0], w[0], j[1], w[1]);
  }
  return 0;
}
