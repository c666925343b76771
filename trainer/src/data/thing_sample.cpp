// SPDX-License-Identifier: MIT
// Solids rotated about axes, put together at random; targets anywhere in the box.
#include "data/thing_sample.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "data/eigen_points.hpp"
#include "data/grown_shell.hpp"

namespace sinew {
namespace {

using namespace rigging;

using Eigen::Vector3d;

constexpr double kTurn = 6.283185307179586;

class Workshop {
 public:
  explicit Workshop(uint64_t seed) : random_(seed) {}

  SourcedSurface make() {
    switch (random_.below(5)) {
      case 0:
        make_machine();
        break;
      case 1:
        make_vehicle();
        break;
      case 2:
        make_furniture();
        break;
      case 3:
        write_letters();
        break;
      default:
        make_limb();
        break;
    }
    turn();
    surface_.source.resize(surface_.vertices.size());
    std::iota(surface_.source.begin(), surface_.source.end(), 0u);
    return std::move(surface_);
  }

 private:
  // A closed solid from a to b: a ring of `sides` corners for every radius, of which there are two or more. Four sides are a box.
  //   flat  how much thinner it is in one direction across
  void add_turned(const Vector3d& a, const Vector3d& b, const std::vector<double>& radii, uint32_t sides,
                  double flat = 1) {
    const Vector3d along = (b - a).normalized();
    const Vector3d helper = std::abs(along.y()) < 0.9 ? Vector3d::UnitY() : Vector3d::UnitX();
    const Vector3d u = along.cross(helper).normalized(), v = along.cross(u);
    const auto first = static_cast<uint32_t>(surface_.vertices.size());
    const auto rings = static_cast<uint32_t>(radii.size());
    for (uint32_t k = 0; k < rings; ++k) {
      const Vector3d middle = a + (b - a) * (k / (rings - 1.0));
      for (uint32_t i = 0; i < sides; ++i) {
        const double angle = kTurn * (i + 0.5) / sides;
        surface_.vertices.push_back(arr(middle + radii[k] * (std::cos(angle) * u + flat * std::sin(angle) * v)));
      }
    }
    surface_.vertices.push_back(arr(a));
    surface_.vertices.push_back(arr(b));
    const uint32_t bottom = first + rings * sides, top = bottom + 1;
    for (uint32_t i = 0; i < sides; ++i) {
      const uint32_t next = (i + 1) % sides, last = first + (rings - 1) * sides;
      surface_.triangles.push_back({bottom, first + next, first + i});
      surface_.triangles.push_back({top, last + i, last + next});
      for (uint32_t k = 0; k + 1 < rings; ++k) {
        const uint32_t below = first + k * sides, above = below + sides;
        surface_.triangles.push_back({below + i, below + next, above + next});
        surface_.triangles.push_back({below + i, above + next, above + i});
      }
    }
  }
  // A box of half sizes, about a center.
  void add_box(const Vector3d& middle, const Vector3d& half) {
    const double across = half.x() * std::sqrt(2.0);
    add_turned(middle - Vector3d(0, half.y(), 0), middle + Vector3d(0, half.y(), 0), {across, across}, 4,
               half.z() / half.x());
  }
  Vector3d axis() {
    const uint32_t which = random_.below(3);
    return which == 0 ? Vector3d::UnitX() : which == 1 ? Vector3d::UnitY() : Vector3d::UnitZ();
  }
  Vector3d within(double x, double y, double z) {
    const double a = random_.uniform(-x, x), b = random_.uniform(-y, y);
    return {a, b, random_.uniform(-z, z)};
  }

  // Blocks, shafts and domes on each other, half of them with their images.
  void make_machine() {
    const uint32_t solids = 3 + random_.below(12);
    const bool mirrored = random_.uniform() < 0.5;
    std::vector<Vector3d> middles = {Vector3d::Zero()};
    for (uint32_t i = 0; i < solids; ++i) {
      const Vector3d middle = middles[random_.below(static_cast<uint32_t>(middles.size()))] + within(0.35, 0.35, 0.35);
      const Vector3d half = 0.5 * random_.uniform(0.1, 0.7) * axis();
      const double wide = random_.uniform(0.03, 0.25),
                   narrow = random_.uniform() < 0.6 ? wide : random_.uniform(0, 1) * wide;
      const uint32_t sides = random_.uniform() < 0.5 ? 4 : 8 + random_.below(9);
      const std::vector<double> radii = random_.uniform() < 0.2
                                            ? std::vector<double>{0.3 * wide, 0.8 * wide, wide, 0.8 * wide, 0.3 * wide}
                                            : std::vector<double>{wide, narrow};
      const double flat = random_.uniform(0.4, 1);
      middles.push_back(middle);
      add_turned(middle - half, middle + half, radii, sides, flat);
      const Vector3d image(-1, 1, 1);
      if (mirrored)
        add_turned((middle - half).cwiseProduct(image), (middle + half).cwiseProduct(image), radii, sides, flat);
    }
  }

  // A hull, a cabin or a turret, wheels in pairs.
  void make_vehicle() {
    const double width = random_.uniform(0.15, 0.3), height = random_.uniform(0.08, 0.25);
    const double wheel = random_.uniform(0.06, 0.16), tyre = random_.uniform(0.02, 0.08);
    add_box({0, wheel + height, 0}, {width, height, 0.5});
    const double back = random_.uniform(-0.3, 0.3);
    if (random_.uniform() < 0.7)
      add_box({0, wheel + 2 * height + 0.1, back},
              {0.85 * width, random_.uniform(0.06, 0.15), random_.uniform(0.1, 0.3)});
    if (random_.uniform() < 0.3)
      add_turned({0, wheel + 2 * height + 0.05, 0}, {0, wheel + 2 * height + 0.05, random_.uniform(0.4, 0.8)},
                 {0.03, 0.03}, 8);
    const uint32_t pairs = 2 + random_.below(3);
    for (uint32_t i = 0; i < pairs; ++i) {
      const double z = -0.38 + 0.76 * i / (pairs - 1.0);
      for (const double side : {1.0, -1.0})
        add_turned({side * width, wheel, z}, {side * (width + tyre), wheel, z}, {wheel, wheel}, 12);
    }
  }

  // A table, a chair, a shelf.
  void make_furniture() {
    const double width = random_.uniform(0.2, 0.5), depth = random_.uniform(0.2, 0.5),
                 height = random_.uniform(0.2, 0.6);
    const double leg = random_.uniform(0.015, 0.05), top = random_.uniform(0.015, 0.06);
    const uint32_t sides = random_.uniform() < 0.5 ? 4 : 10;
    add_box({0, height, 0}, {width, top, depth});
    for (const double x : {1.0, -1.0})
      for (const double z : {1.0, -1.0})
        add_turned({x * (width - leg), 0, z * (depth - leg)}, {x * (width - leg), height, z * (depth - leg)},
                   {leg, leg}, sides);
    if (random_.uniform() < 0.5) add_box({0, height + 0.3, -depth + top}, {width, 0.3, top});
    if (random_.uniform() < 0.3) add_box({0, 0.5 * height, 0}, {width - leg, top, depth - leg});
  }

  // A line of signs, each of a few strokes.
  void write_letters() {
    const uint32_t signs = 2 + random_.below(6);
    const double stroke = random_.uniform(0.08, 0.16), depth = random_.uniform(0.3, 1.5);
    for (uint32_t i = 0; i < signs; ++i) {
      const uint32_t strokes = 1 + random_.below(4);
      for (uint32_t k = 0; k < strokes; ++k) {
        const auto corner = [&](double at) -> Vector3d { return {1.2 * i + 0.5 * random_.below(3) * 0.8, at, 0}; };
        const Vector3d a = corner(0.5 * random_.below(3)), b = corner(0.5 * random_.below(3));
        if ((b - a).norm() < 0.2) continue;
        add_turned(a, b, {stroke, stroke}, 4, depth);
      }
      if (strokes < 2) add_box({1.2 * i + 0.4, 0.5, 0}, {stroke, 0.5, stroke * depth});
    }
  }

  // An arm or a leg without a body: two or three tapering pieces that bend, with a hand of boxes or a foot.
  void make_limb() {
    Vector3d at = Vector3d::Zero(), way = axis() + 0.2 * normals(&random_);
    way.normalize();
    double radius = random_.uniform(0.07, 0.14);
    const uint32_t pieces = 2 + random_.below(2), sides = random_.uniform() < 0.3 ? 4 : 10;
    for (uint32_t i = 0; i < pieces; ++i) {
      const double thin = radius * random_.uniform(0.6, 0.95);
      const Vector3d next = at + random_.uniform(0.35, 0.55) * way;
      add_turned(at, next, {0.8 * radius, radius, 0.5 * (radius + thin), thin}, sides);
      at = next;
      radius = thin;
      way = (way + random_.uniform(0, 0.6) * normals(&random_)).normalized();
    }
    const Vector3d palm = at + 0.15 * way;
    add_turned(at - 0.03 * way, palm, {radius, 1.4 * radius, 1.3 * radius}, 8, 0.5);
    const Vector3d across = way.cross(std::abs(way.y()) < 0.9 ? Vector3d::UnitY() : Vector3d::UnitX()).normalized();
    const uint32_t fingers = random_.below(6);
    for (uint32_t i = 0; i < fingers; ++i) {
      const Vector3d root = palm + radius * (i - 2.0) / 2 * across;
      add_turned(root, root + random_.uniform(0.06, 0.14) * (way + 0.15 * normals(&random_)),
                 {0.25 * radius, 0.2 * radius}, 6);
    }
  }

  // Rotates to any side, with the floor below.
  void turn() {
    const double angle = random_.uniform() < 0.7 ? kTurn / 4 * random_.below(4) : random_.uniform(0, kTurn);
    const Eigen::Matrix3d rotation = Eigen::AngleAxisd(angle, Vector3d::UnitY()).toRotationMatrix();
    double low = 1e9;
    for (Point3& p : surface_.vertices) {
      p = arr(rotation * vec(p));
      low = std::min(low, p[1]);
    }
    for (Point3& p : surface_.vertices) p[1] -= low;
  }

  Random random_;
  SourcedSurface surface_;
};

}  // namespace

SourcedSurface make_thing(uint64_t seed) { return Workshop(seed).make(); }

RigSample make_thing_sample(uint64_t seed, uint32_t cells) {
  SourcedSurface surface = make_thing(seed);
  if (cells > 0) {
    GrownShell shell = grow_shell(surface.vertices, surface.triangles, cells);
    surface = {std::move(shell.vertices), std::move(shell.triangles), std::move(shell.source)};
  }
  EngineMesh engine("thing", surface.vertices, surface.triangles);
  apply_mirror_frame(engine.mirror_frame(), &engine.mesh);
  RigSample s;
  Random random(mix_seeds(seed, 1));
  with_point_set(engine, mix_seeds(seed, 2), [&](const PointSet& set) {
    s = point_sample(set);
    s.name = s.family = "thing";
    for (uint32_t i = 0; i < kSetPoints; ++i) {
      const double sign = PointSet::on_left(set.points[i]) ? 1 : -1;
      const Vector3d medial = Vector3d(set.medial[i].x, set.medial[i].y, set.medial[i].z) / kSide;
      for (const double x : {sign * medial.x(), medial.y(), medial.z()}) s.medial.push_back(static_cast<float>(x));
      for (std::vector<float>* const target : {&s.start, &s.end}) {
        for (const double high : {0.5, 1.0, 0.5})
          target->push_back(static_cast<float>(random.uniform(high - 1.0, high)));
      }
    }
  });
  s.weight.assign(kSetPoints, 1.0f);
  s.start_class.assign(kSetPoints, kClassOther);
  s.end_class.assign(kSetPoints, kClassOther);
  return s;
}

}  // namespace sinew
