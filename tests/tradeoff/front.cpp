#include "tradeoff/front.h"

#include <algorithm>

namespace tradeoff {

namespace {

std::vector<Score> answers(const std::vector<Score>& scores) {
  std::vector<Score> kept;
  for (const Score& score : scores)
    if (score.is_answer()) kept.push_back(score);
  return kept;
}

template <class Better, class Enough>
std::optional<Score> best(const std::vector<Score>& scores, const Better& better,
                          const Enough& enough) {
  std::optional<Score> found;
  for (const Score& score : answers(scores))
    if (enough(score) && (!found || better(score, *found))) found = score;
  return found;
}

bool cheaper(const Score& a, const Score& b) {
  return a.baselines < b.baselines;
}
bool more_accurate(const Score& a, const Score& b) {
  return a.judged() < b.judged();
}

}  // namespace

std::vector<Score> offered(const std::vector<Score>& scores) {
  std::vector<Score> kept;
  for (const Score& score : scores)
    if (is_of_step(score.trial.configuration)) kept.push_back(score);
  return kept;
}

std::vector<Score> pareto_front(const std::vector<Score>& scores) {
  std::vector<Score> sorted = answers(scores), front;
  std::sort(sorted.begin(), sorted.end(), [](const Score& a, const Score& b) {
    return std::pair(a.baselines, a.judged()) < std::pair(b.baselines, b.judged());
  });
  for (const Score& score : sorted)
    if (front.empty() || more_accurate(score, front.back())) front.push_back(score);
  return front;
}

std::vector<Score> distinct(const std::vector<Score>& front) {
  std::vector<Score> kept;
  for (const Score& score : front)
    if (kept.empty() || score.judged() < 0.9 * kept.back().judged()) kept.push_back(score);
  return kept;
}

std::optional<Score> cheapest(const std::vector<Score>& scores, double error) {
  return best(scores, cheaper, [&](const Score& s) { return s.judged() <= error; });
}

std::optional<Score> most_accurate(const std::vector<Score>& scores, double baselines) {
  return best(scores, more_accurate, [&](const Score& s) { return s.baselines <= baselines; });
}

std::optional<std::pair<Score, Score>> crossover(const std::vector<Score>& front) {
  const auto first = std::find_if(front.begin(), front.end(), [](const Score& s) {
    return is_explicit(s.trial.configuration);
  });
  if (first == front.begin() || first == front.end()) return {};
  return std::pair(*(first - 1), *first);
}

}  // namespace tradeoff
