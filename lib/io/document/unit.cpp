#include "io/document/unit.h"

#include <algorithm>
#include <array>

namespace transformesh {
namespace {

constexpr std::string_view mark = "tm:unit ";

// The inch has been 25.4 mm by definition since 1959, and the foot has 12 inches.
constexpr std::array<Unit, 6> units{{{"micron", "um", 1e-3},
                                     {"millimeter", "mm", 1},
                                     {"centimeter", "cm", 10},
                                     {"inch", "in", 25.4},
                                     {"foot", "ft", 304.8},
                                     {"meter", "m", 1000}}};

const Unit* stated_unit(const Document& document) {
  for (const std::string& comment : document.style.comments)
    if (comment.starts_with(mark)) return find_unit(std::string_view(comment).substr(mark.size()));
  return nullptr;
}

}  // namespace

std::span<const Unit> all_units() { return units; }

const Unit* find_unit(std::string_view name) {
  const auto* const found = std::find_if(units.begin(), units.end(), [&](const Unit& unit) {
    return unit.name == name || unit.short_name == name;
  });
  return found == units.end() ? nullptr : found;
}

const Unit* unit_of(const Document& document) {
  const Unit* const stated = stated_unit(document);
  return stated == nullptr && document.style.is_from_stl ? find_unit("mm") : stated;
}

std::vector<std::string> notes_of_units(const Unit* first, const Unit* second) {
  if (first == nullptr || second == nullptr || first == second) return {};
  return {"the units differ, " + std::string(first->name) + " and " + std::string(second->name) +
          ": coordinates are used without conversion"};
}

void set_unit(Document& document, const Unit& unit) {
  std::vector<std::string>& comments = document.style.comments;
  std::erase_if(comments, is_unit_comment);
  comments.push_back(std::string(mark).append(unit.name));
}

void note_lost_unit(const Document& document, const std::string& format, std::string_view usual,
                    std::vector<std::string>& notes) {
  const Unit* unit = stated_unit(document);
  if (unit == nullptr || unit->name == usual) return;
  notes.push_back(format + ": the unit " + std::string(unit->name) + " cannot be stored" +
                  (usual.empty() ? "" : ", and programs will assume " + std::string(usual)));
}

bool is_unit_comment(std::string_view comment) { return comment.starts_with(mark); }

}  // namespace transformesh
