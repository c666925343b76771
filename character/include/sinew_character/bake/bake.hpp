// SPDX-License-Identifier: MIT
// Fits corrective shapes to corrected poses, so that linear skinning with morph targets reproduces the engine's
// deformer.
#ifndef SINEW_CHARACTER_BAKE_HPP
#define SINEW_CHARACTER_BAKE_HPP

#include <cstdint>
#include <functional>
#include <vector>

#include "sinew/deform.h"
#include "sinew_formats/morphs.hpp"

namespace sinew {

using Palette = std::vector<Affine>;  // one skinning matrix per joint

struct BakeSettings {
  sinew_deform_options deform = SINEW_INIT(sinew_deform_options);
  size_t shapes_per_bend = 8;  // maximum, each in one or two directions
  double error =
      2e-3;  // threshold for leaving out displacements of a vertex: root mean square over the poses, as a share of the longest side
  double least_move = 5e-5;  // share of the mesh's longest side; a shape leaves out vertices with smaller displacements
};

// Root mean square of distances to the corrected pose, over vertices and poses, as a share of the mesh's longest side.
struct BakeError {
  double linear = 0;  // of linear skinning only
  double baked = 0;   // with the shapes
};

// Called once per corrected pose; false stops the job with Error.
using BakeProgress = std::function<bool()>;

// Makes shapes for each joint with a parent that bends the surface (vertices follow it and others), driven by
// rotations of joints. Drivers are found per bend by reduced rank regression: the weights, from single rotations and
// pairs, that best predict the displacements of the vertices nearest to it. Each direction of such a weight is a
// shape, so that weights are in 0..1. Then each vertex is fitted to the shapes of nearby bends by least squares over
// all poses with a small ridge, with as few shapes as `error` allows. A bend with small displacements gets no shape.
// Memory: 12 bytes per pose and vertex. Throws Error for missing weights, no pose, or input that the deformer
// rejects.
Morphs bake_bends(const Character& character, const std::vector<Palette>& poses, const BakeSettings& settings,
                  const BakeProgress& progress);

// Makes at most `shape_count` shapes (two or more) for one clip, without drivers: its first principal components, and
// a constant one that keeps their weights in 0..1. `weights` [poses][shapes].
Morphs bake_clip(const Character& character, const std::vector<Palette>& poses, const BakeSettings& settings,
                 size_t shape_count, const BakeProgress& progress, std::vector<std::vector<float>>* weights);

// Measures the error of `morphs` relative to the corrected poses, with the weights of their drivers or the given ones
// [poses][shapes].
BakeError bake_error(const Character& character, const Morphs& morphs, const std::vector<Palette>& poses,
                     const sinew_deform_options& deform, const BakeProgress& progress,
                     const std::vector<std::vector<float>>* weights = nullptr);

// Random poses: each joint with a parent is rotated about a random axis with a probability of 0.7, by up to
// `limit_degrees`. The same seed gives the same poses on every machine.
std::vector<Palette> random_palettes(const Character& character, size_t count, double limit_degrees, uint64_t seed);

}  // namespace sinew
#endif
