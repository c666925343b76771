// SPDX-License-Identifier: MIT
// The skeleton of a flat mesh that stands: paper figures, puppets cut from cloth. Networks know round bodies alone.
#ifndef SINEW_CHARACTER_JOBS_SHEET_SKELETON_HPP
#define SINEW_CHARACTER_JOBS_SHEET_SKELETON_HPP

#include <optional>

#include "sinew_character/jobs/rig_job.hpp"

namespace sinew {

// The skeleton that rig_picture() finds in the outline of the mesh, in the mesh's plane. Empty if the mesh is no
// upright sheet.
//   votes      of the mesh itself: which axis is up, and the front that the user gave
//   character  gets notes
std::optional<PredictedSkeleton> sheet_skeleton(const RigJobOptions& job, const RigModels& models,
                                                const PredictedSkeleton& votes, Character* character);

}  // namespace sinew
#endif
