# SPDX-License-Identifier: MIT
# What formats is compiled from, once for every build of it: this folder's and the WebAssembly modules'.
set(sinew_formats_sources
  base/affine
  base/thread_pool
  fbx/fbx_animations
  fbx/fbx_binary
  fbx/fbx_geometry
  fbx/fbx_materials
  fbx/fbx_models
  fbx/fbx_write
  files/file_kinds
  files/files
  files/folders
  files/memory_files
  files/picture_files
  files/read_mesh
  gltf/animation_track
  gltf/bind_pose
  gltf/control_points
  gltf/cut_vertices
  gltf/document_form
  gltf/gltf_container
  gltf/gltf_decompress
  gltf/gltf_document
  gltf/gltf_draco
  gltf/gltf_from_mesh
  gltf/gltf_from_scene
  gltf/gltf_model
  gltf/gltf_morphs_write
  gltf/morph_animations
  gltf/gltf_motion_read
  gltf/gltf_motion_write
  gltf/gltf_read
  gltf/gltf_rest
  gltf/gltf_skin
  gltf/changed_document
  gltf/pick_vertices
  gltf/reduce_triangles
  gltf/spring_limits
  gltf/springs_read
  gltf/springs_write
  gltf/still_mesh
  gltf/gltf_summary
  gltf/gltf_write
  gltf/iqm_to_glb
  gltf/lod_document
  gltf/tinygltf
  gltf/unused_elements
  gltf/vrm
  gltf/vrm_animation_write
  gltf/vrm_one
  gltf/vrm_springs
  gltf/vrm_zero
  motion/actors
  motion/amc_read
  motion/bvh_read
  motion/bvh_write
  motion/morphs
  motion/motion
  motion/npy
  motion/keypoint_layouts
  motion/keypoints
  motion/named_skeletons
  motion/numpy_read
  motion/person
  motion/posed_joints
  motion/unzip
  motion/vmd_bones
  motion/vmd_read
  text/mtl
  text/obj
  text/print
  text/rig
  usd/usd_materials
  usd/usd_package
  usd/usd_skeleton
  usd/usd_write)
# Checkpoints and models: what trainer and quant meet in; a page has neither.
set(sinew_network_sources
  network/checkpoint
  network/float_network
  network/model_weights)
foreach(sources sinew_formats_sources sinew_network_sources)
  list(TRANSFORM ${sources} PREPEND ${CMAKE_CURRENT_LIST_DIR}/src/)
  list(TRANSFORM ${sources} APPEND .cpp)
endforeach()
# tinygltf itself: what includes its header before it would leave it out.
set_source_files_properties(${CMAKE_CURRENT_LIST_DIR}/src/gltf/tinygltf.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
# Where CMAKE_UNITY_BUILD is on, each room is compiled as one source: its files share the headers that they include and what these instantiate.
function(sinew_rooms_as_one target)
  get_target_property(sources ${target} SOURCES)
  foreach(source ${sources})
    if(source MATCHES "/([a-z]+)/src/([a-z]+)/")
      set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${CMAKE_MATCH_1}_${CMAKE_MATCH_2})
    endif()
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
endfunction()
