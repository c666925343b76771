// SPDX-License-Identifier: MIT
// Rows by answers, parts by doubt, and what the alternatives of a question would change.
#include "weights/questions.hpp"

#include <string.h>

#include "core/sort.hpp"
#include "features/parts.hpp"
#include "weights/alike_parts.hpp"

namespace sinew {
namespace {

constexpr uint32_t kRigidAlternatives = 4;
// Mean L1 in Q16 below which a difference is invisible: 0.02.
constexpr uint32_t kLeastChange = 1311;
constexpr uint8_t kNoAnswer = 0xFF;
constexpr uint32_t kBlends[] = {SINEW_ANSWER_SOFT, SINEW_ANSWER_HARD, SINEW_ANSWER_SOFTER, SINEW_ANSWER_HOST};

struct Answer {
  uint8_t kind;
  uint16_t joint;
};

struct QuestionScratch {
  AlikeParts alike;
  uint32_t* host_vertex = nullptr;    // [U]
  uint32_t* host_distance = nullptr;  // [U]
  uint16_t* favorites = nullptr;      // [parts] joint with most weight, or kNoJoint
  uint64_t* doubts = nullptr;         // [parts] sum over free vertices, Q16
  Answer* answers = nullptr;          // [parts]
  uint64_t* sums = nullptr;           // [J]
  uint32_t* asked = nullptr;          // [parts] firsts of parts alike, by descending gain

  bool allocate(Arena& arena, const Counts& counts) {
    (void)alike.allocate(arena, counts);
    host_vertex = arena.alloc<uint32_t>(counts.vertices);
    host_distance = arena.alloc<uint32_t>(counts.vertices);
    favorites = arena.alloc<uint16_t>(counts.vertices);
    doubts = arena.alloc<uint64_t>(counts.vertices);
    answers = arena.alloc<Answer>(counts.vertices);
    sums = arena.alloc<uint64_t>(counts.joints);
    asked = arena.alloc<uint32_t>(counts.vertices);
    return arena.ok();
  }
};

// A row of kRowSlots slots; unused ones kNoJoint and 0.
struct Row {
  uint16_t joints[kRowSlots];
  uint32_t weights[kRowSlots];
};

void set_single(uint16_t joint, Row* row) {
  for (uint32_t i = 0; i < kRowSlots; ++i) {
    row->joints[i] = i == 0 ? joint : kNoJoint;
    row->weights[i] = i == 0 ? kWholeRow : 0;
  }
}

// Twice as soft: what a softmax gives for logits half as far apart, the roots of the weights.
SINEW_RARE void soften(Row* row) {
  uint64_t sum = 0;
  for (uint32_t& weight : row->weights) {
    weight = isqrt64(static_cast<uint64_t>(weight) << 16);
    sum += weight;
  }
  for (uint32_t& weight : row->weights) weight = static_cast<uint32_t>(static_cast<uint64_t>(weight) * kWholeRow / sum);
}

// Sum over joints of |a - b|, Q16.
SINEW_RARE uint32_t row_distance(const Row& a, const Row& b) {
  uint32_t sum = 0;
  for (uint32_t i = 0; i < kRowSlots; ++i) {
    if (a.joints[i] == kNoJoint) continue;
    uint32_t other = 0;
    for (uint32_t k = 0; k < kRowSlots; ++k) other = b.joints[k] == a.joints[i] ? b.weights[k] : other;
    sum += a.weights[i] > other ? a.weights[i] - other : other - a.weights[i];
  }
  for (uint32_t k = 0; k < kRowSlots; ++k) {
    bool alone = b.joints[k] != kNoJoint;
    for (uint32_t i = 0; i < kRowSlots; ++i) alone = alone && a.joints[i] != b.joints[k];
    sum += alone ? b.weights[k] : 0;
  }
  return sum;
}

class PartQuestions {
 public:
  PartQuestions(const Prediction& prediction, const GivenRows& given, const QuestionScratch& scratch, Rows* rows)
      : p_(prediction), mesh_(prediction.mesh), given_(given), s_(scratch), rows_(*rows) {}

  SINEW_RARE void survey() {
    memset(s_.sums, 0, p_.skeleton.joint_count * sizeof(uint64_t));
    for (uint32_t part = 0; part < mesh_.part_count; ++part) {
      s_.answers[part] = {kNoAnswer, 0};
      s_.doubts[part] = 0;
      add_sums(part, 1);
      for_vertices(part, [&](uint32_t v) {
        if (given_.kind[v] == GivenKind::kFree) s_.doubts[part] += kWholeRow - largest(v);
      });
      uint64_t total;
      s_.favorites[part] = favorite(part, &total);
      add_sums(part, 0);
    }
  }

  SINEW_RARE void take(const sinew_answer* answers, uint32_t count) {
    for (uint32_t i = 0; i < count; ++i) {
      const uint32_t named = mesh_.part[mesh_.vertex_to_welded[answers[i].vertex]];
      const auto put = [&](uint32_t part) {
        s_.answers[part] = {static_cast<uint8_t>(answers[i].kind), 0};
        if (answers[i].kind == SINEW_ANSWER_RIGID)
          s_.answers[part].joint = counterpart(p_.skeleton, s_.alike, s_.favorites, answers[i].joint, named, part);
      };
      if (answers[i].alone != 0) {
        put(named);
      } else {
        for_alike(named, put);
      }
    }
  }

  // Hosts have lower numbers than what they carry, so that their rows are final when they are read.
  SINEW_RARE void apply() {
    for (uint32_t part = 0; part < mesh_.part_count; ++part) {
      const Answer answer = s_.answers[part];
      if (answer.kind == kNoAnswer || answer.kind == SINEW_ANSWER_PROPOSED) continue;
      for_vertices(part, [&](uint32_t v) {
        Row row;
        answered(v, answer.kind, answer.joint, &row);
        memcpy(rows_.joints_of(v), row.joints, sizeof row.joints);
        memcpy(rows_.weights_of(v), row.weights, sizeof row.weights);
      });
    }
  }

  SINEW_RARE void ask(uint32_t most, Questions* out) {
    uint32_t groups = 0;
    for (uint32_t part = 0; part < mesh_.part_count; ++part) {
      out->of_part[part] = SINEW_NO_QUESTION;
      if (s_.alike.first[part] == part && doubt_of(part) > 0) s_.asked[groups++] = part;
    }
    // The sum over parts alike is kept in the first one's place from here on.
    for (uint32_t i = 0; i < groups; ++i) s_.doubts[s_.asked[i]] = doubt_of(s_.asked[i]);
    heap_sort(s_.asked, groups, [&](uint32_t a, uint32_t b) {
      return s_.doubts[a] != s_.doubts[b] ? s_.doubts[a] > s_.doubts[b] : a < b;
    });
    for (uint32_t i = 0; i < groups && out->count < most; ++i) {
      const uint32_t at = out->count;
      sinew_question& question = out->questions[at];
      describe(s_.asked[i], &question);
      if (question.alternative_count == 0) continue;
      out->parts[at] = question.vertex;
      for_open(s_.asked[i], [&](uint32_t part) { out->of_part[part] = at; });
      ++out->count;
    }
  }

 private:
  template <class Body>
  void for_vertices(uint32_t part, const Body& body) const {
    for (uint32_t i = mesh_.part_offsets[part]; i < mesh_.part_offsets[part + 1]; ++i) body(mesh_.part_vertices[i]);
  }
  template <class Body>
  void for_alike(uint32_t part, const Body& body) const {
    for (uint32_t p = s_.alike.first[part]; p != AlikeParts::kNoPart; p = s_.alike.next[p]) body(p);
  }
  // Those of them without an answer.
  template <class Body>
  void for_open(uint32_t part, const Body& body) const {
    for_alike(part, [&](uint32_t p) {
      if (s_.answers[p].kind == kNoAnswer) body(p);
    });
  }

  uint32_t largest(uint32_t v) const {
    uint32_t most = 0;
    for (uint32_t i = 0; i < kRowSlots; ++i) most = rows_.weights_of(v)[i] > most ? rows_.weights_of(v)[i] : most;
    return most < kWholeRow ? most : kWholeRow;
  }
  uint16_t strongest(uint32_t v) const {
    const uint16_t* const joints = rows_.joints_of(v);
    const uint32_t* const weights = rows_.weights_of(v);
    uint32_t best = 0;
    for (uint32_t i = 1; i < kRowSlots; ++i) {
      if (weights[i] > weights[best] || (weights[i] == weights[best] && joints[i] < joints[best])) best = i;
    }
    return joints[best];
  }
  // Adds what the part's rows give to every joint, or with factor 0 makes those sums 0 again.
  SINEW_RARE void add_sums(uint32_t part, uint64_t factor) const {
    for_vertices(part, [&](uint32_t v) { add_row(v, factor); });
  }
  SINEW_RARE void add_row(uint32_t v, uint64_t factor) const {
    for (uint32_t i = 0; i < kRowSlots; ++i) {
      const uint16_t joint = rows_.joints_of(v)[i];
      if (joint != kNoJoint) s_.sums[joint] = factor * (s_.sums[joint] + rows_.weights_of(v)[i]);
    }
  }
  // The joint with the largest sum (ties: the lower) among those of the part's rows, or kNoJoint.
  SINEW_RARE uint16_t favorite(uint32_t part, uint64_t* sum) const {
    uint16_t best = kNoJoint;
    *sum = 0;
    for_vertices(part, [&](uint32_t v) {
      for (uint32_t i = 0; i < kRowSlots; ++i) {
        const uint16_t joint = rows_.joints_of(v)[i];
        if (joint == kNoJoint || s_.sums[joint] < *sum || (s_.sums[joint] == *sum && joint >= best)) continue;
        best = joint;
        *sum = s_.sums[joint];
      }
    });
    return best;
  }

  SINEW_RARE uint64_t doubt_of(uint32_t first) const {
    uint64_t sum = 0;
    for_open(first, [&](uint32_t part) { sum += s_.doubts[part]; });
    return sum;
  }

  // The row of a vertex by an answer. Reads the rows of the vertex and, for a host, of its host.
  SINEW_RARE void answered(uint32_t v, uint32_t kind, uint16_t joint, Row* row) const {
    if (kind == SINEW_ANSWER_RIGID) return set_single(joint, row);
    if (kind == SINEW_ANSWER_HARD) return set_single(strongest(v), row);
    if (kind == SINEW_ANSWER_SOFT) {
      full_row(
          p_, v, [&](uint32_t at, uint16_t* joints, uint32_t* weights) { heat_row(p_.heat, at, joints, weights); },
          row->joints, row->weights);
      return;
    }
    const uint32_t host = kind == SINEW_ANSWER_HOST ? s_.host_vertex[v] : kNoVertex;
    const uint32_t from = host != kNoVertex ? host : v;
    memcpy(row->joints, rows_.joints_of(from), sizeof row->joints);
    memcpy(row->weights, rows_.weights_of(from), sizeof row->weights);
    if (kind == SINEW_ANSWER_SOFTER) soften(row);
  }

  // Joints that a part could move with: its likeliest ones, the parent of the likeliest, and its host's likeliest.
  SINEW_RARE uint32_t rigid_joints(uint32_t part, uint16_t* joints) const {
    uint32_t count = 0;
    const auto add = [&](uint16_t joint) {
      if (joint == kNoJoint || count == kRigidAlternatives) return;
      for (uint32_t i = 0; i < count; ++i) {
        if (joints[i] == joint) return;
      }
      joints[count++] = joint;
    };
    uint64_t sum;
    add_sums(part, 1);
    add(favorite(part, &sum));
    if (count > 0) s_.sums[joints[0]] = 0;  // the second
    const uint16_t second = favorite(part, &sum);
    if (sum > 0) add(second);
    add_sums(part, 0);
    const int32_t parent = count > 0 ? p_.skeleton.parents[joints[0]] : -1;
    if (parent >= 0 && p_.skeleton.usable[parent] != 0) add(static_cast<uint16_t>(parent));
    add(host_favorite(part));
    return count;
  }

  // The joint with most weight over the part's hosts.
  SINEW_RARE uint16_t host_favorite(uint32_t part) const {
    if (part == 0) return kNoJoint;
    for_vertices(part, [&](uint32_t v) { add_row(s_.host_vertex[v], 1); });
    uint16_t best = kNoJoint;
    uint64_t most = 0;
    for_vertices(part, [&](uint32_t v) {
      for (uint32_t i = 0; i < kRowSlots; ++i) {
        const uint16_t joint = rows_.joints_of(s_.host_vertex[v])[i];
        if (joint == kNoJoint || s_.sums[joint] < most || (s_.sums[joint] == most && joint >= best)) continue;
        best = joint;
        most = s_.sums[joint];
      }
    });
    for_vertices(part, [&](uint32_t v) { add_row(s_.host_vertex[v], 0); });
    return best;
  }

  // Mean over the question's open parts of what the alternative changes, Q16.
  SINEW_RARE uint32_t change(uint32_t named, uint32_t kind, uint16_t joint) const {
    uint64_t sum = 0, vertices = 0;
    for_open(named, [&](uint32_t part) {
      const uint16_t own = kind == SINEW_ANSWER_RIGID
                               ? counterpart(p_.skeleton, s_.alike, s_.favorites, joint, named, part)
                               : uint16_t{0};
      for_vertices(part, [&](uint32_t v) {
        Row now, then;
        answered(v, SINEW_ANSWER_PROPOSED, 0, &now);
        answered(v, kind, own, &then);
        sum += row_distance(now, then);
        ++vertices;
      });
    });
    return static_cast<uint32_t>(sum / vertices);
  }

  // Question about the parts alike `first` that are open; `vertex` is the number of the part for now.
  SINEW_RARE void describe(uint32_t first, sinew_question* question) const {
    *question = sinew_question{};
    uint64_t vertices = 0;
    uint32_t named = AlikeParts::kNoPart;
    for_open(first, [&](uint32_t part) {
      named = part < named ? part : named;
      ++question->part_count;
      vertices += mesh_.part_sizes[part];
    });
    question->vertex = named;
    question->joint = s_.favorites[named];
    add_sums(named, 1);
    uint64_t sum;
    (void)favorite(named, &sum);
    add_sums(named, 0);
    const uint64_t share = sum / mesh_.part_sizes[named];
    question->share = static_cast<uint16_t>(share < 65535 ? share : 65535);
    question->doubt = static_cast<uint32_t>(s_.doubts[first] / vertices);
    question->gain = static_cast<uint32_t>(s_.doubts[first] / mesh_.welded_count);
    uint16_t joints[kRigidAlternatives];
    const uint32_t rigid = rigid_joints(named, joints);
    for (uint32_t i = 0; i < rigid; ++i) add(named, SINEW_ANSWER_RIGID, joints[i], question);
    for (const uint32_t kind : kBlends) add(named, kind, 0, question);
  }
  SINEW_RARE void add(uint32_t named, uint32_t kind, uint16_t joint, sinew_question* question) const {
    if (kind == SINEW_ANSWER_HOST && named == 0) return;
    const uint32_t changed = change(named, kind, joint);
    if (changed < kLeastChange) return;
    question->alternatives[question->alternative_count++] = {static_cast<uint16_t>(kind), joint, changed};
  }

  const Prediction& p_;
  const Mesh& mesh_;
  const GivenRows& given_;
  const QuestionScratch& s_;
  const Rows& rows_;
};

static_assert(kRigidAlternatives + 4 <= SINEW_MAX_ALTERNATIVES, "every alternative has a place");

}  // namespace

bool Questions::allocate(Arena& arena, const Counts& counts, uint32_t most) {
  questions = arena.alloc<sinew_question>(most);
  parts = arena.alloc<uint32_t>(most);
  of_part = arena.alloc<uint32_t>(counts.vertices);
  return arena.ok();
}

sinew_status ask_and_answer(const Prediction& prediction, const sinew_answer* answers, uint32_t answer_count,
                            uint32_t most, const GivenRows& given, const Counts& counts, Arena& arena, Rows* rows,
                            Questions* questions) {
  const ArenaScope scope(arena);
  QuestionScratch scratch;
  if (!scratch.allocate(arena, counts)) return SINEW_ERROR_WORKSPACE;
  sinew_status status = find_alike_parts(prediction.mesh, counts, arena, &scratch.alike);
  if (status == SINEW_OK)
    status = find_hosts(prediction.mesh, counts, arena, scratch.host_vertex, scratch.host_distance);
  if (status != SINEW_OK || arena.measuring()) return status;
  PartQuestions parts(prediction, given, scratch, rows);
  parts.survey();
  parts.take(answers, answer_count);
  parts.apply();
  questions->count = 0;
  parts.ask(most, questions);
  return SINEW_OK;
}

void write_questions(const Mesh& mesh, const Questions& questions, sinew_bind_outputs* outputs) {
  outputs->questions_written = questions.count;
  for (uint32_t i = 0; i < questions.count; ++i) {
    outputs->questions[i] = questions.questions[i];
    outputs->questions[i].vertex = SINEW_NO_QUESTION;
    outputs->questions[i].vertex_count = 0;
  }
  for (uint32_t v = 0; v < mesh.vertex_count; ++v) {
    const uint32_t part = mesh.part[mesh.vertex_to_welded[v]], at = questions.of_part[part];
    if (outputs->vertex_parts != nullptr) outputs->vertex_parts[v] = part;
    if (outputs->vertex_questions != nullptr) outputs->vertex_questions[v] = at;
    if (at == SINEW_NO_QUESTION) continue;
    sinew_question& question = outputs->questions[at];
    ++question.vertex_count;
    if (question.vertex == SINEW_NO_QUESTION && questions.parts[at] == part) question.vertex = v;
  }
}

}  // namespace sinew
