// SPDX-License-Identifier: MIT
// Which kernels run: what was built, what the processor has, what the caller wants.
#include "kernels/select.hpp"

#include "kernels/variants.hpp"

namespace sinew {
namespace {

void fill_reference(Kernels* kernels) {
  kernels->id = SINEW_KERNEL_REF;
  kernels->linear = linear_s16_ref;
  kernels->linear_packed = nullptr;
  kernels->linear_sums = nullptr;
  kernels->ring_mean_vertex = ring_mean_vertex_s16_ref;
  kernels->ring_max_vertex = ring_max_vertex_s16_ref;
  kernels->ring_mean_pair = ring_mean_pair_s16_ref;
  kernels->ring_max_pair = ring_max_pair_s16_ref;
  kernels->candidate_max = candidate_max_s16_ref;
  kernels->part_mean_vertex = part_mean_vertex_s16_ref;
  kernels->part_mean_pair = part_mean_pair_s16_ref;
  kernels->global_mean = global_mean_s16_ref;
  kernels->global_max = global_max_s16_ref;
  kernels->softmax = softmax_s16_ref;
  kernels->front = FrontKernels();
  kernels->boxes_met = boxes_met_ref;
}

// Common part of the three x86-64 kernels.
bool add_x86_rest(Kernels* kernels) {
  return add_linear_in_place_s16_avx2(kernels) && add_aggregates_s16_avx2(kernels);
}

// Common part of the kernels for avx2 and avxvnni.
bool add_avx2_rest(Kernels* kernels) {
  return add_x86_rest(kernels) && add_front_s32_avx2(&kernels->front) && add_boxes_s32_avx2(&kernels->boxes_met) &&
         add_softmax_s16_avx2(&kernels->softmax);
}

// The vnni kernels besides the linear layer.
bool add_avx512_rest(Kernels* kernels) {
  return add_x86_rest(kernels) && add_means_s16_avx512(kernels) && add_front_s32_avx512(&kernels->front) &&
         add_boxes_s32_avx512(&kernels->boxes_met) && add_softmax_s16_avx512(&kernels->softmax);
}

// Puts one instruction set's variants over the reference. detect_cpu() calls a processor vnni or avxvnni only if it has
// AVX2 too.
bool add_variants(uint32_t kernel, const Cpu& cpu, Kernels* kernels) {
  bool added = false;
  switch (kernel) {
    case SINEW_KERNEL_AVX2:
      added = cpu.avx2 && add_linear_s16_avx2(kernels) && add_avx2_rest(kernels);
      break;
    case SINEW_KERNEL_AVXVNNI:
      added = cpu.avxvnni && add_linear_s16_avxvnni(kernels) && add_avx2_rest(kernels);
      break;
    case SINEW_KERNEL_VNNI:
      added = cpu.vnni && add_linear_s16_vnni(kernels) && add_avx512_rest(kernels);
      break;
    case SINEW_KERNEL_SIMD128:  // no question to a processor: a module with these instructions does not start without
      added = add_linear_s16_simd128(kernels) && add_aggregates_s16_simd128(kernels) &&
              add_front_s32_simd128(&kernels->front) && add_boxes_s32_simd128(&kernels->boxes_met) &&
              add_softmax_s16_simd128(&kernels->softmax);
      break;
    case SINEW_KERNEL_NEON:  // every ARM64 processor
      added = add_linear_s16_neon(kernels) && add_aggregates_s16_neon(kernels) && add_front_s32_neon(&kernels->front) &&
              add_boxes_s32_neon(&kernels->boxes_met) && add_softmax_s16_neon(&kernels->softmax);
      break;
    case SINEW_KERNEL_DSP:  // code for a core with these instructions is for such cores alone
      added = add_linear_s16_dsp(kernels);
      break;
    default:
      break;
  }
  if (added) kernels->id = kernel;
  return added;
}

constexpr uint32_t kFastestFirst[] = {SINEW_KERNEL_VNNI,    SINEW_KERNEL_AVXVNNI, SINEW_KERNEL_AVX2,
                                      SINEW_KERNEL_SIMD128, SINEW_KERNEL_NEON,    SINEW_KERNEL_DSP};

}  // namespace

bool select_kernels(uint32_t wanted, Kernels* kernels) {
  fill_reference(kernels);
  if (wanted == SINEW_KERNEL_REF) return true;
  const Cpu cpu = detect_cpu();
  if (wanted != SINEW_KERNEL_AUTO) return add_variants(wanted, cpu, kernels);
  for (const uint32_t kernel : kFastestFirst) {
    if (add_variants(kernel, cpu, kernels)) break;
  }
  return true;
}

const char* kernel_name(uint32_t kernel) {
  switch (kernel) {
    case SINEW_KERNEL_AUTO:
      return "auto";
    case SINEW_KERNEL_REF:
      return "ref";
    case SINEW_KERNEL_AVX2:
      return "avx2";
    case SINEW_KERNEL_AVXVNNI:
      return "avxvnni";
    case SINEW_KERNEL_VNNI:
      return "vnni";
    case SINEW_KERNEL_SIMD128:
      return "simd128";
    case SINEW_KERNEL_NEON:
      return "neon";
    case SINEW_KERNEL_DSP:
      return "dsp";
    default:
      return nullptr;
  }
}

}  // namespace sinew
