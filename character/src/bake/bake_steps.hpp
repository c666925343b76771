// SPDX-License-Identifier: MIT
// Steps of a bake: where a surface bends, the error of linear skinning there, and the joint rotations that drive it.
#ifndef SINEW_CHARACTER_BAKE_BAKE_STEPS_HPP
#define SINEW_CHARACTER_BAKE_BAKE_STEPS_HPP

#include <Eigen/Core>
#include <vector>

#include "sinew_character/bake/bake.hpp"
#include "sinew_formats/character.hpp"

namespace sinew {

// Where a surface bends, and what lies near.
struct Bends {
  std::vector<size_t> joints;  // with a parent, such that vertices follow both what is below and something else
  std::vector<std::vector<double>> distances;  // [bends][J] joints between the bend and what follows a joint
  std::vector<std::vector<size_t>> of_vertex;  // [V] numbers of bends, the nearest first; none where nothing bends
};

Bends find_bends(const Character& character, size_t most_of_a_vertex);

// [poses x 3 V] where each vertex would have to stand at rest, less where it does: least squares against the corrected pose, with
// a small ridge where skinning flattens.
Eigen::MatrixXf moves_before_skinning(const Character& character, const std::vector<Palette>& poses,
                                      const sinew_deform_options& deform, const BakeProgress& progress);

// Turns of all joints in all poses.
class PoseRotations {
 public:
  PoseRotations(const Character& character, const std::vector<Palette>& poses);

  const std::vector<std::vector<Quaternion>>& poses() const { return rotations_; }  // [poses][J]
  const std::vector<size_t>& joints() const {
    return joints_;
  }  // those that have a parent; some without weight correct poses, too
  const Eigen::MatrixXf& singles() const { return singles_; }  // [poses x 9 joints()] values of one rotation each
  const Eigen::MatrixXd& gram() const { return gram_; }        // singles' times singles
  // Terms' values, each times its scale. [poses x 9 terms]
  Eigen::MatrixXf values(const std::vector<MorphTerm>& terms, const std::vector<double>& scales) const;

 private:
  std::vector<std::vector<Quaternion>> rotations_;
  std::vector<size_t> joints_;
  Eigen::MatrixXf singles_;
  Eigen::MatrixXd gram_;
};

// A driver whose weights reach 1 in these poses; its shapes have no numbers yet. Fewer sums than `sum_count` where the others explain no more than
// `negligible`, a sum of squares, of the moves.
//   distances  [J] of the bend
//   moves      [poses x 3 vertices] of its region
MorphDriver fit_driver(const PoseRotations& rotations, const std::vector<double>& distances,
                       const Eigen::MatrixXf& moves, size_t sum_count, double negligible = 0);

}  // namespace sinew
#endif
