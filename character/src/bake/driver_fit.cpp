// SPDX-License-Identifier: MIT
// Reduced rank ridge regression (Izenman 1975) of displacements on rotation values. Constants are those that left
// least error on four characters of the deformation yardstick, in sixty poses that were in no fit and are not those
// that `sinew bake` is measured by.
#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "bake/bake_steps.hpp"

namespace sinew {
namespace {

using MatrixF = Eigen::MatrixXf;
using Matrix = Eigen::MatrixXd;
using Eigen::Index;

constexpr size_t kMostTerms = 16;
constexpr double kNearer = 0.85;   // scale of a joint's values, a joint further, before anything is known
constexpr double kFirstRidge = 4;  // of the sums of squares over the poses
constexpr double kDriverRidge = 1;
constexpr double kSharpness = 0.6;  // how much more a joint that explains more may explain in the end
constexpr double kPairs = 2;        // scale of products of two rotations
constexpr double kOneSided =
    0.05;  // a sum that goes no farther than this share of its reach to one side needs no shape there
constexpr double kRounding = 1e3;  // factors have three decimals: a third of the bytes in a file, the same weights

// [turns.joints()] Scales: 1 for the joint that explains most of the moves, by ridge regression on single rotations.
// Regions differ in what moves them (a skirt's legs both of them, a fingertip all the fingers beside it), so they are
// asked, not the tree of joints alone.
std::vector<double> scales_of_joints(const PoseRotations& rotations, const std::vector<double>& distances,
                                     const MatrixF& moves) {
  const size_t count = rotations.joints().size();
  Eigen::VectorXd prior(static_cast<Index>(9 * count));
  for (size_t j = 0; j < count; ++j)
    prior.segment<9>(static_cast<Index>(9 * j)).setConstant(std::pow(kNearer, distances[rotations.joints()[j]]));
  Matrix normal = prior.asDiagonal() * rotations.gram() * prior.asDiagonal();
  normal.diagonal().array() += kFirstRidge;
  const Matrix right = prior.asDiagonal() * (rotations.singles().transpose() * moves).cast<double>();
  const Matrix factors = prior.asDiagonal() * normal.llt().solve(right);
  std::vector<double> scales;
  for (size_t j = 0; j < count; ++j) {
    const auto at = static_cast<Index>(9 * j);
    const auto own = factors.middleRows<9>(at);
    scales.push_back(std::max(0.0, (rotations.gram().block<9, 9>(at, at) * own).cwiseProduct(own).sum()));
  }
  const double most = scales.empty() ? 0 : *std::max_element(scales.begin(), scales.end());
  for (double& scale : scales) scale = most > 0 ? std::pow(scale / most, kSharpness) : 0;
  return scales;
}

struct ScaledTerms {
  std::vector<MorphTerm> terms;
  std::vector<double> scales;
};

// Those whose values can say most.
ScaledTerms chosen_terms(const PoseRotations& rotations, const std::vector<double>& scales) {
  constexpr double kSingleSquare = 0.05, kPairSquare = 0.0009;  // mean squares of values, rotations of up to 60 degrees
  struct Candidate {
    double square, scale;
    size_t joint, with;
  };
  std::vector<Candidate> candidates;
  for (size_t a = 0; a < scales.size(); ++a) {
    const size_t joint = rotations.joints()[a];
    candidates.push_back({scales[a] * scales[a] * kSingleSquare, scales[a], joint, joint});
    for (size_t b = a + 1; b < scales.size(); ++b) {
      const double scale = kPairs * scales[a] * scales[b];
      candidates.push_back({scale * scale * kPairSquare, scale, joint, rotations.joints()[b]});
    }
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.square > b.square; });
  ScaledTerms out;
  for (const Candidate& one : candidates) {
    if (out.terms.size() == kMostTerms || !(one.square > 1e-8)) break;
    out.terms.push_back({one.joint, one.with, {}});
    out.scales.push_back(one.scale);
  }
  return out;
}

}  // namespace

PoseRotations::PoseRotations(const Character& character, const std::vector<Palette>& poses) {
  std::vector<MorphTerm> terms;
  for (size_t j = 0; j < character.joints.size(); ++j) {
    if (character.joints[j].parent < 0) continue;
    joints_.push_back(j);
    terms.push_back({j, j, {}});
  }
  for (const Palette& pose : poses) rotations_.push_back(joint_rotations(character.joints, pose));
  singles_ = values(terms, std::vector<double>(terms.size(), 1));
  gram_ = (singles_.transpose() * singles_).cast<double>();
}

MatrixF PoseRotations::values(const std::vector<MorphTerm>& terms, const std::vector<double>& scales) const {
  MatrixF out(static_cast<Index>(rotations_.size()), static_cast<Index>(9 * terms.size()));
  for (size_t t = 0; t < terms.size(); ++t)
    for (size_t p = 0; p < rotations_.size(); ++p) {
      const std::array<double, 9> nine = term_values(terms[t], rotations_[p]);
      for (size_t i = 0; i < 9; ++i)
        out(static_cast<Index>(p), static_cast<Index>(9 * t + i)) = static_cast<float>(scales[t] * nine[i]);
    }
  return out;
}

MorphDriver fit_driver(const PoseRotations& rotations, const std::vector<double>& distances, const MatrixF& moves,
                       size_t sum_count, double negligible) {
  ScaledTerms chosen = chosen_terms(rotations, scales_of_joints(rotations, distances, moves));
  MorphDriver driver;
  if (chosen.terms.empty()) return driver;
  const MatrixF values = rotations.values(chosen.terms, chosen.scales);
  Matrix normal = (values.transpose() * values).cast<double>();
  normal.diagonal().array() += kDriverRidge;
  const Eigen::LLT<Matrix> root(normal);
  // In coordinates where the normal matrix is 1, the best sums are the main axes of the solution.
  const Matrix solution = root.matrixL().solve((values.transpose() * moves).cast<double>());
  const Eigen::SelfAdjointEigenSolver<Matrix> axes(solution * solution.transpose());  // rising eigenvalues
  const Eigen::VectorXd explained = axes.eigenvalues().cwiseMax(0);
  double left = explained.sum();
  for (Index i = explained.size() - 1; i >= 0 && chosen.terms[0].factors.size() < sum_count; --i) {
    if (!(explained[i] > 1e-9 * explained[explained.size() - 1]) || left <= negligible) break;
    left -= explained[i];
    const Eigen::VectorXd factors = root.matrixU().solve(axes.eigenvectors().col(i));
    const Eigen::VectorXf sums = values * factors.cast<float>();
    const double high = static_cast<double>(sums.maxCoeff()), low = static_cast<double>(sums.minCoeff());
    const double unit = std::max(high, -low);
    if (!(unit > 0)) break;
    const size_t sum = chosen.terms[0].factors.size();
    for (size_t t = 0; t < chosen.terms.size(); ++t) {
      std::array<double, 9> nine{};
      for (size_t k = 0; k < 9; ++k)
        nine[k] = std::round(factors[static_cast<Index>(9 * t + k)] * chosen.scales[t] / unit * kRounding) / kRounding;
      chosen.terms[t].factors.push_back(nine);
    }
    for (const double reach : {high, low})
      if (std::abs(reach) > kOneSided * unit)
        driver.weights.push_back({driver.weights.size(), sum, std::round(unit / reach * kRounding) / kRounding});
  }
  driver.terms = std::move(chosen.terms);
  return driver;
}

}  // namespace sinew
