// SPDX-License-Identifier: MIT
// Layers of a dressed limb where it bends: how often a sleeve comes through the skin.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "core/triangle.hpp"
#include "transfer_scene.hpp"

namespace {

using namespace sinew;
using sinew_test::BoundRows;
using sinew_test::limb;
using sinew_test::MeshScene;
using sinew_test::painted;
using sinew_test::TransferRun;

using Triangle = std::array<uint32_t, 3>;

std::vector<Triangle> triangles_of(const MeshScene& scene) {
  std::vector<Triangle> out;
  for (size_t f = 0; f + 1 < scene.offsets.size(); ++f)
    for (uint32_t c = scene.offsets[f] + 1; c + 1 < scene.offsets[f + 1]; ++c)
      out.push_back({scene.corners[scene.offsets[f]], scene.corners[c], scene.corners[c + 1]});
  return out;
}

Vec3d position(const std::vector<float>& positions, uint32_t v) {
  const float* const p = &positions[3 * size_t{v}];
  return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
}

// An open tube around the limb, on its skeleton.
MeshScene sleeve_of(const MeshScene& body, double radius) {
  MeshScene sleeve = limb(20, 16, 2.4, radius);
  for (size_t i = 1; i < sleeve.positions.size(); i += 3) sleeve.positions[i] += 0.3f;
  sleeve.offsets.resize(sleeve.offsets.size() - 2);  // without its ends
  sleeve.corners.resize(sleeve.offsets.back());
  sleeve.joints = body.joints;
  return sleeve;
}

// Joints 1 and 2 turned about z by so many degrees each.
std::vector<float> posed(const MeshScene& scene, const std::vector<uint16_t>& joints,
                         const std::vector<uint16_t>& weights, double degrees) {
  std::vector<float> palette;
  double x = 0, y = 0, angle = 0;  // of the joint's new position
  for (size_t j = 0; j < 3; ++j) {
    const double rest_x = double{scene.joints[3 * j]}, rest_y = double{scene.joints[3 * j + 1]};
    if (j > 0) {
      const double dx = rest_x - double{scene.joints[3 * j - 3]}, dy = rest_y - double{scene.joints[3 * j - 2]};
      x += std::cos(angle) * dx - std::sin(angle) * dy;
      y += std::sin(angle) * dx + std::cos(angle) * dy;
      angle += degrees * M_PI / 180;
    }
    const double c = std::cos(angle), s = std::sin(angle);
    for (const double e :
         {c, -s, 0.0, x - c * rest_x + s * rest_y, s, c, 0.0, y - s * rest_x - c * rest_y, 0.0, 0.0, 1.0, 0.0})
      palette.push_back(static_cast<float>(e));
  }
  std::vector<float> out(scene.positions.size());
  const uint32_t n = static_cast<uint32_t>(joints.size() / scene.vertex_count());
  const sinew_skin skin = {joints.data(), weights.data(), n, SINEW_WEIGHT_UNORM16};
  EXPECT_EQ(sinew_skin_linear(scene.positions.data(), scene.vertex_count(), &skin, palette.data(), 3, out.data()),
            SINEW_OK);
  return out;
}

// Edges of each layer through triangles of the other.
size_t crossings(const MeshScene& body, const std::vector<float>& skin, const MeshScene& garment,
                 const std::vector<float>& cloth) {
  size_t count = 0;
  const auto through = [&count](const MeshScene& lines, const std::vector<float>& p, const MeshScene& faces,
                                const std::vector<float>& q) {
    const std::vector<Triangle> walls = triangles_of(faces);
    for (const Triangle& line : triangles_of(lines))
      for (size_t k = 0; k < 3; ++k)
        for (const Triangle& wall : walls)
          if (goes_through(position(p, line[k]), position(p, line[(k + 1) % 3]), position(q, wall[0]),
                           position(q, wall[1]), position(q, wall[2])))
            ++count;
  };
  through(garment, cloth, body, skin);
  through(body, skin, garment, cloth);
  return count;
}

// New crossings of cloth through skin, over two sleeves and two bends: fewer than with weights that know no body.
TEST(Layers, ASleeveComesThroughTheSkinLessThanOneThatIsBoundAlone) {
  const MeshScene body = limb(25, 12, 3, 0.3);
  const BoundRows rows = painted(body, 3);
  sinew_transfer_options worn_options = SINEW_INIT(sinew_transfer_options), alone_options = worn_options;
  worn_options.garment = 1;
  alone_options.method = SINEW_TRANSFER_REBIND;
  size_t worn_crossings = 0, alone_crossings = 0;
  for (const double radius : {0.33, 0.36}) {
    const MeshScene sleeve = sleeve_of(body, radius);
    ASSERT_EQ(crossings(body, body.positions, sleeve, sleeve.positions), 0u);
    const TransferRun worn = sinew_test::run_transfer(body, rows, sleeve, worn_options),
                      alone = sinew_test::run_transfer(body, rows, sleeve, alone_options);
    ASSERT_EQ(worn.status, SINEW_OK);
    ASSERT_EQ(alone.status, SINEW_OK);
    for (const double degrees : {30.0, 60.0}) {
      const std::vector<float> skin = posed(body, rows.joints, rows.weights, degrees);
      worn_crossings += crossings(body, skin, sleeve, posed(sleeve, worn.joints, worn.weights, degrees));
      alone_crossings += crossings(body, skin, sleeve, posed(sleeve, alone.joints, alone.weights, degrees));
    }
  }
  EXPECT_GT(alone_crossings, 1000u) << "or this test could not fail";
  EXPECT_LT(3 * worn_crossings, 2 * alone_crossings) << worn_crossings << " of " << alone_crossings;
}

}  // namespace
