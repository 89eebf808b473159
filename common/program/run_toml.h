// run.toml, which makes a run again.
#pragma once
#include <string>

#include "program/options.h"

// The scene as it is run, and in [run] the program, its version and all options of method and
// pictures. A program that reads it as its scene makes the same run again.
std::string run_toml(const Options&, const std::string& effective_scene);
