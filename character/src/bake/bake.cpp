// SPDX-License-Identifier: MIT
// Corrective shapes of a character: by the bends of its joints, or for one clip.
#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "bake/bake_steps.hpp"
#include "sinew_formats/base/box.hpp"

namespace sinew {

// Shapes of every bend: drivers fitted to the region that it is the nearest bend of, then least squares of each vertex on the shapes of
// all bends near it.

namespace {

using MatrixF = Eigen::MatrixXf;
using Eigen::Index;

// Influences of one vertex. With 4 the error of held out poses is 0.402 of linear skinning's, mean of ten characters,
// with 6 0.394.
constexpr size_t kMostBends = 6;
constexpr double kRidge = 1e-3;  // share of a shape's own sum of squares

using Moves = std::map<uint32_t, Vec3>;  // by vertex

// Columns of some vertices.
MatrixF region_of(const MatrixF& moves, const std::vector<uint32_t>& vertices) {
  MatrixF out(moves.rows(), static_cast<Index>(3 * vertices.size()));
  for (size_t i = 0; i < vertices.size(); ++i)
    out.middleCols<3>(static_cast<Index>(3 * i)) = moves.middleCols<3>(static_cast<Index>(3 * vertices[i]));
  return out;
}

// [poses x shapes of the driver]
MatrixF weights_of(const MorphDriver& driver, const PoseRotations& rotations) {
  MatrixF out(static_cast<Index>(rotations.poses().size()), static_cast<Index>(driver.weights.size()));
  for (size_t p = 0; p < rotations.poses().size(); ++p) {
    const std::vector<double> weights = driver_weights(driver, rotations.poses()[p]);
    for (size_t s = 0; s < weights.size(); ++s)
      out(static_cast<Index>(p), static_cast<Index>(s)) = static_cast<float>(weights[s]);
  }
  return out;
}

using Vector3 = Eigen::RowVector3d;
using Right = Eigen::Matrix<double, Eigen::Dynamic, 3>;

// A shape of fewer vertices than this costs more in a file than it mends.
constexpr size_t kLeastVertices = 12;

// Least squares of one vertex on as few shapes as leave out no more than `negligible`, a sum of squares, of what all of them explain: one by one
// the shape that explains most of what is left.
//   normal  [shapes x shapes] with the ridge
//   right   [shapes x 3] shapes times moves
//   explained  sum of squares, of all shapes together
std::vector<std::pair<Index, Vector3>> few_moves(const Eigen::MatrixXd& normal, const Right& right, double explained,
                                                 double negligible) {
  std::vector<Index> chosen;
  Right moves(0, 3);
  double own = 0;
  while (explained - own > negligible && chosen.size() < static_cast<size_t>(normal.rows())) {
    Right left = right;
    for (size_t k = 0; k < chosen.size(); ++k) left -= normal.col(chosen[k]) * moves.row(static_cast<Index>(k));
    Index best = -1;
    double most = 0;
    for (Index s = 0; s < normal.rows(); ++s) {
      const double gain = left.row(s).squaredNorm() / normal(s, s);
      if (gain > most && std::find(chosen.begin(), chosen.end(), s) == chosen.end()) most = gain, best = s;
    }
    if (best < 0) break;
    chosen.push_back(best);
    const Eigen::MatrixXd part = normal(chosen, chosen);
    const Right of_part = right(chosen, Eigen::all);
    moves = part.llt().solve(of_part);
    own = of_part.cwiseProduct(moves).sum();
  }
  std::vector<std::pair<Index, Vector3>> out;
  for (size_t k = 0; k < chosen.size(); ++k) out.emplace_back(chosen[k], moves.row(static_cast<Index>(k)));
  return out;
}

// Shapes that move nothing go, with the sums that drive no other.
void add_driver(MorphDriver driver, const std::string& joint, const std::vector<Moves>& moves, Morphs* morphs) {
  std::vector<MorphWeight> kept;
  std::vector<size_t> sums;
  for (MorphWeight weight : driver.weights) {
    if (moves[weight.shape].empty()) continue;
    MorphShape shape{joint + "." + std::to_string(kept.size() + 1), {}, {}};
    for (const auto& [vertex, move] : moves[weight.shape]) {
      shape.vertices.push_back(vertex);
      shape.moves.push_back(move);
    }
    const auto sum = std::find(sums.begin(), sums.end(), weight.sum);
    const size_t number = static_cast<size_t>(sum - sums.begin());
    if (sum == sums.end()) sums.push_back(weight.sum);
    kept.push_back({morphs->shapes.size(), number, weight.scale});
    morphs->shapes.push_back(std::move(shape));
  }
  for (MorphTerm& term : driver.terms) {
    std::vector<std::array<double, 9>> factors;
    for (const size_t sum : sums) factors.push_back(term.factors[sum]);
    term.factors = std::move(factors);
  }
  driver.weights = std::move(kept);
  if (!driver.weights.empty()) morphs->drivers.push_back(std::move(driver));
}

}  // namespace

Morphs bake_bends(const Character& character, const std::vector<Palette>& poses, const BakeSettings& settings,
                  const BakeProgress& progress) {
  const MatrixF moves = moves_before_skinning(character, poses, settings.deform, progress);
  const Bends bends = find_bends(character, kMostBends);
  const PoseRotations rotations(character, poses);
  std::vector<std::vector<uint32_t>> regions(bends.joints.size());
  std::map<std::vector<size_t>, std::vector<uint32_t>> vertices_of;  // many have the same bends
  for (uint32_t v = 0; v < bends.of_vertex.size(); ++v) {
    if (bends.of_vertex[v].empty()) continue;
    regions[bends.of_vertex[v][0]].push_back(v);
    vertices_of[bends.of_vertex[v]].push_back(v);
  }
  const float size = box_of(character.vertices).longest_side();
  const double negligible =
      static_cast<double>(poses.size()) * std::pow(settings.error * static_cast<double>(size), 2);  // of one vertex
  std::vector<MorphDriver> drivers(bends.joints.size());
  std::vector<MatrixF> weights(bends.joints.size());
  std::vector<std::vector<Moves>> shape_moves(bends.joints.size());
  for (size_t b = 0; b < drivers.size(); ++b) {
    if (regions[b].empty()) continue;
    drivers[b] = fit_driver(rotations, bends.distances[b], region_of(moves, regions[b]), settings.shapes_per_bend,
                            negligible * static_cast<double>(regions[b].size()));
    drivers[b].joint = bends.joints[b];
    weights[b] = weights_of(drivers[b], rotations);
    shape_moves[b].resize(drivers[b].weights.size());
  }
  const double least = settings.least_move * static_cast<double>(size);
  const size_t least_vertices = std::min(kLeastVertices, character.vertices.size() / 8);
  // Once with all shapes, and once more without those that few vertices chose.
  for (const bool last : {false, true}) {
    std::vector<std::vector<Moves>> chosen(shape_moves.size());
    for (size_t b = 0; b < chosen.size(); ++b) chosen[b].resize(shape_moves[b].size());
    for (const auto& [near, vertices] : vertices_of) {
      std::vector<Moves*> shapes;  // of its columns
      MatrixF own(moves.rows(), 0);
      for (const size_t b : near)
        for (size_t s = 0; s < shape_moves[b].size(); ++s) {
          if (last && shape_moves[b][s].size() < least_vertices) continue;
          own.conservativeResize(Eigen::NoChange, own.cols() + 1);
          own.rightCols<1>() = weights[b].col(static_cast<Index>(s));
          shapes.push_back(&chosen[b][s]);
        }
      if (shapes.empty()) continue;
      Eigen::MatrixXd normal = (own.transpose() * own).cast<double>();
      normal.diagonal() *= 1 + kRidge;
      const Eigen::MatrixXd right = (own.transpose() * region_of(moves, vertices)).cast<double>();
      const Eigen::MatrixXd all = normal.llt().solve(right);
      for (size_t i = 0; i < vertices.size(); ++i) {
        const auto at = static_cast<Index>(3 * i);
        const double explained = right.middleCols<3>(at).cwiseProduct(all.middleCols<3>(at)).sum();
        for (const auto& [shape, move] : few_moves(normal, right.middleCols<3>(at), explained, negligible))
          if (move.norm() >= least)
            (*shapes[static_cast<size_t>(shape)])[vertices[i]] = {
                static_cast<float>(move[0]), static_cast<float>(move[1]), static_cast<float>(move[2])};
      }
    }
    shape_moves = std::move(chosen);
  }
  Morphs morphs;
  for (size_t b = 0; b < drivers.size(); ++b)
    add_driver(std::move(drivers[b]), character.joints[bends.joints[b]].name, shape_moves[b], &morphs);
  return morphs;
}

// Principal components of the corrections of one clip.

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
  const Eigen::Index count =
      std::min<Eigen::Index>(frames, static_cast<Eigen::Index>(std::max<size_t>(shape_count, 2) - 1));
  const double least = settings.least_move * static_cast<double>(box_of(character.vertices).longest_side());
  Morphs morphs;
  weights->assign(poses.size(), {});
  Vector always = Vector::Zero(moves.rows());  // what components are at their least
  const auto add_shape = [&](const Vector& shape_moves) {
    MorphShape shape;
    for (size_t v = 0; v < vertex_count; ++v) {
      const auto at = static_cast<Eigen::Index>(3 * v);
      const Eigen::Vector3f move = shape_moves.segment<3>(at).cast<float>();
      if (!(static_cast<double>(move.norm()) >= least)) continue;
      shape.vertices.push_back(static_cast<uint32_t>(v));
      shape.moves.push_back({move[0], move[1], move[2]});
    }
    if (shape.vertices.empty()) return false;
    morphs.shapes.push_back(std::move(shape));
    return true;
  };
  for (Eigen::Index i = 0; i < count; ++i) {
    const Vector over_time = parts.eigenvectors().col(frames - 1 - i);
    const double low = over_time.minCoeff(), reach = over_time.maxCoeff() - low;
    const Vector component = moves * over_time;
    if (!(reach > 0) || !add_shape(component * reach)) break;  // those behind it move less
    always += component * low;
    for (size_t p = 0; p < poses.size(); ++p)
      (*weights)[p].push_back(static_cast<float>((over_time[static_cast<Eigen::Index>(p)] - low) / reach));
  }
  if (add_shape(always))
    for (std::vector<float>& frame : *weights) frame.push_back(1);
  return morphs;
}

}  // namespace sinew
