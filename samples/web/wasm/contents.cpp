// SPDX-License-Identifier: MIT
// Files are read as their readers read them; nothing is guessed from names.
#include "contents.hpp"

#include <string>

#include "sinew_character/check/check.hpp"
#include "sinew_formats/error.hpp"
#include "sinew_formats/file_kinds.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_formats/motion.hpp"

namespace sinew::web {

Json contents(const std::string& path) {
  Json reply = {{"mesh", false}, {"joints", 0}, {"clips", 0}};
  std::string no_mesh;
  if (!is_motion_alone(path)) try {
      const Character character = read_mesh(path);
      reply["mesh"] = character.face_count() > 0;
      reply["joints"] = character.joints.size();
    } catch (const Error& error) {
      no_mesh = error.what();
    }
  try {
    size_t clips = 0;
    for (const Clip& clip : read_motion(path).clips) clips += clip.frames.empty() ? 0 : 1;
    reply["clips"] = clips;
  } catch (const Error&) {
    if (reply["mesh"] == false && !no_mesh.empty()) throw Error(no_mesh);
    if (is_motion_alone(path)) throw;
  }
  return reply;
}

Json check_json(const Session& s) {
  Json list = Json::array();
  for (const RigFinding& finding : check_rig(s.character, s.player.for_file()).findings)
    list.push_back({{"rule", finding.rule->name},
                    {"severity", severity_text(finding.severity)},
                    {"title", finding.rule->title},
                    {"what", finding.what},
                    {"cure", finding.rule->cure},
                    {"joint", finding.joint},
                    {"place", {finding.position.x, finding.position.y, finding.position.z}},
                    {"radius", finding.radius}});
  return {{"findings", list}};
}

}  // namespace sinew::web
