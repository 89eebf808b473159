#include "explain/parts.h"

#include <algorithm>
#include <cstdio>

namespace {

using Slot = std::optional<Term>;

// Where a cloth keeps its terms. Springs bend: they are one of the models of [bend].
std::vector<Slot*> slots_of(Cloth& cloth) {
  return {&cloth.triangles.stretch, &cloth.triangles.shear, &cloth.springs.spring,
          &cloth.hinges.bend, &cloth.quadratic_hinges.bend};
}

// Elements without a term are not there.
void drop_idle_elements(Cloth& cloth) {
  if (!cloth.triangles.stretch && !cloth.triangles.shear) cloth.triangles.elements.clear();
  if (!cloth.springs.spring) cloth.springs.elements.clear();
  if (!cloth.hinges.bend) cloth.hinges.elements.clear();
  if (!cloth.quadratic_hinges.bend) cloth.quadratic_hinges.elements.clear();
}

Cloth without_term(Cloth cloth, size_t slot) {
  slots_of(cloth)[slot]->reset();
  drop_idle_elements(cloth);
  return cloth;
}

Cloth without_damping(Cloth cloth, const std::vector<size_t>& slots) {
  for (const size_t slot : slots) (*slots_of(cloth)[slot])->kd = 0;
  return cloth;
}

Cloth without_gravity(Cloth cloth) {
  cloth.gravity.reset();
  return cloth;
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", value);
  return text;
}

std::string describe(const Term& term, bool by_length, const std::string& model) {
  std::string text = term.name + (model.empty() ? "" : " (" + model + ")") +
                     " k = " + number(term.k) + (by_length ? " N/m" : " N·m");
  if (term.kd > 0) text += ", kd = " + number(term.kd) + (by_length ? " N·s/m" : " N·m·s");
  return text;
}

}  // namespace

std::vector<Part> parts_of(const Cloth& cloth) {
  Cloth looked_at = cloth;
  const std::vector<Slot*> slots = slots_of(looked_at);
  std::vector<Part> parts;
  if (cloth.gravity)
    parts.push_back({"gravity", "--without gravity", false, without_gravity(cloth)});
  std::vector<size_t> damped;
  for (size_t slot = 0; slot < slots.size(); ++slot) {
    if (!*slots[slot]) continue;
    const std::string name = (*slots[slot])->name;
    parts.push_back({name, "--without " + name, false, without_term(cloth, slot)});
    if ((*slots[slot])->kd > 0) damped.push_back(slot);
  }
  if (damped.size() > 1)
    for (const size_t slot : damped) {
      const std::string name = (*slots[slot])->name;
      parts.push_back({"damping of " + name, "[damping] without " + name, true,
                       without_damping(cloth, {slot})});
    }
  if (!damped.empty())
    parts.push_back(
        {damped.size() > 1 ? "all damping" : std::string("damping of ") + (*slots[damped[0]])->name,
         "--without damping", true, without_damping(cloth, damped)});
  return parts;
}

std::vector<std::string> describe_terms(const Cloth& cloth) {
  std::vector<std::string> terms;
  if (cloth.gravity) terms.push_back("gravity " + number(cloth.gravity->norm()) + " m/s²");
  if (const auto& term = cloth.triangles.stretch) terms.push_back(describe(*term, true, ""));
  if (const auto& term = cloth.triangles.shear) terms.push_back(describe(*term, true, ""));
  if (const auto& term = cloth.springs.spring) terms.push_back(describe(*term, true, "springs"));
  const bool sine = cloth.hinges.model == BendModel::bridson;
  if (const auto& term = cloth.hinges.bend)
    terms.push_back(describe(*term, false, sine ? "bridson" : "dihedral"));
  if (const auto& term = cloth.quadratic_hinges.bend)
    terms.push_back(describe(*term, false, "quadratic"));
  return terms;
}

std::string describe_elements(const Scene& scene) {
  const Cloth& cloth = scene.cloth;
  std::string text = std::to_string(cloth.vertices()) + " vertices, " +
                     std::to_string(scene.mesh.faces.size()) + " triangles";
  const size_t hinges = cloth.hinges.elements.size() + cloth.quadratic_hinges.elements.size();
  if (hinges > 0) text += ", " + std::to_string(hinges) + " hinges";
  if (const size_t springs = cloth.springs.elements.size())
    text += ", " + std::to_string(springs) + " springs";
  const long moving = std::count_if(cloth.pins.begin(), cloth.pins.end(),
                                    [](const Pin& pin) { return !pin.velocity.isZero(0); });
  text += ", " + std::to_string(cloth.pins.size()) + " pinned";
  return text + (moving > 0 ? " (" + std::to_string(moving) +
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
