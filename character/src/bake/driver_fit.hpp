// SPDX-License-Identifier: MIT
// Which turns of joints, alone and two together, drive a few shapes that tell most of how a region moves.
#ifndef SINEW_CHARACTER_BAKE_DRIVER_FIT_HPP
#define SINEW_CHARACTER_BAKE_DRIVER_FIT_HPP

#include <Eigen/Core>
#include <vector>

#include "sinew_character/bake/bake.hpp"

namespace sinew {

// Turns of all joints in all poses.
class PoseRotations {
 public:
  PoseRotations(const Character& character, const std::vector<Palette>& poses);

  const std::vector<std::vector<Quaternion>>& poses() const { return rotations_; }  // [poses][J]
  const std::vector<size_t>& joints() const {
    return joints_;
  }  // those that have a parent; some without weight correct poses, too
  const Eigen::MatrixXf& singles() const { return singles_; }  // [poses x 9 joints()] values of one turn each
  const Eigen::MatrixXd& gram() const { return gram_; }        // singles' times singles
  // Terms' values, each times its scale. [poses x 9 terms]
  Eigen::MatrixXf values(const std::vector<MorphTerm>& terms, const std::vector<double>& scales) const;

 private:
  std::vector<std::vector<Quaternion>> rotations_;
  std::vector<size_t> joints_;
  Eigen::MatrixXf singles_;
  Eigen::MatrixXd gram_;
};

// A driver whose weights are at most 1 in these poses; its shapes are not numbered. Fewer than shape_count where less than
// that tells all.
//   distances  [J] of the bend
//   moves      [poses x 3 vertices] of its region
MorphDriver fit_driver(const PoseRotations& rotations, const std::vector<double>& distances,
                       const Eigen::MatrixXf& moves, size_t shape_count);

}  // namespace sinew
#endif
