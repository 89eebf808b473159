// The results of a study for a reader: tables, a picture, a sentence.
#pragma once
#include <functional>

#include "support/shell.h"
#include "tradeoff/front.h"
#include "tradeoff/study.h"

namespace tradeoff {

inline const std::vector<double> asked_errors = {1e-1, 1e-2, 1e-3, 1e-4, 1e-5};

// The cheapest configuration of each kind for errors of 1e-1 … 1e-5, then the front. If errors
// cannot be measured: the statistics of each configuration instead.
void print_tables(const Study&);

// work_precision.png: the error of every trial against its time, and the front of the best trials.
void draw_plot(const Study&);

// One sentence: which configuration to take, and where explicit steps replace implicit ones.
std::string advice(const Study&);

// The best of these trials in the sense of a question, --budget or --seconds.
using Question = std::function<std::optional<Score>(const std::vector<Score>&)>;

// The best trial of the steps' programs, with the command that repeats it. If XPBD or VBD does better, that
// as well, without a command: there is none.
std::string answer(const Study&, const Question&);

// The command that runs the trial, which is one of a step, and the command that measures its error.
std::string command_of(const Study&, const Score&);
std::string scoring_command_of(const Study&, const Score&);

}  // namespace tradeoff
