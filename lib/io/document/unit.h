/// The unit of a document's coordinates. A file that states a unit has it as the comment `tm:unit`,
/// which goes with the mesh through the programs of a pipeline.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "transformesh/document.h"

namespace transformesh {

struct Unit {
  std::string_view name;        ///< in the spelling of 3MF: millimeter
  std::string_view short_name;  ///< mm
  double millimeters = 1;       ///< in one of the unit
};

/// The units of 3MF: micron, millimeter, centimeter, inch, foot, meter.
std::span<const Unit> all_units();

/// Returns the unit of a name, short or long, or null.
const Unit* find_unit(std::string_view name);

/// Returns the unit that the comment states, else millimeter for STL, which has no others by
/// convention, else null.
const Unit* unit_of(const Document& document);

/// Replaces the comment by one that states this unit.
void set_unit(Document& document, const Unit& unit);

/// Appends a line for a format that cannot state the document's unit, unless the unit is `usual`.
void note_lost_unit(const Document& document, const std::string& format, std::string_view usual,
                    std::vector<std::string>& notes);

/// True if the comment states a unit.
bool is_unit_comment(std::string_view comment);

}  // namespace transformesh
