#include "tradeoff/study_scene.h"

#include <algorithm>

#include "scene/velocities.h"
#include "support/scenes.h"
#include "support/text.h"
#include "text/text_file.h"
#include "ways/simulator.h"

namespace tradeoff {

namespace {

// The default scene of the first steps on a coarser mesh. It ends when the cloth begins to fold.
TestScene dropped_sheet(int cells, double k) {
  const Mesh mesh = make_grid({1, 1}, {cells, cells}, Diagonals::alternating);
  Model m = model(k, k / 2, Gravity::on);
  m.pins = {cells * (cells + 1), cells * (cells + 1) + cells};
  TestScene scene = at_rest(mesh, m);
  scene.end = 0.8;
  return scene;
}

TestScene damped_curtain(double k) {
  TestScene scene = curtain_of(k);
  scene.cloth.term<StretchTerm>()->kd = scene.cloth.term<ShearTerm>()->kd = 0.05;
  return scene;
}

// A built-in scene with its stiffnesses scaled to another k.
TestScene rescaled(TestScene scene, double k) {
  const double factor = k / scene.cloth.term<StretchTerm>()->k;
  scene.cloth.term<StretchTerm>()->k *= factor;
  scene.cloth.term<ShearTerm>()->k *= factor;
  return scene;
}

struct Recipe {
  BuiltIn described;
  std::vector<int> cells;  // of the meshes that are compared
  double k;                // N/m, of stretch; shear has half of it
  std::function<TestScene(int cells, double k)> make;
  bool any_cells = false;
  std::function<VecX(const Mesh&, double k, double time)> exact = {};
};

VecX ringing(const Mesh& mesh, double k, double time) {
  return field(mesh, [&](double u, double v) { return Vec3(u, ringing_depth(v - 1, k, time), 0); });
}

const std::vector<Recipe>& recipes() {
  static const std::vector<Recipe> all = {
      {{"trampoline", "T", "held by all edges, stretched by 5 %, thrown up in the middle"},
       {6},
       100,
       [](int, double k) { return rescaled(trampoline(), k); }},
      {{"curtain", "C", "held by its top, pulled 25 degrees aside"},
       {6},
       100,
       [](int, double k) { return curtain_of(k); }},
      {{"flap", "F", "held at one end, falls and bends"},
       {8},
       100,
       [](int, double k) { return rescaled(flap(), k); }},
      {{"damped-curtain", "D", "the curtain with kd = 0.05 N·s/m"},
       {6},
       100,
       [](int, double k) { return damped_curtain(k); }},
      {{"strip", "W", "rings lengthwise; its motion is known, so that meshes are compared too"},
       {1, 2, 4},
       100,
       [](int cells, double k) { return ringing_strip_of(4 * cells, k); },
       true,
       ringing},
      {{"drop", "drop", "a sheet, held by two corners, swings down for 0.8 s"},
       {8},
       1000,
       dropped_sheet,
       true},
  };
  return all;
}

const Recipe* recipe_of(const std::string& name) {
  for (const Recipe& recipe : recipes())
    if (name == recipe.described.name || name == recipe.described.letter) return &recipe;
  return nullptr;
}

// The largest u and v of a grid.
Vec2 size_of(const Mesh& grid) {
  Vec2 size = Vec2::Zero();
  for (const auto& corners : grid.rest)
    for (const Vec2& uv : corners) size = size.cwiseMax(uv);
  return size;
}

std::string table(std::string_view name) {
  return "[" + std::string(name) + "]\n";
}

std::string to_toml(const std::string& key, double value) {
  return key + " = " + number(value) + "\n";
}

// The terms of a cloth, and their damping.
std::string terms_to_toml(const Cloth& cloth) {
  std::string terms, damping;
  for_each_term(cloth, [&]<class T>(const std::optional<T>& term) {
    if (!term) return;
    terms += table(T::info.table) + to_toml("k", term->k);
    if (term->kd > 0) damping += to_toml(std::string(T::info.table), term->kd);
  });
  return terms + (damping.empty() ? "" : table("damping") + damping);
}

std::string to_toml(const TestScene& scene) {
  const Vec2 size = size_of(scene.mesh);
  const auto& [columns, rows] = scene.mesh.grid->cells;
  const bool same = scene.mesh.grid->diagonals == Diagonals::same;
  std::string toml = "[cloth]\nsize = [" + number(size.x()) + ", " + number(size.y()) +
                     "]\ncells = [" + std::to_string(columns) + ", " + std::to_string(rows) +
                     "]\ndiagonals = \"" + (same ? "same" : "alternating") +
                     "\"\ndensity = " + number(density) + "\npins = [";
  for (const Pin& pin : scene.cloth.pins) toml += std::to_string(pin.vertex) + ", ";
  toml += "]\n";
  if (scene.cloth.gravity) toml += "[gravity]\ng = " + number(g) + "\n";
  toml += terms_to_toml(scene.cloth);
  toml += "[start]\npositions = \"start.obj\"\nvelocities = \"start_velocities.csv\"\n";
  return toml + "[time]\nh = " + number(scene.end / 100) + "\nend = " + number(scene.end) +
         "\nframes = 1\n";
}

std::filesystem::path write_scene(const TestScene& scene, const std::filesystem::path& directory) {
  std::filesystem::create_directories(directory);
  write_obj(directory / "start.obj", scene.mesh, scene.start.x);
  write_velocities(directory / "start_velocities.csv", scene.start.v);
  write_text(directory / "scene.toml", to_toml(scene));
  return directory / "scene.toml";
}

double longer_side(const Mesh& mesh) {
  const auto points = mesh.x.reshaped(3, mesh.vertices());
  return (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).maxCoeff();
}

// read_scene decides whether a step can simulate the scene. A step whose new concept the scene does
// not use is left out: it would only repeat the step before.
void choose_steps(StudyScene& study, const Overrides& overrides) {
  const Cloth& cloth = study.scene.cloth;
  const bool bends = first_step_of(cloth) == 5;
  const auto leave_out = [&](int step, const std::string& why) {
    study.not_tried.push_back(std::string(program_of(step)).substr(0, 6) + ": " + why);
  };
  for (int step = 1; step <= 5; ++step) {
    if (step == 2 && !damped(cloth) && !bends) {
      leave_out(2, "moves an undamped cloth as step01 does, to the last bit");
      continue;
    }
    if (step == 5 && !bends) {
      leave_out(5, "moves a cloth that does not bend as step04 does, to the last bit");
      continue;
    }
    try {
      read_scene(study.scene.file, program_of(step), overrides);
      study.steps.push_back(step);
    } catch (const BadInput& cannot) {
      leave_out(step, cannot.what());
    }
  }
}

const Recipe& built_in(const Choice& choice) {
  if (const Recipe* recipe = recipe_of(choice.scene)) return *recipe;
  std::string names;
  for (const Recipe& recipe : recipes()) names += std::string(", ") + recipe.described.name;
  throw BadInput(choice.scene + ": neither a file nor a built-in scene; those are" +
                 names.substr(1));
}

TestScene make_built_in(const Recipe& recipe, const Choice& choice) {
  const int cells = choice.cells.value_or(recipe.cells.front());
  if (!recipe.any_cells && cells != recipe.cells.front())
    throw BadInput("--cells " + std::to_string(cells) + ": the " + recipe.described.name + " has " +
                   std::to_string(recipe.cells.front()) + "; the strip and the drop take any");
  return recipe.make(cells, choice.k.value_or(recipe.k));
}

}  // namespace

int cells_of(const StudyScene& study) {
  const auto& grid = study.scene.cloth.grid;
  return grid ? grid->cells[0] : 0;
}

const std::vector<BuiltIn>& built_in_scenes() {
  static const std::vector<BuiltIn> all = [] {
    std::vector<BuiltIn> described;
    for (const Recipe& recipe : recipes()) described.push_back(recipe.described);
    return described;
  }();
  return all;
}

bool is_built_in(const Choice& choice) {
  return recipe_of(choice.scene) != nullptr;
}

std::string short_name(const Choice& choice) {
  if (const Recipe* recipe = recipe_of(choice.scene)) return recipe->described.name;
  const std::filesystem::path file = std::filesystem::absolute(choice.scene);
  return file.parent_path().filename().string() + "_" + file.stem().string();
}

std::vector<Choice> meshes_of(const Choice& choice) {
  const Recipe* recipe = recipe_of(choice.scene);
  if (choice.cells || !recipe) return {choice};
  std::vector<Choice> choices;
  for (int cells : recipe->cells) choices.push_back({choice.scene, choice.k, cells});
  return choices;
}

StudyScene make_study_scene(const Choice& choice, const std::filesystem::path& directory) {
  StudyScene study;
  Overrides overrides;
  if (!recipe_of(choice.scene) && no_file(choice.scene).empty()) {
    if (choice.k)
      throw BadInput("--k: is for built-in scenes; write the k of this one in its file");
    overrides.cells = choice.cells;
    if (choice.cells) study.options = " --cells " + std::to_string(*choice.cells);
    study.name = choice.scene;
    study.scene = read_scene(choice.scene, program_of(5), overrides);
  } else {
    const Recipe& recipe = built_in(choice);
    const TestScene scene = make_built_in(recipe, choice);
    study.name = recipe.described.name;
    study.scene = read_scene(write_scene(scene, directory), program_of(5));
    if (recipe.exact)
      study.exact = [mesh = scene.mesh, exact = recipe.exact,
                     k = choice.k.value_or(recipe.k)](double t) { return exact(mesh, k, t); };
  }
  study.size = longer_side(study.scene.mesh);
  choose_steps(study, overrides);
  return study;
}

}  // namespace tradeoff
