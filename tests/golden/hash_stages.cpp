// SPDX-License-Identifier: MIT
// Prints one hash per stage of a bind for OBJ + rig.txt characters: what must be equal on every target and build type.
//   hash_stages [--kernel NAME] [--model FILE] NAME.obj...      (NAME.rig.txt beside each)
//   hash_stages --runs NAME      exits with 0 when the processor runs these kernels, else with 1
// Needs the engine alone; its own small reader keeps it free of packages, so that it cross-compiles.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>
#include <string>
#include <vector>

#include "bind/bind.hpp"
#include "network/network.hpp"
#include "spectral/spectral.hpp"
#include "weights/influences.hpp"

namespace {

using namespace sinew;

// FNV-1a over values written low byte first, so that big-endian hosts agree.
struct Hash {
  uint64_t state = 1469598103934665603ull;
  template <class T>
  void add(const T* values, size_t count) {
    for (size_t i = 0; i < count; ++i) {
      const uint64_t v = static_cast<uint64_t>(values[i]);
      for (size_t b = 0; b < sizeof(T); ++b) state = (state ^ ((v >> (8 * b)) & 0xFF)) * 1099511628211ull;
    }
  }
  void add(const Vec3i* values, size_t count) {
    for (size_t i = 0; i < count; ++i) {
      const int32_t xyz[3] = {values[i].x, values[i].y, values[i].z};
      add(xyz, 3);
    }
  }
};

void print(const char* name, const char* stage, const Hash& hash) {
  std::printf("%s %s %016llx\n", name, stage, static_cast<unsigned long long>(hash.state));
}

std::vector<uint8_t> read_all(const char* path) {
  std::FILE* f = std::fopen(path, "rb");
  if (f == nullptr) {
    std::fprintf(stderr, "hash_stages: cannot read %s\n", path);
    std::exit(1);
  }
  std::vector<uint8_t> bytes;
  uint8_t block[65536];
  for (size_t n; (n = std::fread(block, 1, sizeof block, f)) > 0;) bytes.insert(bytes.end(), block, block + n);
  std::fclose(f);
  return bytes;
}

std::vector<std::vector<std::string>> read_words(const std::string& path) {
  std::vector<std::vector<std::string>> lines(1);
  std::string word;
  for (uint8_t byte : read_all(path.c_str())) {
    if (byte > ' ') {
      word += static_cast<char>(byte);
      continue;
    }
    if (!word.empty()) lines.back().push_back(word);
    word.clear();
    if (byte == '\n') lines.emplace_back();
  }
  return lines;
}

struct Input {
  std::vector<float> positions, joints;
  std::vector<uint32_t> offsets = {0}, corners;
  std::vector<int32_t> parents;
  sinew_mesh mesh = {};
  sinew_skeleton skeleton = {};
};

Input read_input(const std::string& obj) {
  Input in;
  for (const auto& line : read_words(obj)) {
    if (line.empty()) continue;
    if (line[0] == "v") {
      for (int i = 1; i <= 3; ++i) in.positions.push_back(std::strtof(line[static_cast<size_t>(i)].c_str(), nullptr));
    } else if (line[0] == "f") {
      for (size_t i = 1; i < line.size(); ++i) {
        in.corners.push_back(static_cast<uint32_t>(std::strtoul(line[i].c_str(), nullptr, 10)) - 1);
      }
      in.offsets.push_back(static_cast<uint32_t>(in.corners.size()));
    }
  }
  std::vector<std::string> names;
  const auto rig = read_words(obj.substr(0, obj.size() - 4) + ".rig.txt");
  for (const auto& line : rig) {
    if (line.empty() || line[0] != "joints") continue;
    names.push_back(line[1]);
    for (size_t i = 2; i < 5; ++i) in.joints.push_back(std::strtof(line[i].c_str(), nullptr));
  }
  in.parents.assign(names.size(), -1);
  auto index = [&](const std::string& name) {
    for (size_t i = 0; i < names.size(); ++i) {
      if (names[i] == name) return static_cast<int32_t>(i);
    }
    return -1;
  };
  for (const auto& line : rig) {
    if (!line.empty() && line[0] == "hier") in.parents[static_cast<size_t>(index(line[2]))] = index(line[1]);
  }
  in.mesh = {
      in.positions.data(), static_cast<uint32_t>(in.positions.size() / 3), in.offsets.data(),
      in.corners.data(),   static_cast<uint32_t>(in.offsets.size() - 1),   static_cast<uint32_t>(in.corners.size())};
  in.skeleton = {in.joints.data(), in.parents.data(), nullptr, static_cast<uint32_t>(names.size())};
  return in;
}

struct Block {
  explicit Block(size_t bytes) : data(::operator new (bytes, std::align_val_t{64})) {}
  ~Block() { ::operator delete (data, std::align_val_t{64}); }
  void* data;
};

void check(sinew_status status) {
  if (status == SINEW_OK) return;
  std::fprintf(stderr, "hash_stages: %s\n", sinew_status_text(status));
  std::exit(1);
}

void hash_prepared(const char* name, const Prepared& p, uint32_t k) {
  const size_t u = p.mesh.welded_count;
  Hash mesh, skeleton, heat, candidates, features;
  mesh.add(p.mesh.positions, u);
  mesh.add(p.mesh.triangles, static_cast<size_t>(p.mesh.triangle_count) * 3);
  mesh.add(p.mesh.normals, u);
  mesh.add(p.mesh.areas, u);
  mesh.add(p.mesh.mean_curvature, u);
  mesh.add(p.mesh.gauss_curvature, u);
  mesh.add(p.mesh.component, u);
  skeleton.add(p.skeleton.positions, p.skeleton.joint_count);
  skeleton.add(p.skeleton.bone_tail, p.skeleton.joint_count);
  skeleton.add(p.skeleton.source, p.skeleton.joint_count);
  for (const HeatField& field : p.heat.field) {
    heat.add(field.joints, u * kHeatSlots);
    heat.add(field.weights, u * kHeatSlots);
    heat.add(field.has_source, u);
  }
  candidates.add(p.candidates.joints, u * k);
  candidates.add(p.candidates.distances, u * k);
  candidates.add(p.candidates.tips, p.skeleton.joint_count);
  features.add(p.features.joints, u * k);
  features.add(p.features.vertex, u * kVertexFeatures);
  features.add(p.features.pair, u * k * kPairFeatures);
  print(name, "mesh", mesh);
  print(name, "skeleton", skeleton);
  print(name, "heat", heat);
  print(name, "candidates", candidates);
  print(name, "features", features);
}

void hash_spectral(const char* name, const Mesh& mesh, const Counts& counts) {
  Arena measuring;
  measure_compute_spectral(measuring, counts);
  Block block(measuring.high_water());
  Arena arena(block.data, measuring.high_water());
  std::vector<int16_t> rows(size_t{mesh.welded_count} * kSpectralChannels);
  check(compute_spectral(mesh, counts, Progress{}, arena, rows.data(), kSpectralChannels));
  Hash hash;
  hash.add(rows.data(), rows.size());
  print(name, "spectral", hash);
}

uint32_t find_kernel(const char* name) {
  for (uint32_t kernel = 0; sinew_kernel_name(kernel) != nullptr; ++kernel) {
    if (std::strcmp(sinew_kernel_name(kernel), name) == 0) return kernel;
  }
  std::fprintf(stderr, "hash_stages: no kernels are called %s\n", name);
  std::exit(2);
}

void hash_bind(const char* name, const char* stage, const Input& in, const sinew_model* model, sinew_method method,
               uint32_t kernel) {
  sinew_options options = {};
  options.kernel = kernel;
  options.method = method;
  size_t bytes = 0;
  check(sinew_bind_workspace_size(model, in.mesh.vertex_count, in.mesh.face_count, in.mesh.corner_count,
                                  in.skeleton.joint_count, &options, &bytes));
  Block block(bytes);
  std::vector<uint16_t> joints(in.mesh.vertex_count * size_t{4}), weights(joints.size());
  check(sinew_bind(model, &in.mesh, &in.skeleton, &options, block.data, bytes, joints.data(), weights.data(), nullptr));
  Hash hash;
  hash.add(joints.data(), joints.size());
  hash.add(weights.data(), weights.size());
  print(name, stage, hash);
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<uint8_t> model_bytes;
  sinew_model model = {};
  if (argc == 3 && std::strcmp(argv[1], "--runs") == 0) return sinew_kernel_select(find_kernel(argv[2])) != 0 ? 0 : 1;
  int first = 1;
  uint32_t kernel = SINEW_KERNEL_AUTO;
  if (argc > 2 && std::strcmp(argv[1], "--kernel") == 0) {
    kernel = find_kernel(argv[2]);
    first = 3;
  }
  std::vector<uint64_t> aligned;
  if (argc > first + 1 && std::strcmp(argv[first], "--model") == 0) {
    model_bytes = read_all(argv[first + 1]);
    aligned.resize(model_bytes.size() / 8 + 1);
    std::memcpy(aligned.data(), model_bytes.data(), model_bytes.size());
    check(sinew_model_open(aligned.data(), model_bytes.size(), &model));
    first += 2;
  }
  for (int i = first; i < argc; ++i) {
    const std::string path = argv[i];
    const std::string name = path.substr(path.find_last_of('/') + 1);
    const Input in = read_input(path);
    Counts counts;
    check(make_counts(in.mesh.vertex_count, in.mesh.face_count, in.mesh.corner_count, in.skeleton.joint_count, 8, 64,
                      &counts));
    Arena measuring;
    measure_prepare(measuring, counts, PrepareFor::kNetwork);
    Block block(measuring.high_water());
    Arena arena(block.data, measuring.high_water());
    Prepared p;
    check(prepare(in.mesh, in.skeleton, 0, counts, PrepareFor::kNetwork, Progress{}, arena, &p));
    hash_prepared(name.c_str(), p, 8);
    hash_spectral(name.c_str(), p.mesh, counts);
    hash_bind(name.c_str(), "bind-heat", in, nullptr, SINEW_METHOD_HEAT, kernel);
    if (model.bytes != nullptr) hash_bind(name.c_str(), "bind-model", in, &model, SINEW_METHOD_MODEL, kernel);
  }
  return 0;
}
