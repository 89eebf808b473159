#include "report_json.h"

#include <nlohmann/json.hpp>

namespace {

using Json = nlohmann::ordered_json;

template <class Value>
Json or_null(const std::optional<Value>& value) {
  return value ? Json(*value) : Json();
}

template <class Value, class Of>
Json or_null(const std::optional<Value>& value, const Of& of) {
  return value ? Json(of(*value)) : Json();
}

Json frame_of(const RecordedRun& run, const RunFrame& frame) {
  const bool has_picture = exists(run.directory / frame.picture());
  return {{"number", frame.number},
          {"time", frame.time},
          {"picture", has_picture ? Json(frame.picture().string()) : Json()},
          {"energy", or_null(frame.value("total"))},
          {"elastic", or_null(frame.value("elastic"))},
          {"stretch", or_null(frame.value("max_stretch"))},
          {"lowest", or_null(frame.value("lowest"))},
          {"iterations", or_null(frame.value("iterations"))}};
}

Json run_of(const RecordedRun& run, const PictureAddresses& addresses) {
  Json frames = Json::array();
  for (const RunFrame& frame : run.frames) frames.push_back(frame_of(run, frame));
  Json result = {{"name", run.name},
                 {"program", run.program},
                 {"directory", run.directory.string()},
                 {"reproduce", command_that_makes(run, run.directory)},
                 {"frames", frames}};
  const auto address = addresses.find(run.directory);
  if (address != addresses.end()) result["pictures"] = address->second;
  return result;
}

Json pair_of(const FramePair& pair) {
  const auto& picture = pair.picture;
  const auto& position = pair.position;
  return {{"time", pair.a->time},
          {"numbers", {pair.a->number, pair.b->number}},
          {"verdict", name_of(pair.verdict)},
          {"pixels", or_null(picture, [](const auto& p) { return p.pixels; })},
          {"of", or_null(picture, [](const auto& p) { return p.of; })},
          {"largest", or_null(picture, [](const auto& p) { return p.difference.largest; })},
          {"window", or_null(picture, [](const auto& p) { return p.difference.window; })},
          {"rms_mm", or_null(position, [](const auto& p) { return 1000 * p.rms; })},
          {"worst_mm", or_null(position, [](const auto& p) { return 1000 * p.worst; })},
          {"worst_vertex", or_null(position, [](const auto& p) { return p.worst_vertex; })}};
}

Json comparison_of(const Comparison& c, const PictureAddresses& addresses) {
  Json inputs = Json::array(), frames = Json::array();
  for (const InputDifference& input : c.inputs)
    inputs.push_back({{"key", input.key}, {"values", {input.a, input.b}}});
  for (const FramePair& pair : c.frames) frames.push_back(pair_of(pair));
  return {{"verdict", name_of(c.verdict)},
          {"summary", summary(c)},
          {"inputs", inputs},
          {"notes", c.notes},
          {"runs", {run_of(*c.a, addresses), run_of(*c.b, addresses)}},
          {"frames", frames},
          {"first_difference", or_null(c.first_difference)},
          {"accept", command_that_makes(*c.b, c.a->directory)}};
}

}  // namespace

std::string report_json(const std::vector<Comparison>& comparisons,
                        const PictureAddresses& addresses) {
  Json pairs = Json::array();
  for (const Comparison& comparison : comparisons)
    pairs.push_back(comparison_of(comparison, addresses));
  // A name that is no UTF-8 keeps its place with a sign of replacement.
  return Json{{"version", 1}, {"pairs", pairs}}.dump(1, ' ', false,
                                                     Json::error_handler_t::replace) +
         "\n";
}
