// Tests inputs alone, without a process, a terminal or other parts of a run.
#include "frame/inputs.h"

#include <doctest/doctest.h>

#include "helpers/shapes.h"
#include "helpers/temporary_folder.h"
#include "transformesh/errors.h"

using namespace transformesh;
using namespace transformesh::tool;

namespace {

struct Place {
  test::TemporaryFolder folder;
  Terminal terminal{"tm-x"};
  Program program{"tm-x", "[INPUT]...", "Tests", {Reads::meshes}};
  Messages messages{program, terminal};
  Phases phases;

  std::string write(const std::string& name, const Mesh& mesh) const {
    Document document;
    document.mesh = mesh;
    const std::string path = folder / name;
    test::make_file(path, write_mesh(document).bytes);
    return path;
  }
};

/// A tetrahedron whose faces share no vertices.
Mesh soup() {
  const Mesh closed = test::tetrahedron();
  Mesh mesh;
  for (const Face& face : closed.faces) {
    const auto v = static_cast<Index>(mesh.positions.size());
    for (const Index corner : face) mesh.positions.push_back(closed.positions[corner]);
    mesh.faces.push_back({v, v + 1, v + 2});
  }
  return mesh;
}

}  // namespace

TEST_CASE("all meshes named are read and counted, and lengths refer to the first one") {
  Place place;
  place.program.inputs = {place.write("a.ply", test::cuboid(Vec3::Zero(), {3, 4, 0.0})),
                          place.write("b.ply", test::cube())};
  Inputs inputs(place.program, place.messages, place.phases);
  CHECK(inputs.counts().empty());
  inputs.read_all();
  inputs.refer_to_mesh();
  CHECK(inputs.documents().size() == 2);
  CHECK(std::get<std::size_t>(inputs.counts()[0].second) == 16);
  CHECK(inputs.length({.1, Length::Unit::diagonal}) == doctest::Approx(.5));
  CHECK(!inputs.used_reference_edge());
  inputs.set_basis(100);
  CHECK(inputs.length({.1, Length::Unit::diagonal}) == doctest::Approx(10));
}

TEST_CASE("the reference edge is used once a length refers to it") {
  Place place;
  place.program.inputs = {place.write("a.ply", test::icosphere(0))};
  Inputs inputs(place.program, place.messages, place.phases);
  inputs.read_all();
  inputs.refer_to_mesh();
  const double edge = inputs.length({2, Length::Unit::reference_edge}) / 2;
  REQUIRE(inputs.used_reference_edge());
  CHECK(*inputs.used_reference_edge() == edge);
  // An icosahedron in the unit sphere.
  CHECK(edge == doctest::Approx(1 / std::sin(2 * std::numbers::pi / 5)));
}

TEST_CASE("a soup is joined where the program says so, and kept elsewhere") {
  Place place;
  place.program.inputs = {place.write("soup.ply", soup())};
  place.program.common.quiet = true;
  place.terminal.configure(true, false, false, false);
  for (const bool joins : {false, true}) {
    if (joins) place.program.input.soups = Soups::joined;
    Inputs inputs(place.program, place.messages, place.phases);
    inputs.read_all();
    CHECK(inputs.document().mesh.positions.size() == (joins ? 4 : 12));
    CHECK(inputs.joined_vertices() == (joins ? 8 : 0));
  }
}

TEST_CASE("stdin cannot be read twice") {
  Place place;
  Inputs inputs(place.program, place.messages, place.phases);
  try {
    inputs.read_bytes("-");
  } catch (const Error&) {
    // The test may run without a standard input.
  }
  CHECK_THROWS_AS(inputs.read_bytes("-"), UsageError);
}
