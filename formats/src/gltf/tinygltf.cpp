// SPDX-License-Identifier: MIT
// The one place where tinygltf's functions are compiled.
#define TINYGLTF_IMPLEMENTATION
#include "gltf/gltf_model.hpp"
