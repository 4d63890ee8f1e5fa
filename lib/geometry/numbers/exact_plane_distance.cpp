#include "geometry/numbers/exact_plane_distance.h"

#include <limits>

#include "geometry/numbers/exact_number.h"

namespace transformesh {

double exact_plane_distance(const Vec3& normal, double offset, double length, const Vec3& point) {
  ExactNumber value = -ExactNumber(offset);
  for (int i = 0; i < 3; ++i) value = value + ExactNumber(normal[i]) * ExactNumber(point[i]);
  const int sign = sign_of(value);
  if (sign == 0) return 0;
  const double distance = quotient(value, ExactNumber(length));
  return distance != 0 ? distance : sign * std::numeric_limits<double>::denorm_min();
}

}  // namespace transformesh
