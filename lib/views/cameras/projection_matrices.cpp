#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "raster/camera.h"
#include "transformesh/errors.h"
#include "views/cameras/camera_formats.h"

namespace transformesh {
namespace {

/// Skew below this fraction of the focal length is set to 0, because it results from rounding
/// numbers to 12 digits.
constexpr double no_skew = 1e-11;

/// Decomposes a projection, whose scale and sign are arbitrary, into K [R | t] with K33 = 1,
/// positive focal lengths and det R = 1. Computes the RQ decomposition by Gram-Schmidt
/// orthogonalization, beginning with the last row.
PinholeCamera decomposed(Projection projection) {
  const double sign = projection.leftCols<3>().determinant() < 0 ? -1 : 1;
  projection *= sign / projection.row(2).head<3>().norm();
  const Vec3 m1 = projection.row(0).head<3>();
  const Vec3 m2 = projection.row(1).head<3>();
  const Vec3 r3 = Vec3(projection.row(2).head<3>()).normalized();
  const Vec3 r1 = m2.cross(r3).normalized();
  const Vec3 r2 = r3.cross(r1);

  PinholeCamera camera;
  camera.rotation << r1.transpose(), r2.transpose(), r3.transpose();
  camera.intrinsics << m1.dot(r1), m1.dot(r2), m1.dot(r3), 0, m2.dot(r2), m2.dot(r3), 0, 0, 1;
  if (std::abs(camera.intrinsics(0, 1)) <= no_skew * camera.intrinsics(0, 0))
    camera.intrinsics(0, 1) = 0;
  camera.translation = camera.intrinsics.inverse() * projection.col(3);
  return camera;
}

/// True if the left three columns are singular in double precision.
bool is_singular(const Projection& projection) {
  const Eigen::Matrix3d left = projection.leftCols<3>();
  const double size = left.row(0).norm() * left.row(1).norm() * left.row(2).norm();
  return !(std::abs(left.determinant()) > 1e-12 * size);
}

/// Returns the text of a comment without surrounding blanks. It is the name of the matrix that
/// follows.
std::string name_in(std::string_view comment) {
  constexpr std::string_view blanks = " \t\r\v\f";
  const std::size_t first = std::min(comment.find_first_not_of(blanks), comment.size());
  comment.remove_prefix(first);
  return std::string(comment.substr(0, comment.find_last_not_of(blanks) + 1));
}

/// Reads twelve numbers in one row, or in three rows of four.
Projection read_projection(TextRows& rows, const std::string& who) {
  const std::size_t row_size = rows.words_left() == 12 ? 12 : 4;
  Projection projection;
  for (std::size_t i = 0; i < 12; ++i) {
    if (i > 0 && i % row_size == 0) {
      rows.end_row([&] { return "a row of " + who; });
      if (!rows.next_row()) rows.fail(who + " ends after " + std::to_string(i) + " of 12 numbers");
    }
    projection(static_cast<Eigen::Index>(i / 4), static_cast<Eigen::Index>(i % 4)) =
        rows.finite_number<double>(
            [&] { return "number " + std::to_string(i + 1) + " of " + who; });
  }
  rows.end_row([&] { return "a row of " + who; });
  return projection;
}

}  // namespace

std::string decompose(const Projection& projection, const std::string& who, PinholeCamera& camera) {
  if (!projection.allFinite() || is_singular(projection)) {
    return who + " is singular: it is not a camera matrix";
  }
  camera = decomposed(projection);
  const std::string problem = intrinsics_problem(camera.intrinsics, who);
  return problem.empty() ? translation_problem(camera.translation, who) : problem;
}

CameraList read_matrices(const Source& source, const std::string& stem) {
  TextRows rows(source, 0, rules_with_comments);
  CameraList list;
  while (rows.next_row()) {
    // Skip the word CONTOUR with which files of Furukawa's data sets begin.
    if (rows.peek() == "CONTOUR" && list.cameras.empty()) {
      rows.skip_row();
      continue;
    }
    CameraRecord record;
    record.place = place_of(rows, source);
    const std::string number = std::to_string(list.cameras.size() + 1);
    if (!rows.comments.empty()) record.name = name_in(rows.comments.back());
    if (record.name.empty()) record.name = (stem + '-').append(number);
    rows.comments.clear();
    const std::string who = "matrix " + number;
    const Projection projection = read_projection(rows, who);
    const std::string problem = decompose(projection, who, record.camera);
    if (!problem.empty()) rows.fail(problem);
    list.cameras.push_back(std::move(record));
  }
  if (list.cameras.empty()) rows.fail("there is no camera in the file");
  // A single matrix is named after its file. A comment before it is a title.
  if (list.cameras.size() == 1) list.cameras[0].name = stem;
  return list;
}

std::string write_matrix(const CameraRecord& record) {
  const Projection projection = record.camera.projection();
  PinholeCamera again;
  const std::string problem =
      decompose(projection, "the matrix of " + in_quotes(record.name), again);
  if (!problem.empty()) throw InputError(problem + " (" + record.place + ")");
  TextBuffer text;
  for (int i = 0; i < 12; ++i) {
    text.add_number(projection(i / 4, i % 4));
    text.add(i % 4 == 3 ? '\n' : ' ');
  }
  return text.take();
}

}  // namespace transformesh
