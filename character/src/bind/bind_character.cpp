// SPDX-License-Identifier: MIT
// A bind of a character for every set of joints that its meshes use, put together.
#include "sinew_character/bind/bind_character.hpp"

#include <algorithm>

#include "sinew_character/bind/engine_views.hpp"
#include "sinew_character/rig/mesh_surface.hpp"
#include "sinew_formats/error.hpp"

namespace sinew {
namespace {

std::vector<uint8_t> only(const std::vector<uint8_t>& values, const std::vector<size_t>& vertices) {
  std::vector<uint8_t> out;
  if (!values.empty())
    for (const size_t v : vertices) out.push_back(values[v]);
  return out;
}

// Progress of one bind of several.
struct ShareOfProgress {
  sinew_progress progress;
  void* user;
  uint32_t number, count;
};
int report_share(void* user, uint32_t done_permille) {
  const ShareOfProgress& share = *static_cast<const ShareOfProgress*>(user);
  return share.progress(share.user, (share.number * 1000 + done_permille) / share.count);
}

class CharacterBinder {
 public:
  CharacterBinder(const Character& character, const JointChoice& choice, const CharacterBindOptions& options)
      : whole_(character),
        choice_(choice),
        options_(options),
        kept_(kept_meshes(character, options.bind_props)),
        left_out_(options.scenery) {
    if (!std::count(kept_.begin(), kept_.end(), true)) return;
    left_out_.resize(whole_.vertices.size());
    for (size_t v = 0; v < left_out_.size(); ++v)
      if (kept_[mesh_of(v)]) left_out_[v] = 1;
  }

  CharacterBind run() {
    out_.kept_meshes = static_cast<size_t>(std::count(kept_.begin(), kept_.end(), true));
    out_.influences.resize(whole_.vertices.size());
    out_.confidence.assign(whole_.vertices.size(), 255);
    if (options_.bind.question_count > 0) {
      out_.vertex_questions.assign(whole_.vertices.size(), SINEW_NO_QUESTION);
      out_.vertex_parts.assign(whole_.vertices.size(), 0);
    }
    if (left_out_.empty()) {
      std::vector<size_t> all(whole_.vertices.size());
      for (size_t v = 0; v < all.size(); ++v) all[v] = v;
      bind_sets(whole_, all);
    } else {
      const MeshPart part = part_without(whole_, left_out_);
      if (part.vertices.empty())
        throw Error(whole_.name + ": all " + std::to_string(kept_.size()) +
                    " meshes are attached to joints without a skin, so there is none to bind; add --bind-props");
      bind_sets(part.character, part.vertices);
      follow_carriers();
    }
    if (!options_.keep_tips) out_.folded_tips = fold_tips(whole_, choice_, kept_, &out_.influences);
    if (options_.keep_apart && !options_.bind.symmetric) separate();
    order_questions();
    return std::move(out_);
  }

 private:
  size_t mesh_of(size_t vertex) const { return whole_.vertex_meshes.empty() ? 0 : whole_.vertex_meshes[vertex]; }

  // Every mesh gets the rows of the bind with its own joints. All binds see the whole character.
  void bind_sets(const Character& character, const std::vector<size_t>& vertices) {
    std::vector<size_t> wanted;  // sets, in order
    for (const size_t v : vertices) {
      const size_t set = choice_.set_of_mesh[mesh_of(v)];
      if (std::find(wanted.begin(), wanted.end(), set) == wanted.end()) wanted.push_back(set);
    }
    std::sort(wanted.begin(), wanted.end());
    const size_t binds = static_cast<size_t>(
        std::count_if(wanted.begin(), wanted.end(), [&](size_t set) { return single_joint(set) == SIZE_MAX; }));
    size_t number = 0;
    for (const size_t set : wanted) {
      const size_t single = single_joint(set);
      if (single != SIZE_MAX && options_.bind.hints.empty() && options_.bind.locked.empty() &&
          options_.bind.answers.empty()) {
        for (const size_t v : vertices)
          if (choice_.set_of_mesh[mesh_of(v)] == set) out_.influences[v] = {{static_cast<uint32_t>(single), 1.0f}};
        continue;
      }
      bind_set(character, vertices, set, number++, std::max<size_t>(binds, 1));
    }
  }

  // The joint of a set that has but one that may get weight, or SIZE_MAX.
  size_t single_joint(size_t set) const {
    if (set == SIZE_MAX) return SIZE_MAX;
    size_t single = SIZE_MAX;
    for (const size_t j : choice_.sets[set]) {
      if ((choice_.flags[j] & SINEW_JOINT_NEVER) != 0) continue;
      if (single != SIZE_MAX) return SIZE_MAX;
      single = j;
    }
    return single;
  }

  void bind_set(const Character& character, const std::vector<size_t>& vertices, size_t set, size_t number,
                size_t count) {
    BindOptions options = options_.bind;
    options.joint_flags = choice_.flags;
    if (set != SIZE_MAX) {
      std::vector<uint8_t> inside(character.joints.size(), 0);
      bool some = false;
      for (const size_t j : choice_.sets[set]) {
        inside[j] = 1;
        some = some || (options.joint_flags[j] & SINEW_JOINT_NEVER) == 0;
      }
      for (size_t j = 0; j < inside.size() && some; ++j)
        if (inside[j] == 0) options.joint_flags[j] |= SINEW_JOINT_NEVER;
    }
    if (options.question_count > 0)  // one of them may be about the body
      options.question_count = std::min<uint32_t>(options.question_count + 1, SINEW_MAX_QUESTIONS);
    options.locked = only(options_.bind.locked, vertices);
    options.hints = only(options_.bind.hints, vertices);
    options.answers = answers_of(vertices, set);
    ShareOfProgress share{options.progress, options.progress_user, static_cast<uint32_t>(number),
                          static_cast<uint32_t>(count)};
    if (options.progress != nullptr && count > 1) {
      options.progress = report_share;
      options.progress_user = &share;
    }
    BindResult result = bind(character, options);
    for (size_t i = 0; i < vertices.size(); ++i) {
      const size_t v = vertices[i];
      if (choice_.set_of_mesh[mesh_of(v)] != set) continue;
      out_.influences[v] = std::move(result.influences[i]);
      out_.confidence[v] = result.confidence[i];
    }
    take_questions(result, vertices, set);
    out_.symmetric_vertices = std::max(out_.symmetric_vertices, result.symmetric_vertices);
    out_.workspace_bytes = std::max(out_.workspace_bytes, result.workspace_bytes);
    out_.used_bytes = std::max(out_.used_bytes, result.used_bytes);
    out_.seconds += result.seconds;
  }

  // Answers about the set's meshes, by the numbers that the bind has for their vertices.
  std::vector<sinew_answer> answers_of(const std::vector<size_t>& vertices, size_t set) const {
    std::vector<sinew_answer> answers;
    for (sinew_answer answer : options_.bind.answers) {
      const auto at = std::lower_bound(vertices.begin(), vertices.end(), size_t{answer.vertex});
      if (at == vertices.end() || *at != answer.vertex || choice_.set_of_mesh[mesh_of(*at)] != set) continue;
      answer.vertex = static_cast<uint32_t>(at - vertices.begin());
      answers.push_back(answer);
    }
    return answers;
  }

  // Questions about the set's meshes; another set's bind asks about the others.
  void take_questions(const BindResult& result, const std::vector<size_t>& vertices, size_t set) {
    std::vector<uint32_t> number(result.questions.size(), SINEW_NO_QUESTION);
    for (size_t q = 0; q < number.size(); ++q) {
      sinew_question question = result.questions[q];
      question.vertex = static_cast<uint32_t>(vertices[question.vertex]);
      if (choice_.set_of_mesh[mesh_of(question.vertex)] != set) continue;
      number[q] = static_cast<uint32_t>(out_.questions.size());
      out_.questions.push_back(question);
    }
    const uint32_t first_part = parts_;  // numbers of the binds follow one another; 0 is for vertices without one
    for (size_t i = 0; i < result.vertex_questions.size(); ++i) {
      parts_ = std::max(parts_, first_part + result.vertex_parts[i] + 1);
      if (choice_.set_of_mesh[mesh_of(vertices[i])] != set) continue;
      out_.vertex_parts[vertices[i]] = first_part + result.vertex_parts[i];
      const uint32_t q = result.vertex_questions[i];
      if (q != SINEW_NO_QUESTION) out_.vertex_questions[vertices[i]] = number[q];
    }
  }

  // Those of all binds by descending gain, no more than were asked for. A part that most of the mesh belongs to is
  // the body, which no answer is for.
  void order_questions() {
    std::vector<uint32_t> order;
    for (uint32_t q = 0; q < out_.questions.size(); ++q)
      if (2 * size_t{out_.questions[q].vertex_count} <= whole_.vertices.size()) order.push_back(q);
    std::stable_sort(order.begin(), order.end(),
                     [&](uint32_t a, uint32_t b) { return out_.questions[a].gain > out_.questions[b].gain; });
    if (order.size() > options_.bind.question_count) order.resize(options_.bind.question_count);
    std::vector<uint32_t> position(out_.questions.size(), SINEW_NO_QUESTION);
    std::vector<sinew_question> questions;
    for (const uint32_t q : order) {
      position[q] = static_cast<uint32_t>(questions.size());
      questions.push_back(out_.questions[q]);
    }
    for (uint32_t& q : out_.vertex_questions)
      if (q != SINEW_NO_QUESTION) q = position[q];
    out_.questions = std::move(questions);
  }

  // No weight across seams; what is given or kept stays.
  void separate() {
    out_.seams = find_seams(whole_, out_.influences);
    std::vector<uint8_t> keep(whole_.vertices.size(), 0);
    for (size_t v = 0; v < keep.size(); ++v) {
      const bool given = (!options_.bind.locked.empty() && options_.bind.locked[v] != 0) ||
                         (!options_.bind.hints.empty() && options_.bind.hints[v] != 0);
      keep[v] = given || (!left_out_.empty() && left_out_[v] != 0) ? 1 : 0;
    }
    out_.separated_vertices = keep_apart(whole_, out_.seams, keep, &out_.influences);
  }

  // Kept meshes: rigid with their joint, so that pictures and poses show them where they are. Scenery goes with the root.
  void follow_carriers() {
    const auto is_root = [](const Joint& joint) { return joint.parent < 0; };
    const auto root = std::find_if(whole_.joints.begin(), whole_.joints.end(), is_root) - whole_.joints.begin();
    for (size_t v = 0; v < whole_.vertices.size(); ++v) {
      if (left_out_[v] == 0) continue;
      const bool kept = !kept_.empty() && kept_[mesh_of(v)];
      const int carrier = kept ? whole_.meshes[mesh_of(v)].carrier : static_cast<int>(root);
      if (carrier >= 0) out_.influences[v] = {{static_cast<uint32_t>(carrier), 1.0f}};
    }
  }

  const Character& whole_;
  const JointChoice& choice_;
  const CharacterBindOptions& options_;
  const std::vector<bool> kept_;   // [meshes]
  std::vector<uint8_t> left_out_;  // [V] 1: of a kept mesh or of the scenery; empty: none is
  CharacterBind out_;
  uint32_t parts_ = 1;  // numbers of parts given so far
};

}  // namespace

CharacterBind bind_character(const Character& character, const JointChoice& choice,
                             const CharacterBindOptions& options) {
  check_bindable(character);
  return CharacterBinder(character, choice, options).run();
}

}  // namespace sinew
