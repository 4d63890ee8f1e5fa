#include "views/color/color_vertices.h"

#include <doctest/doctest.h>

#include "helpers/shapes.h"
#include "helpers/view_maker.h"
#include "transformesh/errors.h"

using namespace transformesh;

namespace {

using Rgb = std::array<std::uint8_t, 3>;

/// Photographs of one color each, from the ends of the x axis.
std::vector<PictureView> two_views(const Rgb& from_right, const Rgb& from_left) {
  std::vector<PictureView> views;
  for (const bool is_right : {true, false}) {
    const view_maker::Frame frame;
    PictureView view;
    view.name = is_right ? "right" : "left";
    view.camera = view_maker::camera_at({is_right ? 6. : -6., 0, 0}, frame);
    view.width = frame.width;
    view.height = frame.height;
    const Rgb color = is_right ? from_right : from_left;
    view.picture = [frame, color] {
      Image image(frame.width, frame.height);
      for (auto& pixel : image.pixels) pixel = {color[0], color[1], color[2], 255};
      return image;
    };
    views.push_back(std::move(view));
  }
  return views;
}

double value(const Mesh& mesh, const char* name, std::size_t vertex) {
  const Column* column = mesh.vertex_columns.find(name);
  REQUIRE(column != nullptr);
  return column->values[vertex];
}

}  // namespace

TEST_CASE("vertices take the color of the photograph that faces them") {
  Mesh mesh = test::icosphere(4);
  // All photographs are equally bright, so exposure compensation has no effect.
  color_vertices(mesh, two_views({100, 100, 100}, {100, 100, 100}));
  for (const char* name : {"red", "green", "blue"}) {
    CHECK(mesh.vertex_columns.find(name)->type == Scalar::uint8);
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) CHECK(value(mesh, name, v) == 100);
  }
}

TEST_CASE("both sides keep their hue, and hidden vertices take that of their neighbors") {
  Mesh mesh = test::icosphere(4);
  color_vertices(mesh, two_views({120, 60, 60}, {60, 60, 120}));
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    if (mesh.positions[v].x() > .5) CHECK(value(mesh, "red", v) > value(mesh, "blue", v));
    if (mesh.positions[v].x() < -.5) CHECK(value(mesh, "red", v) < value(mesh, "blue", v));
    CHECK(value(mesh, "green", v) > 0);
  }
}

TEST_CASE("a mesh behind all cameras is refused") {
  Mesh mesh = test::moved(test::icosphere(2), {0, 0, 500});
  CHECK_THROWS_AS(color_vertices(mesh, two_views({9, 9, 9}, {9, 9, 9})), InputError);
}
