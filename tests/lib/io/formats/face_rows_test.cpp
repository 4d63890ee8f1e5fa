#include "io/formats/face_rows.h"

#include <doctest/doctest.h>

#include <limits>

using namespace transformesh;

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

const std::vector<Vec3> points{{0, 0, 0}, {2, 0, 0},   {2, 2, 0}, {1, 0.5, 0},
                               {0, 2, 0}, {nan, 0, 0}, {3, 3, 3}};

struct Read {
  Mesh mesh;
  std::vector<std::string> notes;
};

/// Reads rows of corners, with one face column that numbers the rows.
Read read(const std::vector<std::vector<Index>>& rows, std::uint32_t first_number = 0) {
  FaceRows faces;
  Read result;
  result.mesh.positions = points;
  for (const std::vector<Index>& row : rows) faces.add(row);
  Column& label = result.mesh.face_columns.get("label", Scalar::int32, rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) label.values[i] = static_cast<double>(i);
  faces.move_into(result.mesh, "off", result.notes, first_number);
  return result;
}

}  // namespace

TEST_CASE("triangles and polygons become faces in their order, with their columns") {
  const Read result = read({{0, 1, 3}, {0, 1, 2, 4}, {1}, {0, 3, 4}, {0, 1, 2, 3, 4}, {4, 3, 0}});
  CHECK(
      result.mesh.faces ==
      std::vector<Face>{
          {0, 1, 3}, {0, 1, 2}, {0, 2, 4}, {0, 3, 4}, {0, 1, 3}, {0, 3, 4}, {1, 2, 3}, {4, 3, 0}});
  CHECK(result.mesh.face_columns.find("label")->values ==
        std::vector<double>{0, 1, 1, 3, 4, 4, 4, 5});
}

TEST_CASE("vertices that are not finite go with the triangles and polygons that use them") {
  const Read result = read({{0, 1, 5}, {0, 1, 2}, {0, 1, 2, 5}, {6, 2, 1}});
  CHECK(result.mesh.positions.size() == 6);
  CHECK(result.mesh.faces == std::vector<Face>{{0, 1, 2}, {5, 2, 1}});
  CHECK(result.mesh.face_columns.find("label")->values == std::vector<double>{1, 3});
  CHECK(result.notes.back() ==
        "off: 1 vertex with a coordinate that is not finite dropped, and 2 faces that use it");
}

TEST_CASE("notes count triangulated, folded and dropped polygons") {
  const std::vector<std::vector<Index>> rows{{0, 1, 2}, {0, 1, 2, 4}, {0, 2, 1, 4}, {0, 1}};
  Read result = read(rows, 1);
  result.notes.pop_back();
  CHECK(result.notes ==
        std::vector<std::string>{"off: 2 polygons cut into 4 triangles",
                                 "off: 1 polygon cut into triangles that fold over, because the "
                                 "outline intersects itself; the first is face 3",
                                 "off: 1 face with fewer than three corners dropped"});
}
