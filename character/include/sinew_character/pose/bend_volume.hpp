// SPDX-License-Identifier: MIT
// Volume of a bend in a pose relative to rest, which linear skinning loses at elbows and knees.
#ifndef SINEW_CHARACTER_BEND_VOLUME_HPP
#define SINEW_CHARACTER_BEND_VOLUME_HPP

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

// A joint's bend is the surface that partly moves with it: faces with a vertex whose weight for the joint and its
// descendants is between 2 and 98 %, and the faces around them. Its volume is the enclosed volume, with holes closed
// by fans. Parts with less than a fifth of the largest part's volume are ignored, and so are those that enclose
// almost nothing, such as a cape.
class BendVolumes {
 public:
  // Takes a character with weights, which need not outlive the object. Throws Error for a hierarchy with a cycle.
  explicit BendVolumes(const Character& character);

  // Returns the volume of the joint's bend divided by that at rest.
  //   positions  [V x 3] of the posed mesh
  // Returns nullopt if the joint has no bend. The bend is computed on first use.
  std::optional<double> kept(size_t joint, const std::vector<float>& positions);

 private:
  using Triangle = std::array<uint32_t, 3>;
  using Edge = std::array<uint32_t, 2>;
  struct Part {
    std::vector<Triangle> triangles;
    std::vector<std::vector<Edge>> holes;  // the edges of each, as their triangle has them
    double rest = 0;                       // signed volume
  };
  struct Bend {
    std::vector<Part> parts;
    double rest = 0;  // sum of the parts' sizes
  };
  static double volume(const Part& part, const std::vector<float>& positions);
  std::vector<bool> moved_by(size_t joint) const;  // [J] the joint and its descendants
  std::vector<Triangle> bend_triangles(size_t joint) const;
  void find_holes(Part* part) const;
  double area(const Part& part) const;
  Bend make_bend(size_t joint) const;

  std::vector<float> rest_;                         // [V x 3]
  std::vector<Triangle> triangles_;                 // of positions, none flat
  std::vector<uint32_t> position_;                  // [V] first vertex there
  std::vector<std::vector<Influence>> influences_;  // [V]
  std::vector<int> parents_;                        // [J]
  std::map<size_t, Bend> bends_;                    // of joints that were used
};

}  // namespace sinew
#endif
