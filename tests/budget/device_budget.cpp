// SPDX-License-Identifier: MIT
// On a Cortex-M under qemu-system-arm -icount shift=6: products per instruction of the linear layer, and the deepest
// stack of a bind. Prints lines `KEY VALUE` that embedded_test.sh compares with budgets.
//   device_budget OBJ_FOLDER_SET...     see main()
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>
#include <vector>

#include "kernels/select.hpp"
#include "linear_layer.hpp"
#include "sinew/sinew.h"
#include "stack_cases.hpp"

namespace {

using namespace sinew;

volatile uint32_t* const kSysTick = reinterpret_cast<volatile uint32_t*>(0xE000E010u);  // control, reload, current

// SysTick counts 25 MHz, 40 ns; an instruction takes 64 ns. Good for 10 million instructions.
void start_counting() {
  kSysTick[1] = 0xFFFFFFu;
  kSysTick[2] = 0;
  kSysTick[0] = 5;
}
uint32_t instructions() { return static_cast<uint32_t>(static_cast<uint64_t>(0xFFFFFFu - kSysTick[2]) * 40 / 64); }

void measure_linear(uint32_t rows, uint32_t in, uint32_t out) {
  test::LinearLayer layer(in, out);
  layer.high = 16383;
  for (int16_t& weight : layer.weights) weight = 3;
  const std::vector<int16_t> values(size_t{rows} * in, 5);
  std::vector<int16_t> results(size_t{rows} * out);
  const LinearView view = layer.view();
  const Kernels kernels = fastest_kernels();
  const uint32_t before = instructions();
  kernels.linear(view, {values.data(), in}, {}, nullptr, rows, results.data(), out);
  const uint32_t spent = instructions() - before;
  std::printf("linear_%s_%ux%ux%u_products_per_1000_instructions %u\n", kernel_name(kernels.id),
              static_cast<unsigned>(rows), static_cast<unsigned>(in), static_cast<unsigned>(out),
              static_cast<unsigned>(uint64_t{rows} * in * out * 1000 / spent));
}

// What lies below the caller is painted, and the lowest changed word found again.
constexpr size_t kPainted = 256 * 1024, kOwn = 512;
uint8_t* stack_pointer() {
  uint8_t* sp;
  __asm__ volatile("mov %0, sp" : "=r"(sp));
  return sp;
}

[[gnu::noinline]] size_t stack_of(const sinew_test::StackCase& tested) {
  volatile uint32_t* const top = reinterpret_cast<volatile uint32_t*>(stack_pointer() - kOwn);
  volatile uint32_t* const bottom = top - kPainted / 4;
  for (volatile uint32_t* word = bottom; word < top; ++word) *word = 0xA5A5A5A5u;
  sinew_test::run(tested);
  volatile uint32_t* word = bottom;
  while (word < top && *word == 0xA5A5A5A5u) ++word;
  return static_cast<size_t>(top - word) * 4 + kOwn;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  start_counting();
  measure_linear(128, 96, 48);
  measure_linear(128, 62, 48);
  measure_linear(128, 576, 64);
  size_t deepest = 0;
  for (const sinew_test::StackCase& tested : sinew_test::stack_cases(argv[1], argv[2])) {
    const size_t bytes = stack_of(tested);
    std::printf("stack_%s_bytes %u\n", tested.name, static_cast<unsigned>(bytes));
    deepest = bytes > deepest ? bytes : deepest;
  }
  std::printf("stack_bytes %u\n", static_cast<unsigned>(deepest));
  return 0;
}
