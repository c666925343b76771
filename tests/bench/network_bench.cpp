// SPDX-License-Identifier: MIT
// The network as a whole: the int16 engine with every kernel that runs here, and the float trainer's forward pass (Eigen) on
// the same features of one synthetic body. One run, passes interleaved, processor time of the thread that computes. CSV on
// standard output; int16 results that differ from each other, or far from float's, end the run.
//   sinew_bench_network [--repeats N] [VERTICES...]      default: 10000
#include <cmath>
#include <cstring>
#include <memory>
#include <stdexcept>

#include "bench_report.hpp"
#include "features/features.hpp"
#include "heat_scene.hpp"
#include "kernels/select.hpp"
#include "sinew/sinew.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_trainer/engine_network.hpp"
#include "sinew_trainer/network.hpp"

namespace {

using namespace sinew;

Character body(double vertices) {
  const uint32_t rings = static_cast<uint32_t>(std::lround(std::sqrt(vertices * 0.78)));
  const sinew_test::HeatScene scene = sinew_test::star(rings, static_cast<uint32_t>(std::lround(vertices / rings)), 10);
  Character c;
  c.name = "body";
  for (uint32_t v = 0; v < scene.vertex_count(); ++v)
    c.vertices.push_back({scene.positions[3 * v], scene.positions[3 * v + 1], scene.positions[3 * v + 2]});
  c.face_vertices = scene.triangles;
  for (uint32_t i = 3; i <= scene.triangles.size(); i += 3) c.face_offsets.push_back(i);
  for (uint32_t j = 0; j < scene.joint_count(); ++j)
    c.joints.push_back({"j" + std::to_string(j),
                        {scene.joints[3 * j], scene.joints[3 * j + 1], scene.joints[3 * j + 2]},
                        scene.parents[j]});
  return c;
}

struct BundledModel {
  std::vector<uint64_t> storage;
  sinew_model model = {};
  BundledModel() {
    const std::vector<uint8_t> bytes = read_file(SINEW_SOURCE_DIR "/samples/data/sinew_default.sinew");
    storage.resize(bytes.size() / 8 + 1);
    std::memcpy(storage.data(), bytes.data(), bytes.size());
    if (sinew_model_open(storage.data(), bytes.size(), &model) != SINEW_OK) throw Error("the bundled model is refused");
  }
};

struct Contestant {
  std::string name;
  size_t bytes = 0;            // activations and, for int16, packed weights
  std::vector<double> passes;  // seconds
  uint64_t hash = 0;
  virtual ~Contestant() = default;
  virtual double pass() = 0;                      // seconds
  virtual std::vector<float> logits() const = 0;  // natural units, of the last pass
};

struct Int16 : Contestant {
  const sinew_model& model;
  NetworkInput input;
  Kernels kernels;
  NetworkOptions options;
  std::vector<int16_t> result;
  std::unique_ptr<Workspace> block;

  Int16(const sinew_model& m, const Sample& s, uint32_t kernel, bool in_place) : model(m), input(network_input(s)) {
    name = std::string("int16 ") + sinew_kernel_name(kernel) + (in_place ? " in place" : "");
    if (!select_kernels(kernel, &kernels)) throw Error(name + ": does not run here");
    options.weights_in_place = in_place || kernel == SINEW_KERNEL_REF;
    block = std::make_unique<Workspace>(network_workspace(model, s, options));
    bytes = block->size();
    result.resize(size_t{s.vertices} * s.candidates);
  }
  double pass() override {
    Arena arena(block->data(), block->size());
    const double start = sinew_bench::thread_seconds();
    if (run_network(model, input, kernels, {}, arena, result.data(), options) != SINEW_OK)
      throw Error(name + ": does not run");
    const double seconds = sinew_bench::thread_seconds() - start;
    hash = sinew_bench::fnv1a(sinew_bench::kHashStart, result.data(), result.size() * 2);
    return seconds;
  }
  std::vector<float> logits() const override {
    std::vector<float> out;
    for (const int16_t q : result) out.push_back(static_cast<float>(q) / 1024 * 0.69314718f);
    return out;
  }
};

size_t activation_bytes(const FloatNetwork& network, const Sample& s) {
  size_t values = 0;
  for (const Buffer& b : network.buffers)
    values += size_t{b.channels} * s.vertices * (b.domain == Domain::kPair ? s.candidates : 1);
  return values * sizeof(float);
}

struct EigenForward : Contestant {
  const FloatNetwork& network;
  const Sample& sample;
  NetworkRunner runner;
  std::vector<float> result;
  EigenForward(const FloatNetwork& n, const Sample& s) : network(n), sample(s) {
    name = "float trainer (Eigen)";
    bytes = activation_bytes(n, s);
  }
  double pass() override {
    const double start = sinew_bench::thread_seconds();
    const std::vector<float>& out = runner.forward(network, sample);
    const double seconds = sinew_bench::thread_seconds() - start;
    result = out;
    hash = sinew_bench::fnv1a(sinew_bench::kHashStart, result.data(), result.size() * 4);
    return seconds;
  }
  std::vector<float> logits() const override { return result; }
};

// Largest and mean distance of logits where candidates are present.
void compare(const Contestant& a, const Contestant& b, const Sample& s, double limit) {
  const std::vector<float> x = a.logits(), y = b.logits();
  double largest = 0, sum = 0;
  size_t count = 0;
  for (size_t i = 0; i < x.size(); ++i) {
    if (s.candidate[i] == kNoJoint) continue;
    const double distance = std::fabs(static_cast<double>(x[i]) - static_cast<double>(y[i]));
    largest = std::max(largest, distance);
    sum += distance;
    ++count;
  }
  std::fprintf(stderr, "%s - %s: logits differ by %.2g in the mean, %.2g at most\n", a.name.c_str(), b.name.c_str(),
               sum / static_cast<double>(count), largest);
  if (sum / static_cast<double>(count) > limit) throw Error(a.name + " and " + b.name + " compute different things");
}

void measure(double vertices, const BundledModel& model, const FloatNetwork& network, int repeats) {
  const Sample sample =
      make_sample(body(vertices), model.model.candidate_count, model.model.grid_size, model.model.feature_set);
  std::vector<std::unique_ptr<Contestant>> all;
  for (uint32_t k = 1; sinew_kernel_name(k) != nullptr; ++k) {
    if (sinew_kernel_select(k) != 0) all.push_back(std::make_unique<Int16>(model.model, sample, k, false));
  }
  const size_t best = all.size() - 1, floats = all.size() + 1;  // kernels are numbered by rising speed
  all.push_back(std::make_unique<Int16>(model.model, sample, SINEW_KERNEL_AUTO, true));
  all.push_back(std::make_unique<EigenForward>(network, sample));
  for (int i = -1; i < repeats; ++i) {  // the first round warms up
    for (const auto& contestant : all) {
      const double seconds = contestant->pass();
      if (i >= 0) contestant->passes.push_back(seconds);
    }
  }
  for (size_t i = 1; i < floats; ++i) {
    if (all[i]->hash != all[0]->hash) throw Error(all[i]->name + " differs from " + all[0]->name);
  }
  compare(*all[floats], *all[0], sample, 0.05);
  const double fastest = sinew_bench::median(all[best]->passes);
  for (const auto& contestant : all) {
    const double median = sinew_bench::median(contestant->passes);
    std::printf("%s,%u,%s,%.3f,%.0f,%.2f,%zu,%016llx\n", sinew_bench::row_start().c_str(), sample.vertices,
                contestant->name.c_str(), median * 1e3, median * 1e9 / sample.vertices, median / fastest,
                contestant->bytes, static_cast<unsigned long long>(contestant->hash));
  }
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    int repeats = 15;
    std::vector<double> sizes = {10000};
    sinew_bench::read_arguments(argc, argv, &repeats, &sizes);
    const BundledModel model;
    const Checkpoint checkpoint = read_checkpoint(SINEW_SOURCE_DIR "/samples/data/sinew_default.ckpt");
    std::printf("machine,compiler,commit,vertices,network,median_ms,ns_per_vertex,times_fastest_int16,bytes,hash\n");
    for (const double vertices : sizes) measure(vertices, model, checkpoint.network, repeats);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "sinew_bench_network: %s\n", error.what());
    return 1;
  }
}
