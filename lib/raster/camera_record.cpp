#include "raster/camera_record.h"

#include <algorithm>

#include "io/streams/source.h"
#include "transformesh/errors.h"

namespace transformesh {
namespace {

std::string size_text(int width, int height) {
  return std::to_string(width) + " x " + std::to_string(height);
}

}  // namespace

void CameraRecord::set_size(int columns, int rows, const std::string& image) {
  if (width != 0 && (width != columns || height != rows)) {
    throw InputError("the camera of " + in_quotes(name) + " is for an image of " +
                     size_text(width, height) + " pixels, but " + image + " has " +
                     size_text(columns, rows) + " (" + place + ")");
  }
  width = columns;
  height = rows;
  if (unit == IntrinsicsUnit::width) camera.intrinsics.topRows<2>() *= columns;
  if (unit == IntrinsicsUnit::larger_side)
    camera.intrinsics.topRows<2>() *= std::max(columns, rows);
  if (is_centered) camera.intrinsics.col(2).head<2>() += Eigen::Vector2d(columns - 1, rows - 1) / 2;
  is_centered = false;
  unit = IntrinsicsUnit::pixel;
}

}  // namespace transformesh
