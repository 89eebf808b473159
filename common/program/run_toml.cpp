#include "program/run_toml.h"

#include "text/text.h"

namespace {

// The options in words; those of the scene (--h, --cells, …) stand in the scene itself.
std::vector<std::string> words_of(const Options& o) {
  std::vector<std::string> words;
  if (o.concepts.implicit) {
    words.push_back(std::string("--jacobian=") +
                    (o.method.jacobian == Jacobian::bw98 ? "bw98" : "definite"));
    words.push_back("--newton=" + std::to_string(o.method.newton));
    words.push_back(std::string("--guard=") + (o.method.guard ? "on" : "off"));
  }
  if (o.concepts.direct) words.push_back("--solver=" + o.method.solver);
  if (o.concepts.iterative) {
    words.push_back("--preconditioner=" + o.method.preconditioner);
    words.push_back("--tolerance=" + shortest(o.method.tolerance));
    words.push_back("--max-iterations=" + std::to_string(o.method.max_iterations));
  }
  if (!o.pictures) words.push_back("--no-pictures");
  if (o.size) words.push_back(text("--size=%dx%d", (*o.size)[0], (*o.size)[1]));
  if (o.wireframe) words.push_back("--wireframe");
  if (o.caption) words.push_back("--caption");
  if (o.strain_scale) words.push_back("--strain=" + shortest(*o.strain_scale));
  if (o.motion) words.push_back("--motion");
  if (o.export_obj) words.push_back("--export=obj");
  if (o.export_pc2) words.push_back("--export=pc2");
  return words;
}

}  // namespace

std::string run_toml(const Options& options, const std::string& effective_scene) {
  std::vector<std::string> words = words_of(options);
  for (std::string& word : words) word = "'" + word + "'";
  return "# " + options.program + " run.toml makes this run again.\n[run]\nprogram = '" +
         options.program + "'\nversion = '" LARGE_STEPS_VERSION "'\noptions = [" +
         joined(words, ", ") + "]\n" + effective_scene;
}
