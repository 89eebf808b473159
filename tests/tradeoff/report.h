// What a study found, for people: tables, a picture, a sentence.
#pragma once
#include "tradeoff/front.h"
#include "tradeoff/study.h"

namespace tradeoff {

inline const std::vector<double> asked_errors = {1e-1, 1e-2, 1e-3, 1e-4, 1e-5};

// The cheapest way of each kind to errors of 1e-1 … 1e-5; then the front. Where no error can be told: the
// statistics of each way instead.
void print_tables(const Study&);

// Error against time of every trial, the front through the best of them: work_precision.png.
void draw_plot(const Study&);

// One sentence: what to take, and where explicit and implicit ways change places.
std::string advice(const Study&);

// A path for a shell: from here, and in quotes where it needs them.
std::string for_shell(const std::filesystem::path&);

// The command that runs the trial, and the one that tells its error.
std::string command_of(const Study&, const Score&);
std::string scoring_command_of(const Study&, const Score&);

}  // namespace tradeoff
