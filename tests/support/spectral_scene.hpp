// SPDX-License-Identifier: MIT
// A mesh taken through the spectral stage in exactly the workspace it asks for.
#ifndef SINEW_TESTS_SUPPORT_SPECTRAL_SCENE_HPP
#define SINEW_TESTS_SUPPORT_SPECTRAL_SCENE_HPP

#include <chrono>
#include <vector>

#include "mesh_scene.hpp"
#include "sinew/sinew.hpp"
#include "spectral/spectral.hpp"

namespace sinew_test {

struct SpectralRun {
  MeshRun mesh_run;
  std::vector<int16_t> rows;  // [U x kSpectralChannels]
  sinew_status status = SINEW_OK;
  size_t scratch_bytes = 0;
  double seconds = 0;

  explicit SpectralRun(const MeshScene& scene, size_t missing_bytes = 0, sinew::Progress progress = {},
                       uint8_t rubbish = 0xA5)
      : mesh_run(scene) {
    status = mesh_run.status;
    if (status != SINEW_OK) return;
    rows.assign(size_t{mesh().welded_count} * sinew::kSpectralChannels, 0);
    const auto compute = [&](sinew::Arena& arena) {
      return sinew::compute_spectral(mesh(), mesh_run.counts, progress, arena, rows.data(), sinew::kSpectralChannels);
    };
    sinew::Arena measure;
    (void)compute(measure);
    scratch_bytes = measure.high_water();
    const sinew::Workspace block(scratch_bytes);
    std::memset(block.data(), rubbish, scratch_bytes);
    sinew::Arena arena(block.data(), scratch_bytes - missing_bytes);
    const auto start = std::chrono::steady_clock::now();
    status = compute(arena);
    seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }
  const sinew::Mesh& mesh() const { return mesh_run.mesh; }
  // log2 of a signature at one of the caller's vertices.
  double at(uint32_t vertex, uint32_t channel) const {
    return rows[size_t{mesh().vertex_to_welded[vertex]} * sinew::kSpectralChannels + channel] / 1024.0;
  }
};

}  // namespace sinew_test
#endif
