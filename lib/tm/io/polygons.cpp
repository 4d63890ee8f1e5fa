#include "tm/io/polygons.h"

#include <numeric>

#include "tm/io/source.h"
#include "tm/support/counted.h"
#include "tm/support/error.h"

namespace transformesh {

void PolygonFans::add(std::span<const Index> corners) {
  if (corners.size() == 3) return add(Face{corners[0], corners[1], corners[2]});
  remember_sources();
  if (corners.size() < 3) {
    ++dropped_;
  } else {
    ++polygons_;
    polygon_faces_ += corners.size() - 2;
  }
  for (std::size_t i = 2; i < corners.size(); ++i) {
    faces_.push_back({corners[0], corners[i - 1], corners[i]});
    source_.push_back(rows_);
  }
  ++rows_;
}

void PolygonFans::move_into(Mesh& mesh, const std::string& format,
                            std::vector<std::string>& notes) {
  if (faces_.size() >= no_index / 3) {
    throw InputError(format + ": more triangles than 32 bits can count");
  }
  mesh.faces = std::move(faces_);
  if (!remembers_sources_) return;
  mesh.face_columns = mesh.face_columns.select(source_);
  if (polygons_ > 0) {
    notes.push_back(format + ": " + counted(polygons_, "polygon") + " cut into " +
                    counted(polygon_faces_, "triangle"));
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
