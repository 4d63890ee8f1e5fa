#include "io/length_basis.h"

#include <doctest/doctest.h>

#include "transformesh/errors.h"

using namespace transformesh;

namespace {

// One right triangle with legs 3 and 4: diagonal 5, mean edge 4.
Document triangle(std::vector<std::string> comments = {}) {
  Document document;
  document.mesh.positions = {{0, 0, 0}, {3, 0, 0}, {0, 4, 0}};
  document.mesh.faces = {{0, 1, 2}};
  document.style.comments = std::move(comments);
  return document;
}

double reference_edge(const Document& document, const std::string& choice) {
  LengthBasis basis(choice);
  basis.set_document(&document);
  return basis.reference_edge();
}

}  // namespace

TEST_CASE("lengths resolve by their unit") {
  const Document document = triangle();
  LengthBasis basis("");
  basis.set_document(&document);
  CHECK(basis.resolve(parse_length("0.02")) == 0.02);
  CHECK(basis.resolve(parse_length("10%")) == doctest::Approx(0.5));
  CHECK_FALSE(basis.has_reference_edge());
  CHECK(basis.resolve(parse_length("0.5x")) == doctest::Approx(2));
  CHECK(basis.has_reference_edge());
  basis.set_diagonal(100);
  CHECK(basis.resolve(parse_length("10%")) == doctest::Approx(10));
}

TEST_CASE("the reference edge is inherited, measured anew, or set") {
  const Document evolved = triangle({"tm:reference-edge 8"});
  CHECK(reference_edge(triangle(), "") == 4);
  CHECK(reference_edge(evolved, "") == 8);
  CHECK(reference_edge(evolved, "auto") == 4);
  CHECK(reference_edge(evolved, "0.25") == 0.25);
  CHECK(reference_edge(evolved, "20%") == doctest::Approx(1));
  CHECK(reference_edge(evolved, "0.5x") == 4);
}

TEST_CASE("the reference edge stays what it was when the mesh changes") {
  Document document = triangle();
  LengthBasis basis("");
  basis.set_document(&document);
  CHECK(basis.reference_edge() == 4);
  document.mesh.positions[1] *= 10;
  CHECK(basis.reference_edge() == 4);
}

TEST_CASE("a relative length without a basis is refused") {
  LengthBasis nothing("");
  CHECK(nothing.resolve(parse_length("3")) == 3);
  CHECK_THROWS_AS(nothing.resolve(parse_length("1%")), UsageError);
  CHECK_THROWS_AS(nothing.resolve(parse_length("1x")), UsageError);
  Document points = triangle();
  points.mesh.faces.clear();
  CHECK_THROWS_AS(reference_edge(points, ""), InputError);
}
