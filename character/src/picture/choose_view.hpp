// SPDX-License-Identifier: MIT
// Which of several looks at a picture is the right one.
#ifndef SINEW_CHARACTER_PICTURE_CHOOSE_VIEW_HPP
#define SINEW_CHARACTER_PICTURE_CHOOSE_VIEW_HPP

#include <cstddef>
#include <vector>

#include "sinew_character/picture/picture_view.hpp"

namespace sinew {

// The one whose votes agree most. Bipeds are drawn from the front: where votes hardly tell, they are seen from there.
inline size_t choose_view(const std::vector<SeenBody>& seen) {
  constexpr float kHardly = 1.11f;  // times the least spread
  size_t best = 0;
  for (size_t s = 1; s < seen.size(); ++s)
    if (seen[s].skeleton.spread < seen[best].skeleton.spread) best = s;
  if (seen[best].body != BodyClass::kBiped) return best;
  for (size_t s = 0; s < seen.size(); ++s)
    if (seen[s].view == PictureView::kFront && seen[s].skeleton.spread < kHardly * seen[best].skeleton.spread) return s;
  return best;
}

}  // namespace sinew
#endif
