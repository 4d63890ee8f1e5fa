#include "tm/clean/intersect/faces_to_search.h"

#include <algorithm>
#include <cmath>

#include "tm/clean/intersect/corner_cells.h"

namespace transformesh {
namespace {

/// In so many cells a face may be on average.
constexpr std::size_t most_cells_each = 16;
constexpr double most_cells_per_axis = 255;
constexpr Index several = no_index - 1;  ///< zones

std::vector<Index> first_copies(const WeldedMesh& welded) {
  std::vector<Index> firsts;
  firsts.reserve(welded.faces.size());
  for (Index f = 0; f < welded.faces.size(); ++f) {
    if (welded.first_copy[f] == f) firsts.push_back(f);
  }
  return firsts;
}

// Per cell, the zone of the faces there. Empty where faces are in too many cells to look at each.
std::vector<Index> find_zones_at(const WeldedMesh& welded, const CornerCells& cells,
                                 std::span<const Index> faces, std::span<const Index> zones) {
  std::size_t left = most_cells_each * faces.size();
  std::vector<Index> zone_at(cells.count(), no_index);
  for (const Index f : faces) {
    const CellRange range = cells.around(welded.faces[f]);
    const std::size_t size = range.size();
    if (size > left) return {};
    left -= size;
    const Index zone = zones[f] == no_index ? several : zones[f];
    cells.for_each(range, [&](std::size_t cell) {
      zone_at[cell] = zone_at[cell] == no_index || zone_at[cell] == zone ? zone : several;
      return true;
    });
  }
  return zone_at;
}

}  // namespace

// There are about as many cells as faces.
std::vector<Index> find_faces_to_search(const WeldedMesh& welded, std::span<const Index> zones) {
  std::vector<Index> firsts = first_copies(welded);
  const auto count = static_cast<std::size_t>(std::count(zones.begin(), zones.end(), no_index));
  if (count > zones.size() / 2) return firsts;
  const double side = std::cbrt(static_cast<double>(firsts.size()));
  const CornerCells cells(welded.points,
                          static_cast<unsigned>(std::clamp(side, 2.0, most_cells_per_axis)));
  if (!cells.is_usable()) return firsts;
  const std::vector<Index> zone_at = find_zones_at(welded, cells, firsts, zones);
  if (zone_at.empty()) return firsts;
  std::erase_if(firsts, [&](Index f) {
    bool is_alone = true;
    cells.for_each(cells.around(welded.faces[f]),
                   [&](std::size_t cell) { return is_alone = zone_at[cell] != several; });
    return is_alone;
  });
  return firsts;
}

}  // namespace transformesh
