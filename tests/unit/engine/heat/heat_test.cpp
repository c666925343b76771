// SPDX-License-Identifier: MIT
// The heat stage file by file: exact visibility, ties and the visibility rule, cotangents, ordering, solvers, finished
// rows.
#include <gtest/gtest.h>

#include <array>
#include <map>
#include <numeric>
#include <set>

#include "heat/solver.hpp"
#include "heat/sources.hpp"
#include "heat_scene.hpp"
#include "kernels/select.hpp"
#include "solve/fronts.hpp"
#include "solve/iterative.hpp"

namespace {

using namespace sinew;
using sinew_test::HeatRun;
using sinew_test::HeatScene;

// A block for pieces of the stage that a test runs on their own.
struct Block {
  explicit Block(size_t bytes)
      : bytes_((bytes + 63) / 64 * 64), memory(std::aligned_alloc(64, bytes_)), arena(memory, bytes_) {}
  ~Block() { std::free(memory); }
  Block(const Block&) = delete;
  Block& operator=(const Block&) = delete;
  size_t bytes_;
  void* memory;
  Arena arena;
};

struct Sources {
  explicit Sources(const HeatRun& run) : block(size(run.counts)) {
    found.allocate(block.arena, run.counts);
    EXPECT_EQ(find_sources(run.mesh, run.skeleton, run.counts, boxes_met_ref, {}, 1000, block.arena, &found), SINEW_OK);
  }
  static size_t size(const Counts& counts) {
    Arena measure;
    HeatSources s;
    s.allocate(measure, counts);
    (void)find_sources({}, {}, counts, boxes_met_ref, {}, 1000, measure, &s);
    return measure.high_water();
  }
  std::set<uint32_t> of(uint32_t field, uint32_t vertex) const {
    std::set<uint32_t> out;
    for (uint32_t t = 0; t < kMaxTies; ++t) {
      if (found.mask[field][vertex] >> t & 1)
        out.insert(found.ties[HeatSources::measure_of(field)][vertex * kMaxTies + t]);
    }
    return out;
  }
  Block block;
  HeatSources found;
};

// Counter-clockwise seen from above: its front looks up.
constexpr Vec3i kA = {0, 0, 0}, kB = {0, 0, 100}, kC = {100, 0, 0};

TEST(Visibility, OnlyTheFrontHides) {
  EXPECT_TRUE(crosses_front({20, 50, 20}, {20, -50, 20}, kA, kB, kC));
  EXPECT_FALSE(crosses_front({20, -50, 20}, {20, 50, 20}, kA, kB, kC));
  EXPECT_FALSE(crosses_front({20, 50, 20}, {20, -50, 20}, kA, kC, kB));
  EXPECT_TRUE(crosses_front({20, -50, 20}, {20, 50, 20}, kA, kC, kB));
}

TEST(Visibility, EdgesAndCornersBelongToTheFace) {
  EXPECT_TRUE(crosses_front({50, 10, 0}, {50, -10, 0}, kA, kB, kC));
  EXPECT_TRUE(crosses_front({50, 10, 50}, {50, -10, 50}, kA, kB, kC));
  EXPECT_TRUE(crosses_front({0, 10, 0}, {0, -10, 0}, kA, kB, kC));
  EXPECT_FALSE(crosses_front({50, 10, -1}, {50, -10, -1}, kA, kB, kC));
  EXPECT_FALSE(crosses_front({51, 10, 50}, {51, -10, 50}, kA, kB, kC));
}

TEST(Visibility, EndsOnTheFaceAndMovesInItsPlaneDoNotCross) {
  EXPECT_FALSE(crosses_front({20, 50, 20}, {20, 0, 20}, kA, kB, kC));
  EXPECT_TRUE(crosses_front({20, 50, 20}, {20, -1, 20}, kA, kB, kC));
  EXPECT_FALSE(crosses_front({20, 0, 20}, {20, -50, 20}, kA, kB, kC));
  EXPECT_FALSE(crosses_front({-50, 0, 20}, {200, 0, 20}, kA, kB, kC));
}

TEST(Visibility, OneUnitDecidesAtFullScale) {
  // The crossing point lies a billionth of a grid unit beside the long edge; any rounding gives the wrong answer for
  // one of the two.
  const Vec3i a = {-524288, 3, -524287}, b = {524287, 5, 524288}, c = {524287, 1, -524288};
  int hits = 0, differs = 0;
  for (int32_t dx = -1; dx <= 1; ++dx) {
    for (int32_t dz = -1; dz <= 1; ++dz) {
      const bool one = crosses_front({dx, 500000, dz}, {dx + 1, -400001, dz}, a, b, c);
      hits += one;
      differs += one != crosses_front_wide({dx, 500000, dz}, {dx + 1, -400001, dz}, a, b, c);
    }
  }
  EXPECT_GT(hits, 0);
  EXPECT_LT(hits, 9);
  EXPECT_EQ(differs, 0);
}

TEST(Visibility, WideDeterminantsEqualTheFastOnes) {
  std::mt19937 random(7);
  const auto pick = [&](int32_t reach) {
    return static_cast<int32_t>(random() % static_cast<uint32_t>(2 * reach + 1)) - reach;
  };
  int hits = 0;
  for (int i = 0; i < 20000; ++i) {
    const int32_t reach = i % 2 == 0 ? 6 : 1 << 18;  // a small lattice meets edges and planes all the time
    const auto point = [&] { return Vec3i{pick(reach), pick(reach), pick(reach)}; };
    const Vec3i s = point(), t = point(), a = point(), b = point(), c = point();
    const bool fast = crosses_front(s, t, a, b, c);
    hits += fast;
    ASSERT_EQ(fast, crosses_front_wide(s, t, a, b, c));
    ASSERT_EQ(fast, crosses_front(s, t, b, c, a));
  }
  EXPECT_GT(hits, 100);
}

TEST(Visibility, FarTargetsUseTheWideWay) {
  const Vec3i a = {-500000, 0, -500000}, b = {-500000, 0, 500000}, c = {500000, 0, 0};
  EXPECT_TRUE(crosses_front({0, 500000, 0}, {0, -8000000, 0}, a, b, c));
  EXPECT_TRUE(crosses_front({0, 500000, 0}, {7000000, -8000000, 0}, a, b, c));
  EXPECT_FALSE(crosses_front({0, 500000, 0}, {8000000, -4000000, 0}, a, b, c));
}

TEST(Visibility, TreeEqualsBruteForce) {
  HeatScene scene = sinew_test::tangle(300, 900, 3, 11);
  for (const uint32_t part : {40u, 70u}) {  // two parts more, in the same place
    const HeatScene other = sinew_test::tangle(part, 2 * part, 1, part);
    const uint32_t base = scene.vertex_count();
    for (size_t i = 0; i < other.positions.size(); i += 3)
      scene.add_vertex(other.positions[i], other.positions[i + 1], other.positions[i + 2]);
    for (size_t i = 0; i < other.triangles.size(); i += 3)
      scene.add_triangle(base + other.triangles[i], base + other.triangles[i + 1], base + other.triangles[i + 2]);
  }
  const HeatRun run(scene, false);
  ASSERT_EQ(run.status, SINEW_OK);
  Arena measure;
  FaceTree tree;
  tree.allocate(measure, run.counts);
  Block block(measure.high_water());
  tree.allocate(block.arena, run.counts);
  tree.build(run.mesh);
  std::mt19937 random(3);
  int hidden[2] = {};
  uint32_t kept[2] = {FaceTree::kNoGroup, FaceTree::kNoGroup};  // hints, from one vertex to the next
  for (uint32_t v = 0; v < run.mesh.welded_count; ++v) {
    const Vec3i target = run.mesh.positions[random() % run.mesh.welded_count];
    const uint32_t first = tree.component_first[run.mesh.component[v]],
                   last = tree.component_first[run.mesh.component[v] + 1];
    for (const bool outside : {false, true}) {
      bool brute = false;
      for (uint32_t t = 0; t < run.mesh.triangle_count; ++t) {
        const uint32_t* c = run.mesh.triangles + 3 * t;
        if (c[0] == v || c[1] == v || c[2] == v) continue;
        if ((run.mesh.component[c[0]] == run.mesh.component[v]) == outside) continue;
        brute = brute || crosses_front(run.mesh.positions[v], target, run.mesh.positions[c[0]],
                                       run.mesh.positions[c[1]], run.mesh.positions[c[2]]);
      }
      uint32_t hint = FaceTree::kNoGroup;
      ASSERT_EQ(tree.hidden(run.mesh, v, target, first, last, outside, &hint), brute) << v;
      ASSERT_EQ(tree.hidden(run.mesh, v, target, first, last, outside, &hint), brute) << v;  // with the hint
      ASSERT_EQ(tree.hidden(run.mesh, v, target, first, last, outside, &kept[outside]), brute) << v;
      hidden[outside] += brute;
    }
  }
  EXPECT_GT(hidden[0], 20);
  EXPECT_GT(hidden[1], 20);
  EXPECT_LT(hidden[1], static_cast<int>(run.mesh.welded_count));
}

TEST(Laplacian, KnownAngles) {
  constexpr int32_t one = 1 << kEdgeWeightBits;
  EXPECT_EQ(cotangent_q24({0, 0, 0}, {7, 0, 0}, {0, 3, 0}), 0);
  EXPECT_EQ(cotangent_q24({0, 0, 0}, {5, 0, 0}, {5, 5, 0}), one);
  EXPECT_EQ(cotangent_q24({0, 0, 0}, {5, 0, 0}, {-5, 5, 0}), -one);
  EXPECT_EQ(cotangent_q24({-524288, 0, -524288}, {524288, 0, -524288}, {524288, 1048576, -524288}), one);
  EXPECT_EQ(cotangent_q24({0, 0, 0}, {1000000, 0, 0}, {1000000, 1, 0}), 50 * one);
  EXPECT_EQ(cotangent_q24({0, 0, 0}, {1000000, 0, 0}, {-1000000, 1, 0}), -50 * one);
  EXPECT_NEAR(cotangent_q24({0, 0, 0}, {3, 1, 2}, {-1, 4, 2}), one * (5.0 / std::sqrt(14 * 21 - 25.0)), 1);
  EXPECT_NEAR(cotangent_q24({1, 1, 1}, {1048576, 1, 7}, {1048570, 30001, 9}), one * 34.9519, one * 0.01);
}

TEST(Laplacian, BorderEdgesCountInFull) {
  // A unit square of two right triangles: the diagonal sees two right angles, every side one angle of 45 degrees.
  HeatScene scene;
  scene.add_vertex(0, 0, 0);
  scene.add_vertex(1, 0, 0);
  scene.add_vertex(1, 1, 0);
  scene.add_vertex(0, 1, 0);
  scene.add_triangle(0, 1, 2);
  scene.add_triangle(0, 2, 3);
  scene.add_joint(0.5, 0.5, -0.5, -1);
  const HeatRun run(scene, false);
  ASSERT_EQ(run.status, SINEW_OK);
  Block block(1 << 16);
  EdgeWeights edges;
  edges.allocate(block.arena, run.counts);
  ASSERT_EQ(weigh_edges(run.mesh, run.counts, block.arena, &edges), SINEW_OK);
  std::multiset<int32_t> weights(edges.weight, edges.weight + run.mesh.row_offsets[run.mesh.welded_count]);
  EXPECT_EQ(weights.count(0), 2u);
  EXPECT_EQ(weights.count(1 << kEdgeWeightBits), 8u);
}

// Smallest pivot of the matrix of the edge weights, which is singular at best, after a millionth was added.
double smallest_pivot(const Mesh& mesh, const EdgeWeights& edges) {
  const size_t n = mesh.welded_count;
  std::vector<double> m(n * n, 0);
  double largest = 0;
  for (uint32_t v = 0; v < n; ++v) {
    for (uint32_t e = mesh.row_offsets[v]; e < mesh.row_offsets[v + 1]; ++e) {
      m[v * n + mesh.col_indices[e]] -= edges.weight[e];
      m[v * n + v] += edges.weight[e];
      largest = std::max(largest, std::fabs(static_cast<double>(edges.weight[e])));
    }
  }
  double smallest = largest;
  for (size_t k = 0; k < n; ++k) {
    const double pivot = m[k * n + k] + largest * 1e-6;
    smallest = std::min(smallest, pivot);
    if (pivot <= 0) break;
    for (size_t i = k + 1; i < n; ++i) {
      for (size_t j = k + 1; j < n; ++j) m[i * n + j] -= m[i * n + k] * m[k * n + j] / pivot;
    }
  }
  return smallest;
}

// Needles whose cotangents were cut, and edges with any number of triangles: as the caller's they may spoil the matrix,
// on a reduced mesh they must not.
TEST(Laplacian, OfAReducedMeshIsPositive) {
  int spoilt = 0;
  for (uint32_t seed = 0; seed < 60; ++seed) {
    HeatScene scene = sinew_test::tangle(16, 30, 1, seed);
    for (size_t v = 0; v < scene.positions.size(); v += 3) scene.positions[v] *= 0.002f;
    HeatRun run(scene, false);
    ASSERT_EQ(run.status, SINEW_OK);
    Block block(1 << 16);
    EdgeWeights edges;
    edges.allocate(block.arena, run.counts);
    ASSERT_EQ(weigh_edges(run.mesh, run.counts, block.arena, &edges), SINEW_OK);
    spoilt += smallest_pivot(run.mesh, edges) <= 0 ? 1 : 0;
    run.mesh.reduced = true;
    ASSERT_EQ(weigh_edges(run.mesh, run.counts, block.arena, &edges), SINEW_OK);
    EXPECT_GT(smallest_pivot(run.mesh, edges), 0) << seed;
  }
  EXPECT_GT(spoilt, 10) << "no scene needs the rules";
}

TEST(Sources, BonesThatShareTheNearestPointShareTheVertex) {
  // A chain of three joints: vertices level with the middle joint are nearest to the end of one bone and the start of
  // the next.
  HeatScene scene = sinew_test::capsule(31, 12, 0);
  scene.add_joint(0, 1, 0, -1);
  scene.add_joint(0, 2, 0, 0);
  scene.add_joint(0, 3, 0, 1);
  const HeatRun run(scene, false);
  ASSERT_EQ(run.status, SINEW_OK);
  const Sources sources(run);
  int shared = 0;
  for (uint32_t v = 0; v < run.mesh.welded_count; ++v) {
    if (std::abs(run.mesh.positions[v].y - kSide / 2) > 2) continue;
    EXPECT_EQ(sources.of(kFieldRule, v), (std::set<uint32_t>{0, 1}));
    EXPECT_EQ(sources.of(kFieldSoft, v), (std::set<uint32_t>{0, 1}));
    EXPECT_EQ(sources.found.nearest[1][v], 0u);
    ++shared;
  }
  EXPECT_EQ(shared, 12);
}

TEST(Sources, NearestAndNearestVisibleOfManyBones) {
  const HeatRun run(sinew_test::tangle(400, 220, 60, 5), false);
  ASSERT_EQ(run.status, SINEW_OK);
  const Sources sources(run);
  size_t visible = 0, second = 0, seen_otherwise = 0;
  for (uint32_t v = 0; v < run.mesh.welded_count; ++v) {
    const Vec3i at = run.mesh.positions[v], normal = run.mesh.normals[v];
    double smallest = 1e30, cosine = 1e30, seen = 1e30;
    for (uint32_t j = 0; j < run.counts.joints; ++j) {
      if (run.skeleton.source[j] == 0) continue;
      const Vec3i head = run.skeleton.positions[j], along = run.skeleton.bone_tail[j] - head, from = at - head;
      const double t = static_cast<double>(dot(from, along)) / std::max(1.0, static_cast<double>(dot(along, along)));
      const double share = std::min(1.0, std::max(0.0, t));
      const double x = from.x - share * along.x, y = from.y - share * along.y, z = from.z - share * along.z;
      const double euclid = std::sqrt(x * x + y * y + z * z);
      const double cos = (x * normal.x + y * normal.y + z * normal.z) / (16384 * std::max(euclid, 1e-3));
      smallest = std::min(smallest, euclid);
      cosine = std::min(cosine, euclid / (0.5 * (cos + 1.001)));
      if (euclid >= seen) continue;
      const Vec3i target = {at.x - static_cast<int32_t>(std::lround(x)), at.y - static_cast<int32_t>(std::lround(y)),
                            at.z - static_cast<int32_t>(std::lround(z))};
      bool hidden = false;
      for (uint32_t i = 0; i < run.mesh.triangle_count && !hidden; ++i) {
        const uint32_t* c = run.mesh.triangles + 3 * i;
        hidden =
            run.mesh.component[c[0]] == run.mesh.component[v] && c[0] != v && c[1] != v && c[2] != v &&
            crosses_front(at, target, run.mesh.positions[c[0]], run.mesh.positions[c[1]], run.mesh.positions[c[2]]);
      }
      if (!hidden) seen = euclid;
    }
    EXPECT_NEAR(static_cast<double>(sources.found.distance[0][v]) / 64, cosine, 2 + cosine / 1000) << v;
    const double soft = static_cast<double>(sources.found.distance[1][v]) / 64;
    EXPECT_GT(soft, smallest - 2) << v;
    if (seen == 1e30) continue;
    ++visible;
    second += seen > 1.1 * smallest;
    seen_otherwise += std::abs(soft - seen) > 2;  // rays along the edge of a triangle
  }
  EXPECT_GT(visible, 200u);
  EXPECT_GT(second, 50u);
  EXPECT_LT(seen_otherwise, 4u);
}

TEST(Sources, StrengthFallsWithTheSquareOfTheDistance) {
  const int64_t near = source_pull_q40(1000000, 100000 << kDistanceBits, kFieldRule);
  EXPECT_NEAR(static_cast<double>(near), 4 * 1e6 / 1e10 * std::pow(2.0, 40), 2);
  EXPECT_NEAR(static_cast<double>(source_pull_q40(1000000, 200000 << kDistanceBits, kFieldRule)),
              static_cast<double>(near) / 4, 2);
  EXPECT_NEAR(static_cast<double>(source_pull_q40(1000000, 100000 << kDistanceBits, kFieldSoft)),
              static_cast<double>(near) * 0.175, 2);
  EXPECT_EQ(source_pull_q40(1000000, 0, kFieldRule), source_pull_q40(1000000, kMinDistance, kFieldRule));
  EXPECT_GE(source_pull_q40(0, int64_t{1} << 41, kFieldSoft), 1);
  EXPECT_LE(source_pull_q40(~uint64_t{0}, 0, kFieldRule), int64_t{1} << 62);
}

// One closed shell far inside another: the inner one's faces look outwards, against anyone who comes from outside.
HeatScene nested_shells() {
  HeatScene scene = sinew_test::capsule(20, 16, 0);
  scene.add_joint(0, 0.6, 0, -1);
  scene.add_joint(0, 3.0, 0, 0);
  sinew_test::add_revolved(
      &scene, 8, 8, [](uint32_t i) { return 0.2 + 3.6 * i / 7; }, [](uint32_t, double) { return 0.15; }, 0.15, 3.85);
  return scene;
}

TEST(Sources, RuleFallsBackToPartsWhereAnotherPartHides) {
  const HeatRun run(nested_shells());
  ASSERT_EQ(run.status, SINEW_OK);
  ASSERT_EQ(run.mesh.component_count, 2u);
  EXPECT_EQ(run.fields.component_rule[0], 1);  // the outer shell: the inner one hides the bones
  EXPECT_EQ(run.fields.component_rule[1], 0);  // the inner shell sees them
}

TEST(Sources, ALoneBoneOwnsEverything) {
  HeatScene scene;
  for (const double x : {0.0, 1.0}) {  // two parallel square plates with the bone between them
    const uint32_t first = scene.vertex_count();
    for (const double y : {0.0, 1.0}) {
      for (const double z : {0.0, 1.0}) scene.add_vertex(x, y, z);
    }
    scene.add_triangle(first, first + 1, first + 2);
    scene.add_triangle(first + 1, first + 3, first + 2);
  }
  scene.add_joint(0.5, 0.5, 0.5, -1);
  const HeatRun run(scene);
  ASSERT_EQ(run.status, SINEW_OK);
  for (uint32_t c = 0; c < run.mesh.component_count; ++c)
    EXPECT_EQ(run.fields.component_rule[c], 0);  // a flat plate hides nothing from its own corners
  for (uint32_t f = 0; f < kFieldCount; ++f) {
    for (uint32_t v = 0; v < run.mesh.welded_count; ++v) EXPECT_EQ(run.weight(f, v, 0), 1.0);
  }
}

TEST(Sources, InsideOutBodiesHideTheirFarSide) {
  HeatScene scene = sinew_test::capsule(12, 12, 0);
  for (size_t i = 0; i < scene.triangles.size(); i += 3) std::swap(scene.triangles[i], scene.triangles[i + 1]);
  scene.add_joint(6, 1, 0, -1);
  scene.add_joint(6, 3, 0, 0);
  const HeatRun run(scene);
  ASSERT_EQ(run.status, SINEW_OK);
  size_t near = 0, far = 0;
  for (uint32_t v = 0; v < run.mesh.welded_count; ++v) {
    if (run.mesh.positions[v].x > kSide / 16) {
      EXPECT_EQ(run.fields.field[kFieldRule].has_source[v], 1) << v;
      ++near;
    } else if (run.mesh.positions[v].x < -kSide / 16) {
      EXPECT_EQ(run.fields.field[kFieldRule].has_source[v], 0) << v;
      ++far;
    }
  }
  EXPECT_GT(near, 20u);
  EXPECT_GT(far, 20u);
}

TEST(Sources, BodiesThatHideTheirOwnBonesAreOpen) {
  // The inner shell hangs on the outer one by a triangle, so it is the same part; its own few vertices alone see the
  // bones.
  HeatScene scene = sinew_test::capsule(30, 30, 0);
  const uint32_t inner = scene.vertex_count();
  sinew_test::add_revolved(
      &scene, 4, 8, [](uint32_t i) { return 0.2 + 3.6 * i / 3; }, [](uint32_t, double) { return 0.25; }, 0.15, 3.85);
  scene.add_triangle(0, 1, inner);
  scene.add_joint(0, 0.6, 0, -1);
  scene.add_joint(0, 3.0, 0, 0);
  const HeatRun run(scene);
  ASSERT_EQ(run.status, SINEW_OK);
  ASSERT_EQ(run.mesh.component_count, 1u);
  EXPECT_EQ(run.fields.component_rule[0], 2);
  size_t seen = 0;
  for (uint32_t v = 0; v < run.mesh.welded_count; ++v) {
    EXPECT_EQ(run.fields.field[kFieldRule].has_source[v], 1);
    seen += run.fields.field[kFieldParts].has_source[v];
  }
  EXPECT_GT(seen, 0u);
  EXPECT_LT(seen, run.mesh.welded_count / 10);
}

TEST(Ordering, IsAPermutationAndKeepsFillSmall) {
  const HeatRun run(sinew_test::star(40, 50, 2), false);
  ASSERT_EQ(run.status, SINEW_OK);
  Arena measure;
  Ordering ordering;
  Factor factor;
  ordering.allocate(measure, run.counts);
  factor.allocate(measure, run.counts);
  Block block(measure.high_water());
  ordering.allocate(block.arena, run.counts);
  factor.allocate(block.arena, run.counts);
  ordering.dissect(run.mesh, 0);
  std::set<uint32_t> seen(ordering.order, ordering.order + run.mesh.welded_count);
  EXPECT_EQ(seen.size(), run.mesh.welded_count);
  for (uint32_t k = 0; k < run.mesh.welded_count; ++k) EXPECT_EQ(ordering.place[ordering.order[k]], k);
  HeatMatrix matrix;
  matrix.mesh = &run.mesh;
  matrix.ordering = &ordering;
  matrix.rows = run.mesh.welded_count;
  ASSERT_TRUE(factor.analyse(matrix));
  // Minimum degree: 21 per vertex; by number: 45.
  EXPECT_LT(factor.column_start[run.mesh.welded_count], 26u * run.mesh.welded_count);
}

// Everything that a solver of one component of a scene needs.
struct OneComponent {
  explicit OneComponent(const HeatScene& scene) : run(scene, false), block(size(run.counts)) {
    edges.allocate(block.arena, run.counts);
    ordering.allocate(block.arena, run.counts);
    fronts.allocate(block.arena, run.counts);
    matrix.diagonal = block.arena.alloc<int64_t>(run.counts.vertices);
    EXPECT_EQ(weigh_edges(run.mesh, run.counts, block.arena, &edges), SINEW_OK);
    ordering.dissect(run.mesh, 0);
    matrix.mesh = &run.mesh;
    matrix.edges = &edges;
    matrix.ordering = &ordering;
    matrix.rows = run.mesh.component_sizes[0];
  }
  static size_t size(const Counts& counts) {
    Arena measure;
    EdgeWeights().allocate(measure, counts);
    Ordering().allocate(measure, counts);
    FrontFactor().allocate(measure, counts);
    measure.alloc<int64_t>(counts.vertices);
    (void)weigh_edges({}, counts, measure, nullptr);
    return measure.high_water();
  }
  HeatRun run;
  Block block;
  EdgeWeights edges;
  Ordering ordering;
  FrontFactor fronts;
  HeatMatrix matrix;
};

TEST(Fronts, SolveForAKnownSolution) {
  // The pulls of a solution that falls along the body, some of them a thousandfold stronger than the stiffness.
  OneComponent c(sinew_test::star(40, 50, 2));
  const uint32_t rows = c.matrix.rows;
  std::vector<int64_t> pulls(rows);
  std::mt19937 random(5);
  for (uint32_t k = 0; k < rows; ++k) pulls[k] = random() % 3 == 0 ? int64_t{1} << (30 + random() % 22) : 0;
  ASSERT_TRUE(c.fronts.analyse(c.matrix));
  c.matrix.assemble(pulls.data(), kFactorDiagonalBits);
  ASSERT_TRUE(c.fronts.factorise(c.matrix, FrontKernels()));
  const auto wanted = [&](uint32_t k) {
    return 0.5 + 0.4 * c.run.mesh.positions[c.ordering.order[k]].y / static_cast<double>(kSide);
  };
  c.fronts.begin();
  const double one = std::pow(2.0, 40), stiffness_unit = std::pow(2.0, 40 - kEdgeWeightBits);
  for (uint32_t k = 0; k < rows; ++k) {
    const uint32_t v = c.ordering.order[k];
    double b = static_cast<double>(pulls[k]) / one * wanted(k);
    for (uint32_t e = c.run.mesh.row_offsets[v]; e < c.run.mesh.row_offsets[v + 1]; ++e) {
      b += c.edges.weight[e] * stiffness_unit / one * (wanted(k) - wanted(c.ordering.place[c.run.mesh.col_indices[e]]));
    }
    c.fronts.add(k, 3, static_cast<int64_t>(std::llround(b * one)));
  }
  c.fronts.eliminate(FrontKernels());
  uint32_t seen = 0;
  double worst = 0;
  c.fronts.substitute(FrontKernels(), [&](uint32_t first, uint32_t count, const int32_t* x) {
    for (uint32_t i = 0; i < count; ++i, ++seen) {
      worst =
          std::max(worst, std::abs(x[i * kFrontLanes + 3] * std::pow(2.0, -kFrontSolutionBits) - wanted(first + i)));
      for (uint32_t lane = 0; lane < kFrontLanes; ++lane) EXPECT_TRUE(lane == 3 || x[i * kFrontLanes + lane] == 0);
    }
  });
  EXPECT_EQ(seen, rows);
  EXPECT_LT(worst, 2e-5);
}

TEST(Fronts, SkipWhatASourceDoesNotReach) {
  OneComponent c(sinew_test::capsule(200, 20, 2));
  const uint32_t rows = c.matrix.rows;
  const std::vector<int64_t> pulls(rows, int64_t{1} << 39);
  ASSERT_TRUE(c.fronts.analyse(c.matrix));
  c.matrix.assemble(pulls.data(), kFactorDiagonalBits);
  ASSERT_TRUE(c.fronts.factorise(c.matrix, FrontKernels()));
  c.fronts.begin();
  c.fronts.add(c.ordering.place[0], 0, pulls[0]);
  c.fronts.eliminate(FrontKernels());
  uint32_t seen = 0;
  int32_t largest = 0;
  c.fronts.substitute(FrontKernels(), [&](uint32_t, uint32_t count, const int32_t* x) {
    seen += count;
    for (uint32_t i = 0; i < count; ++i) largest = std::max(largest, x[i * kFrontLanes]);
  });
  EXPECT_GT(largest, 1 << (kFrontSolutionBits - 4));
  EXPECT_GT(seen, 20u);
  EXPECT_LT(seen, rows / 3);
}

TEST(Fronts, RefuseAMatrixThatIsNotDefinite) {
  OneComponent c(sinew_test::capsule(20, 20, 2));
  std::vector<int64_t> pulls(c.matrix.rows, 0);
  ASSERT_TRUE(c.fronts.analyse(c.matrix));
  c.matrix.assemble(pulls.data(), kFactorDiagonalBits);
  EXPECT_FALSE(c.fronts.factorise(c.matrix, FrontKernels()));  // singular: constants cost nothing
  pulls[7] = int64_t{1} << 40;
  c.matrix.assemble(pulls.data(), kFactorDiagonalBits);
  EXPECT_TRUE(c.fronts.factorise(c.matrix, FrontKernels()));
  c.matrix.diagonal[9] = -c.matrix.diagonal[9];
  EXPECT_FALSE(c.fronts.factorise(c.matrix, FrontKernels()));
}

TEST(Factor, ReciprocalsAndQuotients) {
  for (const int64_t d :
       {int64_t{1}, int64_t{2}, int64_t{3}, int64_t{1000003}, (int64_t{1} << 50) + 12345, (int64_t{1} << 58) - 1}) {
    for (const int64_t sign : {1, -1}) {
      const Reciprocal r = reciprocal(sign * d);
      for (const int64_t n : {int64_t{0}, int64_t{1}, int64_t{-7}, d / 3, -d, 5 * d}) {
        const double exact = static_cast<double>(n) / static_cast<double>(sign * d) * std::pow(2.0, 24);
        EXPECT_NEAR(static_cast<double>(divide(n, r, 24, 20)), exact, 1.0 + std::fabs(exact) * 1e-12)
            << n << " / " << sign * d;
      }
    }
  }
  EXPECT_EQ(divide(int64_t{1} << 60, reciprocal(1), 24, 7), int64_t{1} << 31);
  EXPECT_EQ(divide(int64_t{1} << 60, reciprocal(-1), 24, 7), -(int64_t{1} << 31));
}

// Solves every component with a factor that may hold `entries` and returns field 0.
std::vector<double> solve_with_limit(const HeatRun& run, size_t entries, uint32_t* iterative) {
  Arena measure;
  EdgeWeights edges;
  HeatSolver solver;
  HeatFields fields;
  fields.allocate(measure, run.counts);
  edges.allocate(measure, run.counts);
  solver.allocate(measure, run.counts);
  Block block(measure.high_water() + (4 << 20));
  fields.allocate(block.arena, run.counts);
  edges.allocate(block.arena, run.counts);
  EXPECT_EQ(weigh_edges(run.mesh, run.counts, block.arena, &edges), SINEW_OK);
  // With negative weights the two solvers answer different questions.
  for (uint32_t e = 0; e < run.mesh.row_offsets[run.mesh.welded_count]; ++e)
    edges.weight[e] = std::max(edges.weight[e], 0);
  HeatSolver real;
  real.allocate(block.arena, run.counts);
  real.limit_factor(entries);
  const Sources sources(run);
  *iterative = 0;
  for (uint32_t v = 0; v < run.mesh.welded_count; ++v) fields.field[0].nearest[v] = sources.found.nearest[0][v];
  for (uint32_t c = 0; c < run.mesh.component_count; ++c) {
    real.begin_component(run.mesh, edges, c);
    *iterative += real.iterative();
    real.solve_field(sources.found, kFieldRule, &fields.field[0]);
  }
  std::vector<double> out(size_t{run.mesh.welded_count} * run.counts.joints, 0.0);
  for (uint32_t v = 0; v < run.mesh.welded_count; ++v) {
    for (uint32_t s = 0; s < kHeatSlots; ++s) {
      const uint16_t joint = fields.field[0].joints[v * kHeatSlots + s];
      if (joint != kNoJoint) out[v * run.counts.joints + joint] = fields.field[0].weights[v * kHeatSlots + s] / 32768.0;
    }
  }
  return out;
}

TEST(Solver, IterativeAgreesWithTheFactor) {
  const HeatRun run(sinew_test::capsule(40, 24, 6), false);
  ASSERT_EQ(run.status, SINEW_OK);
  uint32_t direct_count = 0, iterative_count = 0;
  const std::vector<double> direct = solve_with_limit(run, SIZE_MAX, &direct_count);
  const std::vector<double> iterative = solve_with_limit(run, 1000, &iterative_count);
  EXPECT_EQ(direct_count, 0u);
  EXPECT_EQ(iterative_count, 1u);
  double largest = 0;
  for (size_t i = 0; i < direct.size(); ++i) largest = std::max(largest, std::abs(direct[i] - iterative[i]));
  EXPECT_LT(largest, 1e-4);
}

// A strip whose border triangles are very flat: the matrix is indefinite, because a border edge counts in full.
HeatScene flat_strip(int columns) {
  HeatScene scene;
  for (int i = 0; i <= columns; ++i) {
    scene.add_vertex(i, 3, 0);
    scene.add_vertex(i + 0.5, 3.05, 0.02 * (i % 3));
    scene.add_vertex(i, 6, 0.1);
  }
  for (uint32_t i = 0; i < static_cast<uint32_t>(columns); ++i) {
    const uint32_t a = 3 * i;
    scene.add_triangle(a, a + 1, a + 3);
    scene.add_triangle(a, a + 2, a + 1);
    scene.add_triangle(a + 1, a + 2, a + 5);
    scene.add_triangle(a + 1, a + 5, a + 3);
  }
  for (int j = 0; 50 * j < columns; ++j) scene.add_joint(50 * j, 4, -2, j - 1);
  return scene;
}

TEST(Solver, LargeIndefinitePartsKeepToFronts) {
  const HeatScene scene = flat_strip(22000);
  HeatRun run(scene, false);
  ASSERT_EQ(run.status, SINEW_OK);
  ASSERT_GT(run.mesh.component_sizes[0], 65536u);
  const Sources sources(run);
  Arena measure;
  EdgeWeights edges;
  HeatSolver solver;
  const auto allocate = [&](Arena& arena) {
    run.fields.allocate(arena, run.counts);
    edges.allocate(arena, run.counts);
    solver.allocate(arena, run.counts);
  };
  allocate(measure);
  (void)weigh_edges(run.mesh, run.counts, measure, &edges);
  Block block(measure.high_water());
  allocate(block.arena);
  block.arena.release(0);
  run.fields.allocate(block.arena, run.counts);
  edges.allocate(block.arena, run.counts);
  ASSERT_EQ(weigh_edges(run.mesh, run.counts, block.arena, &edges), SINEW_OK);
  solver.allocate(block.arena, run.counts);
  std::copy_n(sources.found.nearest[0], run.mesh.welded_count, run.fields.field[0].nearest);
  solver.begin_component(run.mesh, edges, 0);
  solver.solve_field(sources.found, kFieldRule, &run.fields.field[0]);
  EXPECT_TRUE(solver.with_fronts());
  EXPECT_FALSE(solver.iterative());
  for (uint32_t v = 0; v < run.mesh.welded_count; v += 7) {
    double sum = 0;
    for (uint32_t s = 0; s < kHeatSlots; ++s) sum += run.fields.field[kFieldRule].weights[v * kHeatSlots + s] / 32768.0;
    ASSERT_NEAR(sum, 1.0, 1e-3) << v;
  }
}

TEST(Solver, TanglesDoNotFitTheFactor) {
  const HeatRun run(sinew_test::tangle(700, 1500, 4, 5), false);
  ASSERT_EQ(run.status, SINEW_OK);
  uint32_t iterative = 0;
  (void)solve_with_limit(run, SIZE_MAX, &iterative);
  EXPECT_EQ(iterative, 1u);
}

TEST(Solver, FlattenedTanglesStayInRange) {
  // Needles in the ratio 1 to 1e5 give the iterative solver the widest range of numbers it can meet.
  for (uint32_t seed = 0; seed < 12; ++seed) {
    HeatScene scene = sinew_test::tangle(250, 900, 6, seed);
    for (size_t i = 0; i < scene.positions.size(); ++i) {
      if (i % 3 == 1 || (seed % 2 == 0 && i % 3 == 2)) scene.positions[i] *= 1e-5f;
    }
    const HeatRun run(scene);
    ASSERT_EQ(run.status, SINEW_OK);
    for (uint32_t v = 0; v < run.mesh.welded_count; ++v) {
      double sum = 0;
      for (uint32_t j = 0; j < 6; ++j) sum += run.weight(kFieldRule, v, j);
      ASSERT_NEAR(sum, 1.0, 2e-3) << "seed " << seed << " vertex " << v;
    }
  }
}

TEST(Heat, TwoBonesGiveASmoothMonotoneBlend) {
  const HeatScene scene = sinew_test::capsule(60, 16, 0);
  HeatScene rigged = scene;
  rigged.add_joint(0, 0.4, 0, -1);
  rigged.add_joint(0, 2.0, 0, 0);
  const HeatRun run(rigged);
  ASSERT_EQ(run.status, SINEW_OK);
  std::vector<std::pair<int32_t, double>> profile;
  for (uint32_t v = 0; v < run.mesh.welded_count; ++v) {
    profile.push_back({run.mesh.positions[v].y, run.weight(kFieldRule, v, 1)});
    EXPECT_NEAR(run.weight(kFieldRule, v, 0) + run.weight(kFieldRule, v, 1), 1.0, 5e-4);
  }
  std::sort(profile.begin(), profile.end());
  for (size_t i = 1; i < profile.size(); ++i) {
    EXPECT_GE(profile[i].second, profile[i - 1].second - 2e-3);
    EXPECT_LE(profile[i].second - profile[i - 1].second, 0.3);
  }
  EXPECT_LT(profile.front().second, 0.01);
  EXPECT_GT(profile.back().second, 0.97);
}

TEST(Heat, MirroredBodiesGetMirroredWeights) {
  // Half of the triangles, and their mirror images: the diagonals of the quads must be mirrored, too.
  HeatScene scene = sinew_test::capsule(40, 24, 0);
  const std::vector<uint32_t> all = scene.triangles;
  scene.triangles.clear();
  const auto image = [](uint32_t v) { return v < 40 * 24 ? v / 24 * 24 + (36 - v % 24) % 24 : v; };
  for (size_t i = 0; i < all.size(); i += 3) {
    const double x = scene.positions[3 * all[i]] + scene.positions[3 * all[i + 1]] + scene.positions[3 * all[i + 2]];
    if (x < 0) continue;
    scene.add_triangle(all[i], all[i + 1], all[i + 2]);
    scene.add_triangle(image(all[i]), image(all[i + 2]), image(all[i + 1]));
  }
  ASSERT_EQ(scene.triangles.size(), all.size());
  scene.add_joint(0, 0.6, 0, -1);
  scene.add_joint(0.15, 1.5, 0, 0);
  scene.add_joint(0.2, 3.2, 0, 1);
  scene.add_joint(-0.15, 1.5, 0, 0);
  scene.add_joint(-0.2, 3.2, 0, 3);
  const HeatRun run(scene);
  ASSERT_EQ(run.status, SINEW_OK);
  const uint32_t mirror[5] = {0, 3, 4, 1, 2};
  std::map<std::array<int32_t, 3>, uint32_t> at;
  for (uint32_t v = 0; v < run.mesh.welded_count; ++v)
    at[{run.mesh.positions[v].x, run.mesh.positions[v].y, run.mesh.positions[v].z}] = v;
  size_t pairs = 0;
  double worst = 0;
  for (uint32_t v = 0; v < run.mesh.welded_count; ++v) {
    const Vec3i p = run.mesh.positions[v];
    // The float input is symmetric up to a grid unit.
    for (int32_t step = 0; step < 9; ++step) {
      const auto other = at.find({-p.x + step % 3 - 1, p.y, p.z + step / 3 - 1});
      if (other == at.end()) continue;
      ++pairs;
      for (uint32_t j = 0; j < 5; ++j) {
        worst =
            std::max(worst, std::abs(run.weight(kFieldRule, v, j) - run.weight(kFieldRule, other->second, mirror[j])));
      }
    }
  }
  EXPECT_GT(pairs, run.mesh.welded_count * 9 / 10);
  EXPECT_LT(worst, 2e-3);
}

TEST(Heat, NumberingOfVerticesFacesAndJointsDoesNotMatter) {
  HeatScene scene = sinew_test::capsule(20, 15, 4);
  sinew_test::add_sleeve(&scene, 0.6, 1.0, 3.0, 7, 13);
  const HeatRun plain(scene);
  ASSERT_EQ(plain.status, SINEW_OK);
  std::mt19937 random(19);
  const auto shuffled = [&](uint32_t n) {
    std::vector<uint32_t> order(n);
    std::iota(order.begin(), order.end(), 0u);
    for (uint32_t i = n; i > 1; --i) std::swap(order[i - 1], order[random() % i]);
    return order;
  };
  const std::vector<uint32_t> vertex = shuffled(scene.vertex_count()),
                              face = shuffled(static_cast<uint32_t>(scene.triangles.size() / 3));
  const std::vector<uint32_t> joint = shuffled(scene.joint_count());
  HeatScene renamed = scene;
  for (uint32_t v = 0; v < scene.vertex_count(); ++v) {
    std::copy_n(&scene.positions[3 * v], 3, &renamed.positions[3 * vertex[v]]);
  }
  for (uint32_t f = 0; f < face.size(); ++f) {
    for (uint32_t k = 0; k < 3; ++k) renamed.triangles[3 * face[f] + k] = vertex[scene.triangles[3 * f + (k + f) % 3]];
  }
  for (uint32_t j = 0; j < scene.joint_count(); ++j) {
    std::copy_n(&scene.joints[3 * j], 3, &renamed.joints[3 * joint[j]]);
    renamed.parents[joint[j]] = scene.parents[j] < 0 ? -1 : static_cast<int32_t>(joint[scene.parents[j]]);
  }
  const HeatRun other(renamed);
  ASSERT_EQ(other.status, SINEW_OK);
  for (uint32_t v = 0; v < scene.vertex_count(); ++v) {
    for (uint32_t f = 0; f < kFieldCount; ++f) {
      for (uint32_t j = 0; j < scene.joint_count(); ++j) {
        ASSERT_EQ(plain.weight(f, plain.mesh.vertex_to_welded[v], j),
                  other.weight(f, other.mesh.vertex_to_welded[vertex[v]], joint[j]));
      }
    }
  }
}

TEST(Heat, EveryVertexEndsWithARowThatSumsToOne) {
  HeatScene scene = sinew_test::tangle(60, 40, 5, 2);  // with isolated vertices
  scene.add_vertex(3, 3, 3);
  sinew_test::add_sleeve(&scene, 0.6, 1.0, 3.0, 4, 9);
  const HeatRun run(scene);
  ASSERT_EQ(run.status, SINEW_OK);
  for (const HeatField& field : run.fields.field) {
    for (uint32_t v = 0; v < run.mesh.welded_count; ++v) {
      uint16_t joints[kHeatSlots], weights[kHeatSlots];
      const uint32_t used = finish_heat_row(field, v, joints, weights);
      ASSERT_GE(used, 1u);
      uint32_t sum = 0;
      for (uint32_t s = 0; s < kHeatSlots; ++s) {
        sum += weights[s];
        EXPECT_EQ(joints[s] == kNoJoint, s >= used);
      }
      EXPECT_NEAR(sum, 32768, used);
    }
  }
}

TEST(Heat, RowsFallAndNameNoJointTwice) {
  const HeatRun run(sinew_test::star(28, 37, 5));
  ASSERT_EQ(run.status, SINEW_OK);
  for (const HeatField& field : run.fields.field) {
    for (uint32_t v = 0; v < run.mesh.welded_count; ++v) {
      const uint16_t* joints = field.joints + v * kHeatSlots;
      const uint16_t* weights = field.weights + v * kHeatSlots;
      std::set<uint16_t> seen;
      for (uint32_t s = 0; s < kHeatSlots && joints[s] != kNoJoint; ++s) {
        EXPECT_TRUE(seen.insert(joints[s]).second);
        EXPECT_GE(weights[s], 8u);
        if (s == 0) continue;
        EXPECT_TRUE(weights[s] < weights[s - 1] || (weights[s] == weights[s - 1] && joints[s] > joints[s - 1]));
      }
      EXPECT_FALSE(seen.empty());
    }
  }
}

TEST(Heat, EqualWeightsComeInOrderOfJoints) {
  HeatScene scene = sinew_test::capsule(20, 12, 0);
  scene.add_joint(0, 1, 0, -1);
  for (int i = 0; i < 3; ++i) scene.add_joint(0, 3, 0, 0);  // three bones in one place
  const HeatRun run(scene);
  ASSERT_EQ(run.status, SINEW_OK);
  for (uint32_t v = 0; v < run.mesh.welded_count; ++v) {
    if (run.weight(kFieldRule, v, 1) < 0.3) continue;
    EXPECT_EQ(run.fields.field[kFieldRule].joints[v * kHeatSlots], 1);
    EXPECT_EQ(run.fields.field[kFieldRule].joints[v * kHeatSlots + 1], 2);
    EXPECT_EQ(run.fields.field[kFieldRule].joints[v * kHeatSlots + 2], 3);
    EXPECT_EQ(run.weight(kFieldRule, v, 1), run.weight(kFieldRule, v, 3));
  }
}

TEST(Heat, SpecksFarFromTheBonesStillSumToOne) {
  // A few grid units wide and a thousandfold their size away: their sources pull by less than rounding can hold.
  HeatScene scene = sinew_test::capsule(12, 12, 3);
  const double unit = 1.0 / 200000, far = 2;
  const uint32_t first = scene.vertex_count();
  for (int i = 0; i < 5; ++i) {
    for (int k = 0; k < 5; ++k) scene.add_vertex(far + 3 * unit * i, 1 + 2 * unit * k, unit * (i * k % 3));
  }
  for (uint32_t i = 0; i < 4; ++i) {
    for (uint32_t k = 0; k < 4; ++k) {
      const uint32_t a = first + 5 * i + k;
      scene.add_triangle(a, a + 5, a + 1);
      scene.add_triangle(a + 1, a + 5, a + 6);
    }
  }
  const HeatRun run(scene);
  ASSERT_EQ(run.status, SINEW_OK);
  ASSERT_EQ(run.mesh.component_count, 2u);
  for (uint32_t f = 0; f < kFieldCount; ++f) {
    for (uint32_t v = 0; v < run.mesh.welded_count; ++v) {
      EXPECT_NEAR(run.weight(f, v, 0) + run.weight(f, v, 1) + run.weight(f, v, 2), 1.0, 6e-4) << v;
    }
  }
}

TEST(Heat, FinishedRowsAreCutAndRamped) {
  uint16_t joints[kHeatSlots], weights[kHeatSlots], nearest[1] = {9};
  std::fill_n(joints, kHeatSlots, kNoJoint);
  std::fill_n(weights, kHeatSlots, uint16_t{0});
  HeatField field;
  field.joints = joints;
  field.weights = weights;
  field.nearest = nearest;
  uint16_t out_joints[kHeatSlots], out_weights[kHeatSlots];
  EXPECT_EQ(finish_heat_row(field, 0, out_joints, out_weights), 1u);
  EXPECT_EQ(out_joints[0], 9);
  EXPECT_EQ(out_weights[0], 32768);
  // 0.9, 0.05, 0.0375 (half way up the ramp: 0.025), 0.0249 (cut).
  const double raw[4] = {0.9, 0.05, 0.0375, 0.0249};
  for (uint32_t s = 0; s < 4; ++s) {
    joints[s] = static_cast<uint16_t>(s);
    weights[s] = static_cast<uint16_t>(raw[s] * 32768 + 0.5);
  }
  EXPECT_EQ(finish_heat_row(field, 0, out_joints, out_weights), 3u);
  EXPECT_NEAR(out_weights[0], 32768 * 0.9 / 0.975, 2);
  EXPECT_NEAR(out_weights[1], 32768 * 0.05 / 0.975, 2);
  EXPECT_NEAR(out_weights[2], 32768 * 0.025 / 0.975, 2);
}

TEST(Heat, MeasureEqualsTheRun) {
  for (const HeatScene& scene :
       {sinew_test::star(20, 21, 3), sinew_test::tangle(50, 30, 3, 1), sinew_test::capsule(3, 3, 1)}) {
    HeatRun run(scene, false);
    ASSERT_EQ(run.status, SINEW_OK);
    const size_t held = run.arena.used();
    Block exact(run.heat_scratch_bytes);
    EXPECT_EQ(solve_heat(run.mesh, run.skeleton, run.counts, fastest_kernels(), {}, exact.arena, &run.fields),
              SINEW_OK);
    EXPECT_EQ(exact.arena.high_water(), run.heat_scratch_bytes);
    EXPECT_EQ(exact.arena.used(), 0u);
    EXPECT_EQ(run.arena.used(), held);
    Block small(run.heat_scratch_bytes - 64);
    EXPECT_EQ(solve_heat(run.mesh, run.skeleton, run.counts, fastest_kernels(), {}, small.arena, &run.fields),
              SINEW_ERROR_WORKSPACE);
  }
}

TEST(Heat, FiveThousandVerticesFitTwentyFiveMegabytes) {
  Counts counts;
  counts.vertices = 5000;
  counts.faces = 10000;
  counts.corners = 30000;
  counts.joints = 60;
  Arena measure;
  HeatFields fields;
  (void)solve_heat({}, {}, counts, fastest_kernels(), {}, measure, &fields);
  EXPECT_LT(measure.high_water(), 25u << 20);
}

TEST(Heat, ReportsProgressInOrderAndStopsWhenAsked) {
  const HeatScene scene = sinew_test::star(40, 50, 2);
  HeatRun run(scene, false);
  ASSERT_EQ(run.status, SINEW_OK);
  struct State {
    uint32_t last = 0, calls = 0, stop_at = 2000;
    bool falls = false;
  } state;
  Progress progress;
  progress.user = &state;
  progress.callback = [](void* user, uint32_t permille) {
    State* s = static_cast<State*>(user);
    s->falls = s->falls || permille < s->last;
    s->last = permille;
    ++s->calls;
    return permille >= s->stop_at ? 1 : 0;
  };
  EXPECT_EQ(solve_heat(run.mesh, run.skeleton, run.counts, fastest_kernels(), progress, run.arena, &run.fields),
            SINEW_OK);
  EXPECT_FALSE(state.falls);
  EXPECT_EQ(state.last, 1000u);
  EXPECT_GT(state.calls, 4u);
  for (const uint32_t stop : {0u, 100u, 400u}) {
    state = State();
    state.stop_at = stop;
    const size_t used = run.arena.used();
    EXPECT_EQ(solve_heat(run.mesh, run.skeleton, run.counts, fastest_kernels(), progress, run.arena, &run.fields),
              SINEW_ERROR_CANCELLED);
    EXPECT_EQ(run.arena.used(), used);
  }
}

}  // namespace
