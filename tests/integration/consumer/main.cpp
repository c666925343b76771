// SPDX-License-Identifier: MIT
// The same through the C++ wrapper, built as engines often are: without exceptions and RTTI.
#include <cstdio>
#include <sinew/sinew.hpp>

int main() {
  const float positions[] = {0, 0, 0, 1, 0, 0, 0, 1, 0}, joint[] = {0, 0, 0};
  const uint32_t corners[] = {0, 1, 2};
  const int32_t parent = -1;
  const sinew_mesh mesh = {positions, 3, nullptr, corners, 1, 3};
  sinew_skeleton skeleton = SINEW_INIT(sinew_skeleton);
  skeleton.positions = joint;
  skeleton.parents = &parent;
  skeleton.joint_count = 1;
  sinew::Options options;
  options.method = SINEW_METHOD_HEAT;
  sinew::Workspace workspace;
  sinew::Skin<uint8_t> skin;
  const sinew_status status = sinew::bind(nullptr, mesh, skeleton, options, &workspace, &skin);
  if (status != SINEW_OK || skin.weights[0] != 255) return 1;
  std::printf("sinew %s\n", sinew_version());
  return 0;
}
