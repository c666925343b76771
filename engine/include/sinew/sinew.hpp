// SPDX-License-Identifier: MIT
// Typed C++17 wrapper over sinew.h for programs with a heap: one line per call, with memory and output arrays
// managed. Header only. It throws no exceptions itself and needs no RTTI. All of sinew.h can be used with it.
//
//   sinew::Model model;
//   sinew_status status = model.open_file("model.snw");
//   sinew::Workspace workspace;  // kept for the next character
//   sinew::Skin<uint8_t> skin;
//   if (status == SINEW_OK) status = sinew::bind(model.get(), mesh, skeleton, {}, &workspace, &skin);
//
// Without a skeleton:
//
//   sinew::RiggedSkeleton rigged;
//   status = sinew::rig(rig_model.get(), mesh, {}, &workspace, &rigged);
//   if (status == SINEW_OK) status = sinew::bind(model.get(), mesh, rigged.view(), {}, &workspace, &skin);
//
// Joints of one skeleton for another's:
//
//   sinew::JointMap map;
//   sinew_status status = sinew::map_joints(target, source, {}, &workspace, &map);
//
// Weights of a bound character for another mesh:
//
//   sinew_status status = sinew::transfer(model.get(), bound, mesh, skeleton, {}, &workspace, &skin);
#ifndef SINEW_SINEW_HPP
#define SINEW_SINEW_HPP

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <new>
#include <utility>
#include <vector>

#include "sinew/sinew.h"

namespace sinew {

// Memory for sinew_bind() or sinew_rig() with the required alignment. It grows, never shrinks, and is freed by the
// destructor.
class Workspace {
 public:
  Workspace() = default;
  // size() is 0 if memory is exhausted.
  explicit Workspace(size_t bytes) { (void)reserve(bytes); }
  ~Workspace() { release(); }
  Workspace(Workspace&& other) noexcept
      : data_(std::exchange(other.data_, nullptr)), size_(std::exchange(other.size_, 0)) {}
  Workspace& operator=(Workspace&& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    return *this;
  }
  Workspace(const Workspace&) = delete;
  Workspace& operator=(const Workspace&) = delete;

  // Reserves at least this many bytes, whose content is undefined. Returns false if memory is exhausted; the old
  // content is then lost.
  bool reserve(size_t bytes) noexcept {
    if (bytes <= size_) return true;
    release();
    data_ = ::operator new (bytes, std::align_val_t{SINEW_WORKSPACE_ALIGNMENT}, std::nothrow);
    size_ = data_ == nullptr ? 0 : bytes;
    return data_ != nullptr;
  }
  void* data() const { return data_; }
  size_t size() const { return size_; }

 private:
  void release() noexcept {
    if (data_ != nullptr) ::operator delete (data_, std::align_val_t{SINEW_WORKSPACE_ALIGNMENT});
    data_ = nullptr;
    size_ = 0;
  }
  void* data_ = nullptr;
  size_t size_ = 0;
};

// A model with the bytes of its file, aligned for the engine. Movable, not copyable.
class Model {
 public:
  Model() = default;
  Model(Model&& other) noexcept
      : bytes_(std::move(other.bytes_)), packed_(std::move(other.packed_)), model_(std::exchange(other.model_, {})) {}
  Model& operator=(Model&& other) noexcept {
    bytes_ = std::move(other.bytes_);
    packed_ = std::move(other.packed_);
    model_ = std::exchange(other.model_, {});
    return *this;
  }
  Model(const Model&) = delete;
  Model& operator=(const Model&) = delete;

  // Copies a file's bytes and opens them: with sinew_model_open() for bind(), with sinew_rig_model_open() for rig() and for
  // sinew_rig_details(). Return what those do; SINEW_ERROR_WORKSPACE if memory is exhausted. On failure there is no
  // model.
  sinew_status open(const void* bytes, size_t size) { return open_with(sinew_model_open, bytes, size); }
  sinew_status open_rig(const void* bytes, size_t size) { return open_with(sinew_rig_model_open, bytes, size); }
  // The same for a file. SINEW_ERROR_ARGUMENT if it cannot be read.
  sinew_status open_file(const char* path) { return open_file_with(sinew_model_open, path); }
  sinew_status open_rig_file(const char* path) { return open_file_with(sinew_rig_model_open, path); }
  // sinew_model_pack() with its memory managed.
  sinew_status pack() {
    if (get() == nullptr) return SINEW_ERROR_ARGUMENT;
    size_t bytes = 0;
    if (const sinew_status status = sinew_model_pack_workspace_size(&model_, &bytes); status != SINEW_OK) return status;
    if (bytes == 0 || model_.packed != nullptr) return SINEW_OK;
    if (!packed_.reserve(bytes)) return SINEW_ERROR_WORKSPACE;
    return sinew_model_pack(&model_, packed_.data(), packed_.size());
  }
  // For bind() and the C functions; valid until the next open() or move of this object; null without a model.
  const sinew_model* get() const { return model_.bytes == nullptr ? nullptr : &model_; }

 private:
  using Open = decltype(&sinew_model_open);

  sinew_status open_with(Open open_call, const void* bytes, size_t size) {
    model_ = {};
    if (bytes == nullptr) return SINEW_ERROR_ARGUMENT;
    if (size == 0) return SINEW_ERROR_MODEL_TRUNCATED;
    if (!bytes_.reserve(size)) return SINEW_ERROR_WORKSPACE;
    std::memcpy(bytes_.data(), bytes, size);
    return finish(open_call, size);
  }
  sinew_status open_file_with(Open open_call, const char* path) {
    model_ = {};
    std::FILE* const file = std::fopen(path, "rb");
    if (file == nullptr) return SINEW_ERROR_ARGUMENT;
    sinew_status status = SINEW_ERROR_ARGUMENT;
    if (std::fseek(file, 0, SEEK_END) == 0) {
      const long size = std::ftell(file);
      if (size > 0 && std::fseek(file, 0, SEEK_SET) == 0) {
        status = SINEW_ERROR_WORKSPACE;
        if (bytes_.reserve(static_cast<size_t>(size))) {
          const size_t read = std::fread(bytes_.data(), 1, static_cast<size_t>(size), file);
          status = read == static_cast<size_t>(size) ? finish(open_call, read) : SINEW_ERROR_ARGUMENT;
        }
      }
    }
    std::fclose(file);
    return status;
  }
  sinew_status finish(Open open_call, size_t size) {
    packed_ = Workspace();
    const sinew_status status = open_call(bytes_.data(), size, &model_);
    if (status != SINEW_OK) model_ = {};
    return status;
  }

  Workspace bytes_, packed_;
  sinew_model model_ = {};
};

// The weight format that belongs to a type: uint16_t, uint8_t or float.
template <class Weight>
struct WeightFormat;
template <>
struct WeightFormat<uint16_t> {
  static constexpr uint32_t value = SINEW_WEIGHT_UNORM16;
};
template <>
struct WeightFormat<uint8_t> {
  static constexpr uint32_t value = SINEW_WEIGHT_UNORM8;
};
template <>
struct WeightFormat<float> {
  static constexpr uint32_t value = SINEW_WEIGHT_FLOAT;
};

// sinew_bind_options with every default; {} where a function takes options.
struct Options : sinew_bind_options {
  Options() : sinew_bind_options(SINEW_INIT(sinew_bind_options)) {}
  Options(const sinew_bind_options& options) : sinew_bind_options(options) {}
};

// Rows of a bound mesh, see sinew_bind_outputs.
template <class Weight>
struct Skin {
  uint32_t influence_count = 0;         // N
  std::vector<uint16_t> joint_indices;  // [vertex_count x N]
  std::vector<Weight> weights;          // [vertex_count x N]
  uint32_t symmetric_vertices = 0;      // with options.symmetric
};

// Questions of a bind, see sinew_bind_outputs.
struct QuestionList {
  std::vector<sinew_question> questions;                 // by descending gain
  std::vector<uint32_t> vertex_questions, vertex_parts;  // [vertex_count]
};

// For the functions below. Calls run(Skin<Weight>& rows) with rows of these counts: *skin itself if its counts match,
// else new rows that replace it after SINEW_OK. If *skin is input too (`is_input`) and its counts differ, returns
// SINEW_ERROR_ARGUMENT.
template <class Weight, class Run>
sinew_status fill_skin(uint32_t vertex_count, uint32_t influence_count, bool is_input, Skin<Weight>* skin, Run run) {
  const size_t values = static_cast<size_t>(vertex_count) * influence_count;
  if (skin->influence_count == influence_count && skin->joint_indices.size() == values &&
      skin->weights.size() == values)
    return run(*skin);
  if (is_input) return SINEW_ERROR_ARGUMENT;
  Skin<Weight> fresh{influence_count, std::vector<uint16_t>(values), std::vector<Weight>(values), 0};
  const sinew_status status = run(fresh);
  if (status == SINEW_OK) *skin = std::move(fresh);
  return status;
}

// sinew_bind() with the size query, the workspace and the outputs managed. options.weight_format is set from
// Weight. With options.locked or options.hints *skin is input too and must hold vertex_count rows of the wanted
// influence count (else SINEW_ERROR_ARGUMENT). *confidence gets a value per vertex, unless it is null. With
// options.question_count *asked is required (else SINEW_ERROR_ARGUMENT). Returns what sinew_bind() does;
// SINEW_ERROR_WORKSPACE if memory is exhausted. *skin is untouched on failure, *confidence and *asked are undefined.
template <class Weight>
sinew_status bind(const sinew_model* model, const sinew_mesh& mesh, const sinew_skeleton& skeleton, Options options,
                  Workspace* workspace, Skin<Weight>* skin, std::vector<uint8_t>* confidence = nullptr,
                  QuestionList* asked = nullptr) {
  options.weight_format = WeightFormat<Weight>::value;
  size_t bytes = 0;
  const sinew_status status = sinew_bind_workspace_size(model, mesh.vertex_count, mesh.face_count, mesh.corner_count,
                                                        skeleton.joint_count, &options, &bytes);
  if (status != SINEW_OK) return status;
  if (!workspace->reserve(bytes)) return SINEW_ERROR_WORKSPACE;
  const uint32_t influences = options.influence_count == 0 ? 4 : options.influence_count;
  if (confidence != nullptr) confidence->resize(mesh.vertex_count);
  const auto run = [&](Skin<Weight>& rows) {
    sinew_bind_outputs outputs = SINEW_INIT(sinew_bind_outputs);
    outputs.joint_indices = rows.joint_indices.data();
    outputs.weights = rows.weights.data();
    if (confidence != nullptr) outputs.confidence = confidence->data();
    if (asked != nullptr && options.question_count > 0) {
      asked->questions.resize(options.question_count);
      asked->vertex_questions.resize(mesh.vertex_count);
      asked->vertex_parts.resize(mesh.vertex_count);
      outputs.questions = asked->questions.data();
      outputs.vertex_questions = asked->vertex_questions.data();
      outputs.vertex_parts = asked->vertex_parts.data();
    }
    const sinew_status bound =
        sinew_bind(model, &mesh, &skeleton, &options, workspace->data(), workspace->size(), &outputs);
    if (bound == SINEW_OK) rows.symmetric_vertices = outputs.symmetric_vertices;
    if (bound == SINEW_OK && asked != nullptr) asked->questions.resize(outputs.questions_written);
    return bound;
  };
  return fill_skin(mesh.vertex_count, influences, options.locked != nullptr || options.hints != nullptr, skin, run);
}

// sinew_rig_options with every default; {} where a function takes settings.
struct RigSettings : sinew_rig_options {
  RigSettings() : sinew_rig_options(SINEW_INIT(sinew_rig_options)) {}
  RigSettings(const sinew_rig_options& options) : sinew_rig_options(options) {}
};

struct JointName {
  char text[SINEW_JOINT_NAME_BYTES];  // zero-terminated
};

// A predicted skeleton, see sinew_rig_outputs.
struct RiggedSkeleton {
  std::vector<float> positions;                         // [J x 3]
  std::vector<int32_t> parents, partners;               // [J]
  std::vector<uint8_t> flags, joint_classes;            // [J]
  std::vector<uint16_t> confidence, parent_confidence;  // [J]
  std::vector<JointName> names;                         // [J]
  bool mirrored = false;
  uint32_t facing = 0;
  float plane = 0, spread = 0;
  float front[3] = {0, 0, 1};
  uint32_t up = SINEW_UP_Y;
  float front_confidence = 0, up_confidence = 0;

  uint32_t joint_count() const { return static_cast<uint32_t>(parents.size()); }
  // For bind(); valid as long as the arrays are.
  sinew_skeleton view() const {
    sinew_skeleton skeleton = SINEW_INIT(sinew_skeleton);
    skeleton.positions = positions.data();
    skeleton.parents = parents.data();
    skeleton.joint_count = joint_count();
    skeleton.flags = flags.data();
    return skeleton;
  }
};

// sinew_rig() with the size query, the workspace and the outputs managed. Returns what sinew_rig() does;
// SINEW_ERROR_WORKSPACE if memory is exhausted. *skeleton is untouched on failure.
inline sinew_status rig(const sinew_model* model, const sinew_mesh& mesh, const RigSettings& settings,
                        Workspace* workspace, RiggedSkeleton* skeleton) {
  size_t bytes = 0;
  const sinew_status status =
      sinew_rig_workspace_size(model, mesh.vertex_count, mesh.face_count, mesh.corner_count, &settings, &bytes);
  if (status != SINEW_OK) return status;
  if (!workspace->reserve(bytes)) return SINEW_ERROR_WORKSPACE;
  RiggedSkeleton made;
  const auto resize = [&made](size_t joints) {
    made.positions.resize(3 * joints);
    made.parents.resize(joints);
    made.partners.resize(joints);
    made.flags.resize(joints);
    made.joint_classes.resize(joints);
    made.confidence.resize(joints);
    made.parent_confidence.resize(joints);
    made.names.resize(joints);
  };
  resize(SINEW_MAX_RIG_JOINTS);
  sinew_rig_outputs outputs = SINEW_INIT(sinew_rig_outputs);
  outputs.positions = made.positions.data();
  outputs.parents = made.parents.data();
  outputs.partners = made.partners.data();
  outputs.flags = made.flags.data();
  outputs.joint_classes = made.joint_classes.data();
  outputs.confidence = made.confidence.data();
  outputs.parent_confidence = made.parent_confidence.data();
  outputs.names = &made.names.data()->text;
  const sinew_status rigged = sinew_rig(model, &mesh, &settings, workspace->data(), workspace->size(), &outputs);
  if (rigged != SINEW_OK) return rigged;
  resize(outputs.joint_count);
  made.mirrored = outputs.mirrored != 0;
  made.facing = outputs.facing;
  made.plane = outputs.plane;
  made.spread = outputs.spread;
  for (int axis = 0; axis < 3; ++axis) made.front[axis] = outputs.front[axis];
  made.up = outputs.up;
  made.front_confidence = outputs.front_confidence;
  made.up_confidence = outputs.up_confidence;
  *skeleton = std::move(made);
  return SINEW_OK;
}

// sinew_simplify_options with every default; {} where a function takes settings.
struct SimplifySettings : sinew_simplify_options {
  SimplifySettings() : sinew_simplify_options(SINEW_INIT(sinew_simplify_options)) {}
  SimplifySettings(const sinew_simplify_options& options) : sinew_simplify_options(options) {}
};

// sinew_simplify() with the size query, the workspace and the output managed. Returns what sinew_simplify() does;
// SINEW_ERROR_WORKSPACE if memory is exhausted. *into is untouched on failure.
inline sinew_status simplify(const sinew_skeleton& skeleton, const float* areas, const uint8_t* keep,
                             const SimplifySettings& settings, Workspace* workspace, std::vector<uint32_t>* into) {
  size_t bytes = 0;
  const sinew_status status = sinew_simplify_workspace_size(skeleton.joint_count, &bytes);
  if (status != SINEW_OK) return status;
  if (!workspace->reserve(bytes)) return SINEW_ERROR_WORKSPACE;
  std::vector<uint32_t> made(skeleton.joint_count);
  const sinew_status simplified =
      sinew_simplify(&skeleton, areas, keep, &settings, workspace->data(), workspace->size(), made.data());
  if (simplified == SINEW_OK) *into = std::move(made);
  return simplified;
}

// sinew_map_options with every default; {} where a function takes settings.
struct MapSettings : sinew_map_options {
  MapSettings() : sinew_map_options(SINEW_INIT(sinew_map_options)) {}
  MapSettings(const sinew_map_options& options) : sinew_map_options(options) {}
};

// Sources of joints, see sinew_map_outputs.
struct JointMap {
  std::vector<int32_t> sources;      // [target J] -1 = none
  std::vector<uint16_t> confidence;  // [target J]
  std::vector<uint8_t> reasons;      // [target J] sinew_map_reason
  uint32_t method = 0, mapped = 0, certainty = 0;
};

// sinew_map() with the size query, the workspace and the outputs managed. Returns what sinew_map() does;
// SINEW_ERROR_WORKSPACE if memory is exhausted. *map is untouched on failure.
inline sinew_status map_joints(const sinew_skeleton& target, const sinew_skeleton& source, const MapSettings& settings,
                               Workspace* workspace, JointMap* map) {
  size_t bytes = 0;
  const sinew_status status = sinew_map_workspace_size(target.joint_count, source.joint_count, &bytes);
  if (status != SINEW_OK) return status;
  if (!workspace->reserve(bytes)) return SINEW_ERROR_WORKSPACE;
  JointMap made;
  made.sources.resize(target.joint_count);
  made.confidence.resize(target.joint_count);
  made.reasons.resize(target.joint_count);
  sinew_map_outputs outputs = SINEW_INIT(sinew_map_outputs);
  outputs.sources = made.sources.data();
  outputs.confidence = made.confidence.data();
  outputs.reasons = made.reasons.data();
  const sinew_status mapped = sinew_map(&target, &source, &settings, workspace->data(), workspace->size(), &outputs);
  if (mapped != SINEW_OK) return mapped;
  made.method = outputs.method;
  made.mapped = outputs.mapped;
  made.certainty = outputs.certainty;
  *map = std::move(made);
  return SINEW_OK;
}

// sinew_transfer_options with every default; {} where a function takes settings.
struct TransferSettings : sinew_transfer_options {
  TransferSettings() : sinew_transfer_options(SINEW_INIT(sinew_transfer_options)) {}
  TransferSettings(const sinew_transfer_options& options) : sinew_transfer_options(options) {}
};

// Report of a transfer, see sinew_transfer_outputs.
struct TransferReport {
  std::vector<uint8_t> confidence;         // [vertex_count]
  std::vector<sinew_transfer_part> parts;  // by descending size
  std::vector<uint32_t> vertex_parts;      // [vertex_count]
  uint32_t bound_by = 0, carried_q16 = 0, style_q16 = 0, mismatch_q16 = 0, reference_count = 0;
  size_t used_bytes = 0;
};

// sinew_transfer() with the size query, the workspace and the outputs managed. settings.weight_format is set from
// Weight. With settings.locked *skin is input too and must hold target.vertex_count rows of the wanted influence
// count (else SINEW_ERROR_ARGUMENT). Returns what sinew_transfer() does; SINEW_ERROR_WORKSPACE if memory is
// exhausted. *skin and *report, which may be null, are untouched on failure.
template <class Weight>
sinew_status transfer(const sinew_model* model, const sinew_bound_character& source, const sinew_mesh& target,
                      const sinew_skeleton& skeleton, TransferSettings settings, Workspace* workspace,
                      Skin<Weight>* skin, TransferReport* report = nullptr) {
  settings.weight_format = WeightFormat<Weight>::value;
  size_t bytes = 0;
  const sinew_status status = sinew_transfer_workspace_size(model, &source, &target, &skeleton, &settings, &bytes);
  if (status != SINEW_OK) return status;
  if (!workspace->reserve(bytes)) return SINEW_ERROR_WORKSPACE;
  const auto run = [&](Skin<Weight>& rows) {
    sinew_transfer_outputs outputs = SINEW_INIT(sinew_transfer_outputs);
    outputs.joint_indices = rows.joint_indices.data();
    outputs.weights = rows.weights.data();
    TransferReport made;
    if (report != nullptr) {
      made.confidence.resize(target.vertex_count);
      made.parts.resize(target.vertex_count);
      made.vertex_parts.resize(target.vertex_count);
      outputs.confidence = made.confidence.data();
      outputs.parts = made.parts.data();
      outputs.part_capacity = target.vertex_count;
      outputs.vertex_parts = made.vertex_parts.data();
    }
    const sinew_status transferred =
        sinew_transfer(model, &source, &target, &skeleton, &settings, workspace->data(), workspace->size(), &outputs);
    if (transferred != SINEW_OK) return transferred;
    rows.symmetric_vertices = 0;
    if (report == nullptr) return transferred;
    made.parts.resize(outputs.part_count);
    made.bound_by = outputs.bound_by;
    made.carried_q16 = outputs.carried_q16;
    made.style_q16 = outputs.style_q16;
    made.mismatch_q16 = outputs.mismatch_q16;
    made.reference_count = outputs.reference_count;
    made.used_bytes = outputs.used_bytes;
    *report = std::move(made);
    return transferred;
  };
  const uint32_t influences = settings.influence_count == 0 ? 4 : settings.influence_count;
  return fill_skin(target.vertex_count, influences, settings.locked != nullptr, skin, run);
}

// sinew_retarget_options with every default; {} where a function takes settings.
struct RetargetSettings : sinew_retarget_options {
  RetargetSettings() : sinew_retarget_options(SINEW_INIT(sinew_retarget_options)) {}
  RetargetSettings(const sinew_retarget_options& options) : sinew_retarget_options(options) {}
};

// sinew_contact_options with every default; {} where a function takes settings.
struct ContactSettings : sinew_contact_options {
  ContactSettings() : sinew_contact_options(SINEW_INIT(sinew_contact_options)) {}
  ContactSettings(const sinew_contact_options& options) : sinew_contact_options(options) {}
};

// A sinew_retarget and its memory:
//
//   sinew::RetargetPlan plan;
//   sinew_status status = plan.make(source, target, map, target_classes);
//   if (status == SINEW_OK) status = plan.frame(rotations, translations, ground, out_rotations, out_translations);
class RetargetPlan {
 public:
  // Size query, memory and sinew_retarget_create(). Returns what they do; SINEW_ERROR_WORKSPACE if memory is
  // exhausted. On failure there is no plan, and the functions below return SINEW_ERROR_ARGUMENT.
  sinew_status make(const sinew_skeleton& source, const sinew_skeleton& target, const int32_t* map,
                    const uint8_t* target_classes, const RetargetSettings& settings = {}) {
    plan_ = nullptr;
    size_t bytes = 0;
    const sinew_status status = sinew_retarget_create_workspace_size(source.joint_count, target.joint_count, &bytes);
    if (status != SINEW_OK) return status;
    if (!memory_.reserve(bytes)) return SINEW_ERROR_WORKSPACE;
    return sinew_retarget_create(&source, &target, map, target_classes, &settings, memory_.data(), memory_.size(),
                                 &plan_);
  }
  sinew_status height(const float* rotations, const float* translations, float* height) {
    return sinew_retarget_height(plan_, rotations, translations, height);
  }
  sinew_status ground(float* heights, size_t count, float* ground) const {
    return sinew_retarget_ground(plan_, heights, count, ground);
  }
  sinew_status frame(const float* rotations, const float* translations, float ground, float* out_rotations,
                     float* out_translations) {
    return sinew_retarget_frame(plan_, rotations, translations, ground, out_rotations, out_translations);
  }
  // Functions for whole clips, with the size query and the workspace managed: SINEW_ERROR_WORKSPACE if
  // memory is exhausted.
  sinew_status contacts(const sinew_motion_body* source, const sinew_motion_body& target, const sinew_motion_clip& clip,
                        const ContactSettings& settings, Workspace* workspace) {
    const sinew_status status = reserve_contacts(target, clip, workspace);
    if (status != SINEW_OK) return status;
    return sinew_retarget_contacts(plan_, source, &target, &clip, &settings, workspace->data(), workspace->size());
  }
  sinew_status keep_range(const sinew_motion_body& target, const sinew_motion_clip& clip, Workspace* workspace) {
    const sinew_status status = reserve_contacts(target, clip, workspace);
    if (status != SINEW_OK) return status;
    return sinew_retarget_keep_range(plan_, &target, &clip, workspace->data(), workspace->size());
  }
  // `limbs` gets one element per limb; it is untouched on failure.
  sinew_status measure(const sinew_motion_body* source, const sinew_motion_body& target, const sinew_motion_clip& clip,
                       const ContactSettings& settings, Workspace* workspace, std::vector<sinew_limb_quality>* limbs) {
    sinew_status status = reserve_contacts(target, clip, workspace);
    if (status != SINEW_OK) return status;
    sinew_limb_quality measured[SINEW_MAX_MOTION_LIMBS];
    uint32_t count = 0;
    status = sinew_retarget_measure(plan_, source, &target, &clip, &settings, workspace->data(), workspace->size(),
                                    measured, &count);
    if (status == SINEW_OK) limbs->assign(measured, measured + count);
    return status;
  }
  // For the C functions; null without a plan.
  sinew_retarget* get() const { return plan_; }

 private:
  sinew_status reserve_contacts(const sinew_motion_body& target, const sinew_motion_clip& clip, Workspace* workspace) {
    size_t bytes = 0;
    const sinew_status status = sinew_retarget_contacts_workspace_size(plan_, &target, clip.frame_count, &bytes);
    if (status != SINEW_OK) return status;
    return workspace->reserve(bytes) ? SINEW_OK : SINEW_ERROR_WORKSPACE;
  }

  Workspace memory_;
  sinew_retarget* plan_ = nullptr;
};

// sinew_retarget_stream_options with every default; {} where a function takes settings.
struct StreamSettings : sinew_retarget_stream_options {
  StreamSettings() : sinew_retarget_stream_options(SINEW_INIT(sinew_retarget_stream_options)) {}
  StreamSettings(const sinew_retarget_stream_options& options) : sinew_retarget_stream_options(options) {}
};

// A sinew_retarget_stream and its memory.
class RetargetStream {
 public:
  // Size query, memory and sinew_retarget_stream_create(); body may be null. Returns what they do;
  // SINEW_ERROR_WORKSPACE if memory is exhausted. On failure there is no stream, and the functions below return
  // SINEW_ERROR_ARGUMENT.
  sinew_status make(const sinew_skeleton& source, const sinew_skeleton& target, const int32_t* map,
                    const uint8_t* target_classes, const RetargetSettings& plan_settings, const sinew_motion_body* body,
                    const StreamSettings& settings = {}) {
    stream_ = nullptr;
    size_t bytes = 0;
    const sinew_status status = sinew_retarget_stream_workspace_size(
        source.joint_count, target.joint_count, body == nullptr ? 0 : body->vertex_count,
        body == nullptr ? 0 : body->triangle_count, &bytes);
    if (status != SINEW_OK) return status;
    if (!memory_.reserve(bytes)) return SINEW_ERROR_WORKSPACE;
    return sinew_retarget_stream_create(&source, &target, map, target_classes, &plan_settings, body, &settings,
                                        memory_.data(), memory_.size(), &stream_);
  }
  sinew_status frame(const float* rotations, const float* translations, float* out_rotations, float* out_translations) {
    return sinew_retarget_stream_frame(stream_, rotations, translations, out_rotations, out_translations);
  }
  sinew_status restart() { return sinew_retarget_stream_restart(stream_); }

 private:
  Workspace memory_;
  sinew_retarget_stream* stream_ = nullptr;
};

// sinew_springs and its memory.
class SpringSystem {
 public:
  // Size query, memory and sinew_springs_create(); options may be null. Returns what they do; SINEW_ERROR_WORKSPACE
  // if memory is exhausted. On failure there are no springs, and the functions below return SINEW_ERROR_ARGUMENT.
  sinew_status make(const sinew_skeleton& skeleton, const sinew_spring_set& set,
                    const sinew_springs_options* options = nullptr) {
    springs_ = nullptr;
    size_t bytes = 0;
    const sinew_status status = sinew_springs_workspace_size(skeleton.joint_count, set.joint_count, set.chain_count,
                                                             set.collider_count, set.chain_collider_count, &bytes);
    if (status != SINEW_OK) return status;
    if (!memory_.reserve(bytes)) return SINEW_ERROR_WORKSPACE;
    return sinew_springs_create(&skeleton, &set, options, memory_.data(), memory_.size(), &springs_);
  }
  sinew_status frame(float seconds, const float* rotations, const float* translations, float* out_rotations) {
    return sinew_springs_frame(springs_, seconds, rotations, translations, out_rotations);
  }
  sinew_status restart() { return sinew_springs_restart(springs_); }

 private:
  Workspace memory_;
  sinew_springs* springs_ = nullptr;
};

// sinew_deform_options with every default; {} where a function takes deform options.
struct DeformOptions : sinew_deform_options {
  DeformOptions() : sinew_deform_options(SINEW_INIT(sinew_deform_options)) {}
  DeformOptions(const sinew_deform_options& options) : sinew_deform_options(options) {}
};

// A deformer with its memory and a workspace for one pose at a time.
class Deformer {
 public:
  // sinew_deform_create() with the size query and the memory managed. Returns what they do;
  // SINEW_ERROR_WORKSPACE if memory is exhausted. On failure there is no deformer.
  sinew_status create(const sinew_mesh& mesh, const sinew_skeleton& skeleton, const sinew_skin& skin,
                      const DeformOptions& options) {
    deformer_ = {};
    size_t bytes = 0;
    sinew_status status =
        sinew_deform_create_workspace_size(&mesh, skeleton.joint_count, skin.influence_count, &options, &bytes);
    if (status != SINEW_OK) return status;
    if (!memory_.reserve(bytes)) return SINEW_ERROR_WORKSPACE;
    status = sinew_deform_create(&mesh, &skeleton, &skin, &options, memory_.data(), memory_.size(), &deformer_);
    if (status == SINEW_OK && !workspace_.reserve(deformer_.pose_bytes)) {
      deformer_ = {};
      status = SINEW_ERROR_WORKSPACE;
    }
    return status;
  }
  // As sinew_deform_pose(). SINEW_ERROR_ARGUMENT without a deformer.
  sinew_status pose(const float* palette, sinew_deform_outputs* outputs) {
    return sinew_deform_pose(&deformer_, palette, workspace_.data(), workspace_.size(), outputs);
  }
  const sinew_deformer& get() const { return deformer_; }
  size_t memory_bytes() const { return memory_.size(); }

 private:
  sinew_deformer deformer_ = {};
  Workspace memory_, workspace_;
};

}  // namespace sinew
#endif
