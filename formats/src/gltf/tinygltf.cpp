// SPDX-License-Identifier: MIT
// Compiles tinygltf's functions; no other file does.
#define TINYGLTF_IMPLEMENTATION
#include "gltf/gltf_model.hpp"
