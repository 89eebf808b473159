// The page of --explain: its sections, each printed from what was measured.
#pragma once
#include "explain/survey.h"

void print_scene(const Options&, const Scene&);
// Forecast: s, of everything that has to be measured.
void print_duration(const TimeBudget&, double forecast);
void print_costs(const Options&, const Scene&, const std::vector<Part>&, const Survey&);
void print_explicit_limit(const Scene&, const std::vector<Part>&, const Limit&);
void print_implicit_limit(const Scene&, const Limit&);
void print_error(const Options&, const Scene&, const Survey&);
void print_left_out(const std::vector<Part>&, const Survey&);
void print_not_measured(const TimeBudget&, const Survey&);
void print_advice(const Options&, const std::vector<Part>&, const Survey&);
