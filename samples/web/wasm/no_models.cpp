// SPDX-License-Identifier: MIT
// The page fetches its models, so its module has none.
#include "sinew_character/models/models.hpp"

namespace sinew {

const uint8_t kBundledModel[1] = {0}, kBundledRigModel[1] = {0}, kBundledHandsModel[1] = {0},
              kBundledFrontModel[1] = {0}, kBundledSlotsModel[1] = {0};
const size_t kBundledModelSize = 0, kBundledRigModelSize = 0, kBundledHandsModelSize = 0, kBundledFrontModelSize = 0,
             kBundledSlotsModelSize = 0;

}  // namespace sinew
