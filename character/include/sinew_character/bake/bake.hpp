// SPDX-License-Identifier: MIT
// Fits corrective shapes to corrected poses, so that linear skinning with morph targets shows what the engine's deformer does.
#ifndef SINEW_CHARACTER_BAKE_HPP
#define SINEW_CHARACTER_BAKE_HPP

#include <cstdint>
#include <functional>
#include <vector>

#include "sinew/deform.h"
#include "sinew_formats/morphs.hpp"

namespace sinew {

using Palette = std::vector<Affine>;  // a skinning matrix a joint

struct BakeSettings {
  sinew_deform_options deform = SINEW_INIT(sinew_deform_options);
  size_t shapes_per_bend = 8;  // at most, each in one or two directions
  double error =
      2e-3;  // what may be left out of a vertex's moves, root mean square over the poses, as a share of the longest side
  double least_move = 5e-5;  // share of the mesh's longest side; a shape leaves vertices out that it moves by less
};

// Root mean square of distances to the corrected pose, over vertices and poses, as a share of the mesh's longest side.
struct BakeError {
  double linear = 0;  // of linear skinning alone
  double baked = 0;   // with the shapes
};

// Called once a corrected pose; false ends the work with Error.
using BakeProgress = std::function<bool()>;

// Shapes for every joint with a parent that bends the surface (vertices follow it and others), driven by turns of joints. Drivers
// are found bend by bend: the weights that tell most of how the vertices move which are nearest to it, by reduced rank regression on
// turns, single and in pairs. Both directions of such a weight are a shape each, so that weights lie in 0..1. Then each vertex is fitted to the shapes of
// the bends near it: least squares over all poses with a small ridge, with as few shapes as leave out no more than `error`. A bend that moves no
// vertex enough gets no shape. Memory: 12 bytes a pose and vertex. Throws Error for missing weights,
// no pose, or what the deformer refuses.
Morphs bake_bends(const Character& character, const std::vector<Palette>& poses, const BakeSettings& settings,
                  const BakeProgress& progress);

// At most `shape_count` shapes, two or more, for one clip, without drivers: its first principal components, and one that is always on and makes their weights lie in
// 0..1. `weights` [poses][shapes].
Morphs bake_clip(const Character& character, const std::vector<Palette>& poses, const BakeSettings& settings,
                 size_t shape_count, const BakeProgress& progress, std::vector<std::vector<float>>* weights);

// How far `morphs` are from the corrected poses, with the weights of their drivers or the given ones [poses][shapes].
BakeError bake_error(const Character& character, const Morphs& morphs, const std::vector<Palette>& poses,
                     const sinew_deform_options& deform, const BakeProgress& progress,
                     const std::vector<std::vector<float>>* weights = nullptr);

// Every joint with a parent turned about an axis of its own with a chance of 7 in 10, by up to `limit_degrees`. The same
// seed gives the same poses everywhere.
std::vector<Palette> random_palettes(const Character& character, size_t count, double limit_degrees, uint64_t seed);

}  // namespace sinew
#endif
