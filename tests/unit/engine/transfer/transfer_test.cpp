// SPDX-License-Identifier: MIT
// A whole transfer through the C API: the same mesh gives the same weights, other meshes like ones, rubbish a status.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "sinew/published.h"
#include "transfer_scene.hpp"

namespace {

using sinew_test::BoundRows;
using sinew_test::limb;
using sinew_test::MeshScene;
using sinew_test::painted;
using sinew_test::run_transfer;
using sinew_test::TransferRun;

constexpr uint32_t kMethods[] = {SINEW_TRANSFER_AUTO, SINEW_TRANSFER_NEAREST, SINEW_TRANSFER_BIHARMONIC,
                                 SINEW_TRANSFER_REBIND};

sinew_transfer_options method(uint32_t number) {
  sinew_transfer_options options = SINEW_INIT(sinew_transfer_options);
  options.method = number;
  return options;
}

void expect_rows(const TransferRun& run, uint32_t joints) {
  for (size_t v = 0; v < run.joints.size() / run.n; ++v) {
    uint32_t sum = 0;
    for (uint32_t i = 0; i < run.n; ++i) {
      ASSERT_LT(run.joints[v * run.n + i], joints);
      sum += run.weights[v * run.n + i];
      if (i > 0) {
        ASSERT_LE(run.weights[v * run.n + i], run.weights[v * run.n + i - 1]) << v;
      }
    }
    ASSERT_EQ(sum, 65535u) << v;
  }
}

TEST(Transfer, TheSameMeshKeepsItsWeights) {
  const MeshScene scene = limb(25, 12, 3, 0.3);
  const BoundRows rows = painted(scene, 3);
  for (const uint32_t m :
       {uint32_t{SINEW_TRANSFER_AUTO}, uint32_t{SINEW_TRANSFER_NEAREST}, uint32_t{SINEW_TRANSFER_BIHARMONIC}}) {
    const TransferRun run = run_transfer(scene, rows, scene, method(m));
    ASSERT_EQ(run.status, SINEW_OK) << m;
    EXPECT_LT(sinew_test::distance(run, rows, 3), m == SINEW_TRANSFER_BIHARMONIC ? 0.001 : 0.01) << m;
    EXPECT_LE(run.outputs.used_bytes, run.bytes);
    expect_rows(run, 3);
  }
  EXPECT_GT(sinew_test::distance(run_transfer(scene, rows, scene, method(SINEW_TRANSFER_REBIND)), rows, 3), 0.05)
      << "a bind does not know what was painted, or this test could not fail";
}

// Heights and positions differ, units too: 1:100 and back.
TEST(Transfer, AnotherBuildAndScaleGetsLikeWeights) {
  const MeshScene source = limb(25, 12, 3, 0.3);
  const BoundRows rows = painted(source, 3);
  for (const double scale : {1.0, 0.01, 100.0}) {
    const double height = 4 * scale;
    const MeshScene target = limb(40, 9, height, 0.45 * scale, 0.3);
    for (const uint32_t m : {SINEW_TRANSFER_AUTO, SINEW_TRANSFER_NEAREST}) {
      const TransferRun run = run_transfer(source, rows, target, method(m));
      ASSERT_EQ(run.status, SINEW_OK);
      expect_rows(run, 3);
      const BoundRows expected = painted(target, height);
      EXPECT_LT(sinew_test::distance(run, expected, 3), 0.08) << scale << " " << m;
      EXPECT_GT(run.outputs.carried_q16, 65536u * 2 / 3);
      EXPECT_EQ(run.parts[0].reason, m == SINEW_TRANSFER_AUTO ? SINEW_TRANSFER_STYLE : SINEW_TRANSFER_ASKED);
    }
  }
}

// A skeleton that faces and stands elsewhere is turned as a whole first.
TEST(Transfer, AMeshThatLiesDownIsTheSame) {
  MeshScene source = limb(25, 12, 3, 0.3, 0.2);
  source.add_joint(1, 1, 0.5f, 1);  // tells how the limb faces
  const BoundRows rows = painted(source, 3);
  MeshScene target = source;
  const auto turn = [](std::vector<float>& xyz) {  // a quarter about z, then half about x
    for (size_t i = 0; i < xyz.size(); i += 3) {
      const float x = xyz[i], y = xyz[i + 1], z = xyz[i + 2];
      xyz[i] = -y;
      xyz[i + 1] = -x;
      xyz[i + 2] = -z;
    }
  };
  turn(target.positions);
  turn(target.joints);
  const TransferRun run = run_transfer(source, rows, target, method(SINEW_TRANSFER_NEAREST));
  ASSERT_EQ(run.status, SINEW_OK);
  EXPECT_LT(sinew_test::distance(run, rows, 4), 0.01);
}

TEST(Transfer, WhatABindGivesIsBoundAgain) {
  const MeshScene source = limb(25, 12, 3, 0.3);
  BoundRows bound;
  const TransferRun plain = run_transfer(source, painted(source, 3), source, method(SINEW_TRANSFER_REBIND));
  for (uint32_t v = 0; v < source.vertex_count(); ++v) {
    for (uint32_t i = 0; i < 2; ++i) {
      bound.joints.push_back(plain.joints[v * plain.n + i]);
      bound.weights.push_back(plain.weights[v * plain.n + i]);
    }
  }
  const MeshScene target = limb(31, 10, 2, 0.4, 0.2);
  const TransferRun run = run_transfer(source, bound, target), rebind = run_transfer(source, bound, target, method(3));
  ASSERT_EQ(run.status, SINEW_OK);
  EXPECT_LT(run.outputs.carried_q16, 65536u / 10);
  EXPECT_NE(run.parts[0].reason, SINEW_TRANSFER_STYLE);
  double sum = 0;
  for (uint32_t v = 0; v < target.vertex_count(); ++v)
    for (uint16_t j = 0; j < 3; ++j) sum += std::fabs(run.weight(v, j) - rebind.weight(v, j));
  EXPECT_LT(sum / target.vertex_count(), 0.02);
}

// Neither style nor mismatch: there is a match all the same.
TEST(Transfer, RowsThatAreABindsToTheLastBitHaveAMatch) {
  MeshScene scene = limb(10, 8, 2, 0.3);
  scene.joints.resize(3);
  scene.parents.resize(1);
  BoundRows rows = painted(scene, 2);
  for (size_t i = 0; i < rows.joints.size(); ++i) {
    rows.joints[i] = 0;
    rows.weights[i] = i % 2 == 0 ? 65535 : 0;
  }
  const TransferRun run = run_transfer(scene, rows, scene, method(SINEW_TRANSFER_AUTO));
  ASSERT_EQ(run.status, SINEW_OK);
  EXPECT_EQ(run.parts[0].reason, SINEW_TRANSFER_PLAIN);
}

TEST(Transfer, LockedVerticesStay) {
  const MeshScene source = limb(25, 12, 3, 0.3);
  std::vector<uint8_t> locked(source.vertex_count(), 0);
  TransferRun before;
  before.joints.assign(4 * source.vertex_count(), 2);
  before.weights.assign(before.joints.size(), 0);
  for (uint32_t v = 0; v < source.vertex_count(); v += 5) {
    locked[v] = 1;
    before.weights[4 * v] = 777;
  }
  sinew_transfer_options options = SINEW_INIT(sinew_transfer_options);
  options.locked = locked.data();
  const TransferRun run = run_transfer(source, painted(source, 3), source, options, {}, before);
  ASSERT_EQ(run.status, SINEW_OK);
  for (uint32_t v = 0; v < source.vertex_count(); ++v) {
    EXPECT_EQ(run.weights[4 * v] == 777 && run.joints[4 * v] == 2, locked[v] != 0) << v;
    if (locked[v] != 0) {
      EXPECT_EQ(run.confidence[v], 255);
    }
  }
}

// A joint that only the target has shares what its parent gets; one that only the source has gives to its parent's counterpart.
TEST(Transfer, SkeletonsMayDiffer) {
  const MeshScene source = limb(25, 12, 3, 0.3);
  const BoundRows rows = painted(source, 3);
  MeshScene target = source;
  target.parents.resize(2);
  target.joints.resize(6);
  const TransferRun fewer = run_transfer(source, rows, target, {}, {0, 1, -1});
  const TransferRun less = run_transfer(source, rows, target, SINEW_INIT(sinew_transfer_options), {0, 1, -1});
  EXPECT_EQ(fewer.status, SINEW_ERROR_ARGUMENT) << "struct_size was not set";
  ASSERT_EQ(less.status, SINEW_OK);
  expect_rows(less, 2);
  EXPECT_GT(less.weight(target.vertex_count() - 1, 1), 0.99);

  target = source;
  target.add_joint(0, 2.6f, 0, 2);
  const TransferRun more = run_transfer(source, rows, target);
  ASSERT_EQ(more.status, SINEW_OK);
  const uint32_t top = target.vertex_count() - 1;
  EXPECT_GT(more.weight(top, 3), 0.2);
  EXPECT_GT(more.weight(top, 2) + more.weight(top, 3), 0.98);
  EXPECT_LT(more.weight(0, 3), 0.05);
}

TEST(Transfer, AGarmentIsCarriedNearTheBodyAndBoundFarFromIt) {
  const MeshScene body = limb(25, 12, 3, 0.3);
  const BoundRows rows = painted(body, 3);
  sinew_transfer_options options = SINEW_INIT(sinew_transfer_options);
  options.garment = 1;
  const MeshScene sleeve = limb(20, 16, 3, 0.33);
  const TransferRun near = run_transfer(body, rows, sleeve, options);
  ASSERT_EQ(near.status, SINEW_OK);
  EXPECT_LT(sinew_test::distance(near, painted(sleeve, 3), 3), 0.25);  // the cuffs' normals and a sixth of bind
  EXPECT_EQ(near.parts[0].reason, SINEW_TRANSFER_NEAR);
  const TransferRun far = run_transfer(body, rows, limb(20, 16, 3, 1.2), options);
  ASSERT_EQ(far.status, SINEW_OK);
  EXPECT_EQ(far.parts[0].reason, SINEW_TRANSFER_FAR);
  MeshScene other = body;
  other.up = SINEW_UP_Z;
  EXPECT_EQ(run_transfer(other, rows, sleeve, options).status, SINEW_ERROR_ARGUMENT);
  other.up = SINEW_UP_Y;
  EXPECT_EQ(run_transfer(other, rows, sleeve, options).status, SINEW_OK) << "Y is what no axis stands for";
}

TEST(Transfer, PairsOfVerticesAreReferences) {
  const MeshScene source = limb(25, 12, 3, 0.3), target = limb(25, 12, 3, 0.4, 0.2);
  const BoundRows rows = painted(source, 3);
  std::vector<sinew_vertex_pair> pairs;
  for (uint32_t v = 0; v < source.vertex_count(); v += 13) pairs.push_back({v, v});
  sinew_transfer_options options = method(SINEW_TRANSFER_BIHARMONIC);
  options.pairs = pairs.data();
  options.pair_count = static_cast<uint32_t>(pairs.size());
  const TransferRun run = run_transfer(source, rows, target, options);
  ASSERT_EQ(run.status, SINEW_OK);
  EXPECT_EQ(run.outputs.reference_count, pairs.size());
  EXPECT_LT(sinew_test::distance(run, painted(target, 3), 3), 0.15);
  options.pair_count = 3;
  EXPECT_EQ(run_transfer(source, rows, target, options).status, SINEW_ERROR_RANGE);
  options.pair_count = 5;
  pairs[2].target = target.vertex_count();
  EXPECT_EQ(run_transfer(source, rows, target, options).status, SINEW_ERROR_RANGE);
}

TEST(Transfer, TheWorkspaceIsExact) {
  const MeshScene source = limb(25, 12, 3, 0.3), target = limb(40, 9, 4, 0.45);
  for (const uint32_t m : kMethods) {
    EXPECT_EQ(run_transfer(source, painted(source, 3), target, method(m), {}, {}, 64).status, SINEW_ERROR_WORKSPACE)
        << m;
  }
}

TEST(Transfer, RubbishIsAStatusOrFinite) {
  const MeshScene good = limb(25, 12, 3, 0.3);
  const BoundRows rows = painted(good, 3);
  for (const uint32_t m : kMethods) {
    const auto status = [&](const MeshScene& source, const BoundRows& own, const MeshScene& target) {
      const TransferRun run = run_transfer(source, own, target, method(m));
      if (run.status == SINEW_OK) expect_rows(run, static_cast<uint32_t>(target.parents.size()));
      return run.status;
    };
    MeshScene bad = good;
    bad.positions[7] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(status(good, rows, bad), SINEW_ERROR_NOT_FINITE);
    EXPECT_EQ(status(bad, rows, good), SINEW_ERROR_NOT_FINITE);
    bad = good;
    bad.joints[4] = std::numeric_limits<float>::infinity();
    EXPECT_EQ(status(good, rows, bad), SINEW_ERROR_NOT_FINITE);
    bad = good;
    bad.corners[3] = good.vertex_count();
    EXPECT_EQ(status(good, rows, bad), SINEW_ERROR_INDEX);
    bad = good;
    bad.positions.clear();
    bad.positions.reserve(3);  // a pointer that is not null
    bad.corners.clear();
    bad.corners.reserve(1);
    bad.offsets = {0};
    EXPECT_EQ(status(bad, rows, good), SINEW_ERROR_COUNT);
    EXPECT_EQ(run_transfer(good, rows, bad, method(m)).sized, SINEW_ERROR_COUNT);

    BoundRows none = rows;
    none.weights.assign(none.weights.size(), 0);
    EXPECT_EQ(status(good, none, good), SINEW_ERROR_RANGE);
    BoundRows wrong = rows;
    wrong.joints[5] = 3;
    EXPECT_EQ(status(good, wrong, good), SINEW_ERROR_RANGE);

    MeshScene point;
    point.add_vertex(1, 2, 3);
    point.joints = good.joints;
    point.parents = good.parents;
    MeshScene flat = good;
    for (size_t i = 0; i < flat.positions.size(); i += 3) flat.positions[i] = 0;
    MeshScene one_position = good;
    one_position.positions.assign(one_position.positions.size(), 5);
    MeshScene heap = good;  // all joints at one position
    heap.joints.assign(heap.joints.size(), 0.5f);
    MeshScene huge = good;
    for (float& x : huge.positions) x *= 1e30f;
    for (const MeshScene* odd : {&point, &flat, &one_position, &heap, &huge}) {
      const bool distances = m == SINEW_TRANSFER_BIHARMONIC;
      const sinew_status to = status(good, rows, *odd);
      EXPECT_TRUE(to == SINEW_OK || (distances && to == SINEW_ERROR_RANGE)) << m << " " << to;
      BoundRows own = rows;
      own.joints.resize(2 * odd->vertex_count());
      own.weights.resize(2 * odd->vertex_count());
      const sinew_status from = status(*odd, own, good);
      EXPECT_TRUE(from == SINEW_OK || (distances && from == SINEW_ERROR_RANGE)) << m << " " << from;
    }
  }
}

TEST(Transfer, OptionsOutOfTheirRangeAreRefused) {
  const MeshScene scene = limb(9, 6, 3, 0.3);
  const BoundRows rows = painted(scene, 3);
  std::vector<std::pair<const char*, sinew_transfer_options>> refused;
  const auto add = [&](const char* name) -> sinew_transfer_options& {
    refused.emplace_back(name, SINEW_INIT(sinew_transfer_options));
    return refused.back().second;
  };
  add("method").method = 4;
  add("influences").influence_count = 13;
  add("format").weight_format = 3;
  add("garment").garment = 2;
  add("pairs without an array").pair_count = 4;
  add("threads").thread_count = 65;
  sinew_transfer_options& both = add("a garment by distances");
  both.garment = 1;
  both.method = SINEW_TRANSFER_BIHARMONIC;
  for (const auto& [name, options] : refused) {
    const TransferRun run = run_transfer(scene, rows, scene, options);
    EXPECT_EQ(run.sized, SINEW_ERROR_ARGUMENT) << name;
    EXPECT_EQ(run.status, SINEW_ERROR_ARGUMENT) << name;
  }
  EXPECT_EQ(run_transfer(scene, rows, scene, SINEW_INIT(sinew_transfer_options), {0, 3, 2}).status, SINEW_ERROR_RANGE);
  EXPECT_EQ(run_transfer(scene, rows, scene, SINEW_INIT(sinew_transfer_options), {-1, -1, -1}).status,
            SINEW_ERROR_RANGE);
}

TEST(Transfer, ThreadsAndNumbersOfVerticesChangeNothing) {
  const MeshScene source = limb(25, 12, 3, 0.3), target = limb(40, 9, 4, 0.45, 0.3);
  const BoundRows rows = painted(source, 3);
  for (const uint32_t m : kMethods) {
    const TransferRun expected = run_transfer(source, rows, target, method(m));
    ASSERT_EQ(expected.status, SINEW_OK);
    sinew_transfer_options options = method(m);
    options.thread_count = 3;
    options.parallel_for = [](void*, uint32_t count, void (*body)(void*, uint32_t), void* data) {
      for (uint32_t i = count; i-- > 0;) body(data, i);
    };
    const TransferRun threads = run_transfer(source, rows, target, options);
    EXPECT_EQ(threads.weights, expected.weights) << m;
    EXPECT_EQ(threads.joints, expected.joints) << m;

    // The target's vertices in reverse order.
    MeshScene turned = target;
    const uint32_t count = target.vertex_count();
    for (uint32_t v = 0; v < count; ++v)
      for (uint32_t k = 0; k < 3; ++k) turned.positions[3 * v + k] = target.positions[3 * (count - 1 - v) + k];
    for (uint32_t& corner : turned.corners) corner = count - 1 - corner;
    const TransferRun other = run_transfer(source, rows, turned, method(m));
    for (uint32_t v = 0; v < count; ++v)
      for (uint32_t i = 0; i < 4; ++i)
        ASSERT_EQ(other.weights[4 * v + i], expected.weights[4 * (count - 1 - v) + i]) << m << " " << v;
  }
}

}  // namespace
