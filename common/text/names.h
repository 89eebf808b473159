// Names that a user can choose from, and what to say about one that does not exist.
#pragma once
#include <string>
#include <string_view>
#include <vector>

using Names = std::vector<std::string>;

// `did you mean "stretch"? Valid are cloth, gravity, …`; the question only where one is close.
std::string valid_names(std::string_view given, const Names& valid);

// "ldlt, inverse or cholmod".
std::string choices(const Names& valid);
