// SPDX-License-Identifier: MIT
// Bends a hand by its own weights, and asks the engine for its crop and points.
#include "data/hand_sample.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>

#include "data/eigen_points.hpp"
#include "data/engine_mesh.hpp"
#include "data/rig_sample.hpp"
#include "details/hand_crop.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_trainer/sample.hpp"
#include "votes/rig_task.hpp"

namespace sinew {
namespace {

using namespace rigging;

using Eigen::Vector3d;

constexpr double kAround = 3.2;  // of a hand's length: what of the body is kept

// A point in shares of the longest side. Without an expression of Eigen's, which GCC 12 takes for uninitialized.
Vector3d share(Vec3i p) {
  constexpr double kStep = 1.0 / kSide;
  return {p.x * kStep, p.y * kStep, p.z * kStep};
}

}  // namespace

HandSource::HandSource(const Character& character, const TargetHand& hand)
    : name_(character.name), family_(family_of(character.name)), length_(hand.length) {
  const Vec3& w = character.joints[hand.joint].position;
  const auto local = [&](double x, double y, double z) -> Point3 {
    const double dx = x - static_cast<double>(w.x);
    return {hand.right ? -dx : dx, y - static_cast<double>(w.y), z - static_cast<double>(w.z)};
  };
  const auto local_of = [&](const Vec3& p) {
    return local(static_cast<double>(p.x), static_cast<double>(p.y), static_cast<double>(p.z));
  };
  joints_ = {{{}, -1, kHandRest}, {{}, 0, kHandPalm}};
  std::vector<int> own(character.joints.size(), -1);
  own[hand.joint] = kWrist;
  for (const TargetFinger& finger : hand.fingers) {
    HandFinger f;
    f.finger = finger.finger;
    if (finger.end) f.end = local((*finger.end)[0], (*finger.end)[1], (*finger.end)[2]);
    int parent = kWrist;
    for (size_t k = 0; k < finger.joints.size(); ++k) {
      const Point3& p = finger.positions[k];
      own[finger.joints[k]] = static_cast<int>(joints_.size());
      f.joints.push_back(static_cast<uint32_t>(joints_.size()));
      joints_.push_back({local(p[0], p[1], p[2]), parent, finger_class(finger.finger, static_cast<uint32_t>(k))});
      parent = static_cast<int>(joints_.size()) - 1;
    }
    fingers_.push_back(std::move(f));
  }
  // Vertices that no joint of the hand moves belong to the joint above it.
  const auto owner_of = [&](uint32_t j) -> uint32_t {
    for (int at = static_cast<int>(j); at >= 0; at = character.joints[static_cast<size_t>(at)].parent)
      if (own[static_cast<size_t>(at)] >= 0) return static_cast<uint32_t>(own[static_cast<size_t>(at)]);
    return 0;
  };
  std::vector<uint32_t> number(character.vertices.size(), UINT32_MAX);
  std::vector<Point3> positions;
  for (const Vec3& p : character.vertices) positions.push_back(local_of(p));
  const auto is_near = [&](uint32_t v) { return vec(positions[v]).norm() < kAround * length_; };
  const auto vertex_of = [&](uint32_t v) {
    if (number[v] == UINT32_MAX) {
      number[v] = static_cast<uint32_t>(vertices_.size());
      vertices_.push_back(positions[v]);
      influences_.emplace_back();
      for (const Influence& i : character.influences[v]) influences_.back().push_back({owner_of(i.joint), i.weight});
    }
    return number[v];
  };
  for (size_t f = 0; f < character.face_count(); ++f) {
    const uint32_t* const corners = character.face_vertices.data();
    const uint32_t begin = character.face_offsets[f], end = character.face_offsets[f + 1];
    for (uint32_t i = begin + 2; i < end; ++i) {
      const std::array<uint32_t, 3> t = {corners[begin], corners[i - 1], corners[i]};
      if (is_near(t[0]) && is_near(t[1]) && is_near(t[2]))
        triangles_.push_back({vertex_of(t[0]), vertex_of(t[1]), vertex_of(t[2])});
    }
  }
  // Where the hand points: the middle of its fingers, or of what it moves.
  Vector3d sum = Vector3d::Zero();
  double weights = 0;
  for (const HandFinger& f : fingers_) sum += vec(joints_[f.joints[f.joints.size() / 2]].at);
  weights = static_cast<double>(fingers_.size());
  for (size_t v = 0; v < vertices_.size() && fingers_.empty(); ++v) {
    for (const Influence& i : influences_[v]) {
      if (i.joint != kWrist) continue;
      sum += static_cast<double>(i.weight) * vec(vertices_[v]);
      weights += static_cast<double>(i.weight);
    }
  }
  const Vector3d along = weights > 0 && sum.norm() > 1e-9 ? Vector3d(sum.normalized()) : Vector3d(1, 0, 0);
  palm_end_ = arr(0.85 * length_ * along);
  elbow_ = arr(-1.3 * length_ * along);
  if (hand.elbow >= 0) {
    const Point3 e = local_of(character.joints[static_cast<size_t>(hand.elbow)].position);
    if (vec(e).norm() > 0.3 * length_) elbow_ = e;
  }
}

// Targets of the votes of the crop's points.
class HandSource::Labels {
 public:
  // in_crop: from the hand's axes to the crop's.
  template <class InCrop>
  Labels(const HandSource& hand, const Posed& posed, const InCrop& in_crop, RigSample* out)
      : hand_(hand), posed_(posed), out_(*out), palm_end_(in_crop(posed.palm_end)) {
    for (const Point3& p : posed.joints) joints_.push_back(in_crop(p));
    for (const std::optional<Point3>& end : posed.ends)
      ends_.push_back(end ? std::optional<Vector3d>(in_crop(*end)) : std::nullopt);
  }

  // A point that belongs to joint `own`, 0 = none of the hand's, by a share of `trust`.
  void add(const Vector3d& p, const Vector3d& medial, size_t own, double trust) {
    if (posed_.classes[own] == kHandPalm) own = kWrist;
    const float sure = static_cast<float>(trust * trust);
    out_.class_weight.push_back(sure);
    if (own == 0) {  // no bone of the hand
      put(medial, &out_.start);
      put(medial, &out_.end);
      out_.weight.push_back(0);
      out_.start_class.push_back(kHandRest);
      out_.end_class.push_back(kHandRest);
      return;
    }
    const BoneEnd end = nearest_end(p, own);
    put(joints_[own], &out_.start);
    put(end.at, &out_.end);
    out_.weight.push_back(end.known ? sure : 0);
    out_.start_class.push_back(posed_.classes[own]);
    out_.end_class.push_back(end.hand_class);
  }

  static void put(const Vector3d& at, std::vector<float>* out) {
    for (int i = 0; i < 3; ++i) out->push_back(static_cast<float>(at[i]));
  }

 private:
  struct BoneEnd {
    Vector3d at;
    uint8_t hand_class = kClassTip;
    bool known = true;
  };

  // The end of the bone nearest to p among those that begin at joint `own`.
  BoneEnd nearest_end(const Vector3d& p, size_t own) const {
    BoneEnd end = {palm_end_, kClassTip, own != kWrist || hand_.fingers_.empty()};
    double least = 1e9;
    const auto offer = [&](const Vector3d& at, uint8_t at_class) {
      const double d = segment_distance(p, joints_[own], at);
      if (d >= least) return;
      least = d;
      end.at = at;
      end.hand_class = at_class;
    };
    for (size_t f = 0; f < hand_.fingers_.size(); ++f) {
      const HandFinger& finger = hand_.fingers_[f];
      for (size_t k = 0; k < finger.joints.size(); ++k) {
        const uint32_t j = finger.joints[k];
        if (posed_.classes[j] == kHandPalm) continue;
        if (own == kWrist && k == 0) {
          offer(joints_[j], posed_.classes[j]);
          end.known = true;
        }
        if (own != j) continue;
        if (k + 1 < finger.joints.size()) {
          offer(joints_[finger.joints[k + 1]], posed_.classes[finger.joints[k + 1]]);
        } else if (ends_[f]) {
          offer(*ends_[f], kClassTip);
        } else {
          end.known = false;
        }
      }
    }
    return end;
  }

  const HandSource& hand_;
  const Posed& posed_;
  RigSample& out_;
  const Vector3d palm_end_;
  std::vector<Vector3d> joints_;
  std::vector<std::optional<Vector3d>> ends_;
};

std::optional<RigSample> HandSource::make(uint64_t seed, double strength) const {
  const Posed posed = pose(mix_seeds(seed, 1), strength);
  Random random(mix_seeds(seed, 4));
  EngineMesh engine(name_, posed.vertices, triangles_);
  const auto quantized = [&](const Vector3d& p) {
    const float f[3] = {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
    return quantize_point(engine.quantizer, f);
  };
  // As wrong as a body's skeleton is.
  const Vector3d wrist = vec(posed.joints[kWrist]);
  const Vector3d elbow = vec(posed.joints[0]) + (vec(elbow_) - vec(joints_[0].at));
  HandPosition position;
  position.wrist = quantized(wrist + 0.07 * length_ * normals(&random));
  position.elbow = quantized(elbow + 0.12 * elbow.norm() * normals(&random));
  const double guess = length_ * std::exp(0.15 * random.normal());
  const Vec3i zero = quantized(Vector3d::Zero()), far = quantized(Vector3d(guess, 0, 0));
  position.length = std::max(far.x - zero.x, 1);

  HandCrop crop;
  Interior interior;
  PointSet set;
  const auto run = [&](Arena& arena) {
    (void)crop.allocate(arena, engine.counts);
    (void)interior.allocate(arena);
    (void)set.allocate(arena);
    (void)crop_hand(engine.mesh, position, engine.counts, arena, &crop);
    if (!arena.measuring() && crop.surface_triangles == 0) return;
    (void)build_interior(crop.mesh, arena, &interior);
    (void)make_point_set(crop.mesh, interior, mix_seeds(seed, 2), arena, &set);
  };
  Arena measuring;
  run(measuring);
  Workspace block(measuring.high_water());
  Arena arena(block.data(), block.size());
  run(arena);
  if (crop.surface_triangles == 0) return std::nullopt;

  const auto hand_position = [&](const Point3& p) {
    const Vec3i at = crop.frame.to(quantized(vec(p)));
    return share(at);
  };
  std::vector<uint32_t> caller(engine.mesh.welded_count, UINT32_MAX);
  for (uint32_t v = 0; v < vertices_.size(); ++v) {
    uint32_t& first = caller[engine.mesh.vertex_to_welded[v]];
    if (first == UINT32_MAX) first = v;
  }
  RigSample s = point_sample(set);
  s.name = name_;
  s.family = family_;
  Labels labels(*this, posed, hand_position, &s);
  std::vector<double> sums(joints_.size());
  for (uint32_t i = 0; i < kSetPoints; ++i) {
    const SurfacePoint& point = set.points[i];
    const Vector3d p = share(point.position);
    const Vector3d m = share(set.medial[i]);
    Labels::put(m, &s.medial);
    std::fill(sums.begin(), sums.end(), 0.0);
    const bool is_cap = point.triangle != kNoTriangle && point.triangle >= crop.surface_triangles;
    for (int corner = 0; corner < 3 && !is_cap; ++corner) {
      for (const Influence& influence : influences_[caller[crop.source[point.corner[corner]]]])
        sums[influence.joint] += static_cast<double>(influence.weight) * point.share[corner] / 32768.0;
    }
    const size_t own = is_cap ? 0 : static_cast<size_t>(std::max_element(sums.begin(), sums.end()) - sums.begin());
    const double trust = is_cap ? 1 : std::min(sums[own], 1.0);
    labels.add(p, m, own, trust);
  }
  return s;
}

std::vector<HandSource> hand_sources(const Character& character) {
  std::vector<HandSource> sources;
  for (const TargetHand& hand : target_hands(character))
    if (hand.clear) sources.emplace_back(character, hand);
  return sources;
}

}  // namespace sinew
