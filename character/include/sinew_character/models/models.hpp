// SPDX-License-Identifier: MIT
// Models ready for use: from a file, from bytes, or the ones that are built in.
#ifndef SINEW_CHARACTER_MODELS_HPP
#define SINEW_CHARACTER_MODELS_HPP

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "sinew/sinew.hpp"

namespace sinew {

// A checked model and the bytes it stands on.
struct LoadedModel {
  std::vector<uint64_t> storage;  // 8-byte aligned copy of a file; empty for the bundled model
  sinew::Workspace packed;        // its weights for the processor's kernels
  sinew_model model{};
};
// What a model is opened for.
enum class ModelUse { kBind, kRig, kHands, kSlotJoints, kFront };
// `path` empty or "bundled": the model built into the program. Throws Error.
std::unique_ptr<LoadedModel> load_model(const std::string& path, ModelUse use = ModelUse::kBind);
// The same of ModelUse::kFront; null where that is bundled and the program was built without one: votes tell the front then.
std::unique_ptr<LoadedModel> load_front_model(const std::string& path = "");
std::string model_label(const std::string& path);  // "bundled model" or the file's name
std::unique_ptr<LoadedModel> model_from_bytes(const std::vector<uint8_t>& bytes, const std::string& what,
                                              ModelUse use = ModelUse::kBind);

}  // namespace sinew
#endif
