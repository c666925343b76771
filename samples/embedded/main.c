/* SPDX-License-Identifier: MIT
 * Binds a character that lies in flash, with a model that lies in flash, in one static buffer; then bends every joint a
 * little and deforms the mesh. No heap, no C library beyond memcpy and memset. */
#include <sinew/sinew.h>
#include <stdint.h>

#include "board.h"
#include CHARACTER

enum { kInfluences = 4 };

extern const uint8_t model_start[], model_end[];
static _Alignas(SINEW_WORKSPACE_ALIGNMENT) uint8_t workspace[WORKSPACE_BYTES];
static uint16_t joint_indices[kVertices * kInfluences], weights[kVertices * kInfluences];

static void print_number(uint64_t value, const char* behind) {
  char text[21];
  char* at = text + sizeof text;
  *--at = 0;
  do {
    *--at = (char)('0' + value % 10);
    value /= 10;
  } while (value != 0);
  board_print(at);
  board_print(behind);
}

static void print_hash(uint64_t hash) {
  char text[17];
  for (int i = 0; i < 16; ++i) text[i] = "0123456789abcdef"[(hash >> (60 - 4 * i)) & 15];
  text[16] = 0;
  board_print(text);
  board_print("\n");
}

/* FNV-1a over values, low byte first: the same on hosts of either byte order. */
static uint64_t add_to_hash(uint64_t hash, const uint16_t* values, uint32_t count) {
  for (uint32_t i = 0; i < count; ++i) {
    hash = (hash ^ (values[i] & 0xFFu)) * 1099511628211u;
    hash = (hash ^ (values[i] >> 8)) * 1099511628211u;
  }
  return hash;
}

static int fail(const char* what, sinew_status status) {
  board_print(what);
  board_print(": ");
  board_print(sinew_status_text(status));
  board_print("\n");
  return 1;
}

/* Every joint turns by a tenth of a radian about z against its parent. Parents stand before their children here. */
static void bend(float palette[kJoints][12]) {
  const float c = 0.99500417f, s = 0.09983342f;
  for (int j = 0; j < kJoints; ++j) {
    const float *p = kJointPositions + 3 * j, *up = kJointParents[j] < 0 ? NULL : palette[kJointParents[j]];
    /* Turn about the joint's rest position, then whatever the parent does. */
    const float own[12] = {c, -s, 0, p[0] - c * p[0] + s * p[1], s, c, 0, p[1] - s * p[0] - c * p[1], 0, 0, 1, 0};
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 4; ++column) {
        float sum = up == NULL ? own[4 * row + column] : column == 3 ? up[4 * row + 3] : 0.0f;
        for (int i = 0; up != NULL && i < 3; ++i) sum += up[4 * row + i] * own[4 * i + column];
        palette[j][4 * row + column] = sum;
      }
    }
  }
}

int main(void) {
  sinew_model model;
  sinew_status status = sinew_model_open(model_start, (size_t)(model_end - model_start), &model);
  if (status != SINEW_OK) return fail("the model", status);

  const sinew_mesh mesh = {kPositions, kVertices, NULL, kCorners, kTriangles, 3 * kTriangles};
  sinew_skeleton skeleton = SINEW_INIT(sinew_skeleton);
  skeleton.positions = kJointPositions;
  skeleton.parents = kJointParents;
  skeleton.joint_count = kJoints;
  sinew_bind_options options = SINEW_INIT(sinew_bind_options);
  options.influence_count = kInfluences;
  options.candidate_count = CANDIDATES;
  options.grid_size = 16;
  options.weights_in_place = 1;
  size_t need = 0;
  status = sinew_bind_workspace_size(&model, kVertices, kTriangles, 3 * kTriangles, kJoints, &options, &need);
  if (status != SINEW_OK) return fail("the size of the workspace", status);
  board_print("character: ");
  print_number(kVertices, " vertices, ");
  print_number(kTriangles, " triangles, ");
  print_number(kJoints, " joints\nmodel: ");
  print_number(model.size_bytes, " bytes in flash\nworkspace: ");
  print_number(need, " of ");
  print_number(sizeof workspace, " bytes\n");

  uint64_t start = board_instructions();
  sinew_bind_outputs outputs = SINEW_INIT(sinew_bind_outputs);
  outputs.joint_indices = joint_indices;
  outputs.weights = weights;
  status = sinew_bind(&model, &mesh, &skeleton, &options, workspace, sizeof workspace, &outputs);
  if (status != SINEW_OK) return fail("the bind", status);
  uint64_t instructions = board_instructions() - start;
  board_print("used: ");
  print_number(outputs.used_bytes, " bytes\nkernels: ");
  board_print(sinew_kernel_name(sinew_kernel_select(SINEW_KERNEL_AUTO)));
  board_print("\nbind: ");
  print_number(instructions, " instructions\nhash: ");
  print_hash(add_to_hash(add_to_hash(1469598103934665603u, joint_indices, kVertices * kInfluences), weights,
                         kVertices * kInfluences));

  /* The workspace is free again: palette and posed vertices fit in. */
  float(*const palette)[12] = (float(*)[12])(void*)workspace;
  float* const posed = (float*)(void*)(workspace + sizeof(float[kJoints][12]));
  start = board_instructions();
  bend(palette);
  const sinew_skin skin = {joint_indices, weights, kInfluences, SINEW_WEIGHT_UNORM16};
  status = sinew_skin_linear(kPositions, kVertices, &skin, palette[0], kJoints, posed);
  if (status != SINEW_OK) return fail("the pose", status);
  instructions = board_instructions() - start;
  float far = 0;
  for (int i = 0; i < 3 * kVertices; ++i) {
    const float d = posed[i] - kPositions[i];
    far = d > far ? d : -d > far ? -d : far;
  }
  board_print("pose: ");
  print_number(instructions, " instructions, vertices move by up to ");
  print_number((uint64_t)(far * 1000), " thousandths\n");
  return 0;
}
