// SPDX-License-Identifier: MIT
// tinygltf under a namespace of our own: Debian's libdraco exports another version of it, and a program that loads both
// would mix the two. So it is compiled here (tinygltf.cpp), without the picture codecs that nothing needs.
#ifndef SINEW_FORMATS_GLTF_TINYGLTF_HPP
#define SINEW_FORMATS_GLTF_TINYGLTF_HPP

#define tinygltf sinew_tinygltf
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#include <tiny_gltf.h>

#endif
