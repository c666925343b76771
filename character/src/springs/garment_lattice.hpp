// SPDX-License-Identifier: MIT
// The lattice of a garment: lines from its top to its hem on the outermost surface of its sections, and where vertices lie between them.
#ifndef SINEW_SPRINGS_GARMENT_LATTICE_HPP
#define SINEW_SPRINGS_GARMENT_LATTICE_HPP

#include <array>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "springs/find_garments.hpp"
#include "springs/sections.hpp"

namespace sinew {

// The sections of one garment, and which curves of each are its own.
struct GarmentLevels {
  double top = 0, bottom = 0;
  std::vector<std::vector<SectionCurve>> sections;  // [levels][curves]
  std::vector<std::vector<size_t>> curves;          // [levels]
  size_t last = 0;                                  // the lowest level that has some

  double step() const { return (top - bottom) / static_cast<double>(sections.size() - 1); }
  double height(size_t level) const {
    return top - (top - bottom) * static_cast<double>(level) / static_cast<double>(sections.size() - 1);
  }
};

class GarmentLattice {
 public:
  // How far around or across a garment a point of a section is, 0..1.
  using Coordinate = std::function<double(const Point2&, double height)>;
  // The middle of the body at a height.
  using Middle = std::function<Point2(double height)>;

  //   height  of the character
  //   skirt   the garment goes around; else it is a sheet, from its left edge to its right one
  GarmentLattice(const SectionedMesh& mesh, double height, bool skirt, const GarmentLevels& levels,
                 const Coordinate& coordinate, const Middle& middle);

  bool is_ring() const { return ring_; }
  // From the top to the hem, at equal distances around or across; empty where the surface has a hole under one.
  std::vector<std::vector<Point3>> lines() const;
  // How many lines along a vertex is, 0 to the number of lines, and how far down between the top and the hem, 0..1.
  std::array<double, 2> position_of(size_t vertex) const;

 private:
  static constexpr size_t kParts = 48;  // around or across

  void sample();
  void find_extent();
  size_t line_count() const;
  double share_of(size_t line) const;
  std::optional<size_t> part_beside(size_t part, std::ptrdiff_t offset) const;
  size_t part_at(double share) const;
  std::optional<Point3> surface_near(size_t part, double level) const;
  double hem_near(size_t part) const;
  std::pair<double, double> widest_arc() const;

  const SectionedMesh& mesh_;
  const double height_;
  const bool skirt_;
  const GarmentLevels& levels_;
  const Coordinate coordinate_;
  const Middle middle_;
  // By part and level: the point farthest from the middle, which is where lines run.
  std::vector<std::vector<std::optional<Point2>>> surface_;
  double around_ = 0;         // the longest curve, or of a sheet its mean width
  std::vector<double> hems_;  // [parts] the lowest level, -1 where the part is empty
  bool ring_ = false;
  double from_ = 0, to_ = 1;  // the part of a turn that is covered
  size_t count_ = 0;          // of lines
  std::vector<double> line_hems_;
};

}  // namespace sinew
#endif
