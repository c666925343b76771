// SPDX-License-Identifier: MIT
// BVH (Biovision): a tree of joints with offsets and channels, then a line of numbers per frame.
#include <algorithm>
#include <numbers>

#include "sinew_formats/base/affine.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/file_kinds.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/motion.hpp"
#include "text/joint_names.hpp"
#include "text/text_lines.hpp"

namespace sinew {
namespace {

// One column of the frames.
struct Channel {
  size_t joint = 0;
  size_t axis = 0;
  bool rotates = false;  // else it moves
};

// A frame whose line has fewer numbers than there are channels, or more.
struct IncompleteFrame {
  size_t index, line, numbers;
};

// Keywords are written in any case.
bool is_word(std::string_view found, std::string_view wanted) {
  return std::equal(found.begin(), found.end(), wanted.begin(), wanted.end(), [](char a, char b) {
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
    return lower(a) == lower(b);
  });
}

class BvhReader {
 public:
  BvhReader(const std::string& path, std::string_view text) : path_(path), lines_(path, text) {}

  Motion read() {
    motion_.name = stem_of(path_);
    read_hierarchy();
    read_frames();
    std::vector<std::string> names;
    for (const MotionJoint& joint : motion_.joints) names.push_back(joint.name);
    make_names_unique(&names);
    for (size_t j = 0; j < names.size(); ++j) motion_.joints[j].name = std::move(names[j]);
    return std::move(motion_);
  }

 private:
  // The next statement: a line, of which a brace is one of its own. An Error at the end of the file.
  void next(const char* expected) {
    while (at_ >= lines_.words().size()) {
      if (!lines_.next())
        throw Error(path_ + ": truncated BVH, expected " + expected + " behind line " +
                    std::to_string(lines_.number()) + ", found the end of the file");
      at_ = 0;
    }
    const auto is_brace = [&](size_t i) { return lines_.words()[i] == "{" || lines_.words()[i] == "}"; };
    const size_t first = at_++;
    while (at_ < lines_.words().size() && !is_brace(first) && !is_brace(at_)) ++at_;
    const auto begin = lines_.words().begin();
    words_.assign(begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(at_));
  }
  std::string_view word(size_t i) const { return i < words_.size() ? words_[i] : std::string_view(); }
  double number(size_t i, const char* what) const {
    const std::optional<double> value = to_finite_double(word(i));
    if (!value) lines_.fail(std::string("a finite number as ") + what, word(i));
    return *value;
  }

  std::string name_behind(size_t first) const {
    std::string name;
    for (size_t i = first; i < words_.size(); ++i) name += (name.empty() ? "" : " ") + std::string(words_[i]);
    return name;
  }

  void read_hierarchy() {
    next("HIERARCHY");
    if (!is_word(word(0), "HIERARCHY")) lines_.fail("HIERARCHY", lines_.line());
    for (;;) {
      next("a joint, '}' or MOTION");
      if (is_word(word(0), "MOTION") && open_.empty()) break;
      if (word(0) == "}") {
        close();
      } else if (is_word(word(0), "ROOT") || is_word(word(0), "JOINT") || is_word(word(0), "End")) {
        open_joint();
      } else if (!open_.empty() && is_word(word(0), "OFFSET")) {
        read_offset();
      } else if (!open_.empty() && is_word(word(0), "CHANNELS")) {
        read_channels();
      } else {
        lines_.fail(open_.empty() ? "ROOT or MOTION" : "OFFSET, CHANNELS, JOINT, 'End Site' or '}'", lines_.line());
      }
    }
    if (motion_.joints.empty()) lines_.fail("a ROOT before MOTION", lines_.line());
  }

  void open_joint() {
    const bool root = is_word(word(0), "ROOT"), end = is_word(word(0), "End");
    if (root != open_.empty())
      lines_.fail(open_.empty() ? "ROOT or MOTION" : "JOINT or 'End Site' inside of a joint", lines_.line());
    if (end && !is_word(word(1), "Site")) lines_.fail("'End Site'", lines_.line());
    if (!open_.empty() && motion_.joints[open_.back()].end) lines_.fail("OFFSET and '}' in an End Site", lines_.line());
    MotionJoint joint;
    joint.name = name_behind(end ? 2 : 1);
    joint.parent = open_.empty() ? -1 : static_cast<int>(open_.back());
    joint.end = end;
    if (end) joint.name = motion_.joints[open_.back()].name + "_end";
    if (joint.name.empty()) lines_.fail("a name behind " + std::string(word(0)), lines_.line());
    open_.push_back(motion_.joints.size());
    motion_.joints.push_back(std::move(joint));
    has_offset_.push_back(false);
    has_channels_.push_back(false);
    next("'{'");
    if (word(0) != "{") lines_.fail("'{'", lines_.line());
  }

  void close() {
    if (open_.empty()) lines_.fail("ROOT or MOTION", lines_.line());
    if (!has_offset_[open_.back()])
      lines_.fail("an OFFSET in " + in_quotes(motion_.joints[open_.back()].name) + " before its '}'", lines_.line());
    open_.pop_back();
  }

  void read_offset() {
    const size_t joint = open_.back();
    if (words_.size() != 4) lines_.fail("'OFFSET x y z'", lines_.line());
    if (has_offset_[joint]) lines_.fail("one OFFSET per joint", lines_.line());
    has_offset_[joint] = true;
    for (size_t i = 0; i < 3; ++i) motion_.joints[joint].offset[i] = number(i + 1, "an offset");
  }

  void read_channels() {
    const size_t joint = open_.back();
    const std::optional<int64_t> count = to_integer(word(1));
    if (!count || *count < 0 || *count > 6) lines_.fail("0 to 6 behind CHANNELS", word(1));
    if (words_.size() != static_cast<size_t>(*count) + 2)
      lines_.fail(std::to_string(*count) + " channels", lines_.line());
    if (has_channels_[joint]) lines_.fail("one CHANNELS per joint", lines_.line());
    if (motion_.joints[joint].end) lines_.fail("no CHANNELS in an End Site", lines_.line());
    has_channels_[joint] = true;
    const size_t first = channels_.size();
    for (size_t i = 2; i < words_.size(); ++i) {
      const std::string_view name = word(i);
      const size_t axis = std::string_view("xyzXYZ").find(name[0]);
      const bool rotates = is_word(name.substr(1), "rotation");
      if (axis == std::string_view::npos || (!rotates && !is_word(name.substr(1), "position")))
        lines_.fail("Xposition, Yposition, Zposition, Xrotation, Yrotation or Zrotation", name);
      const Channel channel = {joint, axis % 3, rotates};
      for (size_t c = first; c < channels_.size(); ++c)
        if (channels_[c].axis == channel.axis && channels_[c].rotates == rotates)
          lines_.fail("each channel once", name);
      channels_.push_back(channel);
    }
  }

  void read_frames() {
    next("'Frames: N'");
    const bool apart = word(1) == ":";
    if (!is_word(word(0), apart ? "Frames" : "Frames:")) lines_.fail("'Frames: N'", lines_.line());
    const std::optional<int64_t> count = to_integer(word(apart ? 2 : 1));
    if (!count || *count < 0) lines_.fail("the number of frames", word(apart ? 2 : 1));
    next("'Frame Time: SECONDS'");
    const bool time_apart = word(2) == ":";
    if (!is_word(word(0), "Frame") || !is_word(word(1), time_apart ? "Time" : "Time:"))
      lines_.fail("'Frame Time: SECONDS'", lines_.line());
    Clip clip;
    clip.name = motion_.name;
    clip.frame_time = number(time_apart ? 3 : 2, "the time per frame");
    if (clip.frame_time < 0) lines_.fail("a frame time of 0 or more", lines_.line());
    if (!(clip.frame_time > 0)) {
      clip.frame_time = Clip().frame_time;
      if (*count > 1)
        motion_.notes.push_back("'Frame Time:' is 0; 30 frames per second were assumed, so the speed may be wrong");
    }
    std::vector<IncompleteFrame> incomplete;
    while (lines_.next()) {
      words_ = lines_.words();
      if (words_.empty()) continue;
      const bool whole = words_.size() == channels_.size();
      if (!whole) incomplete.push_back({clip.frames.size(), lines_.number(), words_.size()});
      clip.frames.push_back(whole ? read_frame() : MotionFrame());
    }
    const size_t found = clip.frames.size(), promised = static_cast<size_t>(*count);
    if (found == 0 && promised > 0)
      throw Error(path_ + ": truncated BVH, expected " + std::to_string(promised) + " frames, found none");
    if (found != promised)
      motion_.notes.push_back("warning: 'Frames:' announces " + std::to_string(promised) + " frames, the file has " +
                              std::to_string(found) + "; all of them were read");
    if (!incomplete.empty()) mend_incomplete(incomplete, &clip);
    put_back_in_place(&clip);
    if (!clip.frames.empty()) motion_.clips.push_back(std::move(clip));
  }

  // A few frames without all of their numbers: those at the end are left out, those between others are interpolated.
  // If there are more of them, or the first is incomplete, the channels do not match the frames.
  void mend_incomplete(const std::vector<IncompleteFrame>& incomplete, Clip* clip) {
    constexpr size_t kMostShare = 50;  // one frame in so many, and always one
    const IncompleteFrame& first = incomplete[0];
    if (first.index == 0 || incomplete.size() > 1 + clip->frames.size() / kMostShare)
      lines_.fail_at(first.line, std::to_string(channels_.size()) + " numbers in frame " + std::to_string(first.index),
                     std::to_string(first.numbers) + " of them");
    const size_t all = clip->frames.size();
    while (clip->frames.back().rotations.empty()) clip->frames.pop_back();
    const size_t left_out = all - clip->frames.size(), filled = incomplete.size() - left_out;
    for (size_t k = 0; k < filled; ++k) {
      size_t next = incomplete[k].index + 1;
      while (clip->frames[next].rotations.empty()) ++next;
      const size_t at = incomplete[k].index;
      Clip around;
      around.frame_time = static_cast<double>(next - at + 1);
      around.frames = {clip->frames[at - 1], clip->frames[next]};
      clip->frames[at] = frame_at(around, 1);
    }
    const auto lines = [&](size_t begin, size_t end) {
      return (end - begin > 1 ? "lines " : "line ") + std::to_string(incomplete[begin].line) +
             (end - begin > 1 ? " to " + std::to_string(incomplete[end - 1].line) : "");
    };
    const auto frames = [](size_t n) { return std::to_string(n) + (n > 1 ? " frames" : " frame"); };
    const std::string numbers = " without " + std::to_string(channels_.size()) + " numbers";
    if (filled > 0)
      motion_.notes.push_back("warning: " + frames(filled) + numbers + " (" + lines(0, filled) +
                              "), interpolated from the frames around");
    if (left_out > 0)
      motion_.notes.push_back("warning: " + frames(left_out) + numbers + " at the end (" +
                              lines(filled, incomplete.size()) + "), left out");
  }

  // Some programs write differences from the offset: positions of a joint that are 0 in all frames, where its offset is not.
  void put_back_in_place(Clip* clip) const {
    for (size_t j = 0; j < motion_.joints.size(); ++j) {
      const MotionJoint& joint = motion_.joints[j];
      const bool at_parent = std::all_of(clip->frames.begin(), clip->frames.end(),
                                         [&](const MotionFrame& frame) { return frame.translations[j] == Point3{}; });
      if (joint.parent < 0 || !at_parent) continue;
      for (MotionFrame& frame : clip->frames) frame.translations[j] = joint.offset;
    }
  }

  // Positions replace the offset, as programs write them; rotations apply from the last to the first.
  MotionFrame read_frame() const {
    MotionFrame frame;
    frame.rotations.assign(motion_.joints.size(), kNoRotation4);
    for (const MotionJoint& joint : motion_.joints) frame.translations.push_back(joint.offset);
    for (size_t c = 0; c < channels_.size(); ++c) {
      const Channel& channel = channels_[c];
      const double value = number(c, "a channel's value");
      if (channel.rotates) {
        Quaternion& q = frame.rotations[channel.joint];
        q = multiply(q, axis_rotation(channel.axis, value * (std::numbers::pi / 180)));
      } else {
        frame.translations[channel.joint][channel.axis] = value;
      }
    }
    for (Quaternion& q : frame.rotations) q = normalized(q);
    return frame;
  }

  const std::string path_;
  TextLines lines_;
  std::vector<std::string_view> words_;  // of the statement at hand
  size_t at_ = 0;                        // behind it, in the line's words
  Motion motion_;
  std::vector<size_t> open_;  // joints whose '}' is to come
  std::vector<bool> has_offset_, has_channels_;
  std::vector<Channel> channels_;
};

}  // namespace

Motion read_bvh(const std::string& path) {
  const std::string text = read_text_file(path);
  if (text.empty()) throw Error(path + ": expected a BVH, found an empty file");
  if (text.find('\0') != std::string::npos)
    throw Error(path + ": expected a BVH text file, found binary data (a zero byte)");
  return BvhReader(path, text).read();
}

}  // namespace sinew
