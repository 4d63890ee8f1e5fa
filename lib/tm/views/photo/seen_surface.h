/// The surface as one view sees it, with what a comparison of photographs needs per pixel.
#pragma once

#include "tm/picture/rasterize.h"
#include "tm/views/cameras/view.h"

namespace transformesh {

/// Images are of the view's size, 0 where there is nothing.
struct SeenSurface {
  FaceBuffer faces;
  /// Depth of the pixels that are compared, which see the outside of a face, and not too flatly
  /// along it.
  GrayImage depth;
  /// 1 / (r N) of these, r the pixel's PinholeCamera::ray and N the unit normal of the face: < 0.
  GrayImage inverse_facing;
  /// At (x, y) the largest depth of any face at (x, y), (x+1, y), (x, y+1), (x+1, y+1): a point
  /// that lands between these pixels is hidden where it is clearly behind that.
  GrayImage reach;
  /// The box of the compared pixels; the ends are excluded.
  int first_column = 0, end_column = 0;
  int first_row = 0, end_row = 0;
};

std::vector<Eigen::Vector3f> face_unit_normals(const Mesh& mesh);

/// `normals` are face_unit_normals. `least_cosine` is that of the angle between ray and normal
/// below which a face is seen too flatly; >= 0. Backs of faces hide nothing. In parallel over
/// views; the same for any number of threads.
std::vector<SeenSurface> see_surface(const Mesh& mesh, std::span<const Eigen::Vector3f> normals,
                                     std::span<const View> views, double least_cosine);

}  // namespace transformesh
