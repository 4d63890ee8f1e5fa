// The cameras_sphere.npz of IDR and NeuS: matrices world_mat_N of 4x4 numbers, from the world to
// pixels. The matrices scale_mat_N, which map a unit sphere to the world, are not used: cameras are
// in world coordinates. Reference: Yariv, Kasten, Moran, Galun, Atzmon, Basri & Lipman, "Multiview
// neural surface reconstruction by disentangling geometry and appearance", NeurIPS 2020. The manual
// of the program describes the file under "Data convention".
#include "io/streams/zip_archive.h"
#include "views/cameras/camera_formats.h"
#include "views/cameras/npy_array.h"

namespace transformesh {
namespace {

CameraRecord read_world_matrix(const Source& source, const std::string& name) {
  const NpyArray array = read_npy(source);
  if (array.shape != std::vector<std::size_t>{4, 4})
    source.fail(name + " does not have 4x4 numbers");
  const Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>> matrix(array.values.data());
  CameraRecord record;
  record.place = source.name;
  const std::string problem = decompose(matrix.topRows<3>(), name, record.camera);
  if (!problem.empty()) source.fail(problem);
  return record;
}

}  // namespace

CameraList read_neus(const Source& source, const std::string& stem) {
  ExpansionBudget budget(source);
  const ZipReader archive(source, budget);
  CameraList list;
  for (std::size_t i = 0;; ++i) {
    const std::string name = "world_mat_" + std::to_string(i);
    const auto bytes = archive.read(name + ".npy");
    if (!bytes) break;
    const Source entry{*bytes, source.name + ' ' + name};
    CameraRecord record = read_world_matrix(entry, name);
    record.name = std::string(stem).append("-").append(std::to_string(i + 1));
    list.cameras.push_back(std::move(record));
  }
  if (list.cameras.empty())
    source.fail("the archive has no world_mat_0, unlike cameras_sphere.npz");
  return list;
}

}  // namespace transformesh
