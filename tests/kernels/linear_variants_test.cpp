// SPDX-License-Identifier: MIT
// Every vector variant of the linear layer equals the reference bit for bit: odd sizes, every tile shape, strides,
// extremes, absent rows, both accumulator classes. A variant that was built for this processor must have run.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>
#include <vector>

#include "kernels/select.hpp"
#include "linear_layer.hpp"
#include "random.hpp"

namespace sinew::test {
namespace {

constexpr int16_t kGuard = 0x7A7A;

struct Release {
  void operator()(uint8_t* p) const { ::operator delete (p, std::align_val_t{64}); }
};
using Block = std::unique_ptr<uint8_t, Release>;

// Packs the view's parameters into a block of exactly the size they need.
Block pack(LinearView* view) {
  const size_t bytes = packed_linear_bytes(view->in, view->out, view->block);
  Block block(static_cast<uint8_t*>(::operator new (bytes, std::align_val_t{64})));
  pack_linear(*view, block.get());
  view->packed = packed_view(*view, block.get());
  return block;
}

struct LinearCase {
  uint32_t in, out, rows, block;
  bool wide, residual, masked, extreme;
  ValueRange range;
};

// Both kernels on one random layer; every array has exactly the size it needs, so that a sanitizer sees a step outside.
void compare(uint32_t seed, const LinearCase& c, LinearKernel variant) {
  Random random(seed);
  // The proof: products of a block stay in int32 whatever the inputs are, and in class N with bias and residual.
  const uint32_t summed = c.wide ? c.block : c.in + 2;
  const int32_t largest = static_cast<int32_t>(std::min<uint32_t>(32767, (131000u - 70) / summed));
  const auto weight = [&] {
    return static_cast<int16_t>(c.extreme ? (random.below(2) ? largest : -largest) : random.between(-largest, largest));
  };
  const auto value = [&] {
    return static_cast<int16_t>(c.extreme ? (random.below(2) ? 16383 : -16384) : random.between(-16384, 16383));
  };
  LinearLayer layer(c.in, c.out);
  layer.block = c.block;
  layer.wide = c.wide;
  layer.has_residual = c.residual;
  layer.set_range(c.range);
  for (int16_t& w : layer.weights) w = weight();
  for (int16_t& w : layer.residual) w = weight();
  for (uint32_t n = 0; n < c.out; ++n) {
    const int64_t bias = random.between(-1000000, 1000000);
    layer.set_bias(n, c.wide ? bias * (int64_t{1} << random.below(36)) : bias);
    layer.shifts[n] =
        static_cast<uint8_t>(random.below(4) == 0 ? random.between(1, c.wide ? 47 : 31) : random.between(8, 16));
  }
  LinearView view = layer.view();
  const Block packed = pack(&view);

  const uint32_t in_stride = c.in + random.below(4), residual_stride = c.out + random.below(4),
                 out_stride = c.out + random.below(4);
  const size_t last = c.rows - 1;
  std::vector<int16_t> in(last * in_stride + c.in), residual(c.residual ? last * residual_stride + c.out : 0);
  for (int16_t& x : in) x = value();
  for (int16_t& x : residual) x = value();
  std::vector<uint16_t> present(c.rows);
  for (uint16_t& joint : present) joint = random.below(4) == 0 ? kNoJoint : 3;
  std::vector<int16_t> want(last * out_stride + c.out, kGuard), got = want;
  const uint16_t* mask = c.masked ? present.data() : nullptr;
  linear_s16_ref(view, {in.data(), in_stride}, {residual.data(), residual_stride}, mask, c.rows, want.data(),
                 out_stride);
  variant(view, {in.data(), in_stride}, {residual.data(), residual_stride}, mask, c.rows, got.data(), out_stride);
  for (size_t i = 0; i < want.size(); ++i) {
    ASSERT_EQ(got[i], want[i]) << "row " << i / out_stride << " channel " << i % out_stride << ": in " << c.in
                               << " out " << c.out << " rows " << c.rows << " block " << c.block << " wide " << c.wide
                               << " residual " << c.residual << " masked " << c.masked << " seed " << seed;
  }
}

bool processor_has(uint32_t kernel) {
#if defined(__x86_64__) && defined(__GNUC__)
  if (kernel == SINEW_KERNEL_AVX2) return __builtin_cpu_supports("avx2");
  if (kernel == SINEW_KERNEL_VNNI) {
    return __builtin_cpu_supports("avx512vnni") && __builtin_cpu_supports("avx512bw") &&
           __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
  }
#endif
#if defined(__wasm_simd128__)
  if (kernel == SINEW_KERNEL_SIMD128) return true;
#elif defined(__aarch64__)
  if (kernel == SINEW_KERNEL_NEON) return true;
#elif defined(__ARM_FEATURE_SIMD32)
  if (kernel == SINEW_KERNEL_DSP) return true;
#endif
  return sinew_kernel_select(kernel) != 0;  // the compiler's own check does not know the others
}

class LinearVariant : public testing::TestWithParam<uint32_t> {
 protected:
  // A path that was built and that the processor has but that is not chosen is a failure, not a skip.
  void SetUp() override {
    const uint32_t kernel = GetParam();
    if (!select_kernels(kernel, &kernels_)) {
      ASSERT_FALSE(processor_has(kernel))
          << kernel_name(kernel) << ": this processor has it, but it was not built or not chosen";
      GTEST_SKIP() << "NOT RUN: this processor has no " << kernel_name(kernel);
    }
    // Packed weights, the model's own bytes, or both.
    if (kernels_.linear_packed != nullptr) linear_.push_back(kernels_.linear_packed);
    if (kernels_.linear != &linear_s16_ref) linear_.push_back(kernels_.linear);
    const bool x86 = kernel == SINEW_KERNEL_AVX2 || kernel == SINEW_KERNEL_AVXVNNI || kernel == SINEW_KERNEL_VNNI;
    ASSERT_EQ(linear_.size(), x86 ? 2u : 1u) << "a variant was not built";
  }
  void compare_all(uint32_t seed, const LinearCase& c) const {
    for (const LinearKernel variant : linear_) compare(seed, c, variant);
  }
  Kernels kernels_;
  std::vector<LinearKernel> linear_;
};

TEST_P(LinearVariant, EqualsReferenceOnRandomShapes) {
  Random random(11);
  for (uint32_t i = 0; i < 1500; ++i) {
    LinearCase c;
    c.in = 1 + random.below(i % 10 == 0 ? 1152 : i % 3 == 0 ? 130 : 40);
    c.out = 1 + random.below(i % 10 == 0 ? 40 : 150);
    c.rows = 1 + random.below(i % 4 == 0 ? 40 : 9);
    c.wide = i % 3 == 1;
    c.block = c.wide ? 1 + random.below(random.below(2) ? 4 : c.in) : c.in;
    c.block = std::min(c.block, c.in);
    c.residual = random.below(2) != 0;
    c.masked = random.below(2) != 0;
    c.extreme = i % 5 == 0;
    c.range = static_cast<ValueRange>(random.below(3));
    compare_all(i, c);
    if (HasFatalFailure()) return;
  }
}

TEST_P(LinearVariant, EqualsReferenceOnEveryTileShape) {
  uint32_t seed = 5000;
  for (const uint32_t out : {1u, 15u, 16u, 17u, 31u, 32u, 33u, 47u, 48u, 49u, 63u, 64u, 65u, 80u, 96u, 112u, 129u}) {
    for (uint32_t rows = 1; rows <= 22; ++rows) {
      for (const uint32_t in : {1u, 2u, 3u, 48u}) {
        compare_all(seed++, {in, out, rows, in, false, rows % 2 == 0, rows % 3 == 0, false, ValueRange::kPositive});
        if (HasFatalFailure()) return;
      }
    }
  }
}

TEST_P(LinearVariant, EqualsReferenceOnLongLayersAndManyRows) {
  for (const uint32_t in : {576u, 1023u, 1152u}) {
    for (const bool wide : {false, true}) {
      compare_all(in, {in, 70, 400, wide ? 37u : in, wide, true, true, true, ValueRange::kSigned});
      compare_all(in, {in, 64, 13, in, wide, false, false, true, ValueRange::kLogits});
      if (HasFatalFailure()) return;
    }
  }
}

// Products at the very edge of int32: the sum of one pair is 2 * 32767 * 32767.
TEST_P(LinearVariant, LargestPairDoesNotSaturate) {
  LinearLayer layer(2, 2, 17);
  layer.weights = {32767, 32767, -32767, -32767};
  const std::vector<int16_t> in = {32767, 32767};
  LinearView view = layer.view();
  const Block packed = pack(&view);
  for (const LinearKernel variant : linear_) {
    int16_t out[2];
    variant(view, {in.data(), 2}, {nullptr, 0}, nullptr, 1, out, 2);
    EXPECT_EQ(out[0], 16383);   // 2 * 32767^2 = 2147352578; >> 17
    EXPECT_EQ(out[1], -16384);  // floor
  }
}

// Rows that share columns: what groups of rows share once per group, what rows of a joint share once per joint, the
// rest row by row, is the whole layer.
TEST_P(LinearVariant, SharedColumnsOnceGiveTheSame) {
  if (kernels_.linear_packed == nullptr) GTEST_SKIP() << "reads the model's bytes, whole rows at a time";
  Random random(31);
  for (uint32_t round = 0; round < 300; ++round) {
    const uint32_t per_start = 1 + random.below(9), groups = 1 + random.below(12), rows = per_start * groups;
    const uint32_t out = 1 + random.below(round % 3 == 0 ? 100 : 50);
    // Pieces of even width, the last one of any: alternately the rows' own and shared, in some rounds one by joint.
    std::vector<ColumnRange> own, shared;
    ColumnRange by_joint;
    constexpr uint32_t kJoints = 5;
    const uint32_t joint_piece = random.below(12);
    uint32_t in = 0;
    const uint32_t pieces = 1 + random.below(8);
    for (uint32_t i = 0; i < pieces; ++i) {
      const uint32_t count = 2 * (1 + random.below(20)) - (i + 1 == pieces ? random.below(2) : 0);
      const ColumnRange piece = {static_cast<uint16_t>(in), static_cast<uint16_t>(count)};
      in += count;
      if (i == joint_piece) {
        by_joint = piece;
      } else {
        ((i + round) % 2 == 0 ? own : shared).push_back(piece);
      }
    }
    LinearLayer layer(in, out);
    std::vector<int16_t> values(size_t{rows} * in);
    const int32_t largest = static_cast<int32_t>(120000 / (in + 2));
    for (int16_t& w : layer.weights) w = static_cast<int16_t>(random.between(-largest, largest));
    for (int16_t& x : values) x = static_cast<int16_t>(random.between(-16384, 16383));
    for (uint32_t n = 0; n < out; ++n) layer.set_bias(n, random.between(-99999, 99999));
    for (uint32_t r = 0; r < rows; ++r) {
      for (const ColumnRange& range : shared) {
        std::memcpy(&values[size_t{r} * in + range.first],
                    &values[size_t{r / per_start * per_start} * in + range.first], range.count * sizeof(int16_t));
      }
    }
    std::vector<uint16_t> joints(rows);
    for (uint16_t& joint : joints) joint = static_cast<uint16_t>(random.below(kJoints));
    for (uint32_t r = 0; r < rows; ++r) {  // a joint's columns are those of its first row
      const size_t first = static_cast<size_t>(std::find(joints.begin(), joints.end(), joints[r]) - joints.begin());
      std::memcpy(&values[size_t{r} * in + by_joint.first], &values[first * in + by_joint.first],
                  by_joint.count * sizeof(int16_t));
    }
    LinearView view = layer.view();
    const Block packed = pack(&view);
    std::vector<int16_t> want(size_t{rows} * out), got(want.size());
    std::vector<uint16_t> present = joints;
    for (uint16_t& joint : present) joint = random.below(6) == 0 ? kNoJoint : joint;
    linear_s16_ref(view, {values.data(), in}, {}, present.data(), rows, want.data(), out);

    std::vector<int32_t> starts(size_t{groups} * padded_outputs(out)),
        joint_starts(size_t{kJoints} * padded_outputs(out));
    if (shared.empty() && by_joint.count == 0) continue;
    const int32_t* const layer_bias = view.packed.bias;
    if (!shared.empty()) {
      view.packed.range_count = static_cast<uint32_t>(shared.size());
      std::copy(shared.begin(), shared.end(), view.packed.ranges);
      kernels_.linear_sums(view, {values.data(), in * per_start}, groups, starts.data());
    }
    if (by_joint.count != 0) {  // without the bias
      view.packed.bias = nullptr;
      view.packed.range_count = 1;
      view.packed.ranges[0] = by_joint;
      for (uint32_t r = 0; r < rows; ++r) {
        kernels_.linear_sums(view, {&values[size_t{r} * in], in}, 1,
                             &joint_starts[size_t{joints[r]} * padded_outputs(out)]);
      }
      view.packed.bias = layer_bias;
      view.packed.joint_starts = joint_starts.data();
    }
    if (!shared.empty()) view.packed.starts = starts.data();
    view.packed.rows_per_start = per_start;
    view.packed.range_count = static_cast<uint32_t>(own.size());
    std::copy(own.begin(), own.end(), view.packed.ranges);
    kernels_.linear_packed(view, {values.data(), in}, {}, present.data(), rows, got.data(), out);
    ASSERT_EQ(got, want) << "in " << in << " out " << out << " rows " << rows << " per start " << per_start;
  }
}

INSTANTIATE_TEST_SUITE_P(All, LinearVariant,
                         testing::Values(SINEW_KERNEL_AVX2, SINEW_KERNEL_AVXVNNI, SINEW_KERNEL_VNNI,
                                         SINEW_KERNEL_SIMD128, SINEW_KERNEL_NEON, SINEW_KERNEL_DSP),
                         [](const auto& tested) { return std::string(kernel_name(tested.param)); });

TEST(SelectKernels, AutoIsTheFastestAndReferenceIsAlwaysThere) {
  EXPECT_EQ(sinew_kernel_select(SINEW_KERNEL_REF), uint32_t{SINEW_KERNEL_REF});
  uint32_t fastest = SINEW_KERNEL_REF;
  for (const uint32_t kernel : {SINEW_KERNEL_DSP, SINEW_KERNEL_NEON, SINEW_KERNEL_SIMD128, SINEW_KERNEL_AVX2,
                                SINEW_KERNEL_AVXVNNI, SINEW_KERNEL_VNNI}) {
    if (sinew_kernel_select(kernel) != 0) fastest = kernel;
  }
  EXPECT_EQ(sinew_kernel_select(SINEW_KERNEL_AUTO), fastest);
  EXPECT_EQ(sinew_kernel_select(1000), 0u);
}

TEST(SelectKernels, NamesEndWithNull) {
  uint32_t count = 0;
  while (sinew_kernel_name(count) != nullptr) ++count;
  EXPECT_EQ(count, 8u);
  EXPECT_STREQ(sinew_kernel_name(SINEW_KERNEL_VNNI), "vnni");
  EXPECT_EQ(sinew_kernel_name(1000), nullptr);
}

TEST(PackedLinear, BytesAreWhatPackingFills) {
  Random random(3);
  for (int i = 0; i < 300; ++i) {
    const uint32_t in = 1 + random.below(200), out = 1 + random.below(90), block = 1 + random.below(in);
    LinearLayer layer(in, out);
    layer.block = block;
    layer.wide = block < in;
    const LinearView view = layer.view();
    const size_t bytes = packed_linear_bytes(in, out, block);
    EXPECT_EQ(bytes % 64, 0u);
    const Block memory(static_cast<uint8_t*>(::operator new (bytes + 64, std::align_val_t{64})));
    std::memset(memory.get(), 0xA5, bytes + 64);
    pack_linear(view, memory.get());
    for (size_t b = bytes; b < bytes + 64; ++b) ASSERT_EQ(memory.get()[b], 0xA5);
    const PackedLinear packed = packed_view(view, memory.get());
    const size_t weight_bytes = size_t{packed.pairs} * 4 * ((out + 15) / 16 * 16);
    EXPECT_EQ(reinterpret_cast<const uint8_t*>(packed.weights) + weight_bytes, memory.get() + bytes);
    EXPECT_EQ(reinterpret_cast<uintptr_t>(packed.weights) % 64, 0u);
  }
}

}  // namespace
}  // namespace sinew::test
