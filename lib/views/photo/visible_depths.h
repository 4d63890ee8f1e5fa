/// Depths of a surface at the pixels of a view. They are stored for the rectangle outside of which
/// the surface is not visible.
#pragma once

#include "raster/rasterize.h"
#include "views/images/packable_image.h"

namespace transformesh {

class VisibleDepths {
 public:
  VisibleDepths() = default;
  /// `depths` has the depths in `box` and a frame of one pixel around them, in which depths are 0.
  VisibleDepths(PackableImage depths, const PixelBox& box)
      : depths_(std::move(depths)), left_(box.first_column - 1), top_(box.first_row - 1) {}

  /// Returns the depth at pixel (x, y); 0 if the pixel shows no face.
  float at(int x, int y) const {
    const int column = x - left_;
    const int row = y - top_;
    const bool is_in = column >= 0 && row >= 0 && column < depths_.width && row < depths_.height;
    return is_in ? depths_.at(column, row) : 0;
  }
  /// Returns an object with the same depths and fast access to single pixels. This is usually the
  /// object itself. If its depths are compressed in tiles, decompresses them to `room` and returns
  /// `room`.
  const VisibleDepths& opened(VisibleDepths& room) const {
    if (&depths_.opened(room.depths_) == &depths_) return *this;
    room.left_ = left_;
    room.top_ = top_;
    return room;
  }
  /// Returns the largest depth of the four pixels from (x, y) to (x + 1, y + 1). This object must
  /// be the result of opened().
  float reach(int x, int y) const {
    const int column = x - left_;
    const int row = y - top_;
    const bool is_in =
        column >= 0 && row >= 0 && column + 1 < depths_.width && row + 1 < depths_.height;
    return is_in ? depths_.largest_of_four(column, row) : 0;
  }
  /// Returns the rectangle outside of which all depths are 0.
  PixelBox box() const {
    return {left_ + 1, left_ + depths_.width - 1, top_ + 1, top_ + depths_.height - 1};
  }
  /// Returns the depths of the rectangle and of the frame of one pixel around it. If the depths are
  /// packed, unpacks them to `room`.
  const GrayImage& framed(GrayImage& room) const { return depths_.unpacked(room); }
  std::size_t size() const { return depths_.size(); }

 private:
  PackableImage depths_;
  int left_ = 0, top_ = 0;
};

}  // namespace transformesh
