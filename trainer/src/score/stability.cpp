// SPDX-License-Identifier: MIT
// Poses a character, carries what is found there back to rest, and compares.
#include "sinew_trainer/stability.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>

#include "core/markdown.hpp"
#include "data/eigen_points.hpp"
#include "data/rig_sample.hpp"
#include "sinew_formats/base/point.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/print.hpp"
#include "sinew_trainer/rig_score.hpp"

namespace sinew {
namespace {

using Eigen::Vector3d;

Vec3 floats(const Vector3d& p) {
  return {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
}

// The character in a pose. Its target skeleton follows, so that places in the pose can be told as places at rest.
class PosedCharacter {
 public:
  PosedCharacter(const Character& character, const RigSource& source, RigSource::Palette palette)
      : source_(source), palette_(std::move(palette)) {
    mesh_.name = character.name;
    for (const Point3& p : source.skin(palette_)) mesh_.vertices.push_back(floats(vec(p)));
    mesh_.face_offsets = {0};
    for (const auto& t : source.triangles()) {
      mesh_.face_vertices.insert(mesh_.face_vertices.end(), t.begin(), t.end());
      mesh_.face_offsets.push_back(static_cast<uint32_t>(mesh_.face_vertices.size()));
    }
    own_ = mesh_;
    own_.joints = character.joints;
    for (size_t j = 0; j < own_.joints.size(); ++j) own_.joints[j].position = floats(palette_.origin[j]);
    const PoseBody& body = source.body();
    for (size_t i = 0; i < body.joints.size(); ++i)
      target_.push_back(source.follow(palette_, body.target.joints[i].source, body.joints[i]));
  }

  const Character& mesh() const { return mesh_; }  // bare
  const Character& own() const { return own_; }    // with the character's joints

  Point3 to_rest(const Vec3& place) const {
    const PoseBody& body = source_.body();
    const Vector3d p(place.x, place.y, place.z);
    size_t nearest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (size_t i = 0; i < body.bones(); ++i) {
      double d = (p - target_[i]).norm();
      for (const uint32_t k : body.kids[i]) d = std::min(d, segment_distance(p, target_[i], target_[k]));
      if (d >= least) continue;
      least = d;
      nearest = i;
    }
    const uint32_t joint = body.target.joints[nearest].source;
    return arr(palette_.linear[joint].transpose() * (p - palette_.origin[joint]) + vec(source_.joints()[joint]));
  }

 private:
  const RigSource& source_;
  RigSource::Palette palette_;
  Character mesh_, own_;
  std::vector<Vector3d> target_;
};

int strongest(const std::vector<Influence>& row) {
  if (row.empty()) return -1;
  return static_cast<int>(std::max_element(row.begin(), row.end(), [](const Influence& a, const Influence& b) {
                            return a.weight < b.weight;
                          })->joint);
}

// Places at rest; `bones` are those of joints that deform.
struct RestRig {
  ScoredSkeleton all, bones;
  std::vector<int> strongest;  // [V] index in `bones`, -1 = none
};

ScoredSkeleton places(std::vector<Point3> positions) {
  ScoredSkeleton out;
  out.parents.assign(positions.size(), -1);
  out.classes.resize(positions.size());
  out.tips.assign(positions.size(), 0);
  out.positions = std::move(positions);
  return out;
}

RestRig rest_rig(const PosedCharacter& posed, const FindRig& find) {
  const FoundRig found = find(posed.mesh());
  std::vector<Point3> all, bones;
  std::vector<int> number;
  for (const Joint& joint : found.joints) {
    all.push_back(posed.to_rest(joint.position));
    const bool deforms = joint.deforms.value_or(true);
    number.push_back(deforms ? static_cast<int>(bones.size()) : -1);
    if (deforms) bones.push_back(all.back());
  }
  RestRig rig{places(std::move(all)), places(std::move(bones)), {}};
  for (const auto& row : found.influences) {
    const int joint = strongest(row);
    rig.strongest.push_back(joint < 0 ? -1 : number[static_cast<size_t>(joint)]);
  }
  return rig;
}

double share_of(size_t part, size_t whole) { return static_cast<double>(part) / static_cast<double>(whole); }

double flipped(const RestRig& posed, const RestRig& rest) {
  const std::vector<int> pairs = pair_joints(posed.bones, rest.bones);
  size_t flips = 0;
  for (size_t v = 0; v < rest.strongest.size(); ++v) {
    const int now = posed.strongest[v];
    flips += (now < 0 ? -1 : pairs[static_cast<size_t>(now)]) != rest.strongest[v] ? 1 : 0;
  }
  return share_of(flips, rest.strongest.size());
}

struct StabilityColumn {
  const char *title, *key;
  double StabilityFigures::*value;
};
constexpr StabilityColumn kStabilityColumns[] = {{"spread of joints", "spread", &StabilityFigures::spread},
                                                 {"in the worst pose", "worst_spread", &StabilityFigures::worst_spread},
                                                 {"flips, found anew", "flips", &StabilityFigures::flips},
                                                 {"flips, own joints", "own_flips", &StabilityFigures::own_flips}};

enum class Average { kMean, kMedian };

StabilityFigures average(const std::vector<StabilityFigures>& rows, Average how) {
  StabilityFigures out;
  for (const StabilityColumn& column : kStabilityColumns) {
    std::vector<double> values;
    for (const StabilityFigures& row : rows) values.push_back(row.*column.value);
    std::sort(values.begin(), values.end());
    const size_t n = values.size();
    double sum = 0;
    for (const double value : values) sum += value;
    if (n > 0)
      out.*column.value =
          how == Average::kMean ? sum / static_cast<double>(n) : 0.5 * (values[n / 2] + values[(n - 1) / 2]);
  }
  return out;
}

struct Averages {
  std::map<std::string, StabilityFigures> families;  // means
  std::vector<std::pair<std::string, StabilityFigures>> rows;
};

Averages averages(const StabilityRows& characters) {
  std::map<std::string, std::vector<StabilityFigures>> members;
  std::vector<StabilityFigures> all, families;
  for (const auto& [name, figures] : characters) {
    members[family_of(name)].push_back(figures);
    all.push_back(figures);
  }
  Averages out;
  for (const auto& [family, figures] : members) {
    out.families[family] = average(figures, Average::kMean);
    families.push_back(out.families[family]);
  }
  out.rows = {{"mean of characters", average(all, Average::kMean)},
              {"median of characters", average(all, Average::kMedian)},
              {"mean of families", average(families, Average::kMean)},
              {"median of families", average(families, Average::kMedian)}};
  return out;
}

nlohmann::ordered_json figures_json(const StabilityFigures& figures) {
  nlohmann::ordered_json out;
  for (const StabilityColumn& column : kStabilityColumns) out[column.key] = figures.*column.value;
  return out;
}

}  // namespace

StabilityFigures measure_stability(const Character& character, unsigned poses, const FindRig& find,
                                   const BindOwn& own) {
  const RigSource source(character);
  const PosedCharacter standing(character, source, source.rest_pose());
  const RestRig rest = rest_rig(standing, find);
  const std::vector<std::vector<Influence>> rows = own(standing.own());
  StabilityFigures out;
  for (unsigned pose = 0; pose < poses; ++pose) {
    const PosedCharacter posed(character, source, source.stiff_pose(pose + 1));
    const RestRig rig = rest_rig(posed, find);
    const double spread = score_rig(rig.all, rest.all).j2j;
    out.spread += spread / poses;
    out.worst_spread = std::max(out.worst_spread, spread);
    out.flips += flipped(rig, rest) / poses;
    const std::vector<std::vector<Influence>> moved = own(posed.own());
    size_t flips = 0;
    for (size_t v = 0; v < rows.size(); ++v) flips += strongest(moved[v]) != strongest(rows[v]) ? 1 : 0;
    out.own_flips += share_of(flips, rows.size()) / poses;
  }
  return out;
}

std::string stability_markdown(const StabilityRows& rows) {
  std::string text = "| x 100 | characters |", line = "|---|---|";
  for (const StabilityColumn& column : kStabilityColumns) {
    text += std::string(" ") + column.title + " |";
    line += "---|";
  }
  text += "\n" + line + "\n";
  const auto row = [&](const std::string& name, size_t count, const StabilityFigures& figures) {
    text += "| " + markdown_cell(name) + print(" | %zu |", count);
    for (const StabilityColumn& column : kStabilityColumns) text += print(" %.2f |", 100 * (figures.*column.value));
    text += "\n";
  };
  std::map<std::string, size_t> sizes;
  for (const auto& one : rows) ++sizes[family_of(one.first)];
  const Averages means = averages(rows);
  for (const auto& [family, figures] : means.families) row(family, sizes[family], figures);
  for (const auto& [name, figures] : means.rows)
    row(name, name.find("families") == std::string::npos ? rows.size() : sizes.size(), figures);
  return text;
}

std::string stability_json(const StabilityRows& rows) {
  nlohmann::ordered_json out;
  out["characters"] = out["families"] = nlohmann::ordered_json::object();
  for (const auto& [name, figures] : rows) out["characters"][name] = figures_json(figures);
  const Averages means = averages(rows);
  for (const auto& [family, figures] : means.families) out["families"][family] = figures_json(figures);
  for (const auto& [name, figures] : means.rows) {
    std::string key = name;
    std::replace(key.begin(), key.end(), ' ', '_');
    out[key] = figures_json(figures);
  }
  return out.dump(1);
}

}  // namespace sinew
