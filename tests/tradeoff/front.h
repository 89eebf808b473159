// The Pareto front: the trials that no other trial beats in both error and cost; and the answers
// that follow from it. A trial that exploded, or that ended farther from the truth than the size of
// the cloth, does not count.
#pragma once
#include <optional>

#include "tradeoff/score.h"

namespace tradeoff {

// The trials that the program of a step can repeat: all but those of XPBD and VBD.
std::vector<Score> offered(const std::vector<Score>&);

// From the cheapest to the most accurate.
std::vector<Score> pareto_front(const std::vector<Score>&);

// The front without the trials that are less than a tenth more accurate than the one before: a list
// that is short enough to read.
std::vector<Score> distinct(const std::vector<Score>& front);

// The cheapest trial with an error of at most `error`; the most accurate trial that
// costs at most `baselines`.
std::optional<Score> cheapest(const std::vector<Score>&, double error);
std::optional<Score> most_accurate(const std::vector<Score>&, double baselines);

// Where explicit steps replace implicit ones on the front, from cheap to accurate: the
// last implicit trial and the first explicit one. Empty if the cheapest trial is
// explicit, or if no trial is. The front is one of offered trials.
std::optional<std::pair<Score, Score>> crossover(const std::vector<Score>& front);

}  // namespace tradeoff
