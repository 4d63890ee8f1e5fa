/// The options of tm-transform.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "frame/run.h"
#include "transformesh/transform.h"

namespace transformesh::tool {

struct TransformChoices {
  std::vector<double> translate, rotate, scale, scales, mirror, matrix;
  /// Unit of the input, default: as the mesh states; unit of the output, default: no conversion.
  std::string from, to;
  bool center = false, unit_box = false;
  /// Transformations in the order of the command line. Each function returns the matrix of its
  /// transformation. Its second parameter is the product of the matrices of earlier
  /// transformations.
  std::vector<std::function<Matrix4(Run&, const Matrix4&)>> steps;
};

/// Declares the options. The program keeps references to the choices.
void declare_transforms(Program& program, TransformChoices& choices);

}  // namespace transformesh::tool
