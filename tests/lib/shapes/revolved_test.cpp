#include "shapes/revolved.h"

#include <doctest/doctest.h>

#include <numbers>

#include "transformesh/intersect.h"
#include "transformesh/manifold.h"
#include "transformesh/measure.h"

using namespace transformesh;

TEST_CASE("cylinders and cones of any proportions are closed, oriented and clean") {
  for (const double radius : {0.01, 1.0, 30.0})
    for (const std::size_t faces : {1, 12, 57, 400, 3000}) {
      CAPTURE(radius);
      CAPTURE(faces);
      for (const Mesh& mesh :
           {shapes::cylinder(radius, 2, faces), shapes::cone(radius, 2, faces)}) {
        const ManifoldReport check = check_manifold(mesh);
        CHECK(check.is_closed());
        CHECK(volume(mesh) > 0);
        CHECK(find_intersections(mesh).empty());
        CHECK(bounding_box(mesh).min().z() == -1);
        CHECK(bounding_box(mesh).max().z() == 1);
        for (Index f = 0; f < mesh.faces.size(); ++f) CHECK(face_area(mesh, f) > 0);
      }
    }
}

TEST_CASE("many faces come near the volume of the round solid, and to the number asked for") {
  const double pi = std::numbers::pi;
  const Mesh cylinder = shapes::cylinder(0.5, 2, 20000);
  CHECK(volume(cylinder) == doctest::Approx(pi / 2).epsilon(0.002));
  CHECK(cylinder.faces.size() < 20600);
  CHECK(cylinder.faces.size() > 19400);
  // Slender solids have as many faces as others.
  CHECK(volume(shapes::cylinder(0.1, 5, 5000)) == doctest::Approx(0.05 * pi).epsilon(0.01));
  CHECK(volume(shapes::cone(0.1, 9, 10000)) == doctest::Approx(0.03 * pi).epsilon(0.02));
  CHECK(shapes::cylinder(0.1, 5, 500).faces.size() > 400);
  CHECK(volume(shapes::cone(0.5, 2, 20000)) == doctest::Approx(pi / 6).epsilon(0.002));
}
