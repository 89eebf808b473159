// The terms of a scene, each from the table that it names itself (math/family.h). No term is named
// here.
#include <algorithm>

#include "scene/scene_file.h"

namespace {

std::string named(std::string_view word) {
  return std::string(word);
}

// The models that share a table, in the order of the lists; none where the table has but one.
Names models_of(std::string_view table) {
  Names models;
  for (const TermInfo& term : term_infos())
    if (term.table == table && !term.model.empty()) models.push_back(named(term.model));
  return models;
}

// A term whose k follows from a modulus B.
template <class T>
concept HasModulus = requires {
  T::k_of_modulus(1.0);
};

bool has_modulus(std::string_view table) {
  bool has = false;
  const Families none;
  for_each_term(none, [&]<class T>(const std::optional<T>&) {
    if (HasModulus<T> && T::info.table == table) has = true;
  });
  return has;
}

// Does the scene have the table of this term, and does the table ask for this model? The first
// model of the lists is the default.
bool names(const SceneFile& scene, const TermInfo& term) {
  if (term.first_step == 0 || !scene.has(named(term.table))) return false;
  const Names models = models_of(term.table);
  if (models.empty()) return true;
  const TomlTable table = scene.table(named(term.table));
  return (table.has("model") ? table.one_of("model", models) : models.front()) == term.model;
}

// A term that reads its own keys: its keys, and read(values).
template <class T>
concept ReadsItself = requires {
  T::keys;
};

// The numbers of a table, as a term reads them.
struct Values {
  const TomlTable& table;

  bool has(const char* key) const { return table.has(key); }
  double number(const char* key) const { return table.number(key, Range::any); }
  double positive(const char* key) const { return table.number(key, Range::positive); }
  double not_negative(const char* key) const { return table.number(key, Range::not_negative); }
  std::string one_of(const char* key, const Names& valid) const { return table.one_of(key, valid); }
  [[noreturn]] void refuse(const char* key, const std::string& must) const {
    table.refuse(key, must);
  }
};

void check_keys(const TomlTable& table, const TermInfo& term) {
  Names keys;
  if (!term.model.empty()) keys.push_back("model");
  keys.push_back("k");
  if (!has_modulus(term.table)) return table.allow_only(keys);
  keys.push_back("B");
  table.allow_only(keys);
  if (table.has("B") && table.has("k"))
    table.refuse("B", "k follows from B; take out one of the two");
  if (!table.has("B") && !table.has("k"))
    table.refuse_table("needs k = a number from 0 to 1e30, or B, the modulus that k follows from");
}

template <class T>
T read_term(const TomlTable& table) {
  if constexpr (ReadsItself<T>) {
    Names keys(T::keys.begin(), T::keys.end());
    if (!T::info.model.empty()) keys.insert(keys.begin(), "model");
    table.allow_only(keys);
    T term(0);
    term.read(Values{table});
    return term;
  }
  check_keys(table, T::info);
  if (!table.has("B")) return T(table.number("k", Range::not_negative));
  const double B = table.number("B", Range::not_negative);
  if constexpr (HasModulus<T>)
    return T(T::k_of_modulus(B));
  else
    table.refuse("B", named(T::info.model) + " have no bending modulus; give k in " +
                          named(T::info.units.k) + ", or take another model");
}

// Damping belongs to a term: a scene without the term has nothing to damp.
void read_damping(const SceneFile& scene, Model& model) {
  if (!scene.has("damping")) return;
  const TomlTable table = scene.table("damping");
  const Names known = scene.known(term_tables());
  table.allow_only(known);
  for (const std::string& name : known) {
    if (!table.has(name)) continue;
    const double kd = table.number(name, Range::not_negative);
    bool there = false;
    for_each_term(model, [&]<class T>(std::optional<T>& term) {
      if (!term || T::info.table != name) return;
      term->kd = kd;
      there = true;
    });
    if (!there)
      table.refuse(name, "the scene has no [" + name + "] to damp; add [" + name +
                             "], or take out this key");
  }
}

// A cloth has threads, or a membrane, or springs.
void check_in_plane(const SceneFile& scene, const Model& model) {
  std::optional<TermInfo> first;
  for_each_term(model, [&]<class T>(const std::optional<T>& term) {
    if (!term || T::info.in_plane == InPlane::none) return;
    if (first && first->in_plane != T::info.in_plane)
      scene.table(named(T::info.table))
          .refuse_table("stands in place of [" + named(first->table) +
                        "]; take out one of the two");
    if (!first) first = T::info;
  });
}

void check_rests_flat(const SceneFile& scene, const Mesh& mesh, const TermInfo& term) {
  if (std::find(mesh.in_space.begin(), mesh.in_space.end(), true) == mesh.in_space.end()) return;
  std::string others;
  for (const TermInfo& other : term_infos())
    if (other.table == term.table && !other.rests_flat)
      others += (others.empty() ? "" : " or ") + named(other.model);
  scene.table(named(term.table))
      .refuse("model",
              "this model rests flat, and the mesh has faces without texture coordinates to lay "
              "them flat; use " +
                  others + ", which rest there as the mesh lies");
}

}  // namespace

Names term_tables() {
  Names tables;
  for (const TermInfo& term : term_infos())
    if (term.first_step > 0 && std::find(tables.begin(), tables.end(), term.table) == tables.end())
      tables.push_back(named(term.table));
  return tables;
}

void read_terms(const SceneFile& scene, Model& model) {
  for_each_term(model, [&]<class T>(std::optional<T>& term) {
    if (!names(scene, T::info)) return;
    term = read_term<T>(scene.table(named(T::info.table)));
  });
  check_in_plane(scene, model);
  read_damping(scene, model);
}

void check_terms(const SceneFile& scene, const Mesh& mesh, const Model& model) {
  for_each_term(model, [&]<class T>(const std::optional<T>& term) {
    if constexpr (requires { term->needs_grid(); }) {
      const char* key = term ? term->needs_grid() : nullptr;
      if (key && !mesh.grid)
        scene.table(named(T::info.table)).refuse(key, "only a grid has cells; take it out");
    }
    if (term && T::info.rests_flat) check_rests_flat(scene, mesh, T::info);
  });
}
