#include "io/segments.h"

#include <doctest/doctest.h>

#include "transformesh/errors.h"
#include "transformesh/mesh_io.h"

using namespace transformesh;

namespace {

Document read_edges(const std::string& header, const std::string& rows) {
  return read_mesh(
             "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\n"
             "property double z\n" +
                 header + "end_header\n0 0 0\n1 0 0\n0 2 0\n" + rows,
             "a.ply")
      .document;
}

const std::string ends = "property int vertex1\nproperty int vertex2\n";

}  // namespace

TEST_CASE("segments are read in their order") {
  const auto segments = segments_of(read_edges("element edge 2\n" + ends, "0 1\n2 1\n"), "a.ply");
  REQUIRE(segments.size() == 2);
  CHECK(segments[1].first == Vec3(0, 2, 0));
  CHECK(segments[1].second == Vec3(1, 0, 0));
  CHECK(segments_of(read_edges("element edge 0\n" + ends, ""), "a.ply").empty());
}

TEST_CASE("segments that are none are refused in words") {
  CHECK_THROWS_AS(segments_of(read_edges("", ""), "a.ply"), InputError);
  CHECK_THROWS_AS(segments_of(read_edges("element edge 1\nproperty int vertex1\n", "0\n"), "a.ply"),
                  InputError);
  for (const char* row : {"0 3\n", "-1 0\n"})
    CHECK_THROWS_AS(segments_of(read_edges("element edge 1\n" + ends, row), "a.ply"), InputError);
  CHECK_THROWS_WITH(segments_of(read_edges("element edge 1\n" + ends, "0 3\n"), "a.ply"),
                    "a.ply: edge 0 has vertex 3, but there are 3");
}
