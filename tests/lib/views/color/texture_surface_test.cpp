#include "views/color/texture_surface.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numeric>

#include "helpers/shape_options.h"
#include "helpers/shapes.h"
#include "raster/rasterize.h"
#include "support/parallel.h"
#include "transformesh/control.h"
#include "transformesh/errors.h"
#include "views/cameras/camera_ring.h"
#include "views/cameras/view_files.h"
#include "views/photo/photograph.h"

using namespace transformesh;
using namespace transformesh::test;

namespace {

/// A knot, which hides much of itself.
const Mesh& knot() {
  static const Mesh mesh = make_shape(shape("torus-knot", 6000));
  return mesh;
}

/// Each channel has a texture of its own.
Image color_photograph(const Mesh& mesh, const Camera& camera, double noise) {
  Image picture(camera.width, camera.height, Pixel{0, 0, 0, 255});
  for (std::uint64_t channel = 0; channel < 3; ++channel) {
    const SolidTexture texture({.waves = 15, .finest = 0.1, .coarsest = 1, .seed = channel + 1});
    const Photograph photograph = take_photograph(mesh, camera, texture, channel, {.noise = noise});
    for (std::size_t i = 0; i < picture.pixels.size(); ++i)
      picture.pixels[i][channel] = static_cast<std::uint8_t>(photograph.image.pixels[i]);
  }
  return picture;
}

std::vector<PictureView> photographed(const Mesh& mesh, int count = 12, double noise = 0) {
  CameraRing ring;
  ring.count = count;
  ring.width = 240;
  ring.height = 180;
  ring.focal_length = 800;
  ring.elevations_deg = {50, -20, 10, -60};
  ring.distance = distance_for(mesh.positions, ring);
  std::vector<PictureView> views;
  for (const CameraRecord& record : camera_ring(ring).cameras) {
    const Image picture =
        color_photograph(mesh, {record.camera.projection(), record.width, record.height}, noise);
    views.push_back(
        {record.name, record.camera, record.width, record.height, [picture] { return picture; }});
  }
  return views;
}

/// Returns the bilinear color as viewers compute it: v upwards, centers of texels at halves.
Eigen::Array3d texture_at(const Image& picture, double u, double v) {
  const double x = u * picture.width - 0.5;
  const double y = (1 - v) * picture.height - 0.5;
  const int left = static_cast<int>(std::floor(x));
  const int top = static_cast<int>(std::floor(y));
  Eigen::Array3d sum = Eigen::Array3d::Zero();
  for (const int j : {0, 1})
    for (const int i : {0, 1}) {
      const double weight = std::abs(1 - i - (x - left)) * std::abs(1 - j - (y - top));
      const Pixel& pixel =
          picture.at(std::min(left + i, picture.width - 1), std::min(top + j, picture.height - 1));
      sum += weight * Eigen::Array3d(pixel[0], pixel[1], pixel[2]);
    }
  return sum;
}

/// Returns whether a pixel shows only one part of the surface.
bool is_inner(const FaceBuffer& faces, int x, int y, double step) {
  if (x < 1 || y < 1 || x + 1 >= faces.width || y + 1 >= faces.height) return false;
  for (int j = -1; j <= 1; ++j)
    for (int i = -1; i <= 1; ++i) {
      const FacePixel& other = faces.at(x + i, y + j);
      if (other.face == no_index || std::abs(other.depth - faces.at(x, y).depth) > step)
        return false;
    }
  return true;
}

struct Comparison {
  double mean = 0;  ///< intensities
  std::size_t pixels = 0;
};

/// Compares the photographs with the color that `color` returns for each pixel.
template <class Color>
Comparison compare(const Mesh& mesh, const std::vector<PictureView>& views, const Color& color) {
  Comparison result;
  for (const PictureView& view : views) {
    const FaceBuffer faces = rasterize(mesh, {view.camera.projection(), view.width, view.height});
    const Image picture = view.picture();
    for (int y = 0; y < view.height; ++y) {
      for (int x = 0; x < view.width; ++x) {
        const FacePixel& seen = faces.at(x, y);
        if (!is_inner(faces, x, y, 20 * seen.depth / view.camera.focal_length())) continue;
        const Pixel& pixel = picture.at(x, y);
        result.mean += (color(seen) - Eigen::Array3d(pixel[0], pixel[1], pixel[2])).abs().mean();
        ++result.pixels;
      }
    }
  }
  result.mean /= static_cast<double>(result.pixels);
  return result;
}

Comparison compare_texture(const Mesh& mesh, const Image& picture,
                           const std::vector<PictureView>& views) {
  const Column& column = *mesh.face_columns.find("texcoord");
  return compare(mesh, views, [&](const FacePixel& seen) {
    const double* values = &column.values[column.list_offsets[seen.face]];
    const double a = seen.weight[0];
    const double b = seen.weight[1];
    const double c = 1 - a - b;
    return texture_at(picture, a * values[0] + b * values[2] + c * values[4],
                      a * values[1] + b * values[3] + c * values[5]);
  });
}

}  // namespace

TEST_CASE("a texture agrees with the photographs where they show the surface") {
  Mesh mesh = knot();
  const std::vector<PictureView> views = photographed(mesh);
  const Atlas atlas = texture_surface(mesh, views);
  const Comparison comparison = compare_texture(mesh, atlas.picture, views);
  MESSAGE("mean difference ", comparison.mean, " of ", comparison.pixels, " pixels, texture ",
          atlas.picture.width, "x", atlas.picture.height, ", charts ", atlas.charts, ", unseen ",
          atlas.color.unseen, ", disagreement ", atlas.color.disagreement);
  CHECK(comparison.mean < 5);
  CHECK(comparison.pixels > 40000);
  CHECK(atlas.color.disagreement < 10);
  CHECK(mesh.vertex_columns.find("red") == nullptr);
}

TEST_CASE("vertex colors agree with the photographs, up to the edge length") {
  Mesh mesh = make_shape(shape("torus-knot", 40000));
  const std::vector<PictureView> views = photographed(mesh);
  color_vertices(mesh, views);
  const std::array columns{mesh.vertex_columns.find("red"), mesh.vertex_columns.find("green"),
                           mesh.vertex_columns.find("blue")};
  const Comparison comparison = compare(mesh, views, [&](const FacePixel& seen) {
    const std::array<double, 3> weights{seen.weight[0], seen.weight[1],
                                        1.0 - seen.weight[0] - seen.weight[1]};
    Eigen::Array3d color = Eigen::Array3d::Zero();
    for (std::size_t i = 0; i < 3; ++i)
      for (int channel = 0; channel < 3; ++channel)
        color[channel] +=
            weights[i] *
            columns.at(static_cast<std::size_t>(channel))->values[mesh.faces[seen.face][i]];
    return color;
  });
  MESSAGE("mean difference ", comparison.mean);
  CHECK(comparison.mean < 5);
}

TEST_CASE("an occluder does not color the surface behind it") {
  // In each view, a small black ball hides another part of a white ball.
  Mesh mesh = make_sphere(Vec3::Zero(), 1, 3000);
  const std::size_t white = mesh.positions.size();
  const Mesh small = make_sphere(Vec3(0, 0, 1.5), 0.2, 500);
  for (const auto& [a, b, c] : small.faces)
    mesh.faces.push_back({a + static_cast<Index>(white), b + static_cast<Index>(white),
                          c + static_cast<Index>(white)});
  mesh.positions.insert(mesh.positions.end(), small.positions.begin(), small.positions.end());
  std::vector<PictureView> views = photographed(mesh);
  const auto first_black = make_sphere(Vec3::Zero(), 1, 3000).faces.size();
  for (PictureView& view : views) {
    const FaceBuffer faces = rasterize(mesh, {view.camera.projection(), view.width, view.height});
    Image picture(view.width, view.height, Pixel{128, 128, 128, 255});
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
      if (faces.pixels[i].face == no_index) continue;
      const std::uint8_t intensity = faces.pixels[i].face < first_black ? 250 : 10;
      picture.pixels[i] = {intensity, intensity, intensity, 255};
    }
    view.picture = [picture] { return picture; };
  }
  const ColorResult result = color_vertices(mesh, views);
  const Column& red = *mesh.vertex_columns.find("red");
  for (std::size_t v = 0; v < white; ++v) CHECK(red.values[v] >= 249);
  for (std::size_t v = white; v < mesh.positions.size(); ++v) CHECK(red.values[v] <= 11);
  CHECK(result.disagreement < 1);
}

TEST_CASE("a highlight that moves with the camera is left out") {
  Mesh mesh = make_sphere(Vec3::Zero(), 1, 3000);
  std::vector<PictureView> views = photographed(mesh, 24);
  for (PictureView& view : views) {
    Image picture(view.width, view.height, Pixel{60, 80, 100, 255});
    const Vec3 half = (view.camera.center().normalized() + Vec3(0.2, 0.3, 0.9)).normalized();
    const Vec3 q = view.camera.projection() * half.homogeneous();
    for (int y = 0; y < view.height; ++y)
      for (int x = 0; x < view.width; ++x)
        if (std::hypot(x - q.x() / q.z(), y - q.y() / q.z()) < 7)
          picture.at(x, y) = {255, 255, 255, 255};
    view.picture = [picture] { return picture; };
  }
  color_vertices(mesh, views);
  const Column& red = *mesh.vertex_columns.find("red");
  const auto bright = std::count_if(red.values.begin(), red.values.end(),
                                    [](double intensity) { return intensity > 90; });
  CHECK(static_cast<double>(bright) < 0.01 * static_cast<double>(red.values.size()));
}

TEST_CASE("a texture is the same for any number of threads, and no larger than it may be") {
  const std::vector<PictureView> views = photographed(knot(), 4, 2);
  const AtlasOptions options{.most_size = 256};
  Mesh one = knot();
  Mesh four = knot();
  Atlas first;
  Atlas second;
  {
    const ThreadLimit limit(1);
    first = texture_surface(one, views, options);
  }
  {
    const ThreadLimit limit(4);
    second = texture_surface(four, views, options);
  }
  CHECK(first.picture.pixels == second.picture.pixels);
  CHECK(one.face_columns.find("texcoord")->values == four.face_columns.find("texcoord")->values);
  CHECK(std::max(first.picture.width, first.picture.height) <= 256);
  for (const double value : one.face_columns.find("texcoord")->values) {
    CHECK(value >= 0);
    CHECK(value <= 1);
  }
}

TEST_CASE("a mesh that no view sees, and a texture without room, are refused") {
  Mesh mesh = knot();
  const std::vector<PictureView> views = photographed(mesh, 3);
  CHECK_THROWS_AS(texture_surface(mesh, views, {.most_size = 16}), GoalError);
  CHECK_THROWS_AS(texture_surface(mesh, views, {.most_size = 8}), UsageError);
  Mesh inside_out = knot();
  for (Face& face : inside_out.faces) std::swap(face[0], face[1]);
  CHECK_THROWS_AS(color_vertices(inside_out, views), InputError);
}

TEST_CASE("photographs of other exposures and white balances give the same colors") {
  Mesh mesh = knot();
  std::vector<PictureView> views = photographed(mesh);
  const ColorResult even = color_vertices(mesh, views);
  const auto intensities_of = [](const Mesh& colored) {
    std::array<std::vector<double>, 3> intensities;
    for (std::size_t i = 0; i < 3; ++i)
      intensities[i] = colored.vertex_columns.find(std::array{"red", "green", "blue"}[i])->values;
    return intensities;
  };
  const auto expected = intensities_of(mesh);
  for (std::size_t v = 0; v < views.size(); ++v) {
    const Eigen::Array3d factor =
        Eigen::Array3d(0.8, 0.85, 0.9) + 0.05 * static_cast<double>(v * 5 % 7);
    views[v].picture = [picture = views[v].picture, factor] {
      Image darker = picture();
      for (Pixel& pixel : darker.pixels)
        for (int i = 0; i < 3; ++i)
          pixel[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(
              std::min(factor[i] * pixel[static_cast<std::size_t>(i)] + 0.5, 255.0));
      return darker;
    };
  }
  const ColorResult uneven = color_vertices(mesh, views);
  CHECK(even.largest_gain < 1.02);
  CHECK(uneven.largest_gain > 1.15);
  CHECK(uneven.disagreement < even.disagreement + 0.5);
  // Colors agree up to one factor per channel.
  const auto found = intensities_of(mesh);
  for (std::size_t i = 0; i < 3; ++i) {
    const double by = std::accumulate(found[i].begin(), found[i].end(), 0.0) /
                      std::accumulate(expected[i].begin(), expected[i].end(), 0.0);
    double difference = 0;
    for (std::size_t v = 0; v < found[i].size(); ++v)
      difference += std::abs(found[i][v] - by * expected[i][v]);
    CHECK(difference / static_cast<double>(found[i].size()) < 1.5);
  }
}
