#include "picture/colormap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "transformesh/errors.h"

namespace transformesh {
namespace {

using Stop = std::array<int, 3>;  // sRGB bytes

constexpr std::array<Stop, 18> viridis{{{68, 1, 84},
                                        {72, 23, 105},
                                        {71, 42, 122},
                                        {67, 61, 132},
                                        {61, 78, 138},
                                        {53, 94, 141},
                                        {46, 109, 142},
                                        {41, 123, 142},
                                        {35, 137, 142},
                                        {31, 151, 139},
                                        {33, 165, 133},
                                        {46, 179, 124},
                                        {70, 192, 111},
                                        {101, 203, 94},
                                        {137, 213, 72},
                                        {176, 221, 47},
                                        {216, 226, 25},
                                        {253, 231, 37}}};

constexpr std::array<Stop, 11> blue_to_red{{{5, 48, 97},
                                            {33, 102, 172},
                                            {67, 147, 195},
                                            {146, 197, 222},
                                            {209, 229, 240},
                                            {247, 247, 247},
                                            {253, 219, 199},
                                            {244, 165, 130},
                                            {214, 96, 77},
                                            {178, 24, 43},
                                            {103, 0, 31}}};

constexpr std::size_t intervals = 1020;  // a multiple of the number of intervals in both tables
const Color not_finite = color_of_srgb(0.5, 0.5, 0.5);

/// Returns linear colors at equidistant positions of the table.
template <std::size_t Stops>
std::vector<Color> make_table(const std::array<Stop, Stops>& stops) {
  std::vector<Color> table;
  for (std::size_t i = 0; i <= intervals; ++i) {
    const double place = static_cast<double>(i * (Stops - 1)) / intervals;
    const std::size_t before = std::min(static_cast<std::size_t>(place), Stops - 2);
    const double share = place - static_cast<double>(before);
    const auto channel = [&](std::size_t c) {
      return ((1 - share) * stops[before][c] + share * stops[before + 1][c]) / 255;
    };
    table.push_back(color_of_srgb(channel(0), channel(1), channel(2)));
  }
  return table;
}

/// Returns the position of a value between `low` and `high`, in [0, 1]. Values are halved to avoid
/// overflow.
double place_between(double low, double high, double value) {
  const double extent = high / 2 - low / 2;
  if (!(extent > 0)) return 0.5;
  return std::clamp((value / 2 - low / 2) / extent, 0.0, 1.0);
}

/// Returns the names of number columns, for messages.
std::string names_of(std::span<const Mesh* const> meshes, Columns Mesh::*columns) {
  std::vector<std::string> names;
  for (const Mesh* mesh : meshes)
    for (const Column& column : (mesh->*columns).columns)
      if (is_number_column(&column) && std::ranges::find(names, column.name) == names.end())
        names.push_back(column.name);
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text.empty() ? "none" : text;
}

}  // namespace

Color ColorScale::at(double value) const {
  static const std::vector<Color> sequential = make_table(viridis);
  static const std::vector<Color> diverging = make_table(blue_to_red);
  if (!std::isfinite(value)) return not_finite;
  const double farthest = std::max(-low, high);
  const double place =
      is_diverging() ? place_between(-farthest, farthest, value) : place_between(low, high, value);
  const auto entry = static_cast<std::size_t>(std::floor(place * intervals + 0.5));
  return (is_diverging() ? diverging : sequential)[entry];
}

const Column* number_column_of_faces(const Mesh& mesh, const std::string& name) {
  const Column* column = mesh.face_columns.find(name);
  return is_number_column(column) ? column : nullptr;
}

const Column* number_column_of_vertices(const Mesh& mesh, const std::string& name) {
  if (number_column_of_faces(mesh, name) != nullptr) return nullptr;
  const Column* column = mesh.vertex_columns.find(name);
  return is_number_column(column) ? column : nullptr;
}

ColorScale scale_of_column(std::span<const Mesh* const> meshes, const std::string& name) {
  ColorScale scale{HUGE_VAL, -HUGE_VAL};
  bool is_there = false;
  for (const Mesh* mesh : meshes) {
    const Column* column = number_column_of_faces(*mesh, name);
    if (column == nullptr) column = number_column_of_vertices(*mesh, name);
    if (column == nullptr) continue;
    is_there = true;
    for (const double value : column->values) {
      if (!std::isfinite(value)) continue;
      scale.low = std::min(scale.low, value);
      scale.high = std::max(scale.high, value);
    }
  }
  if (!is_there)
    throw UsageError("neither faces nor vertices have a property '" + name +
                     "' of numbers to color by; faces have " +
                     names_of(meshes, &Mesh::face_columns) + ", vertices " +
                     names_of(meshes, &Mesh::vertex_columns));
  return scale.low <= scale.high ? scale : ColorScale();
}

}  // namespace transformesh
