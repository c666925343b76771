// SPDX-License-Identifier: MIT
// Poses and stretches a character by its own weights, and asks the engine for points.
#include "data/rig_sample.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "data/eigen_points.hpp"
#include "data/engine_mesh.hpp"
#include "data/grown_shell.hpp"
#include "data/sourced_surface.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_trainer/sample.hpp"
#include "votes/rig_task.hpp"

namespace sinew {
namespace {

using namespace rigging;

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kYaw = 0.1;  // radians, standard deviation
constexpr uint32_t kPicturePixels = 320;
constexpr double kNarrowPictures = 0.15;  // of pictures, from where a body is narrower

// The least rotation from one direction to another; between opposite ones about z.
Matrix3d rotation_between(const Vector3d& from, const Vector3d& to) {
  const Vector3d axis = from.cross(to);
  const double sine = axis.norm(), cosine = from.dot(to);
  const Vector3d unit = sine > 1e-12 ? Vector3d(axis / sine) : Vector3d::UnitZ();
  return Eigen::AngleAxisd(std::atan2(sine, cosine), unit).toRotationMatrix();
}

}  // namespace

RigSource::RigSource(const Character& character)
    : name_(character.name), family_(family_of(character.name)), body_{target_skeleton(character), {}, {}, {}} {
  std::vector<Point3> vertices;
  std::vector<uint32_t> source;
  surface_of(character, &vertices, &triangles_, &source);
  for (const uint32_t v : source) influences_.push_back(character.influences[v]);
  const EngineMesh engine(name_, vertices, triangles_);
  const MirrorFrame frame = engine.mirror_frame();

  Vector3d low = vec(vertices[0]), high = low;
  for (const Point3& p : vertices) {
    low = low.cwiseMin(vec(p));
    high = high.cwiseMax(vec(p));
  }
  const double side = std::max((high - low).maxCoeff(), 1e-30), plane = static_cast<double>(frame.plane) / kSide;
  const auto to_frame = [&](const Vector3d& p) -> Point3 {
    const double x = (p.x() - 0.5 * (low.x() + high.x())) / side, y = (p.y() - low.y()) / side,
                 z = (p.z() - 0.5 * (low.z() + high.z())) / side;
    if (frame.turned()) return {plane - z, y, x};
    return {x - plane, y, z};
  };
  for (const Point3& p : vertices) vertices_.push_back(to_frame(vec(p)));
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
    if (order_.size() == before) throw Error(name_ + ": the joint parents form a cycle");
  }

  body_.kids.resize(body_.target.joints.size());
  for (uint32_t i = 0; i < body_.target.joints.size(); ++i) {
    const TargetJoint& joint = body_.target.joints[i];
    body_.joints.push_back(to_frame(vec(joint.position)));
    if (joint.parent >= 0) body_.kids[static_cast<size_t>(joint.parent)].push_back(i);
  }
  find_partners();
  find_parts();
}

void RigSource::find_partners() {
  const std::vector<TargetJoint>& joints = body_.target.joints;
  std::vector<int>& partner = body_.partner;
  for (uint32_t i = 0; i < joints.size(); ++i) {
    Vector3d mirrored = vec(body_.joints[i]);
    mirrored.x() = -mirrored.x();
    int best = -1;
    double least = 0.04;
    for (uint32_t j = 0; j < joints.size(); ++j) {
      const double d = (vec(body_.joints[j]) - mirrored).norm();
      if (joints[i].tip == joints[j].tip && d < least) {
        least = d;
        best = static_cast<int>(j);
      }
    }
    partner.push_back(best);
  }
  for (uint32_t i = 0; i < partner.size(); ++i) {
    if (partner[i] >= 0 && partner[static_cast<size_t>(partner[i])] != static_cast<int>(i)) partner[i] = -1;
  }
}

// Connected parts of welded triangles.
void RigSource::find_parts() {
  std::map<Point3, uint32_t> weld;
  std::vector<uint32_t> root(vertices_.size());
  std::iota(root.begin(), root.end(), 0u);
  const auto find = [&](uint32_t v) {
    while (root[v] != v) v = root[v] = root[root[v]];
    return v;
  };
  for (uint32_t v = 0; v < vertices_.size(); ++v) root[find(v)] = find(weld.emplace(vertices_[v], v).first->second);
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

// The character's own joints rotate if a target joint has its position from them; scales act at the joint, not below
// it.
RigSource::Palette RigSource::palette(const RigPose& pose) const {
  const size_t bones = body_.bones();
  std::vector<Matrix3d> scale(bones);
  std::map<uint32_t, size_t> target_of;
  for (size_t i = 0; i < bones; ++i) {
    const Vector3d offset = body_.direction(i), along = offset.norm() > 1e-9 ? offset.normalized() : Vector3d(0, 1, 0);
    const double s = std::exp(pose.stretch[i][0]), r = std::exp(pose.stretch[i][1]);
    scale[i] = r * Matrix3d::Identity() + (s - r) * along * along.transpose();
    target_of[body_.target.joints[i].source] = i;
  }
  Palette palette;
  palette.origin.resize(joints_.size());
  palette.linear.resize(joints_.size());
  std::vector<Matrix3d> rotation(joints_.size());
  for (const uint32_t j : order_) {
    const bool top = parents_[j] < 0;
    const size_t p = top ? 0 : static_cast<size_t>(parents_[j]);
    const Matrix3d above = top ? Matrix3d::Identity() : rotation[p];
    rotation[j] = above;
    const auto at = target_of.find(j);
    if (at != target_of.end() && pose.aim[at->second].norm() > 1e-12) {
      const Vector3d now = above * body_.direction(at->second);
      rotation[j] = rotation_between(now, pose.aim[at->second]) * above;
    } else if (at != target_of.end() && pose.turn[at->second].norm() > 1e-12) {
      const Vector3d turn = pose.turn[at->second];
      rotation[j] = above * Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix();
    }
    palette.origin[j] = vec(joints_[j]);
    if (!top) palette.origin[j] = palette.origin[p] + palette.linear[p] * (vec(joints_[j]) - vec(joints_[p]));
    palette.linear[j] = rotation[j] * scale[body_.target.owners[j]];
  }
  return palette;
}

Vector3d RigSource::follow(const Palette& palette, uint32_t j, const Point3& p) const {
  return palette.origin[j] + palette.linear[j] * (vec(p) - vec(joints_[j]));
}

std::vector<Point3> RigSource::skin(const Palette& palette) const {
  std::vector<Point3> vertices = vertices_;
  for (size_t v = 0; v < vertices.size(); ++v) {
    Vector3d sum = Vector3d::Zero();
    double weights = 0;
    for (const Influence& i : influences_[v]) {
      sum += i.weight * follow(palette, i.joint, vertices_[v]);
      weights += i.weight;
    }
    if (weights > 1e-6) vertices[v] = arr(sum / weights);
  }
  return vertices;
}

// Small parts vanish, as hats and belts do; never more than half of what a joint moves.
std::vector<uint8_t> RigSource::vanish(Random* random) const {
  const size_t bones = body_.bones();
  std::vector<uint8_t> gone(triangles_.size(), 0);
  std::vector<double> area(parts_, 0.0), moved(bones, 0.0), sums(bones);
  std::vector<uint32_t> owner(triangles_.size());
  for (size_t t = 0; t < triangles_.size(); ++t) {
    area[part_[t]] += area_[t];
    std::fill(sums.begin(), sums.end(), 0.0);
    for (const uint32_t v : triangles_[t])
      for (const Influence& i : influences_[v]) sums[body_.target.owners[i.joint]] += i.weight;
    owner[t] = static_cast<uint32_t>(std::max_element(sums.begin(), sums.end()) - sums.begin());
    moved[owner[t]] += area_[t];
  }
  const double all = std::accumulate(area.begin(), area.end(), 0.0);
  const auto largest = static_cast<uint32_t>(std::max_element(area.begin(), area.end()) - area.begin());
  for (uint32_t p = 0; p < parts_; ++p) {
    if (p == largest || area[p] >= 0.15 * all || random->uniform() >= 0.35) continue;
    std::vector<double> own(bones, 0.0);
    for (size_t t = 0; t < triangles_.size(); ++t)
      if (part_[t] == p) own[owner[t]] += area_[t];
    bool small = true;
    for (size_t j = 0; j < bones; ++j) small = small && own[j] <= 0.5 * moved[j] + 1e-12;
    for (size_t t = 0; t < triangles_.size() && small; ++t)
      if (part_[t] == p) gone[t] = 1;
  }
  return gone;
}

// The triangles that stay, and the vertices that they have; others would spoil the box.
SourcedSurface RigSource::surface(const std::vector<Point3>& vertices, const std::vector<uint8_t>& gone) const {
  SourcedSurface surface;
  std::vector<uint32_t> number(vertices.size(), UINT32_MAX);
  for (size_t t = 0; t < triangles_.size(); ++t) {
    if (gone[t]) continue;
    std::array<uint32_t, 3> corners = triangles_[t];
    for (uint32_t& v : corners) {
      if (number[v] == UINT32_MAX) {
        number[v] = static_cast<uint32_t>(surface.vertices.size());
        surface.vertices.push_back(vertices[v]);
        surface.source.push_back(v);
      }
      v = number[v];
    }
    surface.triangles.push_back(corners);
  }
  return surface;
}

// A picture says nothing of depth. Limbs of both sides lie apart from the side, too, as those of meshes do.
void RigSource::draw(Random* random, Posed* posed) const {
  const bool narrow = random->uniform() < kNarrowPictures,
             side = broad_view(posed->surface) == SilhouetteView::kFromSide;
  const SilhouetteView view = side != narrow ? SilhouetteView::kFromSide : SilhouetteView::kFromFront;
  posed->surface = silhouette_of(posed->surface, view, kPicturePixels);
  if (view == SilhouetteView::kFromSide) {
    posed->symmetric = true;
  } else {
    for (Point3& p : posed->joints) p[2] = 0;
  }
}

RigSource::Posed RigSource::pose(uint64_t seed, const RigVariant& variant) const {
  Random random(seed);
  Posed posed{{}, body_.joints, true};
  std::vector<Point3> vertices = vertices_;
  std::vector<uint8_t> gone(triangles_.size(), 0);
  if (variant.strength > 0) {
    const double strength = variant.strength;
    const RigPose pose = variant.wide ? wide_pose(body_, strength, &random) : mild_pose(body_, strength, &random);
    posed.symmetric = pose.symmetric;
    const Palette moved = palette(pose);
    const auto stretch = [&] { return std::exp(0.1 * strength * random.normal()); };
    const double width = stretch(), height = stretch(), depth = stretch();
    Matrix3d whole = Vector3d(width, height, depth).asDiagonal();
    if (variant.wide && !pose.symmetric)  // no plane tells exactly where such a mesh faces
      whole = Eigen::AngleAxisd(std::clamp(kYaw * random.normal(), -2 * kYaw, 2 * kYaw), Vector3d::UnitY()) * whole;
    vertices = skin(moved);
    for (Point3& p : vertices) p = arr(whole * vec(p));
    for (size_t i = 0; i < posed.joints.size(); ++i)
      posed.joints[i] = arr(whole * follow(moved, body_.target.joints[i].source, body_.joints[i]));
    if (random.uniform() < 0.4 && parts_ > 1) gone = vanish(&random);
  }
  posed.surface = surface(vertices, gone);
  if (variant.picture) {
    draw(&random, &posed);
    return posed;
  }
  if (variant.wall) add_wall(&random, &posed.surface);
  if (variant.cells > 0) {
    GrownShell shell = grow_shell(posed.surface.vertices, posed.surface.triangles, variant.cells);
    for (uint32_t& v : shell.source) v = posed.surface.source[v];
    posed.surface = {std::move(shell.vertices), std::move(shell.triangles), std::move(shell.source)};
  }
  if (variant.specks) add_specks(&random, &posed.surface);
  return posed;
}

RigSource::PosedMesh RigSource::to_mesh(const Posed& posed, uint64_t seed) const {
  PosedMesh posed_mesh{EngineMesh(name_, posed.surface.vertices, posed.surface.triangles), {}, {}};
  EngineMesh& engine = posed_mesh.engine;
  MirrorFrame frame;  // of the character before it was posed
  const float zero[3] = {0, 0, 0};
  frame.plane = quantize_point(engine.quantizer, zero).x;
  Random random(mix_seeds(seed, 3));
  if (!posed.symmetric && random.uniform() < 0.5) frame.plane = 0;  // a plane that could not be found
  apply_mirror_frame(frame, &engine.mesh);
  for (const Point3& p : posed.joints) {  // in grid units of the posed character's own box
    const float f[3] = {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])};
    const Vec3i at = frame.to(quantize_point(engine.quantizer, f));
    posed_mesh.joints.push_back(arr(Vector3d(at.x, at.y, at.z) / kSide));
  }
  posed_mesh.source.assign(engine.mesh.welded_count, UINT32_MAX);
  for (uint32_t v = 0; v < posed.surface.vertices.size(); ++v) {
    uint32_t& first = posed_mesh.source[engine.mesh.vertex_to_welded[v]];
    if (first == UINT32_MAX) first = posed.surface.source[v];
  }
  return posed_mesh;
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

RigSample RigSource::label(const PosedMesh& posed_mesh, const PointSet& set) const {
  std::vector<Vector3d> joints;
  for (const Point3& p : posed_mesh.joints) joints.push_back(vec(p));

  RigSample s = point_sample(set);
  s.name = name_;
  s.family = family_;
  std::vector<double> sums(body_.target.joints.size());
  for (uint32_t i = 0; i < kSetPoints; ++i) {
    const SurfacePoint& point = set.points[i];
    std::fill(sums.begin(), sums.end(), 0.0);
    for (int corner = 0; corner < 3; ++corner) {
      for (const Influence& influence : influences_[posed_mesh.source[point.corner[corner]]])
        sums[body_.target.owners[influence.joint]] += influence.weight * point.share[corner] / 32768.0;
    }
    const size_t own = static_cast<size_t>(std::max_element(sums.begin(), sums.end()) - sums.begin());
    const Vector3d p = Vector3d(point.position.x, point.position.y, point.position.z) / kSide;
    size_t end = own;
    double least = 1e9;
    for (const uint32_t k : body_.kids[own]) {
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
    s.start_class.push_back(body_.target.joints[own].joint_class);
    s.end_class.push_back(body_.target.joints[end].tip ? static_cast<uint8_t>(kClassTip)
                                                       : static_cast<uint8_t>(body_.target.joints[end].joint_class));
  }
  return s;
}

RigSample RigSource::make(uint64_t seed, const RigVariant& variant) const {
  const PosedMesh posed_mesh = make_mesh(seed, variant);
  RigSample s;
  with_point_set(posed_mesh.engine, mix_seeds(seed, 2), [&](const PointSet& set) { s = label(posed_mesh, set); });
  return s;
}

RigSource::PosedMesh RigSource::make_mesh(uint64_t seed, const RigVariant& variant) const {
  return to_mesh(pose(mix_seeds(seed, 1), variant), mix_seeds(seed, 2));
}

}  // namespace sinew
