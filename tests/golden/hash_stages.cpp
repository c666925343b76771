// SPDX-License-Identifier: MIT
// Prints one hash per stage of a bind for OBJ + rig.txt characters: what must be equal on every target and build type.
//   hash_stages [--kernel NAME] [--model FILE] NAME.obj...      (NAME.rig.txt beside each)
//   hash_stages [--kernel NAME] --set FILE      the lines of tests/golden/set.txt, then one hash over all of them
//   hash_stages --kernels      the kernels that run here, one a line
// Needs the engine alone; its own small reader keeps it free of packages, so that it cross-compiles.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>
#include <string>
#include <vector>

#include "../support/rig_skeleton.hpp"
#include "../support/skeleton_of.hpp"
#include "bind/bind.hpp"
#include "kernels/select.hpp"
#include "network/network.hpp"
#include "sinew/motion_clips.h"
#include "sinew/published.h"
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

Hash all_printed;

void print(const char* name, const char* stage, const Hash& hash) {
  std::printf("%s %s %016llx\n", name, stage, static_cast<unsigned long long>(hash.state));
  std::fflush(stdout);  // a target that dies names the stage it died in
  all_printed.add(name, std::strlen(name));
  all_printed.add(stage, std::strlen(stage));
  all_printed.add(&hash.state, 1);
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
  std::vector<std::string> names;
  sinew_mesh mesh = {};
  sinew_skeleton skeleton = SINEW_INIT(sinew_skeleton);
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
  std::vector<std::string>& names = in.names;
  const auto rig = read_words(obj.substr(0, obj.size() - 4) + ".rig.txt");
  for (const auto& line : rig) {
    if (line.empty() || line[0] != "joints") continue;
    names.push_back(line[1]);
    for (size_t i = 2; i < 5; ++i) in.joints.push_back(std::strtof(line[i].c_str(), nullptr));
  }
  in.parents.assign(names.size(), -1);
  auto index = [&](const std::string& name) -> int32_t {
    for (size_t i = 0; i < names.size(); ++i) {
      if (names[i] == name) return static_cast<int32_t>(i);
    }
    std::fprintf(stderr, "hash_stages: %s: no joint is called %s\n", obj.c_str(), name.c_str());
    std::exit(1);
  };
  for (const auto& line : rig) {
    if (!line.empty() && line[0] == "hier") in.parents[static_cast<size_t>(index(line[2]))] = index(line[1]);
  }
  in.mesh = {
      in.positions.data(), static_cast<uint32_t>(in.positions.size() / 3), in.offsets.data(),
      in.corners.data(),   static_cast<uint32_t>(in.offsets.size() - 1),   static_cast<uint32_t>(in.corners.size())};
  in.skeleton = sinew_test::skeleton_of(in.joints.data(), in.parents.data(), static_cast<uint32_t>(names.size()));
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

void hash_prepared(const char* name, const PreparedBind& p, uint32_t k) {
  const size_t u = p.mesh.welded_count;
  Hash mesh, skeleton, heat, candidates, features;
  mesh.add(p.mesh.positions, u);
  mesh.add(p.mesh.triangles, static_cast<size_t>(p.mesh.triangle_count) * 3);
  mesh.add(p.mesh.normals, u);
  mesh.add(p.mesh.areas, u);
  mesh.add(p.mesh.mean_curvature, u);
  mesh.add(p.mesh.gauss_curvature, u);
  mesh.add(p.mesh.part, u);
  skeleton.add(p.skeleton.positions, p.skeleton.joint_count);
  skeleton.add(p.skeleton.bone_tail, p.skeleton.joint_count);
  skeleton.add(p.source_joints, p.skeleton.joint_count);
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
  std::vector<int16_t> rows(size_t{mesh.welded_count} * kSpectralChannels);
  const auto compute = [&](Arena& arena) {
    return compute_spectral(mesh, counts, {}, arena, rows.data(), kSpectralChannels);
  };
  Arena measuring;
  check(compute(measuring));
  Block block(measuring.high_water());
  Arena arena(block.data, measuring.high_water());
  check(compute(arena));
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
  sinew_bind_options options = SINEW_INIT(sinew_bind_options);
  options.kernel = kernel;
  options.method = method;
  size_t bytes = 0;
  check(sinew_bind_workspace_size(model, in.mesh.vertex_count, in.mesh.face_count, in.mesh.corner_count,
                                  in.skeleton.joint_count, &options, &bytes));
  Block block(bytes);
  std::vector<uint16_t> joints(in.mesh.vertex_count * size_t{4}), weights(joints.size());
  sinew_bind_outputs outputs = SINEW_INIT(sinew_bind_outputs);
  outputs.joint_indices = joints.data();
  outputs.weights = weights.data();
  check(sinew_bind(model, &in.mesh, &in.skeleton, &options, block.data, bytes, &outputs));
  Hash hash;
  hash.add(joints.data(), joints.size());
  hash.add(weights.data(), weights.size());
  print(name, stage, hash);
}

// Bytes of a file where sinew_model_open() wants them.
struct ModelFile {
  explicit ModelFile(const char* path, bool rig = false) {
    const std::vector<uint8_t> bytes = read_all(path);
    aligned.resize(bytes.size() / 8 + 1);
    std::memcpy(aligned.data(), bytes.data(), bytes.size());
    check(rig ? sinew_rig_model_open(aligned.data(), bytes.size(), &model)
              : sinew_model_open(aligned.data(), bytes.size(), &model));
  }
  std::vector<uint64_t> aligned;
  sinew_model model = {};
};

void hash_stages(const char* name, const Input& in, uint32_t candidates, uint32_t grid, uint32_t kernel) {
  Counts counts;
  check(make_counts(in.mesh.vertex_count, in.mesh.face_count, in.mesh.corner_count, in.skeleton.joint_count, candidates,
                    grid, &counts));
  Kernels kernels;
  check(select_kernels(kernel, &kernels) ? SINEW_OK : SINEW_ERROR_KERNEL);
  PreparedBind p;
  const auto run = [&](Arena& arena) {
    return prepare(in.mesh, in.skeleton, 0, counts, PreparePurpose::kNetwork, kernels, {}, arena, &p);
  };
  Arena measuring;
  check(run(measuring));
  Block block(measuring.high_water());
  Arena arena(block.data, measuring.high_water());
  check(run(arena));
  hash_prepared(name, p, candidates);
  hash_spectral(name, p.mesh, counts);
}

// One line of a set: "CHARACTER.obj KEY=VALUE ...". Without a model all stages before the network are printed, with one
// what sinew_bind() writes. `model=heat` is the heat method.
struct SetLine {
  explicit SetLine(const std::vector<std::string>& words) : character(words[0]) {
    for (size_t i = 1; i < words.size(); ++i) {
      const size_t split = words[i].find('=');
      const std::string key = words[i].substr(0, split);
      const char* const text = split == std::string::npos ? "" : words[i].c_str() + split + 1;
      const uint32_t value = static_cast<uint32_t>(std::strtoul(text, nullptr, 10));
      if (key == "model") {
        model = text;
      } else if (key == "map") {
        source = text;
      } else if (key == "to") {
        target = text;
      } else if (uint32_t* const option = find(key)) {
        *option = value;
      } else {
        std::fprintf(stderr, "hash_stages: a line of the set has the unknown key %s\n", key.c_str());
        std::exit(2);
      }
    }
  }

  uint32_t* find(const std::string& key) {
    if (key == "grid") return &options.grid_size;
    if (key == "candidates") return &options.candidate_count;
    if (key == "influences") return &options.influence_count;
    if (key == "format") return &options.weight_format;
    if (key == "up") return &z_up;
    if (key == "symmetric") return &options.symmetric;
    if (key == "rigid") return &options.rigid_parts;
    if (key == "softness") return &options.softness_percent;
    if (key == "in-place") return &options.weights_in_place;
    if (key == "surface") return &options.surface_vertices;
    if (key == "hints") return &hint_step;
    if (key == "answers") return &answer_step;
    if (key == "questions") return &options.question_count;
    if (key == "confidence") return &confidence;
    if (key == "rig") return &rig;
    if (key == "details") return &details;
    if (key == "deform") return &deform;
    if (key == "cells") return &deform_options.cell_count;
    if (key == "distance") return &by_distance;
    if (key == "contact") return &deform_options.body_contact;
    if (key == "turns") return &turns;
    if (key == "method") return &rig_options.method;
    if (key == "category") return &rig_options.category;
    if (key == "mirror") return &rig_options.mirror;
    if (key == "spine") return &rig_options.spine_count;
    if (key == "names") return &names;
    if (key == "pin") return &pin;
    if (key == "no-toes") return &rig_options.without;  // 1: SINEW_WITHOUT_TOES
    if (key == "motion") return &motion_frames;
    if (key == "springs") return &spring_frames;
    if (key == "transfer") return &transfer.method;
    if (key == "garment") return &transfer.garment;
    if (key == "as-drawn") return &transfer.as_drawn;
    if (key == "locked") return &locked_step;
    return nullptr;
  }

  std::string character, model;
  std::string
      source;  // the character whose joints are mapped to this one's; method, names, up (1 = guessed) and pin count
  uint32_t names = 0;
  uint32_t pin = 0;  // joint of the target that has the source's joint 1, if it is not 0
  sinew_bind_options options = SINEW_INIT(sinew_bind_options);
  uint32_t z_up = 0;         // 1: Z is up; with a source 1: not known
  uint32_t hint_step = 0;    // every so many vertices one is a hint
  uint32_t answer_step = 0;  // every so many vertices one's part has an answer, of the kinds in turn
  uint32_t confidence = 0;
  uint32_t rig = 0;      // 1: a skeleton for the mesh alone
  uint32_t details = 0;  // 1: the skeleton grows by what sinew_rig_details() finds
  sinew_rig_options rig_options = SINEW_INIT(sinew_rig_options);
  uint32_t motion_frames = 0;  // so many frames of a made-up motion retargeted to the character's skeleton
  uint32_t spring_frames = 0;  // so many frames of a made-up motion behind which chains of the character's swing
  uint32_t by_distance = 0;    // 1: weights by distance in place of heat
  uint32_t deform = 0;         // 1 + the method: a pose of the mesh as it is bound by heat
  sinew_deform_options deform_options = SINEW_INIT(sinew_deform_options);
  uint32_t turns = 1;  // so many times the angle of the pose
  std::string target;  // the character that takes the weights of this one, if any
  sinew_transfer_options transfer = SINEW_INIT(sinew_transfer_options);
  uint32_t locked_step = 0;  // every so many vertices one is locked
};

std::vector<sinew_answer> make_answers(uint32_t step, const Input& in) {
  std::vector<sinew_answer> answers;
  for (uint32_t v = 0; step != 0 && v < in.mesh.vertex_count; v += step) {
    const uint32_t number = v / step, kind = number % 6;
    const uint32_t joint = kind == SINEW_ANSWER_RIGID ? number % in.skeleton.joint_count : 0;
    answers.push_back({v, static_cast<uint16_t>(kind), static_cast<uint16_t>(joint), number / 6 % 2});
  }
  return answers;
}

// Member by member: a hash over bytes would depend on their order.
Hash hash_questions(const std::vector<sinew_question>& questions, const std::vector<uint32_t>& vertex_questions,
                    const std::vector<uint32_t>& vertex_parts) {
  Hash hash;
  for (const sinew_question& q : questions) {
    for (const uint32_t value : {q.vertex, q.part_count, q.vertex_count, uint32_t{q.joint}, uint32_t{q.share}, q.doubt,
                                 q.gain, q.alternative_count})
      hash.add(&value, 1);
    for (uint32_t a = 0; a < q.alternative_count; ++a) {
      for (const uint32_t value :
           {uint32_t{q.alternatives[a].kind}, uint32_t{q.alternatives[a].joint}, q.alternatives[a].change})
        hash.add(&value, 1);
    }
  }
  hash.add(vertex_questions.data(), vertex_questions.size());
  hash.add(vertex_parts.data(), vertex_parts.size());
  return hash;
}

// Everything that sinew_bind() gives to a caller, its status and memory included.
void hash_line(const char* name, const SetLine& line, const Input& in, const sinew_model* model, uint32_t kernel) {
  sinew_bind_options options = line.options;
  options.method = model != nullptr ? SINEW_METHOD_MODEL : SINEW_METHOD_HEAT;
  if (model == nullptr && line.by_distance != 0) options.method = SINEW_METHOD_DISTANCE;
  const uint32_t vertices = in.mesh.vertex_count;
  const size_t slots = size_t{vertices} * (options.influence_count != 0 ? options.influence_count : 4);
  std::vector<uint16_t> joints(slots, 0);
  // One array for each format: rows are values of their own width, which a hash over bytes would not see.
  std::vector<uint16_t> wide(slots, 0);
  std::vector<uint8_t> narrow(slots, 0), hints(vertices, 0), confidence(vertices, 0);
  std::vector<float> real(slots, 0);
  void* weights = wide.data();
  if (options.weight_format == SINEW_WEIGHT_UNORM8) weights = narrow.data();
  if (options.weight_format == SINEW_WEIGHT_FLOAT) weights = real.data();
  for (uint32_t v = 0; line.hint_step != 0 && v < vertices; v += line.hint_step) {
    const size_t first = v * (slots / vertices);
    hints[v] = 1;
    joints[first] = static_cast<uint16_t>(v / line.hint_step % in.skeleton.joint_count);
    wide[first] = 65535;
    narrow[first] = 255;
    real[first] = 1;
  }
  sinew_bind_outputs outputs = SINEW_INIT(sinew_bind_outputs);
  outputs.joint_indices = joints.data();
  outputs.weights = weights;
  if (line.hint_step != 0) options.hints = hints.data();
  if (line.confidence != 0) outputs.confidence = confidence.data();
  const std::vector<sinew_answer> answers = make_answers(line.answer_step, in);
  options.answers = answers.empty() ? nullptr : answers.data();
  options.answer_count = static_cast<uint32_t>(answers.size());
  std::vector<sinew_question> questions(options.question_count);
  std::vector<uint32_t> vertex_questions(questions.empty() ? 0 : vertices, 0), vertex_parts(vertex_questions);
  if (!questions.empty()) {
    outputs.questions = questions.data();
    outputs.vertex_questions = vertex_questions.data();
    outputs.vertex_parts = vertex_parts.data();
  }

  // Asked for the automatic kernel: the same on every host. The reference alone, when forced, needs less.
  size_t bytes = 0;
  check(sinew_bind_workspace_size(model, vertices, in.mesh.face_count, in.mesh.corner_count, in.skeleton.joint_count,
                                  &options, &bytes));
  options.kernel = kernel;
  Block block(bytes);
  sinew_skeleton skeleton = in.skeleton;
  skeleton.up = line.z_up != 0 ? SINEW_UP_Z : SINEW_UP_Y;
  check(sinew_bind(model, &in.mesh, &skeleton, &options, block.data, bytes, &outputs));
  Hash memory, rows, extras;
  const uint64_t size = bytes;
  memory.add(&size, 1);
  rows.add(joints.data(), slots);
  rows.add(wide.data(), slots);
  rows.add(narrow.data(), slots);
  std::vector<uint32_t> bits(slots);
  std::memcpy(bits.data(), real.data(), slots * sizeof(uint32_t));
  rows.add(bits.data(), slots);
  extras.add(confidence.data(), vertices);
  extras.add(&outputs.symmetric_vertices, 1);
  print(name, "memory", memory);
  print(name, "rows", rows);
  if (line.confidence != 0 || options.symmetric != 0) print(name, "extras", extras);
  questions.resize(outputs.questions_written);
  if (options.question_count != 0) print(name, "questions", hash_questions(questions, vertex_questions, vertex_parts));
}

// The arrays of a skeleton, with room.
struct HashedRig : sinew_test::RigSkeleton {
  void print_hashes(const char* name, uint64_t size) const {
    const size_t count = outputs.joint_count;
    Hash memory, joints, names_hash;
    memory.add(&size, 1);
    std::vector<uint32_t> bits(3 * count + 2);
    std::memcpy(bits.data(), positions.data(), 3 * count * sizeof(uint32_t));
    std::memcpy(bits.data() + 3 * count, &outputs.plane, sizeof(uint32_t));
    std::memcpy(bits.data() + 3 * count + 1, &outputs.spread, sizeof(uint32_t));
    joints.add(bits.data(), bits.size());
    joints.add(parents.data(), count);
    joints.add(partners.data(), count);
    joints.add(flags.data(), count);
    joints.add(classes.data(), count);
    joints.add(confidence.data(), count);
    joints.add(parent_confidence.data(), count);
    joints.add(&outputs.mirrored, 1);
    joints.add(&outputs.facing, 1);
    for (size_t j = 0; j < count; ++j) {
      const char* const own = outputs.names[j];
      names_hash.add(reinterpret_cast<const uint8_t*>(own), std::strlen(own));
    }
    print(name, "memory", memory);
    print(name, "joints", joints);
    print(name, "names", names_hash);
  }
};

// Everything that sinew_rig() gives to a caller.
void hash_rig(const char* name, const SetLine& line, const Input& in, const sinew_model& model, uint32_t kernel) {
  sinew_rig_options options = line.rig_options;
  options.up = line.z_up != 0 ? SINEW_UP_Z : SINEW_UP_Y;
  options.weights_in_place = line.options.weights_in_place;
  HashedRig arrays;
  size_t bytes = 0;
  check(sinew_rig_workspace_size(&model, in.mesh.vertex_count, in.mesh.face_count, in.mesh.corner_count, &options,
                                 &bytes));
  options.kernel = kernel;
  Block block(bytes);
  check(sinew_rig(&model, &in.mesh, &options, block.data, bytes, &arrays.outputs));
  arrays.print_hashes(name, bytes);
}

// The character's own skeleton with fingers, faces and props; joints are for what their names end in.
void hash_details(const char* name, const SetLine& line, const Input& in, const sinew_model& model, uint32_t kernel) {
  sinew_rig_options options = line.rig_options;
  options.up = line.z_up != 0 ? SINEW_UP_Z : SINEW_UP_Y;
  options.weights_in_place = line.options.weights_in_place;
  HashedRig arrays;
  const uint32_t count = in.skeleton.joint_count;
  for (uint32_t j = 0; j < count; ++j) {
    const std::string& text = in.names[j];
    const auto ends_in = [&](const std::string& word) {
      return text.size() >= word.size() && text.compare(text.size() - word.size(), word.size(), word) == 0;
    };
    const uint8_t joint_class = ends_in("Hand")      ? SINEW_CLASS_HAND
                                : ends_in("ForeArm") ? SINEW_CLASS_FOREARM
                                : ends_in("Head")    ? SINEW_CLASS_HEAD
                                                     : SINEW_CLASS_OTHER;
    const float* const p = &in.joints[3 * j];
    arrays.add(text, p[0], p[1], p[2], in.parents[j], joint_class, ends_in("_end") ? SINEW_JOINT_NEVER : 0, -1);
  }
  size_t bytes = 0;
  const auto measure = [&](uint32_t wanted, size_t* size) {
    size_t one = 0;
    check(sinew_rig_details_workspace_size(&model, in.mesh.vertex_count, in.mesh.face_count, in.mesh.corner_count,
                                           wanted, &options, &one));
    *size = one > *size ? one : *size;
  };
  constexpr uint32_t kDetails[] = {SINEW_DETAIL_HANDS, SINEW_DETAIL_FACE, SINEW_DETAIL_PROPS};
  for (const uint32_t wanted : kDetails) measure(wanted, &bytes);
  options.kernel = kernel;
  Block block(bytes);
  for (const uint32_t wanted : kDetails)
    check(sinew_rig_details(&model, &in.mesh, wanted, &options, block.data, bytes, &arrays.outputs));
  arrays.print_hashes(name, bytes);
}

// Everything that sinew_map() gives to a caller.
void hash_map(const char* name, const SetLine& line, const Input& in, const Input& source) {
  std::vector<const char*> names[2];
  const auto rig_of = [&](const Input& of, std::vector<const char*>* texts) {
    sinew_skeleton rig = sinew_test::skeleton_of(of.joints.data(), of.parents.data(), of.skeleton.joint_count);
    for (const std::string& one : of.names) texts->push_back(one.c_str());
    if (line.names != 0) rig.names = texts->data();
    if (line.z_up == 0) rig.up = SINEW_UP_Y;
    return rig;
  };
  const sinew_skeleton to = rig_of(in, &names[0]), from = rig_of(source, &names[1]);
  const sinew_map_pin pin = {line.pin, 1};
  sinew_map_options options = SINEW_INIT(sinew_map_options);
  options.method = line.rig_options.method;
  options.pins = &pin;
  options.pin_count = line.pin != 0 ? 1 : 0;
  size_t bytes = 0;
  check(sinew_map_workspace_size(to.joint_count, from.joint_count, &bytes));
  Block block(bytes);
  std::vector<int32_t> sources(to.joint_count, 0);
  std::vector<uint16_t> confidence(to.joint_count, 0);
  std::vector<uint8_t> reasons(to.joint_count, 0);
  sinew_map_outputs outputs = SINEW_INIT(sinew_map_outputs);
  outputs.sources = sources.data();
  outputs.confidence = confidence.data();
  outputs.reasons = reasons.data();
  check(sinew_map(&to, &from, &options, block.data, bytes, &outputs));
  Hash memory, map;
  const uint64_t size = bytes;
  memory.add(&size, 1);
  map.add(sources.data(), sources.size());
  map.add(confidence.data(), confidence.size());
  map.add(reasons.data(), reasons.size());
  map.add(&outputs.method, 1);
  map.add(&outputs.certainty, 1);
  print(name, "memory", memory);
  print(name, "map", map);
}

// The frames of a motion as they come, twice: on the mesh with natural ranges and an uneven floor, and on the joints alone.
void hash_stream(const char* name, const sinew_skeleton& source, const sinew_skeleton& target,
                 const std::vector<int32_t>& map, const std::vector<uint8_t>& classes, const sinew_motion_body& body,
                 const std::vector<float>& turns, const std::vector<float>& positions) {
  const size_t joints = target.joint_count;
  const float steps[] = {0, 0.02f, 0.05f, 0.01f, 0.03f, 0};
  const sinew_floor floor = {steps, 3, 2, {-0.2f, -0.1f}, 0.25f, 0};
  Hash poses;
  for (const bool on_mesh : {true, false}) {
    sinew_retarget_stream_options options = SINEW_INIT(sinew_retarget_stream_options);
    options.fps = on_mesh ? 30 : 60;
    if (!on_mesh) options.without = SINEW_WITHOUT_RANGE;
    if (on_mesh) options.floor = &floor;
    size_t bytes = 0;
    check(sinew_retarget_stream_workspace_size(target.joint_count, target.joint_count, on_mesh ? body.vertex_count : 0,
                                               on_mesh ? body.triangle_count : 0, &bytes));
    Block block(bytes);
    sinew_retarget_stream* stream = nullptr;
    check(sinew_retarget_stream_create(&source, &target, map.data(), classes.data(), nullptr, on_mesh ? &body : nullptr,
                                       &options, block.data, bytes, &stream));
    std::vector<float> out(7 * joints);
    std::vector<uint32_t> bits(out.size());
    for (size_t f = 0; f < turns.size() / (4 * joints); ++f) {
      check(sinew_retarget_stream_frame(stream, turns.data() + 4 * joints * f, positions.data() + 3 * joints * f,
                                        out.data(), out.data() + 4 * joints));
      std::memcpy(bits.data(), out.data(), out.size() * sizeof(uint32_t));
      poses.add(bits.data(), bits.size());
    }
  }
  print(name, "stream", poses);
}

// A source of the character's own joints, larger, on its side and in another rest pose, and frames in which everything
// turns: numbers of a small generator, no libm. Every fifth joint has no source; classes follow the depth, so that there are
// legs and arms.
void hash_motion(const char* name, const SetLine& line, const Input& in) {
  const uint32_t joints = in.skeleton.joint_count;
  uint32_t state = 7;
  const auto draw = [&state] {
    state = state * 1664525u + 1013904223u;
    return static_cast<float>(static_cast<int32_t>(state >> 8) - (1 << 23)) / static_cast<float>(1 << 23);
  };
  const uint8_t by_depth[] = {SINEW_CLASS_PELVIS,    SINEW_CLASS_THIGH,   SINEW_CLASS_CALF, SINEW_CLASS_FOOT,
                              SINEW_CLASS_UPPER_ARM, SINEW_CLASS_FOREARM, SINEW_CLASS_HAND, SINEW_CLASS_OTHER};
  std::vector<float> positions, rotations;
  std::vector<int32_t> map;
  std::vector<uint8_t> classes;
  for (uint32_t j = 0; j < joints; ++j) {
    const float* const p = in.joints.data() + size_t{3} * j;
    positions.insert(positions.end(), {1.5f * p[0] + 0.05f * draw(), -1.5f * p[2], 1.5f * p[1] + 0.05f * draw()});
    rotations.insert(rotations.end(), {draw(), draw(), draw(), 2 + draw()});
    map.push_back(j % 5 == 4 ? -1 : static_cast<int32_t>(j));
    uint32_t depth = 0;
    for (int32_t up = in.parents[j]; up >= 0 && depth < 7; up = in.parents[static_cast<size_t>(up)]) ++depth;
    classes.push_back(by_depth[depth]);
  }
  sinew_skeleton source = sinew_test::skeleton_of(positions.data(), in.parents.data(), joints);
  source.rotations = rotations.data();
  sinew_skeleton target = sinew_test::skeleton_of(in.joints.data(), in.parents.data(), joints);
  size_t bytes = 0;
  check(sinew_retarget_create_workspace_size(joints, joints, &bytes));
  Block block(bytes);
  sinew_retarget* plan = nullptr;
  check(sinew_retarget_create(&source, &target, map.data(), classes.data(), nullptr, block.data, bytes, &plan));
  std::vector<float> turns, translations, heights;
  for (uint32_t f = 0; f < line.motion_frames; ++f) {
    heights.push_back(0);
    for (uint32_t j = 0; j < joints; ++j) {
      turns.insert(turns.end(), {0.1f * draw(), 0.1f * draw(), 0.1f * draw(), 2 + draw()});
      translations.insert(translations.end(), {0.2f * draw(), 0.2f * draw(), 0.2f * draw()});
    }
    check(sinew_retarget_height(plan, turns.data() + size_t{4} * joints * f,
                                translations.data() + size_t{3} * joints * f, &heights[f]));
  }
  float ground = 0;
  check(sinew_retarget_ground(plan, heights.data(), heights.size(), &ground));
  Hash poses;
  const auto add = [&poses](const std::vector<float>& values) {
    std::vector<uint32_t> bits(values.size());
    std::memcpy(bits.data(), values.data(), values.size() * sizeof(uint32_t));
    poses.add(bits.data(), bits.size());
  };
  add(heights);
  add({ground});
  std::vector<float> out_rotations(turns.size()), out_positions(translations.size());
  for (uint32_t f = 0; f < line.motion_frames; ++f) {
    const size_t four = size_t{4} * joints * f, three = size_t{3} * joints * f;
    check(sinew_retarget_frame(plan, turns.data() + four, translations.data() + three, ground,
                               out_rotations.data() + four, out_positions.data() + three));
  }
  add(out_rotations);
  add(out_positions);
  print(name, "motion", poses);
  // Contacts between the mesh and a larger one on its side, each vertex bound to the nearest joint.
  std::vector<float> body;
  std::vector<uint16_t> nearest;
  for (uint32_t v = 0; v < in.mesh.vertex_count; ++v) {
    const float* const p = in.positions.data() + size_t{3} * v;
    body.insert(body.end(), {1.5f * p[0], -1.5f * p[2], 1.25f * p[1]});
    double least = 0;
    nearest.push_back(0);
    for (uint32_t j = 0; j < joints; ++j) {
      double square = 0;
      for (size_t i = 0; i < 3; ++i) {
        const double way = static_cast<double>(p[i]) - static_cast<double>(in.joints[size_t{3} * j + i]);
        square += way * way;
      }
      if (j > 0 && square >= least) continue;
      least = square;
      nearest.back() = static_cast<uint16_t>(j);
    }
  }
  const std::vector<uint16_t> whole(nearest.size(), 65535);
  std::vector<uint32_t> triangles;
  for (uint32_t f = 0; f < in.mesh.face_count; ++f) {
    for (uint32_t c = in.offsets[f] + 2; c < in.offsets[f + 1]; ++c)
      triangles.insert(triangles.end(), {in.corners[in.offsets[f]], in.corners[c - 1], in.corners[c]});
  }
  const uint32_t vertices = in.mesh.vertex_count, triangle_count = static_cast<uint32_t>(triangles.size() / 3);
  const sinew_motion_body own = {in.positions.data(),
                                 triangles.data(),
                                 {nearest.data(), whole.data(), 1, SINEW_WEIGHT_UNORM16},
                                 vertices,
                                 triangle_count};
  const sinew_motion_body other = {
      body.data(), nullptr, {nearest.data(), whole.data(), 1, SINEW_WEIGHT_UNORM16}, vertices, 0};
  const std::vector<float> copied_rotations = out_rotations, copied_positions = out_positions;
  const sinew_motion_clip clip = {turns.data(),         translations.data(), out_rotations.data(),
                                  out_positions.data(), line.motion_frames,  ground};
  check(sinew_retarget_contacts_workspace_size(plan, &own, line.motion_frames, &bytes));
  Block workspace(bytes);
  check(sinew_retarget_contacts(plan, &other, &own, &clip, nullptr, workspace.data, bytes));
  poses = Hash();
  add(out_rotations);
  add(out_positions);
  const auto measure = [&](const sinew_motion_body* from) {
    sinew_limb_quality limbs[SINEW_MAX_MOTION_LIMBS];
    uint32_t count = 0;
    check(sinew_retarget_measure(plan, from, &own, &clip, nullptr, workspace.data, bytes, limbs, &count));
    std::vector<uint32_t> words(size_t{12} * count);
    std::memcpy(words.data(), limbs, words.size() * sizeof(uint32_t));
    poses.add(words.data(), words.size());
  };
  measure(&other);
  // The same without a body of the source's.
  out_rotations = copied_rotations;
  out_positions = copied_positions;
  measure(nullptr);
  check(sinew_retarget_keep_range(plan, &own, &clip, workspace.data, bytes));
  check(sinew_retarget_contacts(plan, nullptr, &own, &clip, nullptr, workspace.data, bytes));
  add(out_rotations);
  add(out_positions);
  print(name, "contacts", poses);
  hash_stream(name, source, target, map, classes, own, turns, translations);
  // The published method, as drawn and with all of its options.
  poses = Hash();
  check(sinew_retarget_reference_points_workspace_size(plan, &own, &bytes));
  Block room(bytes);
  sinew_reference_options options = SINEW_INIT(sinew_reference_options);
  for (const bool drawn : {true, false}) {
    out_rotations = copied_rotations;
    out_positions = copied_positions;
    check(sinew_retarget_reference_points(plan, &other, &own, &clip, &options, room.data, bytes));
    add(out_rotations);
    add(out_positions);
    options.area_power = drawn ? SINEW_NO_AREA : 0;
    options.own_limb = 1;
    options.legs = options.head = options.torso = options.source_points = 1;
    options.falloff = SINEW_NO_FALLOFF;
  }
  // Without a body of the source's: capsules.
  options = SINEW_INIT(sinew_reference_options);
  out_rotations = copied_rotations;
  out_positions = copied_positions;
  check(sinew_retarget_reference_points(plan, nullptr, &own, &clip, &options, room.data, bytes));
  add(out_rotations);
  add(out_positions);
  print(name, "points", poses);
}

// Chains from every leaf up to where the skeleton forks, with colliders of every shape on its first joints, behind frames of different
// lengths in which everything turns. A jump restarts them halfway.
void hash_springs(const char* name, uint32_t frames, const Input& in) {
  const uint32_t joints = in.skeleton.joint_count;
  uint32_t state = 11;
  const auto draw = [&state] {
    state = state * 1664525u + 1013904223u;
    return static_cast<float>(static_cast<int32_t>(state >> 8) - (1 << 23)) / static_cast<float>(1 << 23);
  };
  std::vector<uint32_t> children(joints, 0);
  for (const int32_t parent : in.parents)
    if (parent >= 0) ++children[static_cast<size_t>(parent)];
  std::vector<sinew_spring_joint> spring_joints;
  std::vector<sinew_spring_chain> chains;
  for (uint32_t leaf = 0; leaf < joints; ++leaf) {
    if (children[leaf] != 0) continue;
    std::vector<uint32_t> path = {leaf};
    for (int32_t up = in.parents[leaf]; up >= 0 && children[static_cast<size_t>(up)] == 1;
         up = in.parents[static_cast<size_t>(up)])
      path.insert(path.begin(), static_cast<uint32_t>(up));
    if (path.size() < 2) continue;
    const int32_t center = chains.size() % 2 == 0 ? -1 : in.parents[path[0]];
    chains.push_back({static_cast<uint32_t>(spring_joints.size()), static_cast<uint32_t>(path.size()), 0, 5, center});
    for (const uint32_t joint : path)
      spring_joints.push_back({joint,
                               0.02f,
                               0.5f + 0.4f * draw(),
                               0.5f + 0.4f * draw(),
                               {draw(), -1, draw()},
                               0.4f + 0.3f * draw(),
                               joint % 2 == 0 ? 40.0f : 0.0f});
  }
  if (chains.empty()) return;
  std::vector<sinew_spring_collider> colliders;
  for (uint32_t c = 0; c < 5; ++c)
    colliders.push_back({c % joints,
                         SINEW_COLLIDER_SPHERE + c,
                         {draw(), draw(), draw()},
                         {draw(), draw(), draw()},
                         c < 2 ? 0.4f : 3.0f});
  const uint32_t chain_colliders[] = {0, 1, 2, 3, 4};
  sinew_spring_set set = SINEW_INIT(sinew_spring_set);
  set.joint_count = static_cast<uint32_t>(spring_joints.size());
  set.chain_count = static_cast<uint32_t>(chains.size());
  set.collider_count = 5;
  set.chain_collider_count = 5;
  set.joints = spring_joints.data();
  set.chains = chains.data();
  set.colliders = colliders.data();
  set.chain_colliders = chain_colliders;
  size_t bytes = 0;
  check(sinew_springs_workspace_size(joints, set.joint_count, set.chain_count, 5, 5, &bytes));
  Block block(bytes);
  sinew_springs* springs = nullptr;
  check(sinew_springs_create(&in.skeleton, &set, nullptr, block.data, bytes, &springs));
  Hash poses;
  std::vector<float> rotations(size_t{4} * joints), translations(size_t{3} * joints);
  std::vector<uint32_t> bits(rotations.size());
  const float lengths[] = {1.0f / 60, 1.0f / 30, 0.004f, 0.0f, 0.05f, 1.0f / 144};
  for (uint32_t f = 0; f < frames; ++f) {
    for (uint32_t j = 0; j < joints; ++j) {
      const int32_t parent = in.parents[j];
      for (size_t c = 0; c < 3; ++c) {
        const float above = parent < 0 ? 0 : in.joints[3 * static_cast<size_t>(parent) + c];
        translations[3 * j + c] = in.joints[3 * j + c] - above + (parent < 0 ? 0.2f * draw() : 0);
        if (parent < 0 && f >= frames / 2) translations[3 * j + c] += 1000;
        rotations[4 * j + c] = 0.2f * draw();
      }
      rotations[4 * j + 3] = 1.5f + 0.5f * draw();
    }
    check(sinew_springs_frame(springs, lengths[f % 6], rotations.data(), translations.data(), rotations.data()));
    std::memcpy(bits.data(), rotations.data(), bits.size() * sizeof(uint32_t));
    poses.add(bits.data(), bits.size());
  }
  print(name, "springs", poses);
}

// Every joint turned by the angle of a 3-4-5 triangle, or a multiple of it, about an axis of its own, on top of its parent: no sine
// is needed.
std::vector<float> bent_palette(const Input& in, uint32_t turns) {
  double cosine = 1, sine = 0;
  for (uint32_t t = 0; t < turns; ++t) {
    const double last = cosine;
    cosine = 0.6 * last - 0.8 * sine;
    sine = 0.8 * last + 0.6 * sine;
  }
  const size_t count = in.skeleton.joint_count;
  std::vector<double> matrices(12 * count, 0);
  std::vector<uint8_t> done(count, 0);
  for (size_t left = count; left > 0;) {
    for (size_t j = 0; j < count; ++j) {
      const int32_t parent = in.parents[j];
      if (done[j] != 0 || (parent >= 0 && done[static_cast<size_t>(parent)] == 0)) continue;
      double own[12] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
      const size_t a = j % 3, b = (j + 1) % 3;
      own[5 * a] = own[5 * b] = cosine;
      own[4 * a + b] = j % 2 == 0 ? -sine : sine;
      own[4 * b + a] = -own[4 * a + b];
      for (size_t r = 0; r < 3; ++r) {
        double moved = 0;
        for (size_t c = 0; c < 3; ++c) moved += own[4 * r + c] * static_cast<double>(in.joints[3 * j + c]);
        own[4 * r + 3] = static_cast<double>(in.joints[3 * j + r]) - moved;
      }
      for (size_t r = 0; r < 3; ++r) {
        for (size_t c = 0; c < 4; ++c) {
          double sum = parent < 0 ? own[4 * r + c] : 0;
          if (parent >= 0) {
            const double* const above = &matrices[12 * static_cast<size_t>(parent)];
            for (size_t k = 0; k < 3; ++k) sum += above[4 * r + k] * own[4 * k + c];
            if (c == 3) sum += above[4 * r + 3];
          }
          matrices[12 * j + 4 * r + c] = sum;
        }
      }
      done[j] = 1;
      --left;
    }
  }
  return std::vector<float>(matrices.begin(), matrices.end());
}

// What the deformer needs and makes, and a pose of it.
void hash_deform(const char* name, const SetLine& line, const Input& in) {
  sinew_bind_options bind_options = line.options;
  bind_options.method = SINEW_METHOD_HEAT;
  size_t bytes = 0;
  check(sinew_bind_workspace_size(nullptr, in.mesh.vertex_count, in.mesh.face_count, in.mesh.corner_count,
                                  in.skeleton.joint_count, &bind_options, &bytes));
  std::vector<uint16_t> joints(in.mesh.vertex_count * size_t{4}), weights(joints.size());
  {
    Block block(bytes);
    sinew_bind_outputs outputs = SINEW_INIT(sinew_bind_outputs);
    outputs.joint_indices = joints.data();
    outputs.weights = weights.data();
    check(sinew_bind(nullptr, &in.mesh, &in.skeleton, &bind_options, block.data, bytes, &outputs));
  }
  sinew_deform_options options = line.deform_options;
  options.method = line.deform - 1;
  const sinew_skin skin = {joints.data(), weights.data(), 4, SINEW_WEIGHT_UNORM16};
  check(sinew_deform_create_workspace_size(&in.mesh, in.skeleton.joint_count, 4, &options, &bytes));
  Block memory(bytes);
  sinew_deformer deformer = {};
  check(sinew_deform_create(&in.mesh, &in.skeleton, &skin, &options, memory.data, bytes, &deformer));
  Block workspace(deformer.pose_bytes);
  std::vector<float> positions(size_t{3} * in.mesh.vertex_count);
  sinew_deform_outputs outputs = SINEW_INIT(sinew_deform_outputs);
  outputs.positions = positions.data();
  check(
      sinew_deform_pose(&deformer, bent_palette(in, line.turns).data(), workspace.data, deformer.pose_bytes, &outputs));
  Hash lattice, pose;
  const uint32_t counts[] = {deformer.tetrahedron_count, deformer.node_count,       deformer.split_cell_count,
                             outputs.corrected,          outputs.active_tetrahedra, outputs.inverted_tetrahedra};
  lattice.add(counts, 6);
  std::vector<uint32_t> bits(positions.size());
  std::memcpy(bits.data(), positions.data(), positions.size() * sizeof(uint32_t));
  pose.add(bits.data(), bits.size());
  print(name, "lattice", lattice);
  print(name, "pose", pose);
}

// Everything that sinew_transfer() gives to a caller. The source is bound by heat and then painted: every third vertex
// moves with the next joint in part. Joints of one number are one.
void hash_transfer(const char* name, const SetLine& line, const Input& source, const Input& target,
                   const sinew_model* model, uint32_t kernel) {
  constexpr uint32_t kInfluences = 4;
  const size_t slots = size_t{kInfluences} * source.mesh.vertex_count;
  std::vector<uint16_t> joints(slots), weights(slots);
  size_t bytes = 0;
  {
    sinew_bind_options heat = SINEW_INIT(sinew_bind_options);
    heat.method = SINEW_METHOD_HEAT;
    heat.kernel = kernel;
    sinew_bind_outputs bound = SINEW_INIT(sinew_bind_outputs);
    bound.joint_indices = joints.data();
    bound.weights = weights.data();
    check(sinew_bind_workspace_size(nullptr, source.mesh.vertex_count, source.mesh.face_count, source.mesh.corner_count,
                                    source.skeleton.joint_count, &heat, &bytes));
    Block block(bytes);
    check(sinew_bind(nullptr, &source.mesh, &source.skeleton, &heat, block.data, bytes, &bound));
  }
  for (size_t v = 0; v < source.mesh.vertex_count; v += 3) {
    const uint16_t half = weights[v * kInfluences] / 2;
    joints[v * kInfluences + 3] = static_cast<uint16_t>((joints[v * kInfluences] + 1) % source.skeleton.joint_count);
    weights[v * kInfluences] = static_cast<uint16_t>(weights[v * kInfluences] - half);
    weights[v * kInfluences + 3] = half;
  }
  std::vector<int32_t> map;
  for (uint32_t j = 0; j < source.skeleton.joint_count; ++j)
    map.push_back(j < target.skeleton.joint_count ? static_cast<int32_t>(j) : -1);
  const sinew_bound_character bound = {
      &source.mesh, &source.skeleton, {joints.data(), weights.data(), kInfluences, SINEW_WEIGHT_UNORM16}, map.data()};
  sinew_transfer_options options = line.transfer;
  options.influence_count = line.options.influence_count;
  options.weights_in_place = line.options.weights_in_place;
  const uint32_t n = options.influence_count != 0 ? options.influence_count : 4, vertices = target.mesh.vertex_count;
  std::vector<uint16_t> out_joints(size_t{n} * vertices, 0), out_weights(out_joints);
  std::vector<uint8_t> locked(vertices, 0), confidence(vertices, 0);
  for (uint32_t v = 0; line.locked_step != 0 && v < vertices; v += line.locked_step) locked[v] = 1;
  if (line.locked_step != 0) options.locked = locked.data();
  std::vector<sinew_transfer_part> parts(vertices);
  std::vector<uint32_t> vertex_parts(vertices, 0);
  sinew_transfer_outputs outputs = SINEW_INIT(sinew_transfer_outputs);
  outputs.joint_indices = out_joints.data();
  outputs.weights = out_weights.data();
  outputs.confidence = confidence.data();
  outputs.parts = parts.data();
  outputs.part_capacity = vertices;
  outputs.vertex_parts = vertex_parts.data();
  check(sinew_transfer_workspace_size(model, &bound, &target.mesh, &target.skeleton, &options, &bytes));
  options.kernel = kernel;
  Block block(bytes);
  check(sinew_transfer(model, &bound, &target.mesh, &target.skeleton, &options, block.data, bytes, &outputs));
  Hash memory, rows, extras;
  const uint64_t size = bytes;
  memory.add(&size, 1);
  rows.add(out_joints.data(), out_joints.size());
  rows.add(out_weights.data(), out_weights.size());
  extras.add(confidence.data(), vertices);
  extras.add(vertex_parts.data(), vertices);
  for (uint32_t p = 0; p < outputs.part_count; ++p) {
    const sinew_transfer_part& part = parts[p];
    for (const uint32_t value : {part.vertex, part.vertex_count, part.reason, part.carried_q16, part.style_q16,
                                 part.mismatch_q16, part.distance_q16})
      extras.add(&value, 1);
  }
  for (const uint32_t value : {outputs.part_count, outputs.bound_by, outputs.carried_q16, outputs.style_q16,
                               outputs.mismatch_q16, outputs.reference_count})
    extras.add(&value, 1);
  print(name, "memory", memory);
  print(name, "rows", rows);
  print(name, "extras", extras);
}

std::string base_name(const std::string& path) { return path.substr(path.find_last_of('/') + 1); }

void hash_set(const std::string& path, uint32_t kernel) {
  const std::string folder = path.substr(0, path.find_last_of('/') + 1);
  for (const auto& words : read_words(path)) {
    if (words.empty() || words[0][0] == '#') continue;
    const SetLine line(words);
    const Input in = read_input(folder + line.character);
    std::string name = base_name(words[0]);
    for (size_t i = 1; i < words.size(); ++i) name += "," + base_name(words[i]);
    if (!line.source.empty()) {
      hash_map(name.c_str(), line, in, read_input(folder + line.source));
    } else if (line.spring_frames != 0) {
      hash_springs(name.c_str(), line.spring_frames, in);
    } else if (line.motion_frames != 0) {
      hash_motion(name.c_str(), line, in);
    } else if (!line.target.empty()) {
      const Input target = read_input(folder + line.target);
      if (line.model == "heat") {
        hash_transfer(name.c_str(), line, in, target, nullptr, kernel);
      } else {
        const ModelFile file((folder + line.model).c_str(), false);
        hash_transfer(name.c_str(), line, in, target, &file.model, kernel);
      }
    } else if (line.model.empty()) {
      hash_stages(name.c_str(), in, line.options.candidate_count, line.options.grid_size, kernel);
    } else if (line.deform != 0) {
      hash_deform(name.c_str(), line, in);
    } else if (line.model == "heat") {
      hash_line(name.c_str(), line, in, nullptr, kernel);
    } else {
      const ModelFile file((folder + line.model).c_str(), line.rig != 0 || line.details != 0);
      if (line.details != 0) {
        hash_details(name.c_str(), line, in, file.model, kernel);
      } else if (line.rig != 0) {
        hash_rig(name.c_str(), line, in, file.model, kernel);
      } else {
        hash_line(name.c_str(), line, in, &file.model, kernel);
      }
    }
  }
  const Hash all = all_printed;
  print("set", "all", all);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 2 && std::strcmp(argv[1], "--kernels") == 0) {
    for (uint32_t kernel = SINEW_KERNEL_REF; sinew_kernel_name(kernel) != nullptr; ++kernel) {
      if (sinew_kernel_select(kernel) != 0) std::printf("%s\n", sinew_kernel_name(kernel));
    }
    return 0;
  }
  int first = 1;
  uint32_t kernel = SINEW_KERNEL_AUTO;
  if (argc > 2 && std::strcmp(argv[1], "--kernel") == 0) {
    kernel = find_kernel(argv[2]);
    first = 3;
  }
  if (argc == first + 2 && std::strcmp(argv[first], "--set") == 0) {
    hash_set(argv[first + 1], kernel);
    return 0;
  }
  std::vector<ModelFile> models;
  if (argc > first + 1 && std::strcmp(argv[first], "--model") == 0) {
    models.emplace_back(argv[first + 1]);
    first += 2;
  }
  for (int i = first; i < argc; ++i) {
    const std::string path = argv[i];
    const std::string name = base_name(path);
    const Input in = read_input(path);
    hash_stages(name.c_str(), in, 8, 64, kernel);
    hash_bind(name.c_str(), "bind-heat", in, nullptr, SINEW_METHOD_HEAT, kernel);
    if (!models.empty()) hash_bind(name.c_str(), "bind-model", in, &models[0].model, SINEW_METHOD_MODEL, kernel);
  }
  return 0;
}
