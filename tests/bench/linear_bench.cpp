// SPDX-License-Identifier: MIT
// The linear layer: int16 kernels against Eigen's and oneDNN's float, repetitions interleaved in one run, time of this
// thread's processor. CSV on standard output; times are medians.
//   sinew_bench_linear [Google Benchmark flags]
#include <benchmark/benchmark.h>
#include <unistd.h>

#include <cstdlib>
#include <functional>
#include <map>
#include <memory>
#include <new>
#include <random>
#include <string>
#include <vector>

#include "bench_report.hpp"
#include "kernels/select.hpp"
#include "linear_eigen.hpp"
#include "linear_layer.hpp"
#include "vnni_peak.hpp"
#if SINEW_BENCH_DNNL
#include <oneapi/dnnl/dnnl.hpp>
#endif

namespace {

struct Shape {
  uint32_t rows, in, out;
  double macs() const { return static_cast<double>(rows) * in * out; }
  std::string name() const { return std::to_string(rows) + "x" + std::to_string(in) + "x" + std::to_string(out); }
};

// A layer and its rows, as int16 and as the float numbers of the same values.
struct Problem {
  Shape shape;
  sinew::test::LinearLayer layer;
  std::vector<int16_t> in, out;
  std::vector<float> float_in, float_weights, float_bias, float_out;
  std::unique_ptr<uint8_t, void (*)(uint8_t*)> packed{nullptr, nullptr};
  sinew::LinearView view;

  explicit Problem(const Shape& s) : shape(s), layer(s.in, s.out, 12) {
    std::mt19937 random(s.rows * 31 + s.in * 7 + s.out);
    in.resize(size_t{s.rows} * s.in);
    out.resize(size_t{s.rows} * s.out);
    for (int16_t& x : in) x = static_cast<int16_t>(random() % 16384);
    const int32_t largest = static_cast<int32_t>(120000 / (s.in + 1));
    for (int16_t& w : layer.weights)
      w = static_cast<int16_t>(static_cast<int32_t>(random() % (2 * largest + 1)) - largest);
    for (uint32_t n = 0; n < s.out; ++n) layer.set_bias(n, 2048 + n);
    layer.low = 0;
    layer.high = 16383;
    view = layer.view();
    const size_t bytes = sinew::packed_linear_bytes(s.in, s.out, s.in);
    packed = {static_cast<uint8_t*>(::operator new (bytes, std::align_val_t{64})),
              [](uint8_t* p) { ::operator delete (p, std::align_val_t{64}); }};
    sinew::pack_linear(view, packed.get());
    view.packed = sinew::packed_view(view, packed.get());
    float_in.assign(in.begin(), in.end());
    float_out.resize(out.size());
    float_bias.assign(s.out, 0.5f);
    for (uint32_t n = 0; n < s.out; ++n)  // column-major [in x out] is [out x in]
      for (uint32_t k = 0; k < s.in; ++k) float_weights.push_back(layer.weights[size_t{n} * s.in + k] / 4096.0f);
  }
  void run(sinew::LinearKernel kernel) {
    kernel(view, {in.data(), shape.in}, {nullptr, 0}, nullptr, shape.rows, out.data(), shape.out);
  }
  uint64_t hash() const { return sinew_bench::fnv1a(sinew_bench::kHashStart, out.data(), out.size() * 2); }
};

#if SINEW_BENCH_DNNL
// A matmul with bias and ReLU fused, weights in the library's own layout: what oneDNN does best.
class OneDnn {
 public:
  explicit OneDnn(Problem* p) : engine_(dnnl::engine::kind::cpu, 0), stream_(engine_) {
    using dnnl::memory;
    const memory::dim m = p->shape.rows, k = p->shape.in, n = p->shape.out;
    const memory::desc in({m, k}, memory::data_type::f32, memory::format_tag::ab);
    const memory::desc given({k, n}, memory::data_type::f32, memory::format_tag::ba);
    const memory::desc own({k, n}, memory::data_type::f32, memory::format_tag::any);
    const memory::desc bias({1, n}, memory::data_type::f32, memory::format_tag::ab);
    const memory::desc out({m, n}, memory::data_type::f32, memory::format_tag::ab);
    dnnl::post_ops relu;
    relu.append_eltwise(1.0f, dnnl::algorithm::eltwise_relu, 0, 0);
    dnnl::primitive_attr attributes;
    attributes.set_post_ops(relu);
    const dnnl::matmul::primitive_desc description(dnnl::matmul::desc(in, own, bias, out), attributes, engine_);
    matmul_ = dnnl::matmul(description);
    memory weights(description.weights_desc(), engine_);
    memory from(given, engine_, p->float_weights.data());
    dnnl::reorder(from, weights).execute(stream_, from, weights);
    stream_.wait();
    arguments_ = {{DNNL_ARG_SRC, memory(in, engine_, p->float_in.data())},
                  {DNNL_ARG_WEIGHTS, weights},
                  {DNNL_ARG_BIAS, memory(bias, engine_, p->float_bias.data())},
                  {DNNL_ARG_DST, memory(out, engine_, p->float_out.data())}};
  }
  void run() {
    matmul_.execute(stream_, arguments_);
    stream_.wait();
  }

 private:
  dnnl::engine engine_;
  dnnl::stream stream_;
  dnnl::matmul matmul_;
  std::unordered_map<int, dnnl::memory> arguments_;
};
#endif

struct Measured {
  std::string shape, kernel;
  double macs = 0;
  size_t bytes = 0;
  uint64_t hash = 0;
  std::vector<double> nanoseconds;
};

// Collects every repetition; the rows are written at the end, beside each other.
class Collect : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration || run.error_occurred) continue;
      times[run.run_name.function_name].push_back(run.cpu_accumulated_time * 1e9 / static_cast<double>(run.iterations));
    }
  }
  std::map<std::string, std::vector<double>> times;
};

std::vector<Measured> g_rows;

void add(const std::string& shape, const std::string& kernel, double macs, size_t bytes, uint64_t hash,
         const std::function<void()>& once) {
  g_rows.push_back({shape, kernel, macs, bytes, hash, {}});
  benchmark::RegisterBenchmark((shape + "/" + kernel).c_str(), [once](benchmark::State& state) {
    for (auto _ : state) once();
  });
}

void add_shape(const Shape& shape) {
  const auto p = std::make_shared<Problem>(shape);
  const size_t size16 = 2 * (p->in.size() + p->layer.weights.size() + p->out.size());
  for (uint32_t kernel = 1; sinew_kernel_name(kernel) != nullptr; ++kernel) {
    sinew::Kernels kernels;
    if (!sinew::select_kernels(kernel, &kernels)) continue;
    const sinew::LinearKernel linear = kernels.linear_packed != nullptr ? kernels.linear_packed : kernels.linear;
    p->run(linear);
    if (kernel == SINEW_KERNEL_REF && shape.macs() > 2e8) continue;  // slow, and measured on the small shapes
    add(shape.name(), sinew_kernel_name(kernel), shape.macs(), size16, p->hash(), [p, linear] { p->run(linear); });
  }
  const long rows = shape.rows, in = shape.in, out = shape.out;
  for (const bool wide : {false, true}) {
    if (wide ? !__builtin_cpu_supports("avx512dq") : !__builtin_cpu_supports("fma")) continue;
    const auto layer = wide ? eigen_avx512_layer : eigen_avx2_layer;
    for (const bool product : {false, true}) {
      const std::string name = std::string(wide ? "eigen-avx512" : "eigen-avx2") + (product ? "-product" : "");
      const float* const bias = product ? nullptr : p->float_bias.data();
      add(shape.name(), name, shape.macs(), 2 * size16, 0,
          [=] { layer(p->float_in.data(), p->float_weights.data(), bias, rows, in, out, p->float_out.data()); });
    }
  }
#if SINEW_BENCH_DNNL
  const auto dnnl = std::make_shared<OneDnn>(p.get());
  add(shape.name(), "onednn", shape.macs(), 2 * size16, 0, [dnnl, p] { dnnl->run(); });
#endif
}

}  // namespace

int main(int argc, char** argv) {
  // oneDNN reads how many threads it may use when it is loaded.
  if (std::getenv("OMP_NUM_THREADS") == nullptr) {
    setenv("OMP_NUM_THREADS", "1", 1);
    execv("/proc/self/exe", argv);
  }
  std::vector<char*> arguments(argv, argv + argc);
  std::string defaults[] = {"--benchmark_enable_random_interleaving=true", "--benchmark_repetitions=9",
                            "--benchmark_min_time=0.02"};
  for (std::string& flag : defaults) arguments.insert(arguments.begin() + 1, flag.data());
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 2;

  if (__builtin_cpu_supports("avx512vnni"))
    add("peak", "vpdpwssd", kPeakMacsPerRound * 100000, 0, 0, [] { benchmark::DoNotOptimize(run_vnni_peak(100000)); });
  for (const Shape& shape : {Shape{4096, 64, 64}, Shape{4096, 64, 256}, Shape{4096, 576, 512}, Shape{4096, 1024, 256},
                             Shape{32768, 96, 64}, Shape{128, 96, 48}, Shape{128, 46, 48}})
    add_shape(shape);

  Collect collect;
  benchmark::RunSpecifiedBenchmarks(&collect);
  double peak = 0;
  std::map<std::string, double> gmacs;
  for (Measured& row : g_rows) {
    row.nanoseconds = collect.times[row.shape + "/" + row.kernel];
    if (row.nanoseconds.empty()) continue;
    gmacs[row.shape + "/" + row.kernel] = row.macs / sinew_bench::median(row.nanoseconds);
    if (row.shape == "peak") peak = gmacs[row.shape + "/" + row.kernel];
  }
  const std::string start = sinew_bench::row_start();
  std::printf(
      "machine,compiler,commit,shape,kernel,repetitions,median_ns,gmac_per_s,share_of_vnni_peak,"
      "to_eigen_avx512,to_eigen_avx512_product,to_eigen_avx2,to_onednn,bytes,hash\n");
  for (const Measured& row : g_rows) {
    if (row.nanoseconds.empty()) continue;
    const double rate = gmacs[row.shape + "/" + row.kernel];
    const auto ratio = [&](const char* other) {
      const auto at = gmacs.find(row.shape + "/" + other);
      return at == gmacs.end() ? 0 : rate / at->second;
    };
    std::printf("%s,%s,%s,%zu,%.0f,%.1f,%.3f,%.2f,%.2f,%.2f,%.2f,%zu,%016llx\n", start.c_str(), row.shape.c_str(),
                row.kernel.c_str(), row.nanoseconds.size(), sinew_bench::median(row.nanoseconds), rate,
                peak > 0 ? rate / peak : 0, ratio("eigen-avx512"), ratio("eigen-avx512-product"), ratio("eigen-avx2"),
                ratio("onednn"), row.bytes, static_cast<unsigned long long>(row.hash));
  }
  return 0;
}
