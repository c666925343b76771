// SPDX-License-Identifier: MIT
// How much of its volume a bend keeps in a pose: what linear skinning loses at elbows and knees.
#ifndef SINEW_CHARACTER_BEND_VOLUME_HPP
#define SINEW_CHARACTER_BEND_VOLUME_HPP

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "sinew_formats/character.hpp"

namespace sinew {

// A joint's bend is the surface that moves with it in part: faces with a vertex whose weight for the joint and all below it is
// between 2 and 98 %, and those around them. Its volume is that within, holes closed by fans. Parts of the bend with less than a
// fifth of the largest one's volume do not count, and neither does what encloses next to nothing, as a cape's cloth.
class BendVolumes {
 public:
  // Of a character with weights; it may go away. Throws Error for a hierarchy with a cycle.
  explicit BendVolumes(const Character& character);

  // Volume of the joint's bend over that at rest: 1 where it keeps all.
  //   positions  [V x 3] of the posed mesh
  // None where the joint has no bend. What a bend is made of is found when it is first asked for.
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
  std::vector<bool> moved_by(size_t joint) const;  // [J] itself, and what hangs on it
  std::vector<Triangle> bend_triangles(size_t joint) const;
  void find_holes(Part* part) const;
  double area(const Part& part) const;
  Bend make_bend(size_t joint) const;

  std::vector<float> rest_;                         // [V x 3]
  std::vector<Triangle> triangles_;                 // of positions, none flat
  std::vector<uint32_t> position_;                  // [V] first vertex there
  std::vector<std::vector<Influence>> influences_;  // [V]
  std::vector<int> parents_;                        // [J]
  std::map<size_t, Bend> bends_;                    // of joints that were asked for
};

}  // namespace sinew
#endif
