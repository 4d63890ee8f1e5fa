#include "tm/io/formats/polygons.h"

#include <algorithm>
#include <numeric>
#include <unordered_map>

#include "tm/io/streams/source.h"
#include "tm/mesh/surface_columns.h"
#include "tm/support/counted.h"
#include "tm/support/error.h"

namespace transformesh {
namespace {

bool has_repeats(std::span<const Index> corners) {
  std::vector<Index> sorted(corners.begin(), corners.end());
  std::sort(sorted.begin(), sorted.end());
  return std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
}

}  // namespace

void PolygonFans::add(std::span<const Index> corners) {
  if (corners.size() == 3) return add(Face{corners[0], corners[1], corners[2]});
  remember_sources();
  if (corners.size() < 3) {
    ++dropped_;
  } else {
    ++polygons_;
    has_repeats(corners) ? add_loops(corners) : add_fan(corners);
  }
  ++rows_;
}

void PolygonFans::add_fan(std::span<const Index> corners) {
  for (std::size_t i = 2; i < corners.size(); ++i) {
    faces_.push_back({corners[0], corners[i - 1], corners[i]});
    source_.push_back(rows_);
    ++polygon_faces_;
  }
}

// What lies between two visits of a corner is a loop of its own. Loops of one or two corners, which
// repeats and spikes are, bound nothing.
void PolygonFans::add_loops(std::span<const Index> corners) {
  ++repeating_;
  std::vector<Index> path;
  std::unordered_map<Index, std::size_t> places;  // of the corners in the path
  for (const Index corner : corners) {
    const auto [place, is_new] = places.emplace(corner, path.size());
    if (!is_new) {
      const std::size_t first = place->second;
      add_fan(std::span(path).subspan(first));
      for (std::size_t i = first + 1; i < path.size(); ++i) places.erase(path[i]);
      path.resize(first);
    }
    path.push_back(corner);
  }
  add_fan(path);
}

void PolygonFans::move_into(Mesh& mesh, const std::string& format,
                            std::vector<std::string>& notes) {
  if (faces_.size() >= no_index / 3) {
    throw InputError(format + ": more triangles than 32 bits can count");
  }
  mesh.faces = std::move(faces_);
  if (!remembers_sources_) return;
  mesh.face_columns = mesh.face_columns.select(source_);
  split_corner_lists(mesh.face_columns, source_);
  if (polygons_ > 0) {
    notes.push_back(format + ": " + counted(polygons_, "polygon") + " cut into " +
                    counted(polygon_faces_, "triangle"));
  }
  if (repeating_ > 0) {
    notes.push_back(format + ": " + counted(repeating_, "polygon") +
                    " cut into loops where a corner is visited again");
  }
  if (dropped_ > 0) {
    notes.push_back(format + ": " + counted(dropped_, "face") +
                    " with fewer than three corners dropped");
  }
}

void PolygonFans::remember_sources() {
  if (remembers_sources_) return;
  remembers_sources_ = true;
  source_.resize(rows_);
  std::iota(source_.begin(), source_.end(), 0U);
}

}  // namespace transformesh
