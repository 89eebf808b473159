#include "comparison.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "cloth_pixels.h"
#include "picture/png.h"
#include "scene/mesh.h"
#include "text/bad_input.h"
#include "text/text.h"

namespace {

// --- which frames belong together

const RunFrame& nearest(const std::vector<RunFrame>& frames, double time) {
  return *std::min_element(frames.begin(), frames.end(), [&](const RunFrame& f, const RunFrame& g) {
    return std::abs(f.time - time) < std::abs(g.time - time);
  });
}

std::vector<FramePair> pairs_in_time(const RecordedRun& a, const RecordedRun& b) {
  std::vector<FramePair> pairs;
  const double apart = (a.h + b.h) / 2;
  for (const RunFrame& frame : a.frames) {
    const RunFrame& partner = nearest(b.frames, frame.time);
    const double rounding = 1e-9 * std::max(1.0, std::abs(frame.time));
    if (std::abs(partner.time - frame.time) <= apart + rounding &&
        &nearest(a.frames, partner.time) == &frame)
      pairs.push_back({.a = &frame, .b = &partner});
  }
  return pairs;
}

// --- one line for many frames of which the same is to be said

std::string at_times(const std::vector<const RunFrame*>& frames) {
  const std::string first = text("t = %.6g s", frames[0]->time);
  if (frames.size() == 1) return "at " + first;
  return text("at %zu times, of which the first is ", frames.size()) + first;
}

void note_lonely_frames(const RecordedRun& run, const std::vector<FramePair>& pairs,
                        const RunFrame* FramePair::*member, const char* other,
                        std::vector<std::string>& notes) {
  std::vector<const RunFrame*> lonely;
  for (const RunFrame& frame : run.frames)
    if (std::none_of(pairs.begin(), pairs.end(),
                     [&](const FramePair& pair) { return pair.*member == &frame; }))
      lonely.push_back(&frame);
  if (!lonely.empty()) notes.push_back(std::string(other) + " has no frame " + at_times(lonely));
}

// --- files that may be missing or broken

// Reads the files of one kind, pictures or meshes, of the frames of both runs, and notes what is missing or
// broken.
template <class Content>
struct Files {
  const Comparison& runs;
  std::string kind;  // picture
  std::filesystem::path (RunFrame::*name)() const;
  Content (*read)(const std::filesystem::path&);
  std::vector<const RunFrame*> missing_in_a = {}, missing_in_b = {};  // but the other has it
  std::vector<std::string> faults = {};
  bool any = false;  // does any frame have the file in both runs?

  // The files of both runs, where both can be read.
  std::optional<std::array<Content, 2>> of(FramePair& pair) {
    const std::filesystem::path a = runs.a->directory / (pair.a->*name)(),
                                b = runs.b->directory / (pair.b->*name)();
    const bool in_a = exists(a), in_b = exists(b);
    if (!in_a && in_b) missing_in_a.push_back(pair.a);
    if (in_a && !in_b) missing_in_b.push_back(pair.b);
    if (!in_a || !in_b) return std::nullopt;
    any = true;
    std::optional<Content> first = content("A", a), second = content("B", b);
    pair.broken |= !first || !second;
    if (!first || !second) return std::nullopt;
    return std::array{std::move(*first), std::move(*second)};
  }

  std::optional<Content> content(const std::string& run, const std::filesystem::path& path) try {
    return read(path);
  } catch (const std::exception& fault) {
    faults.push_back(run + ": " + one_line(fault.what()));
    return std::nullopt;
  }

  void note(std::vector<std::string>& notes) const {
    if (!missing_in_a.empty()) notes.push_back("A has no " + kind + " " + at_times(missing_in_a));
    if (!missing_in_b.empty()) notes.push_back("B has no " + kind + " " + at_times(missing_in_b));
    notes.insert(notes.end(), faults.begin(), faults.end());
  }
};

// --- one pair

PictureComparison compare_pictures(const Image& a, const Image& b) {
  PictureComparison result{compare(a, b)};
  for (size_t i = 0; i < a.rgb.size(); i += 3) {
    if (!shows_cloth(&a.rgb[i]) && !shows_cloth(&b.rgb[i])) continue;
    ++result.of;
    result.pixels += pixel_difference(&a.rgb[i], &b.rgb[i]) > 2;
  }
  return result;
}

PositionComparison compare_positions(const VecX& a, const VecX& b) {
  PositionComparison result;
  double squares = 0;
  for (int i = 0; i < a.size() / 3; ++i) {
    const double distance = (a.segment<3>(3 * i) - b.segment<3>(3 * i)).norm();
    squares += distance * distance;
    if (distance <= result.worst) continue;
    result.worst = distance;
    result.worst_vertex = i;
  }
  if (a.size() > 0) result.rms = std::sqrt(3 * squares / double(a.size()));
  return result;
}

// A difference that hardly shows: where the cloth is 300 pixels wide, a twentieth of a pixel.
constexpr double equivalent_positions = 2e-4;  // of the size of the cloth

Verdict verdict_of(const PositionComparison& positions, double size) {
  if (positions.worst == 0) return Verdict::IDENTICAL;
  return positions.worst <= equivalent_positions * size ? Verdict::EQUIVALENT : Verdict::DIFFERENT;
}

// The diagonal of the box around the vertices.
double size_of(const VecX& x) {
  if (x.size() == 0) return 0;
  const Eigen::Map<const Eigen::Matrix3Xd> points(x.data(), 3, x.size() / 3);
  return (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).norm();
}

// Energies and the lowest point: what can be compared without pictures and meshes.
constexpr std::array compared_columns = {"total", "elastic", "lowest"};

// The largest finite value of each of these columns, of the reference alone: a run that explodes has any
// energy.
std::array<double, 3> largest_values(const RecordedRun& reference) {
  std::array<double, 3> most = {};
  for (const RunFrame& frame : reference.frames)
    for (size_t c = 0; c < most.size(); ++c) {
      const double value = std::abs(frame.value(compared_columns[c]).value_or(0));
      if (std::isfinite(value)) most[c] = std::max(most[c], value);
    }
  return most;
}

// The same digits, or apart by at most 1e-4 of the reference's largest value.
Verdict verdict_of_log(const FramePair& pair, const std::array<double, 3>& most) {
  Verdict worst = Verdict::IDENTICAL;
  for (size_t c = 0; c < most.size(); ++c) {
    const std::optional<double> a = pair.a->value(compared_columns[c]),
                                b = pair.b->value(compared_columns[c]);
    if (!a || !b || *a == *b) continue;
    const bool close = std::abs(*a - *b) <= 1e-4 * most[c];  // false for nan
    worst = std::max(worst, close ? Verdict::EQUIVALENT : Verdict::DIFFERENT);
  }
  return worst;
}

bool same_size(const std::array<Image, 2>& images) {
  return images[0].width == images[1].width && images[0].height == images[1].height;
}

std::string size_of(const Image& image) {
  return text("%dx%d", image.width, image.height);
}

class Comparer {
 public:
  explicit Comparer(Comparison& runs_) : runs(runs_) {}

  void compare(FramePair& pair) {
    Verdict worst = Verdict::IDENTICAL;
    if (const auto both = pictures.of(pair)) worst = compare(*both, pair);
    if (const auto both = meshes.of(pair)) worst = std::max(worst, compare(*both, pair));
    if (!pair.picture && !pair.position) worst = verdict_of_log(pair, most);
    pair.verdict = pair.broken ? Verdict::DIFFERENT : worst;
  }

  void note(std::vector<std::string>& notes) {
    if (!other_size.empty()) notes.push_back(other_size);
    if (!other_vertices.empty()) notes.push_back(other_vertices);
    pictures.note(notes);
    meshes.note(notes);
    if (!meshes.any)
      notes.push_back("no distances in mm: make both runs with --export obj to have them");
  }

 private:
  Verdict compare(const std::array<Image, 2>& images, FramePair& pair) {
    if (!same_size(images)) {
      other_size = "the pictures of A are " + size_of(images[0]) + ", those of B " +
                   size_of(images[1]) + ": not compared";
      return Verdict::IDENTICAL;
    }
    pair.picture = compare_pictures(images[0], images[1]);
    return verdict(pair.picture->difference);
  }

  Verdict compare(const std::array<VecX, 2>& x, FramePair& pair) {
    if (x[0].size() != x[1].size()) {
      other_vertices = text("A has %td vertices, B %td: positions are not compared",
                            x[0].size() / 3, x[1].size() / 3);
      return Verdict::IDENTICAL;
    }
    pair.position = compare_positions(x[0], x[1]);
    return verdict_of(*pair.position, size_of(x[0]));
  }

  const Comparison& runs;
  const std::array<double, 3> most = largest_values(*runs.a);
  Files<Image> pictures{runs, "picture", &RunFrame::picture, read_png};
  Files<VecX> meshes{runs, "mesh", &RunFrame::mesh, read_obj_vertices};
  std::string other_size, other_vertices;
};

std::vector<InputDifference> differing_inputs(const RecordedRun& a, const RecordedRun& b) {
  std::map<std::string, std::string> all = a.inputs;
  all.insert(b.inputs.begin(), b.inputs.end());
  std::vector<InputDifference> differing;
  if (a.inputs.empty() || b.inputs.empty()) return differing;  // a run.toml that cannot be read
  for (const auto& [key, value] : all) {
    const auto of = [&, &k = key](const RecordedRun& run) {
      const auto found = run.inputs.find(k);
      return found == run.inputs.end() ? "(absent)" : found->second;
    };
    if (of(a) != of(b)) differing.push_back({key, of(a), of(b)});
  }
  return differing;
}

std::string what_differs(const PictureComparison& picture) {
  if (picture.pixels > 0)
    return text("%ld of the %ld pixels of the cloth differ", picture.pixels, picture.of);
  return text("%ld pixels differ, none of them shows the cloth", picture.difference.above0);
}

std::string what_differs_in_the_log(const FramePair& pair) {
  std::vector<std::string> facts;
  for (const char* const column : compared_columns) {
    const std::optional<double> a = pair.a->value(column), b = pair.b->value(column);
    if (a && b && *a != *b) facts.push_back(text("%s is %.6g in A and %.6g in B", column, *a, *b));
  }
  return joined(facts, ", ");
}

std::string what_differs(const FramePair& pair) {
  std::vector<std::string> facts;
  if (pair.broken) facts.push_back("a file of it cannot be read");
  if (pair.picture && pair.picture->difference.above0 > 0)
    facts.push_back(what_differs(*pair.picture));
  if (pair.position && pair.position->worst > 0)
    facts.push_back(text("vertex %d is %.3g mm away", pair.position->worst_vertex,
                         1000 * pair.position->worst));
  return facts.empty() ? what_differs_in_the_log(pair) : joined(facts, ", ");
}

}  // namespace

Comparison compare_runs(const RecordedRun& a, const RecordedRun& b) {
  Comparison result{.a = &a, .b = &b};
  result.inputs = differing_inputs(a, b);
  for (const std::string& fault : a.faults) result.notes.push_back("A: " + fault);
  for (const std::string& fault : b.faults) result.notes.push_back("B: " + fault);

  result.frames = pairs_in_time(a, b);
  note_lonely_frames(a, result.frames, &FramePair::a, "B", result.notes);
  note_lonely_frames(b, result.frames, &FramePair::b, "A", result.notes);
  if (result.frames.size() < a.frames.size()) result.verdict = Verdict::DIFFERENT;

  Comparer comparer(result);
  for (size_t i = 0; i < result.frames.size(); ++i) {
    FramePair& pair = result.frames[i];
    comparer.compare(pair);
    result.verdict = std::max(result.verdict, pair.verdict);
    if (pair.verdict == Verdict::DIFFERENT && !result.first_difference) result.first_difference = i;
  }
  comparer.note(result.notes);
  return result;
}

std::string summary(const Comparison& comparison) {
  if (comparison.frames.empty()) return "No two frames are of the same time.";
  if (comparison.first_difference) {
    const FramePair& pair = comparison.frames[*comparison.first_difference];
    return text("The first frame that differs is frame %d, t = %.6g s: ", pair.a->number,
                pair.a->time) +
           what_differs(pair) + ".";
  }
  if (comparison.verdict == Verdict::DIFFERENT)
    return "No frame differs, but B has partners for only " +
           std::to_string(comparison.frames.size()) + " of A's " +
           count(long(comparison.a->frames.size()), "frame") + ".";
  return "All frames (" + std::to_string(comparison.frames.size()) + ") are " +
         name_of(comparison.verdict) + ".";
}

std::string name_of(Verdict v) {
  return v == Verdict::IDENTICAL    ? "identical"
         : v == Verdict::EQUIVALENT ? "equivalent"
                                    : "different";
}
