// SPDX-License-Identifier: MIT
// Binds whose stack and memory are measured: every stage and every option that has code of its own.
#ifndef SINEW_TESTS_BUDGET_STACK_CASES_HPP
#define SINEW_TESTS_BUDGET_STACK_CASES_HPP

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <new>
#include <string>
#include <vector>

#include "sinew/sinew.h"
#include "skeleton_of.hpp"

namespace sinew_test {

// A round tube along y with a chain of joints inside: plain, but every stage has something to do.
struct Tube {
  static constexpr uint32_t kRings = 40, kAround = 12, kJoints = 9;
  std::vector<float> positions, joints;
  std::vector<uint32_t> corners;
  std::vector<int32_t> parents;

  Tube() {
    constexpr float kCircle[kAround][2] = {{1, 0},  {.87f, .5f},   {.5f, .87f},   {0, 1},  {-.5f, .87f}, {-.87f, .5f},
                                           {-1, 0}, {-.87f, -.5f}, {-.5f, -.87f}, {0, -1}, {.5f, -.87f}, {.87f, -.5f}};
    for (uint32_t ring = 0; ring < kRings; ++ring) {
      for (const auto& point : kCircle) {
        positions.insert(positions.end(), {point[0], 0.5f * static_cast<float>(ring), point[1]});
      }
    }
    for (uint32_t ring = 0; ring + 1 < kRings; ++ring) {
      for (uint32_t i = 0; i < kAround; ++i) {
        const uint32_t a = ring * kAround + i, b = ring * kAround + (i + 1) % kAround;
        corners.insert(corners.end(), {a, b, b + kAround, a, b + kAround, a + kAround});
      }
    }
    for (uint32_t j = 0; j < kJoints; ++j) {
      joints.insert(joints.end(), {0.0f, 2.3f * static_cast<float>(j), 0.0f});
      parents.push_back(static_cast<int32_t>(j) - 1);
    }
  }
  sinew_mesh mesh() const {
    return {positions.data(),
            kRings * kAround,
            nullptr,
            corners.data(),
            static_cast<uint32_t>(corners.size() / 3),
            static_cast<uint32_t>(corners.size())};
  }
  sinew_skeleton skeleton() const { return skeleton_of(joints.data(), parents.data(), kJoints); }
};

struct StackCase {
  const char* name = "";
  std::shared_ptr<std::vector<uint64_t>> model_bytes;
  sinew_model model = {};
  sinew_bind_options options = SINEW_INIT(sinew_bind_options);
  // Everything a bind writes to, so that run() itself needs next to no stack and no heap.
  std::shared_ptr<Tube> tube;
  std::shared_ptr<std::vector<uint8_t>> hints;
  std::shared_ptr<std::vector<uint16_t>> joints, weights;
  std::shared_ptr<void> workspace;
  size_t workspace_bytes = 0;
};

inline void prepare(StackCase* c, const std::string& model_path) {
  if (std::FILE* file = model_path.empty() ? nullptr : std::fopen(model_path.c_str(), "rb")) {
    std::vector<char> bytes;
    char block[4096];
    for (size_t n; (n = std::fread(block, 1, sizeof block, file)) > 0;) bytes.insert(bytes.end(), block, block + n);
    std::fclose(file);
    c->model_bytes = std::make_shared<std::vector<uint64_t>>(bytes.size() / 8 + 1);
    std::memcpy(c->model_bytes->data(), bytes.data(), bytes.size());
    if (sinew_model_open(c->model_bytes->data(), bytes.size(), &c->model) != SINEW_OK) std::abort();
  } else if (!model_path.empty()) {
    std::fprintf(stderr, "cannot read %s\n", model_path.c_str());
    std::abort();
  }
  c->options.method = model_path.empty() ? SINEW_METHOD_HEAT : SINEW_METHOD_MODEL;
  c->options.grid_size = 24;
  c->tube = std::make_shared<Tube>();
  const sinew_mesh mesh = c->tube->mesh();
  c->hints = std::make_shared<std::vector<uint8_t>>(mesh.vertex_count, 0);
  c->joints = std::make_shared<std::vector<uint16_t>>(mesh.vertex_count * 4u, 0);
  c->weights = std::make_shared<std::vector<uint16_t>>(mesh.vertex_count * 4u, 0);
  if (c->options.hints != nullptr) {
    for (size_t v = 0; v < mesh.vertex_count; v += 50) {
      (*c->hints)[v] = 1;
      (*c->weights)[4 * v] = 65535;
    }
    c->options.hints = c->hints->data();
  }
  const sinew_model* const model = model_path.empty() ? nullptr : &c->model;
  if (sinew_bind_workspace_size(model, mesh.vertex_count, mesh.face_count, mesh.corner_count, Tube::kJoints,
                                &c->options, &c->workspace_bytes) != SINEW_OK) {
    std::abort();
  }
  c->workspace = std::shared_ptr<void>(::operator new (c->workspace_bytes, std::align_val_t{64}),
                                       [](void* p) { ::operator delete (p, std::align_val_t{64}); });
}

// `golden` is the folder tests/golden/models.
inline std::vector<StackCase> stack_cases(const std::string& default_model, const std::string& golden) {
  static const uint8_t kSome = 0;
  std::vector<StackCase> cases(5);
  cases[0].name = "heat";
  prepare(&cases[0], "");
  cases[1].name = "model";
  prepare(&cases[1], default_model);
  cases[2].name = "in_place";
  cases[2].options.weights_in_place = 1;
  prepare(&cases[2], default_model);
  cases[3].name = "spectral";
  prepare(&cases[3], golden + "/spectral.sinew");
  cases[4].name = "edited";
  cases[4].options.symmetric = 1;
  cases[4].options.rigid_parts = SINEW_RIGID_PARTS_NEVER;
  cases[4].options.hints = &kSome;
  prepare(&cases[4], golden + "/broad.sinew");
  return cases;
}

// Returns the bytes of workspace that were used.
inline size_t run(const StackCase& c) {
  const sinew_mesh mesh = c.tube->mesh();
  const sinew_skeleton skeleton = c.tube->skeleton();
  sinew_bind_outputs outputs = SINEW_INIT(sinew_bind_outputs);
  outputs.joint_indices = c.joints->data();
  outputs.weights = c.weights->data();
  if (sinew_bind(c.model_bytes ? &c.model : nullptr, &mesh, &skeleton, &c.options, c.workspace.get(), c.workspace_bytes,
                 &outputs) != SINEW_OK) {
    std::abort();
  }
  return outputs.used_bytes;
}

}  // namespace sinew_test
#endif
