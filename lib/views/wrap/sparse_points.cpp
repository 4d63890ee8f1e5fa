#include "views/wrap/sparse_points.h"

#include <filesystem>

#include "io/streams/file_list.h"
#include "io/streams/source.h"
#include "views/cameras/camera_place.h"
#include "views/wrap/colmap_points.h"
#include "views/wrap/doubtful_points.h"

namespace transformesh {

std::vector<Vec3> sparse_points_beside(const std::string& cameras) {
  namespace fs = std::filesystem;
  const std::string folder =
      is_folder(cameras) ? folder_with_cameras(cameras) : fs::path(cameras).parent_path().string();
  const std::string extension = colmap_extension(folder, cameras);
  const std::string path = (fs::path(folder) / ("points3D" + extension)).string();
  if (extension.empty() || !is_file(path)) return {};
  const std::string bytes = file_bytes(path);
  const std::optional<Mesh> points = read_colmap_points({bytes, path});
  if (!points) return {};
  std::vector<bool> is_doubtful(points->positions.size(), false);
  for (const Index i : with_large_error(reprojection_errors(points->vertex_columns)))
    is_doubtful[i] = true;
  for (const Index i : with_short_track(track_lengths(points->vertex_columns)))
    is_doubtful[i] = true;
  std::vector<Vec3> kept;
  for (std::size_t i = 0; i < points->positions.size(); ++i)
    if (!is_doubtful[i]) kept.push_back(points->positions[i]);
  return kept;
}

}  // namespace transformesh
