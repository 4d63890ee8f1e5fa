#include "views/cameras/camera_formats.h"

namespace transformesh {
namespace {

void require_next_row(TextRows& rows, const std::string& what) {
  if (!rows.next_row()) rows.fail("the file ends before " + what);
}

Vec3 read_vector(TextRows& rows, const std::string& what) {
  require_next_row(rows, what);
  Vec3 vector;
  for (int i = 0; i < 3; ++i) {
    vector[i] = rows.finite_number<double>(
        [&] { return "number " + std::to_string(i + 1) + " of " + what; });
  }
  rows.end_row([&] { return what; });
  return vector;
}

/// Reads one camera. Converts its coordinates from Bundler's convention (looks along -z, y up) to
/// ours (looks along z, y down).
CameraRecord read_bundler_camera(TextRows& rows, const Source& source, std::size_t number) {
  CameraRecord record;
  record.name = "camera" + std::to_string(number);
  const std::string who = "camera " + std::to_string(number);
  const Vec3 lens = read_vector(rows, "focal length, k1 and k2 of " + who);
  record.place = place_of(rows, source);
  if (lens.x() == 0)
    rows.fail(who + " has focal length 0, because Bundler could not place it: leave it out");
  record.camera.intrinsics = Vec3(lens.x(), lens.x(), 1).asDiagonal();
  check_intrinsics(rows, record.camera.intrinsics, who);
  // Radial distortion does not change if y is reversed.
  record.distortion.radial[0] = lens.y();
  record.distortion.radial[1] = lens.z();
  const Vec3 turned(1, -1, -1);
  for (int i = 0; i < 3; ++i) {
    const Vec3 row = read_vector(rows, "row " + std::to_string(i + 1) + " of R of " + who);
    record.camera.rotation.row(i) = turned[i] * row.transpose();
  }
  check_rotation(rows, record.camera.rotation, who);
  record.camera.translation = turned.cwiseProduct(read_vector(rows, "t of " + who));
  check_translation(rows, record.camera.translation, who);
  record.is_centered = true;
  return record;
}

}  // namespace

CameraList read_bundler(const Source& source) {
  TextRows rows(source, 0, rules_without_comments);
  require_next_row(rows, "its first line");
  const std::string_view title = rows.skip_row();
  if (!title.ends_with("v0.3")) {
    rows.fail("only Bundler files of version 0.3 are read, not " + in_quotes(title));
  }
  require_next_row(rows, "the numbers of cameras and points");
  const auto count = rows.number<std::size_t>([] { return std::string("the number of cameras"); });
  rows.number<std::size_t>([] { return std::string("the number of points"); });
  rows.end_row([] { return std::string("the line of counts"); });
  if (count == 0) rows.fail("there is no camera in the file");

  CameraList list;
  for (std::size_t i = 0; i < count; ++i)
    list.cameras.push_back(read_bundler_camera(rows, source, i));
  return list;
}

}  // namespace transformesh
