// SPDX-License-Identifier: MIT
// Training samples of hands: points of a hand's crop with the finger bones that move them.
#ifndef SINEW_TRAINER_DATA_HAND_SAMPLE_HPP
#define SINEW_TRAINER_DATA_HAND_SAMPLE_HPP

#include <optional>

#include "data/rig_sample.hpp"
#include "details/hand_class.hpp"
#include "sinew_data_sets/target_skeleton.hpp"
#include "sinew_formats/base/point.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew {

inline constexpr size_t kWrist = 1;  // of a hand's own joints

// One hand of a character, ready to be bent, stretched, cropped and sampled. Labels follow the joints.
class HandSource {
 public:
  HandSource(const Character& character, const TargetHand& hand);

  // strength 0: the hand as it is, where a body's skeleton would say it is, which is never quite right; 1: fingers bend
  // and grow, one may be missing, the hand rotates. The same seed gives the same sample; nullopt where nothing was
  // left of the hand.
  std::optional<RigSample> make(uint64_t seed, double strength) const;

 private:
  // Joints of the hand's own: 0 what does not belong to it, 1 the wrist, then those of the fingers.
  struct HandJoint {
    Point3 at{};
    int parent = -1;  // of these
    uint8_t hand_class = rigging::kHandRest;
  };
  struct HandFinger {
    uint32_t finger = 0;
    std::vector<uint32_t> joints;  // of these
    std::optional<Point3> end;
  };
  struct Posed {
    std::vector<Point3> vertices, joints;     // [V], [joints_]
    std::vector<std::optional<Point3>> ends;  // [fingers_]
    Point3 palm_end{};
    std::vector<uint8_t> classes;  // [joints_] HandClass; those of a missing finger are kHandPalm
  };
  class Labels;
  class Motion;
  Posed pose(uint64_t seed, double strength) const;

  std::string name_, family_;
  double length_ = 1;
  std::vector<Point3> vertices_;  // [V] from the wrist, a left hand
  std::vector<std::array<uint32_t, 3>> triangles_;
  std::vector<std::vector<Influence>> influences_;  // [V] of joints_
  std::vector<HandJoint> joints_;
  std::vector<HandFinger> fingers_;
  Point3 elbow_{}, palm_end_{};
};

// The hands of a character that teach something: its clear ones.
std::vector<HandSource> hand_sources(const Character& character);

}  // namespace sinew
#endif
