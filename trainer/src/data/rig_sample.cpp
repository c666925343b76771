// SPDX-License-Identifier: MIT
// Poses and stretches a character by its own weights, and asks the engine for points.
#include "data/rig_sample.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "core/random.hpp"
#include "data/engine_mesh.hpp"
#include "data/point_sample.hpp"
#include "rig/rig_task.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_trainer/sample.hpp"

namespace sinew {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Vector3d vec(const std::array<double, 3>& p) { return {p[0], p[1], p[2]}; }
std::array<double, 3> arr(const Vector3d& v) { return {v.x(), v.y(), v.z()}; }

// How far joints of a class turn, standard deviation in radians.
double rotation_sigma(JointClass c) {
  switch (c) {
    case kClassUpperArm:
      return 0.45;
    case kClassForearm:
    case kClassWing:
    case kClassHair:
    case kClassEar:
      return 0.3;
    case kClassThigh:
    case kClassCalf:
    case kClassTail:
      return 0.25;
    case kClassHand:
      return 0.2;
    case kClassToe:
      return 0.1;
    case kClassSpine:
    case kClassClavicle:
      return 0.08;
    case kClassHip:
      return 0.05;
    case kClassPelvis:
      return 0;
    default:
      return 0.15;
  }
}

double segment_distance(const Vector3d& p, const Vector3d& a, const Vector3d& b) {
  const Vector3d along = b - a;
  const double t = std::clamp((p - a).dot(along) / std::max(along.squaredNorm(), 1e-12), 0.0, 1.0);
  return (p - a - t * along).norm();
}

}  // namespace

RigSource::RigSource(const Character& character)
    : name_(character.name), family_(family_of(character.name)), target_(target_skeleton(character)) {
  std::vector<Point> vertices;
  std::vector<uint32_t> source;
  surface_of(character, &vertices, &triangles_, &source);
  for (const uint32_t v : source) influences_.push_back(character.influences[v]);
  const EngineMesh engine(name_, vertices, triangles_);
  const MirrorFrame frame = engine.mirror_frame();

  Vector3d low = vec(vertices[0]), high = low;
  for (const Point& p : vertices) {
    low = low.cwiseMin(vec(p));
    high = high.cwiseMax(vec(p));
  }
  const double side = std::max((high - low).maxCoeff(), 1e-30), plane = static_cast<double>(frame.plane) / kSide;
  const auto to_frame = [&](const Vector3d& p) -> Point {
    const double x = (p.x() - 0.5 * (low.x() + high.x())) / side, y = (p.y() - low.y()) / side,
                 z = (p.z() - 0.5 * (low.z() + high.z())) / side;
    if (frame.turned()) return {plane - z, y, x};
    return {x - plane, y, z};
  };
  for (const Point& p : vertices) vertices_.push_back(to_frame(vec(p)));
  for (const Joint& j : character.joints) {
    joints_.push_back(to_frame({j.position.x, j.position.y, j.position.z}));
    parents_.push_back(j.parent);
  }
  std::vector<uint8_t> placed(parents_.size(), 0);
  while (order_.size() < parents_.size()) {
    const size_t before = order_.size();
    for (uint32_t j = 0; j < parents_.size(); ++j) {
      if (placed[j] || (parents_[j] >= 0 && !placed[static_cast<size_t>(parents_[j])])) continue;
      placed[j] = 1;
      order_.push_back(j);
    }
    if (order_.size() == before) throw Error(name_ + ": the joints' parents form a circle");
  }

  kids_.resize(target_.joints.size());
  for (uint32_t i = 0; i < target_.joints.size(); ++i) {
    target_joints_.push_back(to_frame(vec(target_.joints[i].position)));
    if (target_.joints[i].parent >= 0) kids_[static_cast<size_t>(target_.joints[i].parent)].push_back(i);
  }
  for (uint32_t i = 0; i < target_joints_.size(); ++i) {
    Vector3d mirrored = vec(target_joints_[i]);
    mirrored.x() = -mirrored.x();
    int best = -1;
    double least = 0.04;
    for (uint32_t j = 0; j < target_joints_.size(); ++j) {
      const double d = (vec(target_joints_[j]) - mirrored).norm();
      if (target_.joints[i].tip == target_.joints[j].tip && d < least) {
        least = d;
        best = static_cast<int>(j);
      }
    }
    partner_.push_back(best);
  }
  for (uint32_t i = 0; i < partner_.size(); ++i) {
    if (partner_[i] >= 0 && partner_[static_cast<size_t>(partner_[i])] != static_cast<int>(i)) partner_[i] = -1;
  }

  // Connected parts of welded triangles.
  std::map<Point, uint32_t> weld;
  std::vector<uint32_t> root(vertices_.size());
  std::iota(root.begin(), root.end(), 0u);
  const auto find = [&](uint32_t v) {
    while (root[v] != v) v = root[v] = root[root[v]];
    return v;
  };
  for (uint32_t v = 0; v < vertices.size(); ++v) root[find(v)] = find(weld.emplace(vertices[v], v).first->second);
  for (const auto& t : triangles_) {
    root[find(t[1])] = find(t[0]);
    root[find(t[2])] = find(t[0]);
  }
  std::map<uint32_t, uint32_t> part_number;
  for (const auto& t : triangles_) {
    part_.push_back(part_number.emplace(find(t[0]), static_cast<uint32_t>(part_number.size())).first->second);
    const Vector3d a = vec(vertices_[t[0]]);
    area_.push_back((vec(vertices_[t[1]]) - a).cross(vec(vertices_[t[2]]) - a).norm());
  }
  parts_ = static_cast<uint32_t>(part_number.size());
}

RigSource::Posed RigSource::pose(uint64_t seed, double strength) const {
  Posed posed{vertices_, target_joints_, std::vector<uint8_t>(triangles_.size(), 0), true};
  if (strength <= 0) return posed;
  Random random(seed);
  posed.symmetric = random.uniform() < 0.7;
  const size_t bones = static_cast<size_t>(
      std::count_if(target_.joints.begin(), target_.joints.end(), [](const TargetJoint& j) { return !j.tip; }));
  std::vector<Vector3d> turn(bones, Vector3d::Zero());
  std::vector<std::array<double, 2>> stretch(bones);
  for (size_t i = 0; i < bones; ++i) {
    const JointClass c = target_.joints[i].joint_class;
    const int partner = partner_[i];
    if (posed.symmetric && partner >= 0 && partner < static_cast<int>(i)) {
      const size_t p = static_cast<size_t>(partner);
      turn[i] = turn[p].cwiseProduct(Vector3d(1, -1, -1));
      stretch[i] = stretch[p];
      continue;
    }
    constexpr double kStrengths[3] = {0.5, 1, 1.5};
    const double sigma = rotation_sigma(c) * strength * kStrengths[random.below(3)];
    for (int axis = 0; axis < 3; ++axis) turn[i][axis] = sigma * random.normal();
    if (random.uniform() < 0.3) turn[i].setZero();
    if (posed.symmetric && partner == static_cast<int>(i)) turn[i].y() = turn[i].z() = 0;
    const bool trunk = c == kClassPelvis || c == kClassSpine || c == kClassNeck;
    const double spread = c == kClassHead ? 0.22 : trunk ? 0.12 : 0.18;
    const double along = spread * random.normal(), across = c == kClassHead ? along : spread * random.normal();
    stretch[i] = {std::clamp(strength * along, -0.5, 0.5), std::clamp(strength * across, -0.5, 0.5)};
  }
  std::vector<Matrix3d> scale(bones);
  for (size_t i = 0; i < bones; ++i) {
    Vector3d along(0, 1, 0);
    if (!kids_[i].empty()) {
      Vector3d mean = Vector3d::Zero();
      for (const uint32_t k : kids_[i]) mean += vec(target_joints_[k]);
      const Vector3d offset = mean / static_cast<double>(kids_[i].size()) - vec(target_joints_[i]);
      if (offset.norm() > 1e-9) along = offset.normalized();
    }
    const double s = std::exp(stretch[i][0]), r = std::exp(stretch[i][1]);
    scale[i] = r * Matrix3d::Identity() + (s - r) * along * along.transpose();
  }
  // The character's own joints turn where a target joint has its place from them; scales act at the joint, not below it.
  std::map<uint32_t, size_t> target_of;
  for (size_t i = 0; i < bones; ++i) target_of[target_.joints[i].source] = i;
  std::vector<Matrix3d> rotation(joints_.size()), linear(joints_.size());
  std::vector<Vector3d> origin(joints_.size());
  for (const uint32_t j : order_) {
    Matrix3d own = Matrix3d::Identity();
    const auto at = target_of.find(j);
    if (at != target_of.end() && turn[at->second].norm() > 1e-12) {
      own = Eigen::AngleAxisd(turn[at->second].norm(), turn[at->second].normalized()).toRotationMatrix();
    }
    if (parents_[j] < 0) {
      rotation[j] = own;
      origin[j] = vec(joints_[j]);
    } else {
      const size_t p = static_cast<size_t>(parents_[j]);
      rotation[j] = rotation[p] * own;
      origin[j] = origin[p] + linear[p] * (vec(joints_[j]) - vec(joints_[p]));
    }
    linear[j] = rotation[j] * scale[target_.owners[j]];
  }
  const Vector3d whole(std::exp(0.1 * strength * random.normal()), std::exp(0.1 * strength * random.normal()),
                       std::exp(0.1 * strength * random.normal()));
  for (size_t v = 0; v < vertices_.size(); ++v) {
    Vector3d sum = Vector3d::Zero();
    double weights = 0;
    for (const Influence& i : influences_[v]) {
      sum += i.weight * (origin[i.joint] + linear[i.joint] * (vec(vertices_[v]) - vec(joints_[i.joint])));
      weights += i.weight;
    }
    const Vector3d moved = weights > 1e-6 ? Vector3d(sum / weights) : vec(vertices_[v]);
    posed.vertices[v] = arr(moved.cwiseProduct(whole));
  }
  for (size_t i = 0; i < target_joints_.size(); ++i) {
    const uint32_t j = target_.joints[i].source;
    posed.joints[i] = arr((origin[j] + linear[j] * (vec(target_joints_[i]) - vec(joints_[j]))).cwiseProduct(whole));
  }

  // Small parts vanish, as hats and belts do; never more than half of what a joint moves.
  if (random.uniform() < 0.4 && parts_ > 1) {
    std::vector<double> area(parts_, 0.0), moved(bones, 0.0);
    std::vector<uint32_t> owner(triangles_.size());
    std::vector<double> sums(bones);
    for (size_t t = 0; t < triangles_.size(); ++t) {
      area[part_[t]] += area_[t];
      std::fill(sums.begin(), sums.end(), 0.0);
      for (const uint32_t v : triangles_[t])
        for (const Influence& i : influences_[v]) sums[target_.owners[i.joint]] += i.weight;
      owner[t] = static_cast<uint32_t>(std::max_element(sums.begin(), sums.end()) - sums.begin());
      moved[owner[t]] += area_[t];
    }
    const double all = std::accumulate(area.begin(), area.end(), 0.0);
    const auto largest = static_cast<uint32_t>(std::max_element(area.begin(), area.end()) - area.begin());
    for (uint32_t p = 0; p < parts_; ++p) {
      if (p == largest || area[p] >= 0.15 * all || random.uniform() >= 0.35) continue;
      std::vector<double> own(bones, 0.0);
      for (size_t t = 0; t < triangles_.size(); ++t)
        if (part_[t] == p) own[owner[t]] += area_[t];
      bool small = true;
      for (size_t j = 0; j < bones; ++j) small = small && own[j] <= 0.5 * moved[j] + 1e-12;
      if (!small) continue;
      for (size_t t = 0; t < triangles_.size(); ++t)
        if (part_[t] == p) posed.gone[t] = 1;
    }
  }
  return posed;
}

RigSource::Placed RigSource::place(const Posed& posed, uint64_t seed) const {
  std::vector<uint32_t> number(vertices_.size(), UINT32_MAX), source;
  std::vector<Point> vertices;
  std::vector<std::array<uint32_t, 3>> triangles;
  for (size_t t = 0; t < triangles_.size(); ++t) {
    if (posed.gone[t]) continue;
    std::array<uint32_t, 3> corners = triangles_[t];
    for (uint32_t& v : corners) {
      if (number[v] == UINT32_MAX) {
        number[v] = static_cast<uint32_t>(vertices.size());
        vertices.push_back(posed.vertices[v]);
        source.push_back(v);
      }
      v = number[v];
    }
    triangles.push_back(corners);
  }
  Placed placed{EngineMesh(name_, vertices, triangles), {}, {}};
  EngineMesh& engine = placed.engine;
  MirrorFrame frame;  // of the character before it was posed
  const float zero[3] = {0, 0, 0};
  frame.plane = quantize_point(engine.quantizer, zero).x;
  Random random(mix_seeds(seed, 3));
  if (!posed.symmetric && random.uniform() < 0.5) frame.plane = 0;  // nobody would find it
  apply_mirror_frame(frame, &engine.mesh);
  for (const Point& p : posed.joints) {  // in grid units of the posed character's own box
    const float f[3] = {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])};
    const Vec3i at = frame.to(quantize_point(engine.quantizer, f));
    placed.joints.push_back(arr(Vector3d(at.x, at.y, at.z) / kSide));
  }
  placed.source.assign(engine.mesh.welded_count, UINT32_MAX);
  for (uint32_t v = 0; v < vertices.size(); ++v) {
    uint32_t& first = placed.source[engine.mesh.vertex_to_welded[v]];
    if (first == UINT32_MAX) first = source[v];
  }
  return placed;
}

void with_point_set(const EngineMesh& engine, uint64_t seed, const std::function<void(const PointSet&)>& use) {
  Interior interior;
  PointSet set;
  const auto run = [&](Arena& arena) {
    (void)interior.allocate(arena);
    (void)set.allocate(arena);
    (void)build_interior(engine.mesh, arena, &interior);
    (void)make_point_set(engine.mesh, interior, seed, arena, &set);
  };
  Arena measuring;
  run(measuring);
  Workspace block(measuring.high_water());
  Arena arena(block.data(), block.size());
  run(arena);
  use(set);
}

RigSample RigSource::sample(const Posed& posed, uint64_t seed) const {
  const Placed placed = place(posed, seed);
  RigSample s;
  with_point_set(placed.engine, seed, [&](const PointSet& set) { s = label(placed, set); });
  return s;
}

RigSample RigSource::label(const Placed& placed, const PointSet& set) const {
  std::vector<Vector3d> joints;
  for (const Point& p : placed.joints) joints.push_back(vec(p));

  RigSample s = point_sample(set);
  s.name = name_;
  s.family = family_;
  std::vector<double> sums(target_.joints.size());
  for (uint32_t i = 0; i < kSetPoints; ++i) {
    const SurfacePoint& point = set.points[i];
    std::fill(sums.begin(), sums.end(), 0.0);
    for (int corner = 0; corner < 3; ++corner) {
      for (const Influence& influence : influences_[placed.source[point.corner[corner]]])
        sums[target_.owners[influence.joint]] += influence.weight * point.share[corner] / 32768.0;
    }
    const size_t own = static_cast<size_t>(std::max_element(sums.begin(), sums.end()) - sums.begin());
    const Vector3d p = Vector3d(point.position.x, point.position.y, point.position.z) / kSide;
    size_t end = own;
    double least = 1e9;
    for (const uint32_t k : kids_[own]) {
      const double d = segment_distance(p, joints[own], joints[k]);
      if (d < least) {
        least = d;
        end = k;
      }
    }
    const double sign = PointSet::on_left(point) ? 1 : -1;
    const auto put = [&](const Vector3d& at, std::vector<float>* out) {
      out->push_back(static_cast<float>(sign * at.x()));
      out->push_back(static_cast<float>(at.y()));
      out->push_back(static_cast<float>(at.z()));
    };
    put(Vector3d(set.medial[i].x, set.medial[i].y, set.medial[i].z) / kSide, &s.medial);
    put(joints[own], &s.start);
    put(joints[end], &s.end);
    s.weight.push_back(static_cast<float>(sums[own] * sums[own]));
    s.start_class.push_back(target_.joints[own].joint_class);
    s.end_class.push_back(target_.joints[end].tip ? static_cast<uint8_t>(kClassTip)
                                                  : static_cast<uint8_t>(target_.joints[end].joint_class));
  }
  return s;
}

RigSample RigSource::make(uint64_t seed, double strength) const {
  return sample(pose(mix_seeds(seed, 1), strength), mix_seeds(seed, 2));
}

RigSource::Placed RigSource::make_mesh(uint64_t seed, double strength) const {
  return place(pose(mix_seeds(seed, 1), strength), mix_seeds(seed, 2));
}

}  // namespace sinew
