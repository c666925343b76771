// SPDX-License-Identifier: MIT
// A skeleton on the way to something else. Apart from rig_job.cpp, whose users bring models of their own and need no bundled ones.
#include <memory>
#include <utility>

#include "sinew_character/jobs/rig_job.hpp"
#include "sinew_character/models/models.hpp"

namespace sinew {

Character rig_bare_mesh(Character mesh) {
  const std::unique_ptr<LoadedModel> rig = load_model("", ModelUse::kRig), bind = load_model(""),
                                     hands = load_model("", ModelUse::kHands), front = load_front_model();
  const RigModels models = {&rig->model, &bind->model, &hands->model, front ? &front->model : nullptr};
  return rig_character(std::move(mesh), {}, models).character;
}

}  // namespace sinew
