// SPDX-License-Identifier: MIT
// The mesh is laid out as hands of bodies lie, with an arm of two joints, and the model of hands is asked for its fingers.
#include "sinew_character/predict/lone_hand.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "sinew_character/predict/predict_details.hpp"

namespace sinew {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Thirteen hands of training characters reach 0.165 to 0.245, one of another world 0.125, and no other one more than
// 0.137 (trainer/configs/RESULTS.md).
constexpr float kLeastAgreement = 0.15f;
// A hand of the other side that agrees this well is as good. All ten training hands whose names tell their side have it, seven of them with
// less than this of the other one.
constexpr float kAsGood = 0.8f;
constexpr double kAxisSteps = 4096;  // axes are rounded, so that the last bits of a sum decide nothing
// Shares of the length before the wrist: none, or an arm of that length.
constexpr std::array<double, 3> kWrists = {0.04, 0.25, 0.5};
constexpr double kHandEnd = 0.86;  // of a hand's length: where a hand's bone ends

Vector3d to_vec3(const Vec3& p) { return {p.x, p.y, p.z}; }
Vec3 point(const Vector3d& p) {
  return {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
}

// Rows: the longest, the middle and the shortest axis of the surface.
Matrix3d axes_of(const Character& mesh) {
  Vector3d sum = Vector3d::Zero();
  Matrix3d squares = Matrix3d::Zero();
  double area = 0;
  for (size_t f = 0; f < mesh.face_count(); ++f)
    for (uint32_t c = mesh.face_offsets[f] + 1; c + 1 < mesh.face_offsets[f + 1]; ++c) {
      const Vector3d a = to_vec3(mesh.vertices[mesh.face_vertices[mesh.face_offsets[f]]]),
                     b = to_vec3(mesh.vertices[mesh.face_vertices[c]]),
                     d = to_vec3(mesh.vertices[mesh.face_vertices[c + 1]]);
      const double own = 0.5 * (b - a).cross(d - a).norm();
      const Vector3d middle = (a + b + d) / 3;
      area += own;
      sum += own * middle;
      squares += own * middle * middle.transpose();
    }
  if (!(area > 0)) return Matrix3d::Identity();
  const Vector3d mean = sum / area;
  const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(squares / area - mean * mean.transpose());  // rising
  Matrix3d rows;
  for (int k = 0; k < 2; ++k) {
    Vector3d axis = solver.eigenvectors().col(2 - k);
    for (double& v : axis) v = std::round(v * kAxisSteps) / kAxisSteps;
    if (k == 1) axis -= axis.dot(rows.row(0)) * rows.row(0).transpose();
    rows.row(k) = axis.normalized().transpose();
  }
  rows.row(2) = rows.row(0).cross(rows.row(1));
  return rows;
}

// How the mesh is laid out: fingers along x, or against it for a right hand, the palm's axis along y.
struct Layout {
  Matrix3d turn;
  bool right = false;
};

Layout layout_of(const Matrix3d& axes, bool back, bool over, bool right) {
  Layout layout;
  layout.right = right;
  const Vector3d x = (back != right ? -1.0 : 1.0) * axes.row(0).transpose(),
                 y = (over ? -1.0 : 1.0) * axes.row(2).transpose();
  layout.turn.row(0) = x.transpose();
  layout.turn.row(1) = y.transpose();
  layout.turn.row(2) = x.cross(y).transpose();
  return layout;
}

// Where a share of the laid out mesh's length is, in the middle of what is near; 0 is behind the wrist, 1 where fingers end.
Vector3d along(const Character& laid, const Layout& layout, double share) {
  constexpr double kNear = 0.12;
  double low = laid.vertices[0].x, high = low;
  for (const Vec3& v : laid.vertices) {
    low = std::min(low, double{v.x});
    high = std::max(high, double{v.x});
  }
  const double x = layout.right ? high + share * (low - high) : low + share * (high - low);
  Vector3d sum(0, 0, 0);
  double count = 0;
  for (const Vec3& v : laid.vertices) {
    if (std::abs(v.x - x) > kNear * (high - low)) continue;
    sum += to_vec3(v);
    ++count;
  }
  return count > 0 ? Vector3d(x, sum.y() / count, sum.z() / count) : Vector3d(x, 0, 0);
}

// An arm as long as the hand, the hand and its end.
PredictedSkeleton arm_of(const Character& laid, const Layout& layout, double wrist) {
  const Vector3d hand = along(laid, layout, wrist), tip = along(laid, layout, wrist + kHandEnd * (1 - wrist));
  PredictedSkeleton arm;
  const std::string side = layout.right ? "Right" : "Left";
  arm.joints = {{side + "ForeArm", point(2 * hand - tip), -1, true},
                {side + "Hand", point(hand), 0, true},
                {side + "Hand_end", point(tip), 1, false}};
  arm.classes = {SINEW_CLASS_FOREARM, SINEW_CLASS_HAND, SINEW_CLASS_HAND};
  arm.ends = {0, 0, 1};
  arm.partners.assign(3, -1);
  arm.confidence.assign(3, 1);
  arm.parent_confidence.assign(3, 1);
  return arm;
}

float agreement_of(const PredictedSkeleton& skeleton) {
  float sum = 0;
  for (size_t j = 0; j < skeleton.joints.size(); ++j)
    if (is_finger_class(skeleton.classes[j]) && skeleton.ends[j] == 0) sum += skeleton.confidence[j];
  return sum / 15;  // three joints of five fingers
}

// The best of one layout's wrists.
struct LayoutCandidate {
  Layout layout;
  double wrist = 0;
  PredictedSkeleton skeleton;
  float agreement = 0;
};

class Search {
 public:
  Search(const Character& character, const sinew_model& hands, uint32_t kernel) : character_(character), hands_(hands) {
    options_.kernel = kernel;
    laid_.name = character.name;
    laid_.vertices = character.vertices;
    laid_.face_vertices = character.face_vertices;
    laid_.face_offsets = character.face_offsets;
  }

  // The bare mesh in that layout, until the next one is asked for.
  const Character& laid(const Layout& layout) {
    for (size_t v = 0; v < laid_.vertices.size(); ++v)
      laid_.vertices[v] = point(layout.turn * to_vec3(character_.vertices[v]));
    return laid_;
  }

  // Every layout with the first wrist, the best one with the others.
  LayoutCandidate run() {
    const Matrix3d axes = axes_of(character_);
    LayoutCandidate best;
    for (uint32_t way = 0; way < 8; ++way) {
      LayoutCandidate one;
      one.layout = layout_of(axes, (way & 1) != 0, (way & 2) != 0, (way & 4) != 0);
      ask(laid(one.layout), kWrists[0], &one);
      most_[one.layout.right ? 1 : 0] = std::max(most_[one.layout.right ? 1 : 0], one.agreement);
      if (one.agreement > best.agreement) best = std::move(one);
    }
    if (best.agreement > 0) {
      const Character& mesh = laid(best.layout);
      for (size_t w = 1; w < kWrists.size(); ++w) ask(mesh, kWrists[w], &best);
    }
    best.skeleton.seconds = seconds_;
    return best;
  }
  bool side_known() const { return std::min(most_[0], most_[1]) < kAsGood * std::max(most_[0], most_[1]); }

 private:
  void ask(const Character& mesh, double wrist, LayoutCandidate* one) {
    PredictedSkeleton skeleton = arm_of(mesh, one->layout, wrist);
    (void)predict_hands(mesh, hands_, options_, &skeleton);
    seconds_ += skeleton.seconds;
    const float agreement = agreement_of(skeleton);
    if (agreement <= one->agreement) return;
    one->agreement = agreement;
    one->wrist = wrist;
    one->skeleton = std::move(skeleton);
  }

  const Character& character_;
  Character laid_;
  const sinew_model& hands_;
  SkeletonOptions options_;
  double seconds_ = 0;
  std::array<float, 2> most_ = {0, 0};  // agreement of left hands and of right ones
};

// Where the mesh begins at the hand, the arm was only for laying it out.
void drop_arm(PredictedSkeleton* skeleton) {
  for (std::vector<uint8_t>* one : {&skeleton->classes, &skeleton->ends}) one->erase(one->begin());
  for (std::vector<float>* one : {&skeleton->confidence, &skeleton->parent_confidence}) one->erase(one->begin());
  skeleton->joints.erase(skeleton->joints.begin());
  skeleton->partners.erase(skeleton->partners.begin());
  for (Joint& joint : skeleton->joints) --joint.parent;
}

}  // namespace

std::optional<LoneHand> find_lone_hand(const Character& character, const sinew_model& hands,
                                       const SkeletonOptions& options) {
  Search search(character, hands, options.kernel);
  LayoutCandidate found = search.run();
  if (found.agreement < kLeastAgreement) return std::nullopt;
  LoneHand hand = {std::move(found.skeleton), found.layout.right, false, search.side_known(), found.agreement};
  if (found.wrist == kWrists[0]) {
    drop_arm(&hand.skeleton);
  } else {
    hand.skeleton.joints[0].position = point(along(search.laid(found.layout), found.layout, kWrists[0]));
  }
  for (Joint& joint : hand.skeleton.joints)
    joint.position = point(found.layout.turn.transpose() * to_vec3(joint.position));
  for (const uint8_t c : hand.skeleton.classes) hand.thumb = hand.thumb || c == SINEW_CLASS_THUMB;
  return hand;
}

}  // namespace sinew
