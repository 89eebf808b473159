#include "explain/parts.h"

#include <algorithm>
#include <map>

#include "text/text.h"

namespace {

// Elements without a term are not there.
Cloth without_term(Cloth cloth, const std::string& table) {
  for_each_family(cloth, [&](auto& family) {
    family.for_each_term([&]<class T>(std::optional<T>& term) {
      if (T::info.table == table) term.reset();
    });
    if (!family.acts()) family.elements.clear();
  });
  return cloth;
}

Cloth without_damping(Cloth cloth, const std::vector<std::string>& tables) {
  for_each_term(cloth, [&]<class T>(std::optional<T>& term) {
    if (term && std::find(tables.begin(), tables.end(), T::info.table) != tables.end())
      term->kd = 0;
  });
  return cloth;
}

Cloth without_gravity(Cloth cloth) {
  cloth.gravity.reset();
  return cloth;
}

// Every stiffness of a term that is not zero, and its damping.
template <class T>
std::string describe(const T& term) {
  const TermInfo& info = T::info;
  std::vector<std::string> values;
  const auto note = [&](const char* name, double value, std::string_view unit) {
    if (value != 0) values.push_back(text("%s = %g ", name, value) + std::string(unit));
  };
  if constexpr (requires { term.stiffnesses(); })
    for (const auto& [name, value] : term.stiffnesses()) note(name, value, info.units.k);
  else
    values.push_back(text("k = %g ", term.k) + std::string(info.units.k));
  note("kd", term.kd, info.units.kd);
  const std::string model = info.model.empty() ? "" : " (" + std::string(info.model) + ")";
  return std::string(info.table) + model + " " + joined(values, ", ");
}

// The tables of all terms of a cloth, each once, and the tables of the damped ones.
struct Tables {
  std::vector<std::string> all, damped;
};
Tables tables_of(const Cloth& cloth) {
  Tables tables;
  const auto note = [](std::vector<std::string>& list, std::string_view table) {
    if (std::find(list.begin(), list.end(), table) == list.end()) list.emplace_back(table);
  };
  for_each_term(cloth, [&]<class T>(const std::optional<T>& term) {
    if (term) note(tables.all, T::info.table);
    if (term && term->kd > 0) note(tables.damped, T::info.table);
  });
  return tables;
}

}  // namespace

std::vector<Part> parts_of(const Cloth& cloth) {
  const auto [all, damped] = tables_of(cloth);
  std::vector<Part> parts;
  if (cloth.gravity)
    parts.push_back({"gravity", "--without gravity", false, without_gravity(cloth)});
  for (const std::string& table : all)
    parts.push_back({table, "--without " + table, false, without_term(cloth, table)});
  if (damped.size() > 1)
    for (const std::string& table : damped)
      parts.push_back({"damping of " + table, "[damping] without " + table, true,
                       without_damping(cloth, {table})});
  if (!damped.empty())
    parts.push_back({damped.size() > 1 ? "all damping" : "damping of " + damped[0],
                     "--without damping", true, without_damping(cloth, damped)});
  return parts;
}

std::vector<std::string> describe_terms(const Cloth& cloth) {
  std::vector<std::string> terms;
  if (cloth.gravity) terms.push_back("gravity " + text("%g", cloth.gravity->norm()) + " m/s²");
  for_each_term(cloth, [&]<class T>(const std::optional<T>& term) {
    if (term) terms.push_back(describe(*term));
  });
  return terms;
}

Sharing sharing_of(const Cloth& cloth) {
  Sharing sharing;
  for_each_family(cloth, [&](const auto& family) {
    std::vector<std::string> here;
    family.for_each_term([&]<class T>(const std::optional<T>& term) {
      if (term) here.emplace_back(T::info.table);
    });
    if (here.size() < 2) return;
    sharing.elements.emplace_back(std::decay_t<decltype(family.elements[0])>::plural);
    sharing.terms.insert(sharing.terms.end(), here.begin(), here.end());
  });
  return sharing;
}

std::string describe_elements(const Scene& scene) {
  const Cloth& cloth = scene.cloth;
  std::string words = std::to_string(cloth.vertices()) + " vertices, " +
                      std::to_string(scene.mesh.faces.size()) + " triangles";
  std::map<std::string_view, size_t> elements;  // hinges, springs
  for_each_family(cloth, [&](const auto& family) {
    elements[std::decay_t<decltype(family.elements[0])>::plural] += family.elements.size();
  });
  for (const auto& [plural, number] : elements)
    if (number > 0 && plural != Triangle::plural)
      words += ", " + std::to_string(number) + " " + std::string(plural);
  const long moving = std::count_if(cloth.pins.begin(), cloth.pins.end(),
                                    [](const Pin& pin) { return pin.moves(); });
  words += ", " + std::to_string(cloth.pins.size()) + " pinned";
  return words + (moving > 0 ? " (" + std::to_string(moving) +
                                   (moving == 1 ? " of them moves)" : " of them move)")
                             : "");
}

size_t element_bytes(const Cloth& cloth) {
  size_t bytes = 0;
  for_each_family(cloth, [&](const auto& family) {
    bytes += sizeof(family.elements[0]) * family.elements.size();
  });
  return bytes;
}
