// SPDX-License-Identifier: MIT
// Model files and the bundled models, opened and packed.
#include "sinew_character/models/models.hpp"

#include <cstring>
#include <filesystem>

#include "front/front_points.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/io.hpp"
#include "votes/rig_task.hpp"

namespace sinew {

using namespace rigging;

namespace {

sinew_status open_for(ModelUse use, const void* bytes, size_t size, sinew_model* model) {
  if (use == ModelUse::kBind) return sinew_model_open(bytes, size, model);
  const sinew_status status = sinew_rig_model_open(bytes, size, model);
  // Bodies, hands and slots have models of their own.
  const uint32_t wanted = use == ModelUse::kHands        ? kHandsFeatureSet
                          : use == ModelUse::kSlotJoints ? kSlotsFeatureSet
                          : use == ModelUse::kFront      ? kFrontFeatureSet
                                                         : kRigFeatureSet;
  return status == SINEW_OK && model->feature_set != wanted ? SINEW_ERROR_MODEL_TASK : status;
}

// Once for all characters that it will bind.
void pack_weights(LoadedModel* loaded) {
  size_t bytes = 0;
  if (sinew_model_pack_workspace_size(&loaded->model, &bytes) == SINEW_OK && loaded->packed.reserve(bytes))
    (void)sinew_model_pack(&loaded->model, loaded->packed.data(), bytes);
}

}  // namespace

std::unique_ptr<LoadedModel> model_from_bytes(const std::vector<uint8_t>& bytes, const std::string& what,
                                              ModelUse use) {
  auto loaded = std::make_unique<LoadedModel>();
  loaded->storage.resize(bytes.size() / 8 + 1);
  if (!bytes.empty()) std::memcpy(loaded->storage.data(), bytes.data(), bytes.size());
  const sinew_status status = open_for(use, loaded->storage.data(), bytes.size(), &loaded->model);
  const char* cure = status == SINEW_ERROR_MODEL_MAGIC ? "; make one from a checkpoint with: sinew-lab quantize" : "";
  if (bytes.empty()) throw Error(what + ": the file is empty, expected a model (.sinew)");
  if (status != SINEW_OK) throw Error(what + ": " + sinew_status_text(status) + cure);
  pack_weights(loaded.get());
  return loaded;
}

namespace {

bool is_bundled(const std::string& path) { return path.empty() || path == "bundled"; }

}  // namespace

std::string model_label(const std::string& path) {
  return is_bundled(path) ? "bundled model" : std::filesystem::path(path).filename().string();
}

std::unique_ptr<LoadedModel> load_front_model(const std::string& path) {
  return is_bundled(path) && kBundledFrontModelSize == 0 ? nullptr : load_model(path, ModelUse::kFront);
}

std::unique_ptr<LoadedModel> load_model(const std::string& path, ModelUse use) {
  if (!is_bundled(path)) return model_from_bytes(read_file(path), path, use);
  struct Bundled {
    const uint8_t* bytes;
    size_t size;
    const char* missing;
  };
  const Bundled bundled =
      use == ModelUse::kRig
          ? Bundled{kBundledRigModel, kBundledRigModelSize, "no bundled model of skeletons; give --model"}
      : use == ModelUse::kHands
          ? Bundled{kBundledHandsModel, kBundledHandsModelSize, "no bundled model of hands; give --hands-model"}
      : use == ModelUse::kSlotJoints
          ? Bundled{kBundledSlotsModel, kBundledSlotsModelSize, "no bundled model of slots; give --model"}
      : use == ModelUse::kFront
          ? Bundled{kBundledFrontModel, kBundledFrontModelSize, "no bundled model of fronts; give --front-model"}
          : Bundled{kBundledModel, kBundledModelSize, "no bundled model; give --model or --method heat"};
  if (bundled.size == 0) throw Error(bundled.missing);
  auto loaded = std::make_unique<LoadedModel>();
  const sinew_status status = open_for(use, bundled.bytes, bundled.size, &loaded->model);
  if (status != SINEW_OK) throw Error(std::string("the bundled model: ") + sinew_status_text(status));
  pack_weights(loaded.get());
  return loaded;
}

std::unique_ptr<LoadedModel> load_any_model(const std::string& path, ModelUse* use) {
  *use = ModelUse::kBind;
  if (is_bundled(path)) return load_model(path);
  const std::vector<uint8_t> bytes = read_file(path);
  for (const ModelUse one : {ModelUse::kRig, ModelUse::kHands, ModelUse::kSlotJoints, ModelUse::kFront}) {
    sinew_model ignored{};
    if (open_for(one, bytes.data(), bytes.size(), &ignored) == SINEW_OK) *use = one;
  }
  return model_from_bytes(bytes, path, *use);
}

}  // namespace sinew
