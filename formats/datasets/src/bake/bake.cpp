// SPDX-License-Identifier: MIT
// Least squares for shapes that turns of joints drive, principal components for shapes of one clip.
#include "sinew_datasets/bake.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>

#include "bake/corrections.hpp"
#include "bake/turn_clusters.hpp"
#include "sinew_formats/box.hpp"

namespace sinew {
namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

constexpr double kRidge = 3e-3;        // of unknowns whose features have a mean square of 1
constexpr double kLeastWeight = 0.02;  // a vertex with less of a joint and the one before it is not of its bend
constexpr size_t kMostBends = 12;      // of one vertex: those that concern it most

// One bend and its features, the weights of its shapes in every pose.
struct Bend {
  MorphDriver driver;
  size_t before = 0;          // the nearest joint above that has weight
  Matrix features;            // [poses x shapes] scaled to a mean square of 1
  std::vector<double> scale;  // [shapes] feature = weight / scale
};

bool same_turn(const Quaternion& a, const Quaternion& b) {
  return std::abs(a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3]) > 1 - 1e-9;
}

// Joints that bend the surface: vertices follow what is below them and something else.
std::vector<char> bending_joints(const Character& character) {
  std::vector<char> bends(character.joints.size(), 0);
  for (const std::vector<Influence>& row : character.influences) {
    double total = 0;
    for (const Influence& influence : row) total += static_cast<double>(influence.weight);
    std::map<size_t, double> below;  // by joint: weight of its subtree
    for (const Influence& influence : row) {
      size_t steps = 0;
      for (int j = static_cast<int>(influence.joint); j >= 0 && steps <= bends.size(); ++steps) {
        below[static_cast<size_t>(j)] += static_cast<double>(influence.weight);
        j = character.joints[static_cast<size_t>(j)].parent;
      }
    }
    for (const auto& [joint, weight] : below)
      if (weight > 0.01 * total && weight < 0.99 * total && character.joints[joint].parent >= 0) bends[joint] = 1;
  }
  return bends;
}

// The nearest joint above each that has weight; of a root, itself.
std::vector<size_t> joints_before(const Character& character) {
  std::vector<char> has_weight(character.joints.size(), 0);
  for (const std::vector<Influence>& row : character.influences)
    for (const Influence& influence : row)
      if (influence.weight > 0) has_weight[influence.joint] = 1;
  std::vector<size_t> before;
  for (size_t j = 0; j < character.joints.size(); ++j) {
    size_t at = j;
    do {
      if (character.joints[at].parent < 0) break;
      at = static_cast<size_t>(character.joints[at].parent);
    } while (has_weight[at] == 0);
    before.push_back(at);
  }
  return before;
}

std::vector<Bend> find_bends(const Character& character, const std::vector<size_t>& before,
                             const std::vector<Palette>& poses, const BakeSettings& settings) {
  const std::vector<char> bending = bending_joints(character);
  std::vector<Bend> bends;
  for (size_t j = 0; j < bending.size(); ++j) {
    if (bending[j] == 0) continue;
    std::vector<Quaternion> turns, turned;
    for (const Palette& pose : poses) {
      turns.push_back(joint_turn(character.joints, pose, j));
      if (!same_turn(turns.back(), kNoTurn4)) turned.push_back(turns.back());
    }
    if (turned.empty()) continue;
    Bend bend;
    bend.driver.joint = j;
    bend.before = before[j];
    bend.driver.falloff = settings.falloff;
    bend.driver.turns = turn_clusters(turned, settings.shapes_per_bend);
    const size_t shapes = bend.driver.turns.size();
    bend.features.resize(static_cast<Eigen::Index>(poses.size()), static_cast<Eigen::Index>(shapes));
    for (size_t p = 0; p < poses.size(); ++p) {
      const std::vector<double> weights = driver_weights(bend.driver, turns[p]);
      for (size_t s = 0; s < shapes; ++s)
        bend.features(static_cast<Eigen::Index>(p), static_cast<Eigen::Index>(s)) = weights[s];
    }
    for (Eigen::Index s = 0; s < bend.features.cols(); ++s) {
      bend.scale.push_back(
          std::max(1e-9, std::sqrt(bend.features.col(s).squaredNorm() / static_cast<double>(poses.size()))));
      bend.features.col(s) /= bend.scale.back();
    }
    bends.push_back(std::move(bend));
  }
  return bends;
}

// How much a bend concerns what follows a joint. The surface is solved as a whole, so a bend moves what follows the joints next
// to its own a little, too. before [J]: joints_before().
double concern(const Bend& bend, const std::vector<size_t>& before, size_t joint) {
  const size_t own = bend.driver.joint;
  if (joint == own) return 2;  // before others of the same parent
  if (joint == bend.before) return 1;
  if (before[joint] == own) return 0.5;
  if (before[before[joint]] == own) return 0.3;
  return before[joint] == bend.before ? 0.25 : 0;
}

// The bends that a vertex takes part in, those that concern it most first.
std::vector<size_t> bends_of(const std::vector<Bend>& bends, const std::vector<size_t>& before,
                             const std::vector<Influence>& row) {
  std::vector<std::pair<double, size_t>> found;
  for (size_t b = 0; b < bends.size(); ++b) {
    double weight = 0;
    for (const Influence& influence : row)
      weight += concern(bends[b], before, influence.joint) * static_cast<double>(influence.weight);
    if (weight > kLeastWeight) found.push_back({-weight, b});
  }
  std::sort(found.begin(), found.end());
  if (found.size() > kMostBends) found.resize(kMostBends);
  std::vector<size_t> out;
  for (const auto& [weight, b] : found) out.push_back(b);
  std::sort(out.begin(), out.end());
  return out;
}

// One vertex: moves d of its shapes that make L sum_k f_k d_k nearest to what skinning lacks over all poses, where L is the
// linear part of its skinning matrix and f are features. Unknowns stand coordinate by coordinate.
class VertexFit {
 public:
  explicit VertexFit(size_t pose_count) : linear_(9, static_cast<Eigen::Index>(pose_count)), lack_(3, linear_.cols()) {}

  void set(size_t pose, const Affine& m, const float* lack) {
    const auto p = static_cast<Eigen::Index>(pose);
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 3; ++c) linear_(3 * r + c, p) = m[static_cast<size_t>(4 * r + c)];
    for (int c = 0; c < 3; ++c) lack_(c, p) = static_cast<double>(lack[c]);
  }

  // [features x 3]
  Matrix solve(const Matrix& features) const {
    const Eigen::Index k = features.cols();
    Matrix normal(3 * k, 3 * k);
    Vector right(3 * k);
    for (int a = 0; a < 3; ++a) {
      Vector along = Vector::Zero(features.rows());
      for (int r = 0; r < 3; ++r) along += linear_.row(3 * r + a).cwiseProduct(lack_.row(r)).transpose();
      right.segment(a * k, k) = features.transpose() * along;
      for (int b = 0; b <= a; ++b) {
        Vector weight = Vector::Zero(features.rows());
        for (int r = 0; r < 3; ++r) weight += linear_.row(3 * r + a).cwiseProduct(linear_.row(3 * r + b)).transpose();
        normal.block(a * k, b * k, k, k).noalias() = features.transpose() * weight.asDiagonal() * features;
      }
    }
    normal.diagonal().array() += kRidge * static_cast<double>(features.rows());
    const Vector moves = normal.selfadjointView<Eigen::Lower>().llt().solve(right);
    return Eigen::Map<const Matrix>(moves.data(), k, 3);
  }

 private:
  Matrix linear_, lack_;
};

Vec3 row_of(const Matrix& moves, Eigen::Index k, double scale) {
  return {static_cast<float>(moves(k, 0) / scale), static_cast<float>(moves(k, 1) / scale),
          static_cast<float>(moves(k, 2) / scale)};
}

double length_of(const Vec3& v) {
  return std::hypot(static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z));
}

// Shapes that move nothing go, with their basis functions.
void drop_empty_shapes(Morphs* morphs) {
  std::vector<size_t> number(morphs->shapes.size(), 0);
  std::vector<MorphShape> kept;
  for (size_t s = 0; s < number.size(); ++s) {
    number[s] = morphs->shapes[s].vertices.empty() ? SIZE_MAX : kept.size();
    if (number[s] != SIZE_MAX) kept.push_back(std::move(morphs->shapes[s]));
  }
  morphs->shapes = std::move(kept);
  std::vector<MorphDriver> drivers;
  for (const MorphDriver& driver : morphs->drivers) {
    MorphDriver left{driver.joint, driver.falloff, {}, {}};
    for (size_t i = 0; i < driver.turns.size(); ++i) {
      if (number[driver.shapes[i]] == SIZE_MAX) continue;
      left.turns.push_back(driver.turns[i]);
      left.shapes.push_back(number[driver.shapes[i]]);
    }
    if (!left.turns.empty()) drivers.push_back(std::move(left));
  }
  morphs->drivers = std::move(drivers);
}

}  // namespace

Morphs bake_bends(const Character& character, const std::vector<Palette>& poses, const BakeSettings& settings,
                  const BakeProgress& progress) {
  const Corrections corrections = find_corrections(character, poses, settings.deform, progress);
  const std::vector<size_t> before = joints_before(character);
  std::vector<Bend> bends = find_bends(character, before, poses, settings);
  Morphs morphs;
  for (Bend& bend : bends) {
    for (size_t i = 0; i < bend.driver.turns.size(); ++i) {
      bend.driver.shapes.push_back(morphs.shapes.size());
      morphs.shapes.push_back({character.joints[bend.driver.joint].name + "." + std::to_string(i + 1), {}, {}});
    }
    morphs.drivers.push_back(bend.driver);
  }
  const double least = settings.least_move * static_cast<double>(box_of(character.vertices).longest_side());
  std::map<std::vector<size_t>, Matrix> features;  // many vertices have the same bends
  VertexFit fit(poses.size());
  for (size_t v = 0; v < character.vertices.size(); ++v) {
    const std::vector<size_t> near = bends_of(bends, before, character.influences[v]);
    float largest = 0;
    for (const std::vector<float>& lack : corrections.lacks)
      for (size_t c = 0; c < 3; ++c) largest = std::max(largest, std::abs(lack[3 * v + c]));
    if (near.empty() || static_cast<double>(largest) < least) continue;
    Matrix& own = features[near];
    if (own.size() == 0) {
      Eigen::Index width = 0;
      for (const size_t b : near) width += bends[b].features.cols();
      own.resize(static_cast<Eigen::Index>(poses.size()), width);
      width = 0;
      for (const size_t b : near) {
        own.middleCols(width, bends[b].features.cols()) = bends[b].features;
        width += bends[b].features.cols();
      }
    }
    for (size_t p = 0; p < poses.size(); ++p)
      fit.set(p, blended_matrix(character.influences[v], poses[p]), &corrections.lacks[p][3 * v]);
    const Matrix moves = fit.solve(own);
    Eigen::Index k = 0;
    for (const size_t b : near)
      for (size_t i = 0; i < bends[b].driver.shapes.size(); ++i, ++k) {
        const Vec3 move = row_of(moves, k, bends[b].scale[i]);
        if (!(length_of(move) >= least)) continue;
        MorphShape& shape = morphs.shapes[bends[b].driver.shapes[i]];
        shape.vertices.push_back(static_cast<uint32_t>(v));
        shape.moves.push_back(move);
      }
  }
  drop_empty_shapes(&morphs);
  return morphs;
}

Morphs bake_clip(const Character& character, const std::vector<Palette>& poses, const BakeSettings& settings,
                 size_t shape_count, const BakeProgress& progress, std::vector<std::vector<float>>* weights) {
  const Corrections corrections = find_corrections(character, poses, settings.deform, progress);
  const auto frames = static_cast<Eigen::Index>(poses.size());
  const size_t vertex_count = character.vertices.size();
  // Moves before skinning, pose by pose: least squares of one vertex, with a ridge where skinning flattens.
  Matrix moves(static_cast<Eigen::Index>(3 * vertex_count), frames);
  for (size_t p = 0; p < poses.size(); ++p)
    for (size_t v = 0; v < vertex_count; ++v) {
      const Affine m = blended_matrix(character.influences[v], poses[p]);
      Eigen::Matrix3d linear;
      for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c) linear(r, c) = m[static_cast<size_t>(4 * r + c)];
      const float* lack = &corrections.lacks[p][3 * v];
      const Eigen::Vector3d wanted(static_cast<double>(lack[0]), static_cast<double>(lack[1]),
                                   static_cast<double>(lack[2]));
      Eigen::Matrix3d normal = linear.transpose() * linear;
      normal.diagonal().array() += kRidge;
      moves.block<3, 1>(static_cast<Eigen::Index>(3 * v), static_cast<Eigen::Index>(p)) =
          normal.llt().solve(linear.transpose() * wanted);
    }
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
      if (!(length_of(move) >= least)) continue;
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
