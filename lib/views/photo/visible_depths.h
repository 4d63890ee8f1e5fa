/// Depths of the surface in a rectangle of a view. Outside of the rectangle nothing is visible.
#pragma once

#include "raster/rasterize.h"
#include "views/images/packable_image.h"

namespace transformesh {

class VisibleDepths {
 public:
  VisibleDepths() = default;
  /// `depths` covers `box` and a frame of one pixel around it, which is 0.
  VisibleDepths(PackableImage depths, const PixelBox& box)
      : depths_(std::move(depths)), left_(box.first_column - 1), top_(box.first_row - 1) {}

  /// Returns the depth of a pixel; 0 if it shows no face.
  float at(int x, int y) const {
    const int column = x - left_;
    const int row = y - top_;
    const bool is_in = column >= 0 && row >= 0 && column < depths_.width && row < depths_.height;
    return is_in ? depths_.at(column, row) : 0;
  }
  /// Returns the depths with fast access: itself, or unpacked in `room` if the depths are packed.
  const VisibleDepths& opened(VisibleDepths& room) const {
    if (&depths_.opened(room.depths_) == &depths_) return *this;
    room.left_ = left_;
    room.top_ = top_;
    return room;
  }
  /// Returns the largest depth of the four pixels from (x, y) to (x + 1, y + 1). Requires opened().
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
  /// Returns the depths of the rectangle and of the frame around it; `room` is used if the depths
  /// are packed.
  const GrayImage& framed(GrayImage& room) const { return depths_.unpacked(room); }
  std::size_t size() const { return depths_.size(); }

 private:
  PackableImage depths_;
  int left_ = 0, top_ = 0;
};

}  // namespace transformesh
