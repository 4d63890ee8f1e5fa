#include "io/formats/file_format.h"

#include <algorithm>
#include <utility>

#include "io/document/unit.h"
#include "mesh/coordinate_spacing.h"
#include "support/lower_case.h"

namespace transformesh {
namespace {

// Returns the extension in lower case, with the dot; empty if there is none.
std::string extension_of(std::string_view name) {
  return lower_case(name.substr(std::min(name.rfind('.'), name.size())));
}

}  // namespace

bool is_ply(Format format) {
  return format == Format::ply_ascii || format == Format::ply_little || format == Format::ply_big;
}

Format format_for(Format input, std::string_view wanted, std::string_view name) {
  if (wanted == "ply") return Format::ply_little;
  if (wanted == "ply-ascii") return Format::ply_ascii;
  if (wanted == "ply-be") return Format::ply_big;
  const std::string extension = wanted.empty() ? extension_of(name) : '.' + std::string(wanted);
  if (extension == ".off") return Format::off;
  if (extension == ".obj") return Format::obj;
  if (extension == ".glb") return Format::glb;
  if (extension == ".vtp") return Format::vtp;
  if (extension == ".3mf") return Format::three_mf;
  if (extension == ".xyz") return Format::xyz;
  const bool is_text_stl = input == Format::stl_ascii;
  if (extension == ".stl") return is_text_stl ? Format::stl_ascii : Format::stl_binary;
  if (extension == ".ply") return is_ply(input) ? input : Format::ply_little;
  return is_ply(input) || input == Format::off ? input : Format::ply_little;
}

const std::vector<std::string>& written_endings() {
  static const std::vector<std::string> endings{".ply", ".off", ".obj", ".stl",
                                                ".glb", ".vtp", ".3mf", ".xyz"};
  return endings;
}

std::string unknown_ending(std::string_view name, const std::vector<std::string>& known) {
  // Length of the longest extension, with its dot. If the text after a dot is longer, it counts as
  // part of the name.
  constexpr std::size_t longest = 5;
  const std::string_view file = name.substr(name.rfind('/') + 1);
  const std::string ending = extension_of(file);
  const bool is_ending =
      ending.size() > 1 && ending.size() <= longest && ending.size() < file.size();
  const bool is_known = std::find(known.begin(), known.end(), ending) != known.end();
  const bool has_letter =
      std::any_of(ending.begin(), ending.end(), [](char c) { return c >= 'a' && c <= 'z'; });
  return is_ending && has_letter && !is_known ? ending : "";
}

std::size_t set_format(Document& document, Format format, std::optional<Scalar> coordinate) {
  Style& style = document.style;
  // Store the unit in a comment. Without it, readers would assume meters, the unit of glTF,
  // although coordinates of STL are in millimeters by convention.
  if (const Unit* unit = unit_of(document); unit != nullptr && format == Format::glb)
    set_unit(document, *unit);
  style.format = format;
  if (holds_floats(format)) coordinate = Scalar::float32;
  if (!coordinate && !is_ply(format)) coordinate = Scalar::float64;
  const Scalar before = std::exchange(style.coordinate, coordinate.value_or(style.coordinate));
  return before == style.coordinate ? 0 : round_positions(document.mesh, style.coordinate);
}

bool holds_floats(Format format) {
  return format == Format::stl_ascii || format == Format::stl_binary || format == Format::glb;
}

bool is_text(Format format) {
  return format == Format::ply_ascii || format == Format::off || format == Format::obj ||
         format == Format::stl_ascii || format == Format::xyz;
}

}  // namespace transformesh
