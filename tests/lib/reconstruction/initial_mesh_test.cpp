#include "reconstruction/initial_mesh.h"

#include <doctest/doctest.h>

#include "helpers/photographed.h"
#include "helpers/shapes.h"
#include "transformesh/errors.h"
#include "transformesh/measure.h"

using namespace transformesh;

TEST_CASE("a pixel at the object is the distance / focal length") {
  const CameraRing ring = test::small_ring();
  const std::vector<View> views = test::photographed(test::icosphere(3));
  CHECK(pixel_size(views) == doctest::Approx(ring.distance / ring.focal_length).epsilon(.05));
}

TEST_CASE("the hull of masks encloses the object, and is little larger") {
  const Mesh ball = test::icosphere(3);
  std::vector<View> views = test::photographed(ball);
  const Mesh hull = hull_of(views, {}, std::nullopt);
  CHECK(volume(hull) > volume(ball) * .97);
  CHECK(volume(hull) < volume(ball) * 1.3);
}

TEST_CASE("outlines are the silhouettes of the mesh, and a view without one is named") {
  const Mesh ball = test::icosphere(3);
  std::vector<View> views = test::photographed(ball);
  const std::vector<View> masks = views;
  outline(views, ball);
  for (std::size_t i = 0; i < views.size(); ++i) {
    int different = 0, inside = 0;
    for (int y = 0; y < 72; ++y)
      for (int x = 0; x < 96; ++x) {
        const bool is_in = views[i].silhouette.at(x, y) > 127;
        inside += is_in ? 1 : 0;
        different += is_in != (masks[i].silhouette.at(x, y) > 127) ? 1 : 0;
      }
    CHECK(inside > 2000);
    CHECK(different < inside / 50);
  }
  try {
    outline(views, test::moved(ball, {100, 0, 0}));
    FAIL("nothing is in view");
  } catch (const InputError& error) {
    CHECK(error.problem().sentence.find(views[0].name) != std::string::npos);
  }
}

TEST_CASE("only the part of a given mesh inside the hull stays") {
  const Mesh ball = test::icosphere(3);
  std::vector<View> views = test::photographed(ball);
  Document document;
  document.mesh = test::joined(test::scaled(ball, 1.5), test::moved(ball, {30, 0, 0}));
  InitialMeshOptions options;
  options.is_given = true;
  make_initial_mesh(document, views, options, pixel_size(views));
  const Box box = bounding_box(document.mesh);
  CHECK(box.max().x() < 1.4);
  CHECK(volume(document.mesh) < volume(ball) * 1.3);
  document.mesh = test::moved(ball, {30, 0, 0});
  CHECK_THROWS_AS(make_initial_mesh(document, views, options, pixel_size(views)), GoalError);
}

TEST_CASE("a given mesh that fits the masks to a pixel is not shaved by their hull") {
  const Mesh ball = test::icosphere(4);
  std::vector<View> views = test::photographed(ball);
  InitialMeshOptions options;
  options.is_given = true;
  for (const double size : {1.0, 1.1}) {
    Document document;
    document.mesh = test::scaled(ball, size);
    const InitialMesh made = make_initial_mesh(document, views, options, pixel_size(views));
    CHECK((document.mesh.faces.size() == ball.faces.size()) == (size == 1));
    CHECK(made.unclipped.has_value() == (size > 1));
    if (made.unclipped) CHECK(made.unclipped->mesh.faces.size() == ball.faces.size());
  }
}
