// SPDX-License-Identifier: MIT
// Lines of a clip become angles of joints, shifts of the root and paths of feet, frame by frame.
#include "clips/performance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "sinew_formats/error.hpp"

namespace sinew::clips {
namespace {

constexpr double kFps = 30, kReach = 0.9985, kLower = 0.004, kLowest = 0.4;

// Joints of a leg: two bones to `end`, a third one to `ankle` where that is another joint, then the foot's ball.
struct Leg {
  size_t upper, lower, end, ankle, ball;
  Point3 bend;
  FootShape shape;
};

struct Moved {  // what a line says of one joint
  const Line* line;
  size_t joint;
  double late, grow, sign;  // sign of y and z: the right side is the mirror image
};

class Performance {
 public:
  Performance(Puppet* puppet, const Block& kind, const Block& clip, const Block* variant) : puppet_(puppet) {
    const Line& head = clip.head;
    const double tempo = variant != nullptr ? variant->head.number("tempo", 1) : 1;
    frames_ = static_cast<size_t>(std::lround(head.number("frames", 30) / tempo));
    reach_ = variant != nullptr ? variant->head.number("travel", 1) : 1;
    travel_ = reach_ * head.number("travel", 0);
    sides_ = head.number("sides", 0);
    signals_.add(kind.lines);
    signals_.add(clip.lines);
    if (variant != nullptr) signals_.vary(variant->lines);
    std::map<std::string, const Line*> legs;  // by the ankle: a later line replaces an earlier one
    for (const Block* block : {&kind, &clip})
      for (const Line& line : block->lines) {
        if (line.verb == "leg" && line.names.size() > 1) legs[line.names[line.names.size() - 2]] = &line;
        if (line.verb == "turn") add(line, &turns_);
        if (line.verb == "steady") add(line, &steadies_);
        if (line.verb == "foot") add(line, &feet_);
        if (line.verb == "move") moves_.push_back(&line);
      }
    for (const auto& [ankle, line] : legs)
      if (!puppet_->is_left_out(ankle)) add_leg(*line);
  }

  Clip clip(const std::string& name) {
    for (double drop = 0;; drop += kLower) {
      Clip clip = {name, 1 / kFps, {}};
      puppet_->take_stretch();
      for (size_t f = 0; f <= frames_; ++f) {
        pose(static_cast<double>(f % frames_) / static_cast<double>(frames_), drop);
        clip.frames.push_back(puppet_->frame());
        clip.frames.back().translations[0][2] += travel_ * static_cast<double>(f) / static_cast<double>(frames_);
      }
      if (puppet_->take_stretch() <= kReach || drop > kLowest) return clip;
    }
  }

 private:
  // Applies to the left side and, a share of the cycle later, to the right one, unless "!" follows the name: that one
  // alone.
  void add(const Line& line, std::vector<Moved>* moved) const {
    const double later = line.number("later", 0), grow = line.number("grow", 1);
    for (size_t n = 0; n < line.names.size(); ++n) {
      std::string name = line.names[n];
      const bool alone = name.back() == '!';
      if (alone) name.pop_back();
      if (puppet_->is_left_out(name)) continue;
      const size_t joint = puppet_->index(name), twin = puppet_->twin(joint);
      const double late = later * static_cast<double>(n), gain = std::pow(grow, static_cast<double>(n));
      moved->push_back({&line, joint, late, gain, puppet_->is_right(joint) ? -1.0 : 1.0});
      if (!alone && twin != joint) moved->push_back({&line, twin, late - sides_, gain, -1});
    }
  }

  void add_leg(const Line& line) {
    const size_t count = line.names.size();
    if (count != 4 && count != 5) throw Error("gaits: expected 4 or 5 joints of a leg, found " + std::to_string(count));
    for (const bool right : {false, true}) {
      const auto joint = [&](size_t n) {
        const size_t left = puppet_->index(line.names[n]);
        return right ? puppet_->twin(left) : left;
      };
      Leg leg = {joint(0), joint(1), joint(2), joint(count - 2), joint(count - 1), {}, {}};
      leg.bend = {(right ? -1 : 1) * line.number("x", 0), line.number("y", 0), line.number("z", 0)};
      leg.shape = {puppet_->rest_position(leg.ankle), {}, puppet_->rest_position(leg.ball)};
      leg.shape.heel = {leg.shape.ankle[0], 0.01, leg.shape.ankle[2] - line.number("heel", 0.03)};
      legs_.push_back(leg);
    }
  }

  double value(const Moved& moved, const char* name, double phase) const {
    const Sum* sum = moved.line->find(name);
    return sum == nullptr ? 0 : moved.grow * signals_.value(*sum, phase - moved.late);
  }

  void pose(double phase, double drop) {
    puppet_->to_rest();
    Point3 shift = {0, -drop, 0};
    for (const Line* line : moves_)
      for (const auto& [axis, sum] : line->values)
        shift[axis == "x" ? 0 : axis == "y" ? 1 : 2] += signals_.value(sum, phase);
    puppet_->move_root(shift);

    std::vector<std::array<double, 4>> angles(puppet_->motion().joints.size());
    std::vector<double> steady(angles.size());
    for (const Moved& turn : turns_) {
      std::array<double, 4>& a = angles[turn.joint];
      a[0] += value(turn, "x", phase);
      a[1] += turn.sign * value(turn, "y", phase);
      a[2] += turn.sign * value(turn, "z", phase);
      a[3] += value(turn, "roll", phase);
    }
    for (const Moved& one : steadies_) steady[one.joint] += value(one, "share", phase);
    for (size_t j = 0; j < angles.size(); ++j) {
      const auto& [x, y, z, roll] = angles[j];
      Quaternion q = multiply(multiply(about_y(y), about_x(x)), multiply(about_z(z), about_x(roll)));
      if (steady[j] != 0) q = multiply(slerp(kNoRotation4, conjugate(puppet_->carried(j)), steady[j]), q);
      puppet_->turn(j, q);
    }
    for (const Leg& leg : legs_) place(leg, phase);
  }

  // A leg that no line puts on the floor is rotated joint by joint.
  void place(const Leg& leg, double phase) {
    std::vector<const Moved*> lines;
    const Moved* step = nullptr;
    for (const Moved& foot : feet_)
      if (foot.joint == leg.ankle) {
        lines.push_back(&foot);
        if (step == nullptr || foot.line->find("stance") != nullptr) step = &foot;
      }
    if (step == nullptr) return;
    const auto start = [](const Moved& foot) { return foot.late + foot.line->number("phase", 0); };
    double own = phase - start(*step);  // from where the foot begins to stand
    own -= std::floor(own);
    const auto sum = [&](const char* name, double at) {
      double total = 0;
      for (const Moved* foot : lines)
        if (const Sum* one = foot->line->find(name)) total += signals_.value(*one, at + start(*step) - start(*foot));
      return total;
    };
    FootPath path;
    path.stance = step->line->number("stance", 1);
    path.stride = travel_;
    path.front = reach_ * step->line->number("front", 0);
    path.lift = step->line->number("lift", 0);
    path.pitch = [&](double at) { return sum("pitch", at); };
    const FootPose foot = foot_at(path, leg.shape, own);
    const double sign = puppet_->is_right(leg.ankle) ? -1 : 1;
    const Point3 ankle = foot.ankle + Point3{sign * sum("x", own), sum("y", own), sum("z", own)};
    const Quaternion lean = about_x(sum("hock", own));
    const Point3 bone = puppet_->rest_position(leg.end) - leg.shape.ankle;
    puppet_->reach(leg.upper, leg.lower, leg.end, ankle + rotate(lean, bone), leg.bend);
    if (leg.end != leg.ankle) puppet_->turn_in_world(leg.end, lean);
    puppet_->turn_in_world(leg.ankle, about_x(foot.pitch));
    if (!puppet_->is_end(leg.ball)) puppet_->turn_in_world(leg.ball, about_x(foot.toes + sum("toes", own)));
  }

  Puppet* puppet_;
  Signals signals_;
  size_t frames_ = 0;
  double travel_ = 0, sides_ = 0;
  double reach_ = 1;  // of a variant's steps, over the clip's
  std::vector<Leg> legs_;
  std::vector<Moved> turns_, steadies_, feet_;
  std::vector<const Line*> moves_;
};

// Left is right and right is left.
Clip mirrored(const Puppet& puppet, const Clip& clip) {
  Clip image = clip;
  for (size_t f = 0; f < clip.frames.size(); ++f)
    for (size_t j = 0; j < puppet.motion().joints.size(); ++j) {
      const Quaternion& q = clip.frames[f].rotations[puppet.twin(j)];
      const Point3& p = clip.frames[f].translations[puppet.twin(j)];
      image.frames[f].rotations[j] = {q[0], -q[1], -q[2], q[3]};
      image.frames[f].translations[j] = {-p[0], p[1], p[2]};
    }
  return image;
}

}  // namespace

Puppet puppet_of(const Block& kind) {
  std::vector<std::string> without, spliced;
  for (const Line& line : kind.lines) {
    if (line.verb == "without") without.insert(without.end(), line.names.begin(), line.names.end());
    if (line.verb == "splice") spliced.insert(spliced.end(), line.names.begin(), line.names.end());
  }
  const std::vector<std::string>& head = kind.head.names;  // kind, skeleton, prefix of its names
  return Puppet(head.at(1), head.size() > 2 ? head[2] : "", without, spliced);
}

Clip perform(Puppet* puppet, const Block& kind, const Block& clip, const Block* variant) {
  const std::string name = clip.head.names.at(0) + (variant == nullptr ? "" : "_" + variant->head.names.at(0));
  Clip performed = Performance(puppet, kind, clip, variant).clip(name);
  return variant != nullptr && variant->head.number("mirror", 0) != 0 ? mirrored(*puppet, performed) : performed;
}

}  // namespace sinew::clips
