// SPDX-License-Identifier: MIT
// sinew_bind() beside geodesic voxel binding with 128 cells on the characters of a folder, interleaved: CSV on standard
// output. tests/bench/peers.py puts Blender's automatic weights beside it.
//   sinew_bench_peers MODEL DIR [repeats]
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "bench_report.hpp"
#include "geodesic_voxel.hpp"
#include "sinew/sinew.hpp"
#include "sinew_formats/io.hpp"

namespace {

using sinew_bench::median;
using sinew_bench::thread_seconds;

struct Input {
  explicit Input(const sinew::Character& character) {
    for (const sinew::Vec3& p : character.vertices) positions.insert(positions.end(), {p.x, p.y, p.z});
    for (const sinew::Joint& joint : character.joints) {
      joints.insert(joints.end(), {joint.position.x, joint.position.y, joint.position.z});
      parents.push_back(joint.parent);
    }
    mesh = {positions.data(),
            static_cast<uint32_t>(character.vertices.size()),
            character.face_offsets.data(),
            character.face_vertices.data(),
            static_cast<uint32_t>(character.face_count()),
            static_cast<uint32_t>(character.face_vertices.size())};
    skeleton = {joints.data(), parents.data(), nullptr, static_cast<uint32_t>(parents.size())};
  }
  std::vector<float> positions, joints;
  std::vector<int32_t> parents;
  sinew_mesh mesh = {};
  sinew_skeleton skeleton = SINEW_INIT(sinew_skeleton);
};

int run(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "usage: sinew_bench_peers MODEL DIR [repeats]\n");
    return 2;
  }
  const int repeats = argc > 3 ? std::max(1, std::atoi(argv[3])) : 3;
  const std::vector<uint8_t> file = sinew::read_file(argv[1]);
  std::vector<uint64_t> aligned(file.size() / 8 + 1);
  std::copy(file.begin(), file.end(), reinterpret_cast<uint8_t*>(aligned.data()));
  sinew_model model;
  const sinew_status opened = sinew_model_open(aligned.data(), file.size(), &model);
  if (opened != SINEW_OK) {
    std::fprintf(stderr, "%s: %s\n", argv[1], sinew_status_text(opened));
    return 1;
  }
  std::printf("machine,compiler,commit,character,vertices,joints,sinew_s,geodesic_voxel_s,sinew_hash\n");
  sinew::Workspace workspace;
  for (const std::string& path : sinew::list_characters(argv[2])) {
    const sinew::Character character = sinew::read_character(path);
    const Input in(character);
    sinew::Skin<uint8_t> skin;
    std::vector<double> ours, peer;
    for (int i = 0; i < repeats; ++i) {
      double start = thread_seconds();
      const sinew_status status = sinew::bind(&model, in.mesh, in.skeleton, {}, &workspace, &skin);
      ours.push_back(thread_seconds() - start);
      if (status != SINEW_OK) {
        std::fprintf(stderr, "%s: %s\n", path.c_str(), sinew_status_text(status));
        return 1;
      }
      start = thread_seconds();
      const sinew_bench::GeodesicVoxelWeights other = sinew_bench::bind_geodesic_voxel(in.mesh, in.skeleton, 128);
      peer.push_back(thread_seconds() - start);
      if (other.weights.empty()) {
        std::fprintf(stderr, "%s: refused by the voxel binder\n", path.c_str());
        return 1;
      }
    }
    uint64_t hash =
        sinew_bench::fnv1a(sinew_bench::kHashStart, skin.joint_indices.data(), skin.joint_indices.size() * 2);
    hash = sinew_bench::fnv1a(hash, skin.weights.data(), skin.weights.size());
    std::printf("%s,%s,%u,%u,%.6f,%.6f,%016llx\n", sinew_bench::row_start().c_str(), character.name.c_str(),
                in.mesh.vertex_count, in.skeleton.joint_count, median(ours), median(peer),
                static_cast<unsigned long long>(hash));
    std::fflush(stdout);
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
