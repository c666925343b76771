// SPDX-License-Identifier: MIT
// A skeleton's arrays go through sinew_rig_face() or sinew_rig_props(); longer ones come back.
#include "sinew_character/predict_face.hpp"

#include "skeleton_arrays.hpp"

namespace sinew {

namespace {

using EngineCall = decltype(&sinew_rig_face);

// Lets the skeleton grow by one call and returns how many joints there are more that are no bone ends.
size_t add_joints(const Character& character, const SkeletonOptions& options, const char* what, EngineCall engine_call,
                  PredictedSkeleton* skeleton) {
  const size_t before = skeleton->joints.size();
  SkeletonArrays arrays(character, *skeleton, what, true);
  GrowingCall call;
  call.workspace_size = [](const sinew_mesh& mesh, const sinew_rig_options& engine_options, size_t* bytes) {
    return sinew_rig_face_workspace_size(mesh.vertex_count, mesh.face_count, mesh.corner_count, &engine_options, bytes);
  };
  call.run = [&](const sinew_mesh& mesh, const sinew_rig_options& engine_options, void* block, size_t bytes,
                 sinew_rig_outputs* outputs) { return engine_call(&mesh, &engine_options, block, bytes, outputs); };
  arrays.run(character, options, call, skeleton);
  size_t more = 0;
  arrays.resize(skeleton);
  for (size_t j = before; j < arrays.joint_count(); ++j) {
    arrays.take(j, arrays.name(j), skeleton);
    more += skeleton->ends[j] == 0 ? 1 : 0;
  }
  return more;
}

}  // namespace

size_t predict_face(const Character& character, const SkeletonOptions& options, PredictedSkeleton* skeleton) {
  return add_joints(character, options, "faces", sinew_rig_face, skeleton);
}

size_t predict_props(const Character& character, const SkeletonOptions& options, PredictedSkeleton* skeleton) {
  return add_joints(character, options, "props", sinew_rig_props, skeleton);
}

}  // namespace sinew
