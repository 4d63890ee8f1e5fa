#include "raster/middlebury.h"

#include "io/formats/text_rows.h"
#include "io/streams/text_buffer.h"
#include "raster/camera_checks.h"
#include "support/counted.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

constexpr TextRows::Rules rules{'#', false};

Eigen::Matrix3d read_matrix(TextRows& rows, char letter, const std::string& name) {
  Eigen::Matrix3d matrix;
  for (int i = 0; i < 9; ++i) {
    matrix(i / 3, i % 3) = rows.finite_number<double>([&] {
      return std::string{letter, static_cast<char>('1' + i / 3), static_cast<char>('1' + i % 3)} +
             " of " + name;
    });
  }
  return matrix;
}

/// Scales the calibration matrix so that k33 is 1, because its scale is arbitrary. Throws
/// InputError if the matrix is not zero below its diagonal, or if k33 is 0.
void normalize(const TextRows& rows, Eigen::Matrix3d& intrinsics, const std::string& who) {
  const bool is_upper = intrinsics(1, 0) == 0 && intrinsics(2, 0) == 0 && intrinsics(2, 1) == 0;
  if (!is_upper || intrinsics(2, 2) == 0) {
    rows.fail("k21, k31 and k32 of " + who + " must be 0, and k33 must not");
  }
  if (intrinsics(2, 2) != 1) intrinsics /= intrinsics(2, 2);
  check_intrinsics(rows, intrinsics, who);
}

CameraRecord read_camera(TextRows& rows, const Source& source) {
  CameraRecord record;
  record.name = rows.word();
  record.place = place_of(rows, source);
  const std::string who = in_quotes(record.name);
  record.camera.intrinsics = read_matrix(rows, 'k', who);
  record.camera.rotation = read_matrix(rows, 'r', who);
  for (int i = 0; i < 3; ++i) {
    record.camera.translation[i] =
        rows.finite_number<double>([&] { return 't' + std::to_string(i + 1) + " of " + who; });
  }
  rows.end_row([&] { return "the camera of " + who; });
  normalize(rows, record.camera.intrinsics, who);
  check_rotation(rows, record.camera.rotation, who);
  check_translation(rows, record.camera.translation, who);
  return record;
}

std::size_t read_count(TextRows& rows) {
  if (!rows.next_row()) rows.fail("there is no camera in the file");
  if (rows.words_left() != 1) {
    rows.fail("the first line of a Middlebury camera file is the number of cameras, nothing else");
  }
  const auto count = rows.number<std::size_t>([] { return std::string("the number of cameras"); });
  if (count == 0) rows.fail("there is no camera in the file");
  return count;
}

template <class Matrix>
void add_matrix(TextBuffer& text, const Matrix& matrix) {
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) {
      text.add(' ');
      text.add_number(matrix(i, j));
    }
  }
}

}  // namespace

CameraList read_middlebury(const Source& source) {
  TextRows rows(source, 0, rules);
  const std::size_t count = read_count(rows);
  CameraList list;
  list.names_images = true;
  while (rows.next_row()) {
    if (list.cameras.size() == count) {
      rows.fail("the first line announces " + counted(count, "camera") + ", but there are more");
    }
    list.cameras.push_back(read_camera(rows, source));
  }
  if (list.cameras.size() < count) {
    rows.fail("the first line announces " + counted(count, "camera") + ", but there are only " +
              std::to_string(list.cameras.size()));
  }
  return list;
}

std::string write_middlebury(const CameraList& list) {
  TextBuffer text;
  text.add_number(list.cameras.size());
  text.add('\n');
  for (const CameraRecord& record : list.cameras) {
    if (record.name.find_first_of(" \t#") != std::string::npos) {
      throw InputError("a name in a Middlebury camera file must not contain blanks or #: " +
                       in_quotes(record.name) + " (" + record.place + ")");
    }
    check_read_again(record, record.camera);
    text.add(record.name);
    add_matrix(text, record.camera.intrinsics);
    add_matrix(text, record.camera.rotation);
    add_matrix(text, record.camera.translation);
    text.add('\n');
  }
  return text.take();
}

}  // namespace transformesh
