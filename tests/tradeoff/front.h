// The Pareto front: the trials that no other beats in error and in cost at once; and what is read off it.
// What exploded, or ended farther from the truth than the cloth is wide, is no answer.
#pragma once
#include <optional>

#include "tradeoff/score.h"

namespace tradeoff {

// From the cheapest to the most accurate.
std::vector<Score> pareto_front(const std::vector<Score>&);

// The front without those that are less than a tenth more accurate than the one before: as many as one
// wants to read.
std::vector<Score> distinct(const std::vector<Score>& front);

// The cheapest with an error of no more than `error`; the most accurate in no more than `baselines`.
std::optional<Score> cheapest(const std::vector<Score>&, double error);
std::optional<Score> most_accurate(const std::vector<Score>&, double baselines);

// Where on the front, from cheap to accurate, explicit ways take over from implicit ones: the last of these
// and the first of those. Nothing where the cheapest is explicit, or none is.
std::optional<std::pair<Score, Score>> crossover(const std::vector<Score>& front);

}  // namespace tradeoff
