// SPDX-License-Identifier: MIT
// Progress that a bind has reported when a stage ends. A stage reports from where the one before it ended.
#ifndef SINEW_BIND_PROGRESS_HPP
#define SINEW_BIND_PROGRESS_HPP

#include <stdint.h>

namespace sinew {

// Permille of the whole bind.
namespace ends_at {
constexpr uint32_t kMesh = 50;
constexpr uint32_t kReduction = 100;
constexpr uint32_t kCandidates = 200;
constexpr uint32_t kHeat = 600;
constexpr uint32_t kHeatAlone = 950;  // for method heat: no stage from here to the rows, and none for candidates before
constexpr uint32_t kFeatures = 620;
constexpr uint32_t kSpectral = 650;  // reported instead of kFeatures if there is no spectral stage
constexpr uint32_t kNetwork = 990;
constexpr uint32_t kNetworkBeforeEdits = 960;  // if edits follow
constexpr uint32_t kEdits = 990;
constexpr uint32_t kRows = 1000;
}  // namespace ends_at

}  // namespace sinew
#endif
