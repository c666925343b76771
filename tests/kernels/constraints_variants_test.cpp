// SPDX-License-Identifier: MIT
// The variants of the deformation's constraints against their definition, bit for bit: nodes near their rest, collapsed ones
// and ones as far apart as they come, with and without pins, in both directions.
#include <gtest/gtest.h>

#include <array>
#include <random>
#include <vector>

#include "kernels/constraints.hpp"
#include "kernels/select.hpp"

namespace {

using namespace sinew;

enum class Positions { kNear, kSquashed, kCollapsed, kFar };
constexpr Positions kLayouts[] = {Positions::kNear, Positions::kSquashed, Positions::kCollapsed, Positions::kFar};

// Entries with nodes of their own, in runs of eight and of four but for some that stand between runs.
class Scene {
 public:
  Scene(uint32_t entries, uint32_t nodes_of_entry, Positions layout, uint32_t seed) : random_(seed), flags(entries) {
    for (uint32_t n = 0; n < entries * nodes_of_entry; ++n)
      nodes.push_back({position(n % nodes_of_entry, layout), random_() % 5 != 0 ? -1 : 0});
    for (uint32_t k = 0; k + 8 <= entries; k += random_() % 3 == 0 ? 1 : 0) {
      const bool eight = random_() % 2 == 0;
      flags[k] = eight ? kRunOfFour | kRunOfEight : kRunOfFour;
      if (eight) flags[k + 4] = kRunOfFour;
      k += eight ? 8 : 4;
    }
  }
  uint32_t below(uint32_t n) { return static_cast<uint32_t>(random_()) % n; }
  int32_t within(int32_t most) { return static_cast<int32_t>(below(2 * static_cast<uint32_t>(most) + 1)) - most; }

 private:
  // Of a corner of a tetrahedron of its cell.
  Vec3i position(uint32_t corner, Positions layout) {
    constexpr int32_t kCorners[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    if (layout == Positions::kCollapsed) return {7, 7, 7};
    if (layout == Positions::kFar) return {within(1 << 28), within(1 << 28), within(1 << 28)};
    const int32_t* const c = kCorners[corner];
    const int32_t off = kCellUnits / 3, high = layout == Positions::kSquashed ? 40 : kCellUnits;
    return {c[0] * kCellUnits + within(off), c[1] * kCellUnits + within(off), c[2] * high + within(high / 3)};
  }
  std::mt19937 random_;

 public:
  std::vector<uint8_t> flags;
  std::vector<SolverNode> nodes;
};

std::vector<ConstraintKernels> variants() {
  std::vector<ConstraintKernels> out;
  const Cpu cpu = detect_cpu();
  ConstraintKernels kernels;
  if (add_constraints_s32_avx2(&kernels) && cpu.avx2) out.push_back(kernels);
  if (add_constraints_s32_avx512(&kernels) && cpu.vnni) out.push_back(kernels);
#if defined(__x86_64__)
  EXPECT_EQ(out.size(), size_t{cpu.avx2} + size_t{cpu.vnni});
#endif
  return out;
}

void expect_same(const std::vector<SolverNode>& a, const std::vector<SolverNode>& b) {
  for (size_t n = 0; n < a.size(); ++n) {
    ASSERT_EQ(a[n].position.x, b[n].position.x) << "node " << n;
    ASSERT_EQ(a[n].position.y, b[n].position.y) << "node " << n;
    ASSERT_EQ(a[n].position.z, b[n].position.z) << "node " << n;
    ASSERT_EQ(a[n].moves, b[n].moves) << "node " << n;
  }
}

TEST(ConstraintVariants, VolumesAreTheReference) {
  for (const ConstraintKernels& variant : variants()) {
    for (const Positions layout : kLayouts) {
      for (const uint8_t kind : {uint8_t{0}, kLargeVolume}) {
        Scene scene(257, 4, layout, 3 * static_cast<uint32_t>(layout) + kind);
        std::vector<uint32_t> corners(scene.nodes.size());
        for (uint32_t n = 0; n < corners.size(); ++n) corners[n] = n;
        for (uint8_t& flags : scene.flags) flags |= kind;
        std::vector<SolverNode> expected = scene.nodes, found = scene.nodes;
        for (uint32_t round = 0; round < (layout == Positions::kFar ? 1u : 6u); ++round) {
          const VolumeList a = {corners.data(), scene.flags.data(), expected.data()},
                           b = {corners.data(), scene.flags.data(), found.data()};
          const uint32_t count = static_cast<uint32_t>(scene.flags.size());
          solve_volumes_ref(a, 0, count, round % 2 != 0);
          variant.volumes(b, 0, count, round % 2 != 0);
          expect_same(expected, found);
        }
        size_t moved = 0;
        for (size_t n = 0; n < expected.size(); ++n) moved += expected[n].position == scene.nodes[n].position ? 0 : 1;
        EXPECT_EQ(moved > expected.size() / 10, layout != Positions::kCollapsed) << moved;
      }
    }
  }
}

TEST(ConstraintVariants, EdgesAreTheReference) {
  for (const ConstraintKernels& variant : variants()) {
    for (const Positions layout : kLayouts) {
      for (const int64_t softness : {0, 77, 1 << 20}) {
        Scene scene(257, 2, layout, 5 * static_cast<uint32_t>(layout) + static_cast<uint32_t>(softness));
        const EdgeRates rates = {softness, {(1 << 24) / (256 + softness), (1 << 24) / (512 + softness)}};
        std::vector<uint32_t> ends(scene.nodes.size());
        for (uint32_t n = 0; n < ends.size(); ++n) ends[n] = n;
        const std::vector<int32_t> rests(scene.flags.size(), 16 * kCellUnits);
        std::vector<int32_t> first;
        for (uint32_t i = 0; i < scene.flags.size(); ++i)
          first.push_back(scene.within(layout == Positions::kFar ? 1 << 30 : 99999));
        std::vector<int32_t> same = first;
        std::vector<SolverNode> expected = scene.nodes, found = scene.nodes;
        for (uint32_t round = 0; round < (layout == Positions::kFar ? 1u : 6u); ++round) {
          const EdgeList a = {rates, ends.data(), rests.data(), first.data(), scene.flags.data(), expected.data()},
                         b = {rates, ends.data(), rests.data(), same.data(), scene.flags.data(), found.data()};
          const uint32_t count = static_cast<uint32_t>(first.size());
          solve_edges_ref(a, 0, count, round % 2 != 0);
          variant.edges(b, 0, count, round % 2 != 0);
          expect_same(expected, found);
          for (size_t e = 0; e < first.size(); ++e) ASSERT_EQ(first[e], same[e]) << e;
        }
      }
    }
  }
}

}  // namespace
