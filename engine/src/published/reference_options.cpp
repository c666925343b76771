// SPDX-License-Identifier: MIT
// Options of reference points, checked.
#include <stddef.h>

#include "core/struct_size.hpp"
#include "motion/reference_points.hpp"

namespace sinew::motion {

sinew_status read_reference_options(const sinew_reference_options* options, ReferenceOptions* out, Progress* progress) {
  sinew_reference_options o = SINEW_INIT(sinew_reference_options);
  // The struct of the first release, 0.1, ends with progress_user.
  constexpr uint32_t kFirstSize = offsetof(sinew_reference_options, progress_user) + sizeof(void*);
  const sinew_status status = options == nullptr ? SINEW_OK : read_struct(options, kFirstSize, sizeof o, &o);
  if (status != SINEW_OK) return status;
  const double no_falloff = static_cast<double>(SINEW_NO_FALLOFF);
  const double falloff = static_cast<double>(o.falloff), least = static_cast<double>(o.least_cosine);
  if ((o.area_power > 4 && o.area_power != SINEW_NO_AREA) || o.own_limb > 1 || o.legs > 1 || o.head > 1 ||
      o.torso > 1 || o.source_points > 1 || o.as_drawn > 1 ||
      !(falloff >= 0 || (falloff <= no_falloff && falloff >= no_falloff)) || !is_finite(falloff) ||
      !(least >= 0 && least <= 1)) {
    return SINEW_ERROR_ARGUMENT;
  }
  *out = ReferenceOptions();
  out->as_drawn = o.as_drawn != 0;
  if (o.area_power != 0) out->area_power = o.area_power == SINEW_NO_AREA ? 0 : o.area_power;
  if (out->as_drawn) o.own_limb = o.legs = o.head = o.torso = o.source_points = 1;
  out->own_limb = o.own_limb != 0;
  out->legs = o.legs != 0;
  out->head = o.head != 0;
  out->torso = o.torso != 0;
  out->source_points = o.source_points != 0;
  if (falloff > 0) out->falloff = falloff;
  if (falloff < 0 || out->as_drawn) out->falloff = 0;
  if (least > 0) out->least_cosine = least;
  *progress = Progress{o.progress, o.progress_user};
  return SINEW_OK;
}

}  // namespace sinew::motion
