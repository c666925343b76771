// SPDX-License-Identifier: MIT
// The linear layer and softmax alone with one kernel, without any package, so that it runs under WebAssembly too: CSV
// on standard output. sinew_bench_linear compares with other libraries.
//   sinew_bench_layer [--kernel NAME] [--repeats N]
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <random>
#include <vector>

#include "bench_report.hpp"
#include "kernels/select.hpp"
#include "linear_layer.hpp"
#include "sinew/sinew.hpp"

namespace {

using namespace sinew;

struct Shape {
  uint32_t rows, in, out;
};
constexpr Shape kShapes[] = {{4096, 64, 64},  {4096, 64, 256}, {4096, 576, 512}, {4096, 1024, 256},
                             {32768, 96, 64}, {128, 96, 48},   {128, 46, 48}};

void measure(const Shape& shape, const Kernels& kernels, int repeats) {
  std::mt19937 random(1);
  const auto below = [&](uint32_t n) { return static_cast<int32_t>(random() % n); };
  const int32_t largest = static_cast<int32_t>(120000 / shape.in);  // no sum leaves int32
  test::LinearLayer layer(shape.in, shape.out, 10);
  layer.low = 0;
  layer.high = 16383;
  std::vector<int16_t> in(size_t{shape.rows} * shape.in), out(size_t{shape.rows} * shape.out);
  for (int16_t& w : layer.weights) w = static_cast<int16_t>(below(static_cast<uint32_t>(2 * largest + 1)) - largest);
  for (int16_t& x : in) x = static_cast<int16_t>(below(16384));
  LinearView view = layer.view();
  const Workspace packed(packed_linear_bytes(shape.in, shape.out, shape.in));
  pack_linear(view, packed.data());
  view.packed = packed_view(view, packed.data());
  const LinearKernel run = kernels.linear_packed != nullptr ? kernels.linear_packed : kernels.linear;
  const double products = static_cast<double>(shape.rows) * shape.in * shape.out;
  const int calls = 1 + static_cast<int>(2e7 / products);
  std::vector<double> seconds;
  for (int i = 0; i < repeats; ++i) {
    const double start = sinew_bench::thread_seconds();
    for (int c = 0; c < calls; ++c) {
      run(view, {in.data(), shape.in}, {}, nullptr, shape.rows, out.data(), shape.out);
    }
    seconds.push_back((sinew_bench::thread_seconds() - start) / calls);
  }
  const double median = sinew_bench::median(seconds);
  const uint64_t hash = sinew_bench::fnv1a(sinew_bench::kHashStart, out.data(), out.size() * 2);
  std::printf("%s,%s,%ux%ux%u,%.4f,%.2f,%016llx\n", sinew_bench::row_start().c_str(), kernel_name(kernels.id),
              shape.rows, shape.in, shape.out, median * 1e3, products / median / 1e9,
              static_cast<unsigned long long>(hash));
  std::fflush(stdout);
}

// Logits as a network has them, an eighth of the slots absent; a call per row, as a bind does.
void measure_softmax(uint32_t count, const Kernels& kernels, int repeats) {
  constexpr uint32_t kRows = 32768;
  std::mt19937 random(1);
  std::vector<int16_t> logits(size_t{kRows} * count);
  std::vector<uint16_t> joints(logits.size());
  std::vector<uint32_t> out(logits.size());
  for (int16_t& x : logits) x = static_cast<int16_t>(static_cast<int32_t>(random() % 16384) - 8192);
  for (uint16_t& joint : joints) joint = random() % 8 == 0 ? kNoJoint : uint16_t{5};
  std::vector<double> seconds;
  for (int i = 0; i < repeats; ++i) {
    const double start = sinew_bench::thread_seconds();
    for (size_t row = 0; row < out.size(); row += count)
      kernels.softmax(logits.data() + row, joints.data() + row, count, 655, out.data() + row);
    seconds.push_back(sinew_bench::thread_seconds() - start);
  }
  const uint64_t hash = sinew_bench::fnv1a(sinew_bench::kHashStart, out.data(), out.size() * 4);
  std::printf("%s,%s,softmax %ux%u,%.4f,,%016llx\n", sinew_bench::row_start().c_str(), kernel_name(kernels.id), kRows,
              count, sinew_bench::median(seconds) * 1e3, static_cast<unsigned long long>(hash));
}

}  // namespace

int main(int argc, char** argv) {
  uint32_t kernel = SINEW_KERNEL_AUTO;
  int repeats = 15;
  for (int i = 1; i + 1 < argc; i += 2) {
    if (std::strcmp(argv[i], "--repeats") == 0) {
      repeats = std::max(1, std::atoi(argv[i + 1]));
    } else if (std::strcmp(argv[i], "--kernel") == 0) {
      while (kernel_name(kernel) != nullptr && std::strcmp(kernel_name(kernel), argv[i + 1]) != 0) ++kernel;
    }
  }
  Kernels kernels;
  if (!select_kernels(kernel, &kernels)) {
    std::fprintf(stderr, "sinew_bench_layer: no such kernels run here\n");
    return 2;
  }
  std::printf("machine,compiler,commit,kernel,shape,median_ms,gmac_per_s,hash\n");
  for (const Shape& shape : kShapes) measure(shape, kernels, repeats);
  for (const uint32_t count : {8u, 16u}) measure_softmax(count, kernels, repeats);
  return 0;
}
