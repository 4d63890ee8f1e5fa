#include "picture/shade.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>

#include "picture/corner_normals.h"
#include "picture/lights.h"
#include "picture/ribbons.h"
#include "picture/soft_shadow.h"
#include "raster/camera.h"
#include "support/parallel.h"

namespace transformesh {
namespace {

constexpr int most_samples = 1 << 17;  ///< limit of samples per thread; one row may exceed it
constexpr int most_rows = 8;  ///< limit of the pixel rows in a band, so that all threads have work
/// Half the width of mesh edges in pixels; the adjacent face draws the other half.
constexpr double line_half_width = 0.45;
constexpr float line_strength = 0.65F;      ///< opacity of mesh edges; chosen by hand, not measured
constexpr double segment_width = 2;         ///< width of drawn segments in pixels
constexpr float light_in_the_dark = 0.15F;  ///< brightness at openness 0
constexpr float floor_darkness = 0.45F;     ///< darkening of the background if the lamp is hidden
const Color segment_color = color_of_srgb(0.85, 0.05, 0.45);
const Color line_color = color_of_srgb(0.10, 0.12, 0.16);

class Shader {
 public:
  Shader(const Mesh& mesh, const Camera& samples, const ShadeOptions& options)
      : mesh_(mesh),
        camera_(samples),
        options_(options),
        color_(mesh, options.color),
        lights_(samples, options.upright),
        eye_(samples.center()),
        openness_(options.openness.empty() ? nullptr : mesh.vertex_columns.find(options.openness)),
        normals_(corner_normals(mesh, options.crease_angle_deg)),
        shadow_(options.soft_shadow ? std::optional<SoftShadow>({mesh, lights_.towards_key()})
                                    : std::nullopt),
        rays_(samples.projection.leftCols<3>().inverse()),
        rows_(rows_per_band(samples, options)),
        lined_(with_segments(mesh, samples, options)),
        seen_(options.segments.empty() ? mesh : lined_, samples, rows_ * options.samples) {}

  std::size_t bands() const { return seen_.bands(); }

  /// Draws bands [first, last) of the image, whose upper left corner is at (left, above). Allocates
  /// samples of one band only.
  void draw(std::size_t first, std::size_t last, Image& image, int left, int above) const {
    const int width = camera_.width / options_.samples;
    const int height = camera_.height / options_.samples;
    const FaceBuffer nothing(camera_.width, rows_ * options_.samples);
    FaceBuffer samples;
    for (std::size_t band = first; band < last; ++band) {
      samples = nothing;
      seen_.draw(band, samples.row(0));
      const int top = static_cast<int>(band) * rows_;
      for (int y = top; y < std::min(top + rows_, height); ++y)
        for (int x = 0; x < width; ++x) image.at(left + x, above + y) = pixel(samples, x, y, top);
    }
  }

 private:
  /// Returns the mean of the samples of a pixel, in the band that begins at row `top`.
  Pixel pixel(const FaceBuffer& samples, int x, int y, int top) const {
    const int n = options_.samples;
    Color sum = Color::Zero();
    int hits = 0;
    KeyLight key;
    for (int j = y * n; j < (y + 1) * n; ++j)
      for (int i = x * n; i < (x + 1) * n; ++i) {
        const FacePixel& hit = samples.at(i, j - top * n);
        if (hit.face == no_index) continue;
        sum += sample(hit, i, j, key).cwiseMin(1.0F);
        ++hits;
      }
    const bool has_floor = hits < n * n && shadow_ && options_.floor;
    return blended(sum, hits, n * n, y, has_floor ? darkness_of_floor(x, y) : 0);
  }

  static int rows_per_band(const Camera& samples, const ShadeOptions& options) {
    return std::clamp(most_samples / (samples.width * options.samples), 1, most_rows);
  }

  /// Returns the mesh with faces for segments appended; an empty mesh if there are no segments.
  static Mesh with_segments(const Mesh& mesh, const Camera& samples, const ShadeOptions& options) {
    if (options.segments.empty()) return {};
    Mesh lined{mesh.positions, mesh.faces, {}, {}};
    add_ribbons(options.segments, samples, segment_width * options.samples, lined);
    return lined;
  }

  /// Blends the samples with the background. The fraction `dark` of the background is darkened.
  Pixel blended(const Color& sum, int hits, int samples, int y, float dark) const {
    const Background& background = options_.background;
    if (background.is_transparent) {
      const float covered = static_cast<float>(hits) + static_cast<float>(samples - hits) * dark;
      if (covered == 0) return {0, 0, 0, 0};
      const auto alpha =
          static_cast<std::uint8_t>(std::lround(255 * covered / static_cast<float>(samples)));
      return pixel_of(sum / covered, alpha);
    }
    const Color behind = (1 - dark) * background.at(y, camera_.height / options_.samples);
    const Color all = sum + static_cast<float>(samples - hits) * behind;
    return pixel_of(all / static_cast<float>(samples));
  }

  /// Cached fraction of the key light that reaches a face, for the next samples of the same pixel.
  struct KeyLight {
    Index face = no_index;
    float share = 1;
  };

  Color sample(const FacePixel& hit, int x, int y, KeyLight& key) const {
    if (hit.face >= mesh_.faces.size()) return segment_color;
    const Face& face = mesh_.faces[hit.face];
    const Vec3& a = mesh_.positions[face[0]];
    const Vec3& b = mesh_.positions[face[1]];
    const Vec3& c = mesh_.positions[face[2]];
    const Vec3 to_eye = eye_ - (c + hit.weight[0] * (a - c) + hit.weight[1] * (b - c));
    const bool is_front = (b - a).cross(c - a).dot(eye_ - a) > 0;

    const CornerNormals& corners = normals_[hit.face];
    const float rest = 1 - hit.weight[0] - hit.weight[1];
    const Eigen::Vector3f normal =
        (hit.weight[0] * corners[0] + hit.weight[1] * corners[1] + rest * corners[2]).normalized();
    Color lit = lights_.reflected(color_.at(hit, is_front), is_front ? normal : -normal,
                                  to_eye.normalized().cast<float>(), key_share(hit, is_front, key));
    if (openness_ != nullptr && is_front) lit *= dimming(face, hit);
    if (!options_.draw_edges || !is_on_line(face, x, y)) return lit;
    return lit + line_strength * (line_color - lit);
  }

  /// Returns the fraction of the key light that reaches the face. Computed once for consecutive
  /// samples of a face in a pixel.
  float key_share(const FacePixel& hit, bool is_front, KeyLight& key) const {
    if (!shadow_ || key.face == hit.face) return key.share;
    const Face& face = mesh_.faces[hit.face];
    const std::array corners{mesh_.positions[face[0]], mesh_.positions[face[1]],
                             mesh_.positions[face[2]]};
    const double side = is_front ? 1 : -1;
    std::array<Vec3, 3> normals;
    for (std::size_t i = 0; i < 3; ++i) normals[i] = side * normals_[hit.face][i].cast<double>();
    const Vec3 flat = side * (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    const Vec3 place = round_place(corners, normals, hit.weight[0], hit.weight[1]);
    key = {hit.face, shadow_->share_seen(place, flat.stableNormalized())};
    return key.share;
  }

  /// Returns 0 if the pixel does not show the floor.
  float darkness_of_floor(int x, int y) const {
    const double middle = (options_.samples - 1) / 2.0;
    const Vec3 ray = rays_ * Vec3(x * options_.samples + middle, y * options_.samples + middle, 1);
    const double down = -ray.dot(options_.upright);
    const double height = eye_.dot(options_.upright) - *options_.floor;
    if (!(height > 0 && down > 0)) return 0;
    const Vec3 place = eye_ + height / down * ray;
    return floor_darkness * (1 - shadow_->share_seen(place, options_.upright));
  }

  float dimming(const Face& face, const FacePixel& hit) const {
    const auto at = [&](std::size_t i) { return static_cast<float>(openness_->values[face[i]]); };
    const float rest = 1 - hit.weight[0] - hit.weight[1];
    const float open = hit.weight[0] * at(0) + hit.weight[1] * at(1) + rest * at(2);
    return light_in_the_dark + (1 - light_in_the_dark) * open;
  }

  /// True if the sample is close to an edge of its face, measured in the image.
  bool is_on_line(const Face& face, int x, int y) const {
    const EdgeFunctions functions = edge_functions(camera_.project(mesh_.positions[face[0]]),
                                                   camera_.project(mesh_.positions[face[1]]),
                                                   camera_.project(mesh_.positions[face[2]]));
    const double width = line_half_width * options_.samples;
    return std::any_of(functions.edge.begin(), functions.edge.end(), [&](const Vec3& edge) {
      return edge.dot(Vec3(x, y, 1)) < width * edge.head<2>().norm();
    });
  }

  const Mesh& mesh_;
  const Camera& camera_;
  const ShadeOptions& options_;
  const SurfaceColor color_;
  const Lights lights_;
  const Vec3 eye_;
  const Column* openness_;
  const std::vector<CornerNormals> normals_;
  const std::optional<SoftShadow> shadow_;
  const Eigen::Matrix3d rays_;  ///< maps pixels to directions away from the camera
  const int rows_;              ///< rows of pixels per band
  const Mesh lined_;
  const BandRasterizer seen_;
};

}  // namespace

void shade(const Mesh& mesh, const Camera& camera, const ShadeOptions& options, int left, int above,
           Image& image) {
  const Camera samples = camera.resampled(options.samples);
  const Shader shader(mesh, samples, options);
  parallel_for(shader.bands(), 1, [&](std::size_t first, std::size_t last) {
    shader.draw(first, last, image, left, above);
  });
}

Image shade(const Mesh& mesh, const Camera& camera, const ShadeOptions& options) {
  Image image(camera.width, camera.height);
  shade(mesh, camera, options, 0, 0, image);
  return image;
}

}  // namespace transformesh
