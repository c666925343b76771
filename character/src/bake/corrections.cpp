// SPDX-License-Identifier: MIT
// Poses for a fit, what linear skinning lacks in them, and what is still lacking with shapes.
#include <Eigen/Cholesky>
#include <cmath>
#include <random>

#include "bake/bake_steps.hpp"
#include "sinew_character/pose/deform.hpp"
#include "sinew_character/pose/pose.hpp"
#include "sinew_formats/base/box.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {

Eigen::MatrixXf moves_before_skinning(const Character& character, const std::vector<Palette>& poses,
                                      const sinew_deform_options& deform, const BakeProgress& progress) {
  constexpr double kRidge = 2e-2;  // with 3e-3 a skirt's held out error was 0.443 of linear skinning's, with this 0.427
  if (character.influences.size() != character.vertices.size())
    throw Error(character.name + ": has no skin weights to bake; bind it first with sinew bind");
  if (poses.empty()) throw Error(character.name + ": cannot bake, there is no pose to train on");
  CharacterDeformer deformer(character, deform);
  const Morphs none;
  Eigen::MatrixXf moves(static_cast<Eigen::Index>(poses.size()),
                        static_cast<Eigen::Index>(3 * character.vertices.size()));
  for (size_t p = 0; p < poses.size(); ++p) {
    const std::vector<float>& wanted = deformer.pose(poses[p]);
    const std::vector<Vec3> linear = morphed_pose(character, none, {}, poses[p]);
    for (size_t v = 0; v < linear.size(); ++v) {
      const Affine m = blended_matrix(character.influences[v], poses[p]);
      Eigen::Matrix3d rotation;
      for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c) rotation(r, c) = m[static_cast<size_t>(4 * r + c)];
      const Eigen::Vector3d lack(static_cast<double>(wanted[3 * v] - linear[v].x),
                                 static_cast<double>(wanted[3 * v + 1] - linear[v].y),
                                 static_cast<double>(wanted[3 * v + 2] - linear[v].z));
      Eigen::Matrix3d normal = rotation.transpose() * rotation;
      normal.diagonal().array() += kRidge;
      moves.block<1, 3>(static_cast<Eigen::Index>(p), static_cast<Eigen::Index>(3 * v)) =
          normal.llt().solve(rotation.transpose() * lack).cast<float>().transpose();
    }
    if (!progress()) throw Error(character.name + ": the job was interrupted");
  }
  return moves;
}

BakeError bake_error(const Character& character, const Morphs& morphs, const std::vector<Palette>& poses,
                     const sinew_deform_options& deform, const BakeProgress& progress,
                     const std::vector<std::vector<float>>* weights) {
  CharacterDeformer deformer(character, deform);
  const Morphs none;
  double linear = 0, baked = 0;
  for (size_t p = 0; p < poses.size(); ++p) {
    const std::vector<float>& wanted = deformer.pose(poses[p]);
    const auto add = [&](const std::vector<Vec3>& found, double* sum) {
      for (size_t v = 0; v < found.size(); ++v) {
        const double x = static_cast<double>(wanted[3 * v] - found[v].x),
                     y = static_cast<double>(wanted[3 * v + 1] - found[v].y),
                     z = static_cast<double>(wanted[3 * v + 2] - found[v].z);
        *sum += x * x + y * y + z * z;
      }
    };
    add(morphed_pose(character, none, {}, poses[p]), &linear);
    add(morphed_pose(character, morphs,
                     weights != nullptr ? weights->at(p) : shape_weights(character.joints, morphs, poses[p]), poses[p]),
        &baked);
    if (!progress()) throw Error(character.name + ": the job was interrupted");
  }
  const double size = static_cast<double>(box_of(character.vertices).longest_side());
  const double count = static_cast<double>(poses.size() * character.vertices.size());
  if (!(size > 0) || count == 0) return {};
  return {std::sqrt(linear / count) / size, std::sqrt(baked / count) / size};
}

std::vector<Palette> random_palettes(const Character& character, size_t count, double limit_degrees, uint64_t seed) {
  constexpr double kChance = 0.7;
  std::mt19937_64 bits(seed);  // its distributions differ between libraries, so they are not used
  const auto draw = [&bits] { return static_cast<double>(bits() >> 11) / 9007199254740992.0; };
  const std::vector<size_t> order = joint_tree(character).parents_first;
  std::vector<Palette> out;
  for (size_t p = 0; p < count; ++p) {
    Palette palette(character.joints.size(), kIdentity);
    for (const size_t j : order) {
      const int parent = character.joints[j].parent;
      if (parent < 0) continue;
      std::array<double, 3> axis{};
      double square = 0;
      do {  // even over the sphere
        for (double& x : axis) x = 2 * draw() - 1;
        square = axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2];
      } while (!(square > 0.01 && square < 1));
      for (double& x : axis) x /= std::sqrt(square);
      const double radians = draw() < kChance ? draw() * limit_degrees * (std::acos(-1.0) / 180) : 0;
      const Vec3& at = character.joints[j].position;
      const Affine rotation =
          rotation_about(axis_rotation(axis, radians),
                         {static_cast<double>(at.x), static_cast<double>(at.y), static_cast<double>(at.z)});
      palette[j] = multiply(palette[static_cast<size_t>(parent)], rotation);
    }
    out.push_back(std::move(palette));
  }
  return out;
}

}  // namespace sinew
