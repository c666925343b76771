// SPDX-License-Identifier: MIT
// Rigs are small; rows are kept only where a bind would not make them again.
#include "keep.hpp"

#include <utility>

#include "characters.hpp"
#include "sinew_formats/error.hpp"

namespace sinew::web {
namespace {

// Marks of the vertices that a list names.
std::vector<uint8_t> marks(const Session& s, const Json& vertices) {
  std::vector<uint8_t> marked;
  if (vertices.empty()) return marked;
  marked.assign(s.character.vertices.size(), 0);
  for (const Json& v : vertices) {
    if (v.get<size_t>() >= marked.size()) throw Error(s.character.name + ": the project is of another mesh");
    marked[v.get<size_t>()] = 1;
  }
  return marked;
}

}  // namespace

void keep(Session& s, uint32_t number) {
  s.kept[number] = {s.number, s.rigs().now(), s.began, s.locked, s.hints, s.picture()};
}

Json restore(Session& s, uint32_t number) {
  const auto at = s.kept.find(number);
  if (at == s.kept.end() || at->second.number != s.number) throw Error("no such step was kept");
  const Kept& kept = at->second;
  end_preview(s);
  stand(s);
  s.rigs().put(kept.rig, false);
  Json reply = show_rig(s);
  if (!kept.rows.empty()) s.character.influences = kept.rows;
  s.locked = kept.locked;
  s.hints = kept.hints;
  if (kept.picture != nullptr) {
    s.pictures_of[s.number] = kept.picture;
    reply["picture"] = picture_json(*kept.picture);
  }
  return reply;
}

Json kept_rows(const Session& s) {
  Json locked = Json::array(), painted = Json::array(), rows = Json::array();
  for (size_t v = 0; v < s.began.size(); ++v) {
    const bool is_locked = !s.locked.empty() && s.locked[v] != 0, is_painted = !s.hints.empty() && s.hints[v] != 0;
    if (!is_locked && !is_painted) continue;
    if (is_locked) locked.push_back(v);
    if (is_painted) painted.push_back(v);
    Json row = {v};
    for (const Influence& influence : s.began[v]) {
      row.push_back(influence.joint);
      row.push_back(influence.weight);
    }
    rows.push_back(std::move(row));
  }
  return {{"locked", locked}, {"painted", painted}, {"rows", rows}};
}

void put_rows(Session& s, const Json& rows) {
  std::vector<uint8_t> locked = marks(s, rows.at("locked")), hints = marks(s, rows.at("painted"));
  std::vector<std::vector<Influence>> influences = s.character.influences;
  for (const Json& row : rows.at("rows")) {
    std::vector<Influence>& one = influences.at(row.at(0).get<size_t>());
    one.clear();
    for (size_t i = 1; i + 1 < row.size(); i += 2) {
      one.push_back({row.at(i).get<uint32_t>(), row.at(i + 1).get<float>()});
      if (one.back().joint >= s.character.joints.size())
        throw Error(s.character.name + ": the project is of another skeleton");
    }
  }
  s.character.influences = std::move(influences);
  s.locked = std::move(locked);
  s.hints = std::move(hints);
}

}  // namespace sinew::web
