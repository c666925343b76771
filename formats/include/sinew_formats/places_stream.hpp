// SPDX-License-Identifier: MIT
// Places of joints as they come, from a camera or a capture, to rotations of a person's joints: what a stream of
// sinew/motion_stream.h takes.
#ifndef SINEW_FORMATS_PLACES_STREAM_HPP
#define SINEW_FORMATS_PLACES_STREAM_HPP

#include <memory>
#include <string>
#include <vector>

#include "sinew_formats/motion.hpp"

namespace sinew {

class PlacesSolver;
struct PlacesLayout;

class PlacesStream {
 public:
  //   layout  of motion_layouts()
  //   first   [frames][places of the layout] of the person that moves, any unit: lengths of bones, which way is up, whether the world is
  //           mirrored and whether places are relative to the hips are learnt from them. One will do; a second or two are better
  // Throws Error.
  PlacesStream(const std::string& layout, const std::vector<std::vector<Point3>>& first);
  PlacesStream(PlacesStream&&) noexcept;
  ~PlacesStream();

  // Joints with their places at rest, y up, notes of what was found out, and `first` as a clip at the layout's own rate.
  const Motion& person() const;
  // Rotations and translations of person()'s joints in the frame of these places, of this frame alone. Throws Error.
  MotionFrame next(const std::vector<Point3>& places) const;

 private:
  void check(const std::vector<Point3>& row) const;

  const PlacesLayout* layout_ = nullptr;
  std::unique_ptr<PlacesSolver> solver_;
};

}  // namespace sinew
#endif
