// SPDX-License-Identifier: MIT
// A page on files that were checked: a picture for every finding, with the camera on it.
#ifndef SINEW_CHARACTER_CHECK_PAGE_HPP
#define SINEW_CHARACTER_CHECK_PAGE_HPP

#include <string>
#include <vector>

#include "sinew_character/check/check_output.hpp"
#include "sinew_character/draw/image.hpp"

namespace sinew {

// The finding's vertices ringed, or its joint, in the pose or the frame in which it shows; colours are the joints', by weight.
Image finding_picture(const CheckedFile& file, const RigFinding& finding);

// One page that needs nothing else. Of a file's findings the first 40 have a picture.
std::string check_html(const std::vector<CheckedFile>& files);

}  // namespace sinew
#endif
