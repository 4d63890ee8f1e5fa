#include "picture/change_picture.h"

#include <algorithm>
#include <array>

#include "picture/picture.h"

namespace transformesh {
namespace {

// Red and green of about the same lightness stand out from gray and from each other.
constexpr std::array<double, 3> gray{190, 195, 200}, red{224, 50, 40}, green{40, 160, 70};

/// Returns the mesh with face colors instead of its columns: `mark` for marked faces, gray for
/// others.
Mesh colored(const Mesh& mesh, const std::vector<char>& is_marked,
             const std::array<double, 3>& mark) {
  Mesh surface;
  surface.positions = mesh.positions;
  surface.faces = mesh.faces;
  const std::array names{"red", "green", "blue"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    Column& channel = surface.face_columns.get(names[i], Scalar::uint8, mesh.faces.size());
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
      channel.values[f] = is_marked[f] ? mark[i] : gray[i];
  }
  return surface;
}

}  // namespace

Image draw_change(const Mesh& before, const Mesh& after, const ChangePictureOptions& options,
                  const Progress& progress) {
  const Mesh left = colored(before, options.is_lost, red);
  const Mesh right = colored(after, options.is_new, green);
  const std::array<const Mesh*, 2> meshes{&left, &right};
  PictureOptions row;
  row.width = options.width;
  row.height = options.height / 2;
  row.framing = Framing::place;
  Image picture = draw_picture(meshes, row, progress);
  row.orbit.azimuth_deg += 180;
  const Image behind = draw_picture(meshes, row, progress);
  picture.pixels.insert(picture.pixels.end(), behind.pixels.begin(), behind.pixels.end());
  picture.height += behind.height;
  return picture;
}

}  // namespace transformesh
