// SPDX-License-Identifier: MIT
// Principal components of the corrections of one clip.
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "bake/corrections.hpp"
#include "sinew_formats/base/box.hpp"

namespace sinew {
namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

}  // namespace

Morphs bake_clip(const Character& character, const std::vector<Palette>& poses, const BakeSettings& settings,
                 size_t shape_count, const BakeProgress& progress, std::vector<std::vector<float>>* weights) {
  const auto frames = static_cast<Eigen::Index>(poses.size());
  const size_t vertex_count = character.vertices.size();
  const Matrix moves = moves_before_skinning(character, poses, settings.deform, progress).transpose().cast<double>();
  const Eigen::SelfAdjointEigenSolver<Matrix> parts(moves.transpose() * moves);  // rising eigenvalues
  const Eigen::Index count = std::min<Eigen::Index>(frames, static_cast<Eigen::Index>(shape_count));
  const double least = settings.least_move * static_cast<double>(box_of(character.vertices).longest_side());
  Morphs morphs;
  weights->assign(poses.size(), {});
  for (Eigen::Index i = 0; i < count; ++i) {
    const Vector over_time = parts.eigenvectors().col(frames - 1 - i);
    const double largest = over_time.cwiseAbs().maxCoeff();
    const Vector shape_moves = moves * over_time * largest;  // at weights that reach 1
    MorphShape shape;
    for (size_t v = 0; v < vertex_count; ++v) {
      const auto at = static_cast<Eigen::Index>(3 * v);
      const Vec3 move = {static_cast<float>(shape_moves[at]), static_cast<float>(shape_moves[at + 1]),
                         static_cast<float>(shape_moves[at + 2])};
      if (!(std::hypot(static_cast<double>(move.x), static_cast<double>(move.y), static_cast<double>(move.z)) >= least))
        continue;
      shape.vertices.push_back(static_cast<uint32_t>(v));
      shape.moves.push_back(move);
    }
    if (shape.vertices.empty()) break;  // those behind it move less
    morphs.shapes.push_back(std::move(shape));
    for (size_t p = 0; p < poses.size(); ++p)
      (*weights)[p].push_back(static_cast<float>(over_time[static_cast<Eigen::Index>(p)] / largest));
  }
  return morphs;
}

}  // namespace sinew
