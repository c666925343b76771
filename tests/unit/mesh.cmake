# SPDX-License-Identifier: MIT
sinew_test(sinew_mesh_test SOURCES unit/mesh_quantize_test.cpp unit/mesh_test.cpp unit/skeleton_test.cpp unit/voxels_test.cpp
           unit/propagation_test.cpp unit/candidates_test.cpp unit/parts_test.cpp LIBS sinew::engine_internals LABELS unit)
