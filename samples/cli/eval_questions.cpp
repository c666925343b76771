// SPDX-License-Identifier: MIT
// sinew eval --questions: what a few answers of an artist are worth, with the reference as the artist.
#include <algorithm>
#include <cstdio>
#include <map>

#include "eval_studies.hpp"
#include "progress.hpp"
#include "sinew_character/bind/answers.hpp"
#include "sinew_character/style/style.hpp"
#include "sinew_formats/io.hpp"
#include "sinew_trainer/artist.hpp"
#include "sinew_trainer/evaluate.hpp"
#include "sinew_trainer/parallel.hpp"
#include "support.hpp"

namespace sinew::cli {
namespace {

struct QuestionGain {
  double before = 0, after = 0;  // L1
  double asked = 0;              // questions
  double covered = 0;            // share of the vertices that they are about
  size_t characters = 0;
  void add(const QuestionGain& g) {
    before += g.before;
    after += g.after;
    asked += g.asked;
    covered += g.covered;
    characters += g.characters;
  }
  QuestionGain mean() const {
    const double n = static_cast<double>(characters);
    return {before / n, after / n, asked / n, covered / n, 1};
  }
};

BindOptions options_of(const Study& study) {
  BindOptions options;
  options.method = study.model == nullptr ? SINEW_METHOD_HEAT : SINEW_METHOD_MODEL;
  options.model = study.model;
  options.influence_count = study.influences;
  return options;
}

QuestionGain question_gain(const Study& study, const Character& c, uint32_t questions, size_t* kinds) {
  const Answered answered = ask_artist(c, options_of(study), questions);
  QuestionGain gain;
  gain.before = measure(c, answered.before.influences, c.name, 0).l1;
  gain.after = measure(c, answered.after.influences, c.name, 0).l1;
  gain.asked = static_cast<double>(answered.answers.size());
  for (const uint32_t question : answered.before.vertex_questions) gain.covered += question != SINEW_NO_QUESTION;
  gain.covered /= static_cast<double>(c.vertices.size());
  gain.characters = 1;
  for (const sinew_answer& answer : answered.answers) ++kinds[answer.kind];
  return gain;
}

void print_question_row(const std::string& name, const QuestionGain& sum) {
  const QuestionGain g = sum.mean();
  std::printf("| %s | %zu | %.4f | %.4f | %.1f %% | %.1f | %.0f %% |\n", name.c_str(), sum.characters, g.before,
              g.after, 100 * (g.before - g.after) / std::max(g.before, 1e-12), g.asked, 100 * g.covered);
}

}  // namespace

void study_questions(const Study& study, uint32_t questions) {
  const std::vector<FoundCharacter> found = characters_in(study.folder);
  std::vector<QuestionGain> gains(found.size());
  std::vector<std::vector<size_t>> kinds(found.size(), std::vector<size_t>(answer_names().size(), 0));
  {
    Progress progress(found.size(), "characters");
    parallel_for(found.size(), study.jobs, [&](size_t i, unsigned) {
      const Character c = read_found(found[i]);
      if (c.influences.empty()) throw Error(found[i].path + ": has no reference weights to answer by");
      gains[i] = question_gain(study, c, questions, kinds[i].data());
      progress.step();
    });
  }
  std::map<std::string, QuestionGain> families;
  QuestionGain all, family_mean;
  std::vector<size_t> answers(answer_names().size(), 0);
  for (size_t i = 0; i < found.size(); ++i) {
    families[family_of(found[i].name)].add(gains[i]);
    all.add(gains[i]);
    for (size_t k = 0; k < answers.size(); ++k) answers[k] += kinds[i][k];
  }
  std::printf(
      "| family (up to %u questions) | characters | L1 | answered | less | questions | of the vertices |\n"
      "|---|---|---|---|---|---|---|\n",
      questions);
  for (const auto& [name, sum] : families) {
    print_question_row(name, sum);
    family_mean.add(sum.mean());
  }
  print_question_row("mean of families", family_mean);
  print_question_row("mean of characters", all);
  std::printf("\nanswers:");
  for (size_t k = 0; k < answers.size(); ++k)
    std::printf(" %s %zu%s", answer_names()[k].c_str(), answers[k], k + 1 < answers.size() ? "," : "\n");
}

void study_style(const Study& study, uint32_t questions) {
  std::map<std::string, std::vector<FoundCharacter>> families;
  for (const FoundCharacter& found : characters_in(study.folder)) families[family_of(found.name)].push_back(found);
  std::vector<std::pair<std::string, std::vector<FoundCharacter>>> several;
  for (auto& [name, found] : families)
    if (found.size() > 1) several.emplace_back(name, std::move(found));
  if (several.empty())
    throw Error(study.folder + ": --style needs a family (FAMILY__NAME) with two characters or more");
  std::vector<std::vector<QuestionGain>> gains(several.size());
  {
    Progress progress(several.size(), "families");
    parallel_for(several.size(), study.jobs, [&](size_t f, unsigned) {
      const std::vector<FoundCharacter>& found = several[f].second;
      const Character first = read_found(found[0]);
      if (first.influences.empty()) throw Error(found[0].path + ": has no reference weights to answer by");
      const Answered answered = ask_artist(first, options_of(study), questions);
      const Style style = {
          {learn_style(first, {answered.before.questions, answered.before.vertex_parts}, answered.answers)}};
      for (size_t i = 1; i < found.size(); ++i) {
        const Character c = read_found(found[i]);
        BindOptions options = options_of(study);
        options.question_count = SINEW_MAX_QUESTIONS;
        const BindResult before = bind(c, options);
        options.question_count = 0;
        options.answers = answer_by_style(style, c, {before.questions, before.vertex_parts}, {});
        QuestionGain gain;
        gain.before = measure(c, before.influences, c.name, 0).l1;
        gain.after = measure(c, bind(c, options).influences, c.name, 0).l1;
        gain.asked = static_cast<double>(options.answers.size());
        gain.characters = 1;
        gains[f].push_back(gain);
      }
      progress.step();
    });
  }
  std::printf(
      "| family (%u questions to its first character) | others | L1 | with the style | less | answers | worst loss |\n"
      "|---|---|---|---|---|---|---|\n",
      questions);
  QuestionGain all, family_mean;
  double worst = 0;
  const auto print = [](const std::string& name, const QuestionGain& sum, double loss) {
    const QuestionGain g = sum.mean();
    std::printf("| %s | %zu | %.4f | %.4f | %.1f %% | %.1f | %.4f |\n", name.c_str(), sum.characters, g.before, g.after,
                100 * (g.before - g.after) / std::max(g.before, 1e-12), g.asked, loss);
  };
  for (size_t f = 0; f < several.size(); ++f) {
    QuestionGain sum;
    double loss = 0;
    for (const QuestionGain& gain : gains[f]) {
      sum.add(gain);
      loss = std::max(loss, gain.after - gain.before);
    }
    print(several[f].first, sum, loss);
    all.add(sum);
    family_mean.add(sum.mean());
    worst = std::max(worst, loss);
  }
  print("mean of families", family_mean, worst);
  print("mean of characters", all, worst);
}

}  // namespace sinew::cli
