/// The unit of length of a document's coordinates. If a file states its unit, the document has the
/// comment `tm:unit`, which is kept by all programs of a pipeline.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "transformesh/document.h"

namespace transformesh {

struct Unit {
  std::string_view name;        ///< name in 3MF, such as millimeter
  std::string_view short_name;  ///< abbreviation, such as mm
  double millimeters = 1;       ///< length of the unit in millimeters
};

/// The units of 3MF: micron, millimeter, centimeter, inch, foot, meter.
std::span<const Unit> all_units();

/// Returns the unit with this name or abbreviation, or null.
const Unit* find_unit(std::string_view name);

/// Returns the unit of the `tm:unit` comment. Without the comment, returns millimeter, the usual
/// unit, for documents that were read from STL, and null for others.
const Unit* unit_of(const Document& document);

/// Returns a note if the units of two meshes are known and differ, else nothing.
std::vector<std::string> notes_of_units(const Unit* first, const Unit* second);

/// Replaces the `tm:unit` comment by a comment with this unit.
void set_unit(Document& document, const Unit& unit);

/// Appends a note if the format `format` cannot store the unit that a comment states. No note is
/// needed if the unit is `usual`, the usual unit of the format.
void note_lost_unit(const Document& document, const std::string& format, std::string_view usual,
                    std::vector<std::string>& notes);

/// True if the comment states a unit.
bool is_unit_comment(std::string_view comment);

}  // namespace transformesh
