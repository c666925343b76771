// SPDX-License-Identifier: MIT
// Loads training samples through a cache of one file per sample, filled by several threads.
#include "data/sample_cache.hpp"

#include <unistd.h>

#include <atomic>
#include <cereal/archives/binary.hpp>
#include <cereal/types/string.hpp>
#include <cereal/types/vector.hpp>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <mutex>
#include <optional>
#include <sstream>

#include "core/random.hpp"
#include "data/cache_file.hpp"
#include "features/features.hpp"
#include "sinew_data_sets/dataset.hpp"
#include "sinew_formats/base/thread_pool.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/file_kinds.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/print.hpp"

namespace sinew {

template <class Archive>
void serialize(Archive& archive, NetworkSample::Input& input) {
  archive(input.channels, input.rows);
}
template <class Archive>
void serialize(Archive& archive, Sample& s) {
  archive(s.name, s.family, s.vertices, s.candidates, s.part_count, s.joints, s.inputs, s.candidate, s.row_offsets,
          s.col_indices, s.part, s.part_offsets, s.part_vertices, s.target, s.fold, s.missing, s.importance, s.owner,
          s.heat, s.vertex_to_welded, s.positions, s.joint_positions, s.parents);
}

namespace {

constexpr uint64_t kCacheVersion = 5;  // grows whenever the file's layout or, in its last bits, a feature changes

// Parts of a request. The files of a character are read in any case, since they are the key of the cache.
struct SampleInputs {
  std::string stem;              // of the cache file
  std::vector<uint8_t> content;  // that the sample depends on, beside the settings
  std::optional<Character> character;
};

SampleInputs gather(const SampleRequest& request) {
  SampleInputs out;
  if (!request.mesh_path.empty()) {
    out.stem = stem_of(request.mesh_path);
    out.content = read_file(request.mesh_path);
    if (std::filesystem::exists(rig_path_beside(request.mesh_path))) {
      const std::vector<uint8_t> rig = read_file(rig_path_beside(request.mesh_path));
      out.content.insert(out.content.end(), rig.begin(), rig.end());
    }
    return out;
  }
  SynthesizeOptions options;
  options.plan = request.plan;
  options.seed = request.synthetic_seed;
  out.character = synthesize(options);
  out.stem = out.character->name =
      "synthetic_" + std::string(body_plan_name(request.plan)) + "__" + std::to_string(request.synthetic_seed);
  const auto add = [&](const void* data, size_t size) {
    const auto* bytes = static_cast<const uint8_t*>(data);
    out.content.insert(out.content.end(), bytes, bytes + size);
  };
  for (const Vec3& p : out.character->vertices) add(&p, sizeof p);
  for (const Joint& joint : out.character->joints) {
    add(&joint.position, sizeof joint.position);
    add(&joint.parent, sizeof joint.parent);
  }
  add(out.character->face_vertices.data(), out.character->face_vertices.size() * sizeof(uint32_t));
  for (const auto& row : out.character->influences) {
    for (const Influence& i : row) {
      add(&i.joint, sizeof i.joint);
      add(&i.weight, sizeof i.weight);
    }
  }
  return out;
}

uint64_t settings_of(const SampleRequest& request, const SampleSource& source) {
  uint64_t settings =
      mix_seeds(kCacheVersion, kFeatureSet | source.feature_flags, (uint64_t{kVertexFeatures} << 32) | kPairFeatures);
  settings = mix_seeds(settings, source.candidates, source.grid);
  if (source.vertex_limit != 0) settings = mix_seeds(settings, 0x6C696D6974, source.vertex_limit);
  if (request.variant != 0) settings = mix_seeds(settings, mix_seeds(kAugmentVersion, source.seed), request.variant);
  return settings;
}

std::optional<Sample> read_cached(const std::string& path) {
  const std::optional<std::string> payload = read_cache_file(path, kCacheVersion);
  if (!payload) return std::nullopt;
  std::istringstream stream(*payload, std::ios::binary);
  Sample sample;
  cereal::BinaryInputArchive archive(stream);
  archive(sample);
  return sample;
}

void write_cached(const std::string& path, Sample& sample) {
  std::ostringstream stream(std::ios::binary);
  cereal::BinaryOutputArchive{stream}(sample);
  write_cache_file(path, kCacheVersion, stream.str());
}

}  // namespace

namespace {

std::string cache_path(const SampleInputs& from, const SampleRequest& request, const SampleSource& source) {
  return (std::filesystem::path(source.cache_dir) /
          (from.stem + "-" + cache_key(from.content.data(), from.content.size(), settings_of(request, source)) +
           ".sample"))
      .string();
}

Sample make_cached(SampleInputs&& from, const SampleRequest& request, const SampleSource& source,
                   const std::string& path) {
  Character character = from.character ? std::move(*from.character) : read_character(request.mesh_path);
  const size_t limit = source.vertex_limit, vertices = character.vertices.size();
  if (limit != 0 && vertices > limit && character.face_count() > 0) {
    character = decimate(character, static_cast<double>(limit) / static_cast<double>(vertices));
  }
  if (request.variant != 0) {
    const uint64_t name = hash_bytes(reinterpret_cast<const uint8_t*>(character.name.data()), character.name.size(), 0);
    character = augment(character, mix_seeds(source.seed, request.variant, name));
  }
  Sample sample = make_sample(character, source.candidates, source.grid, source.feature_flags);
  write_cached(path, sample);
  return sample;
}

// Counts on stderr: on a terminal a line that is written over, else every 25th sample.
class FeatureProgress {
 public:
  FeatureProgress(const SampleSource& source, size_t total, const char* by)
      : quiet_(source.quiet), silent_(source.silent), terminal_(isatty(STDERR_FILENO) != 0), total_(total), by_(by) {}

  void made() {
    const std::lock_guard<std::mutex> lock(lock_);
    ++made_;
  }
  void left_out(const char* why) {
    const std::lock_guard<std::mutex> lock(lock_);
    if (!silent_) std::fprintf(stderr, "%sleft out: %s\n", terminal_ && done_ > 0 && !quiet_ ? "\n" : "", why);
  }
  void step() {
    const std::lock_guard<std::mutex> lock(lock_);
    ++done_;
    const bool last = done_ == total_;
    if (quiet_ || !(terminal_ || last || done_ % 25 == 0)) return;
    std::fprintf(stderr, "%sfeatures: %zu of %zu samples, %zu made %s%s", terminal_ ? "\r" : "", done_, total_, made_,
                 by_, last || !terminal_ ? "\n" : "");
    std::fflush(stderr);
  }
  size_t made_count() const { return made_; }  // when all threads are done

 private:
  const bool quiet_, silent_, terminal_;
  const size_t total_;
  const char* const by_;
  std::mutex lock_;
  size_t done_ = 0, made_ = 0;
};

void make_cache_folder(const SampleSource& source) {
  std::error_code failure;
  std::filesystem::create_directories(source.cache_dir, failure);
  if (failure) throw Error(source.cache_dir + ": cannot create the cache folder: " + failure.message());
}

}  // namespace

size_t fill_cache(const std::vector<SampleRequest>& requests, const SampleSource& source, uint32_t part,
                  uint32_t parts) {
  make_cache_folder(source);
  // Own part in rising order; what others have left in falling order, so that it meets them where they are not yet.
  std::vector<size_t> order;
  for (size_t i = 0; i < requests.size(); ++i) {
    if (i % parts == part) order.push_back(i);
  }
  for (size_t i = requests.size(); i-- > 0;) {
    if (i % parts != part) order.push_back(i);
  }
  std::atomic<size_t> failed{0};
  FeatureProgress progress(source, requests.size(), "by this process");
  parallel_for(order.size(), source.threads, [&](size_t item, unsigned) {
    const SampleRequest& request = requests[order[item]];
    try {
      SampleInputs from = gather(request);
      const std::string path = cache_path(from, request, source);
      if (!read_cache_file(path, kCacheVersion)) {
        make_cached(std::move(from), request, source, path);
        progress.made();
      }
    } catch (const Error& error) {
      ++failed;
      progress.left_out(error.what());
    }
    progress.step();
  });
  if (failed == requests.size() && !requests.empty()) {
    throw Error(requests[0].mesh_path + ": neither this nor any other of the " + std::to_string(requests.size()) +
                " characters could be used; see the lines above");
  }
  return progress.made_count();
}

std::vector<Sample> load_requests(const std::vector<SampleRequest>& requests, const SampleSource& source) {
  make_cache_folder(source);
  std::vector<std::optional<Sample>> loaded(requests.size());
  FeatureProgress progress(source, requests.size(), "anew");
  parallel_for(requests.size(), source.threads, [&](size_t item, unsigned) {
    const SampleRequest& request = requests[item];
    try {
      SampleInputs from = gather(request);
      const std::string path = cache_path(from, request, source);
      loaded[item] = read_cached(path);
      if (!loaded[item]) {
        loaded[item] = make_cached(std::move(from), request, source, path);
        progress.made();
      }
    } catch (const Error& error) {
      progress.left_out(error.what());
    }
    if (loaded[item] && !request.name.empty()) loaded[item]->name = request.name;
    progress.step();
  });
  std::vector<Sample> samples;
  for (std::optional<Sample>& sample : loaded) {
    if (sample) samples.push_back(std::move(*sample));
  }
  if (samples.empty() && !requests.empty()) {
    throw Error(requests[0].mesh_path + ": neither this nor any other of the " + std::to_string(requests.size()) +
                " characters could be used; see the lines above");
  }
  return samples;
}

}  // namespace sinew
