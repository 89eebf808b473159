// The sections of the page, each printed from what was measured.
#pragma once
#include "explain/limit.h"
#include "explain/survey.h"

void print_scene(const Options&, const Scene&);
void print_costs(const Options&, const Scene&, const std::vector<Part>&, const Survey&);
void print_explicit_limit(const Scene&, const std::vector<Part>&, const Limit&);
void print_implicit_limit(const Scene&);
void print_error(const Options&, const Scene&, const Survey&);
void print_left_out(const std::vector<Part>&, const Survey&);
void print_advice(const Options&, const std::vector<Part>&, const Survey&);

// The mean of the run and its twin, nudged by next to nothing, s.
double step_seconds(const Survey&);

// Of other methods that solve as accurately the cheapest; nothing where it saves less than a fifth.
const Probe* better_method(const Survey&, double tolerance);
