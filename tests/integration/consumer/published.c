/* SPDX-License-Identifier: MIT
 * What a library says of the methods of sinew/published.h: published built|left-out. */
#include <sinew/published.h>
#include <sinew/sinew.h>
#include <stdio.h>
#include <string.h>

static int wrong;
static int built;

/* A method that is not built says so, whatever else the call is given. */
static void expect(const char* what, sinew_status status) {
  if ((status == SINEW_ERROR_NOT_BUILT) == !built) return;
  printf("%s: status %d\n", what, (int)status);
  wrong = 1;
}

int main(int argc, char** argv) {
  const float positions[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, joints[] = {0, 0, 0, 0, 1, 0};
  const uint32_t corners[] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
  const int32_t parents[] = {-1, 0};
  sinew_mesh mesh = {positions, 4, NULL, corners, 4, 12};
  sinew_skeleton skeleton = SINEW_INIT(sinew_skeleton);
  skeleton.positions = joints;
  skeleton.parents = parents;
  skeleton.joint_count = 2;
  sinew_bound_character source;
  sinew_bind_options bind = SINEW_INIT(sinew_bind_options);
  sinew_rig_options rig = SINEW_INIT(sinew_rig_options);
  sinew_deform_options deform = SINEW_INIT(sinew_deform_options);
  size_t bytes = 0;
  if (argc != 2) return 2;
  built = strcmp(argv[1], "built") == 0;
  memset(&source, 0, sizeof source);
  source.mesh = &mesh;
  source.skeleton = &skeleton;
  bind.method = SINEW_METHOD_DISTANCE;
  expect("distance", sinew_bind_workspace_size(NULL, 4, 4, 12, 2, &bind, &bytes));
  rig.method = SINEW_RIG_REGIONS;
  expect("regions", sinew_rig_workspace_size(NULL, 4, 4, 12, &rig, &bytes));
  rig.method = SINEW_RIG_SLOTS;
  expect("slots", sinew_rig_workspace_size(NULL, 4, 4, 12, &rig, &bytes));
  deform.method = SINEW_DEFORM_XPBD;
  expect("xpbd", sinew_deform_create_workspace_size(&mesh, 2, 4, &deform, &bytes));
  expect("corresponding points", sinew_corresponding_points_workspace_size(&source, &mesh, &skeleton, &bytes));
  expect("reference points", sinew_retarget_reference_points(NULL, NULL, NULL, NULL, NULL, NULL, 0));
  bind.method = SINEW_METHOD_HEAT; /* ours is there either way */
  if (sinew_bind_workspace_size(NULL, 4, 4, 12, 2, &bind, &bytes) != SINEW_OK) wrong = 1;
  return wrong;
}
