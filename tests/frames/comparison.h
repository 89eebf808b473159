// Two runs, frame by frame: pictures, positions and the log.
#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "picture/compare.h"
#include "run_directory.h"

struct PictureComparison {
  Difference difference;
  // Of the pixels that show the cloth in one of the two pictures: how many differ by more than 2 of 255, and
  // of how many.
  long pixels = 0, of = 0;
};

struct PositionComparison {
  double rms = 0, worst = 0;  // m, distances of a vertex to itself in the other run
  int worst_vertex = 0;
};

struct FramePair {
  const RunFrame *a = nullptr, *b = nullptr;
  std::optional<PictureComparison> picture;    // where both have one that can be compared
  std::optional<PositionComparison> position;  // where both have exported a mesh
  bool broken = false;                         // is one of the files there, but cannot be read?
  Verdict verdict = Verdict::IDENTICAL;
};

struct InputDifference {
  std::string key, a, b;  // "(absent)" where a run does not have the key
};

// The runs outlive their comparison.
struct Comparison {
  const RecordedRun *a = nullptr, *b = nullptr;
  std::vector<InputDifference> inputs;  // what differs in run.toml
  std::vector<std::string> notes;       // what could not be compared, one line each
  std::vector<FramePair> frames;        // in time
  Verdict verdict = Verdict::IDENTICAL;
  std::optional<size_t> first_difference;  // of frames, the first that is DIFFERENT
};

// Frames are paired by time. A frame lies within half a step of the moment that it stands for, so two frames
// of one moment are at most half a step of A and half a step of B apart. Of several such frames the nearest
// is taken. The verdict of a pair is the worst of its pictures and of its positions; where it has neither,
// that of the log. A file that cannot be read makes it DIFFERENT. The verdict of the runs is the worst of all
// pairs; a frame of A without a partner makes them DIFFERENT.
Comparison compare_runs(const RecordedRun& a, const RecordedRun& b);

// One sentence: the first frame that is different and by what, or that none is.
std::string summary(const Comparison&);

std::string name_of(Verdict);  // identical, equivalent, different
