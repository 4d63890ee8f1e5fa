#include "transformesh/align.h"

#include <cmath>
#include <limits>
#include <string>

#include "mesh/touching_borders.h"
#include "step/registration.h"
#include "transformesh/errors.h"
#include "transformesh/stitch.h"

namespace transformesh {
namespace {

/// Least number of samples. The overlap of the meshes must contain at least 20 % of the samples and
/// at least 20 pairs of points. With 100 samples both limits are the same.
constexpr std::size_t least_samples = 100;

/// Number of short registrations: from the position of the mesh, and from rotations by
/// `start_angle_deg` about each axis in both directions. With a single start, a quarter of
/// registrations of a figure that is rotated by 20 degrees end in a wrong position. The time is
/// proportional to the number of starts.
constexpr int starts = 7;
constexpr double start_angle_deg = 30;
/// Number of samples of a short registration. With 1000 samples, a right position is distinguished
/// from a wrong one in a fifth of the time of the final registration.
constexpr std::size_t samples_of_start = 1000;
constexpr int iterations_of_start = 40;

/// The frame of the registration. Its origin is the center of the reference's bounding box, and its
/// unit is the diagonal of that box.
struct Frame {
  Vec3 center;
  double size;
};

Mesh in_frame(Mesh mesh, const Frame& frame) {
  for (Vec3& point : mesh.positions) point = (point - frame.center) / frame.size;
  return mesh;
}

RigidMotion start_motion(int start, const Vec3& center) {
  RigidMotion motion;
  if (start == 0) return motion;
  const double side = start % 2 == 0 ? 1 : -1;
  motion.rotation =
      rotation_about(side * Vec3::Unit((start - 1) / 2), start_angle_deg).topLeftCorner<3, 3>();
  motion.translation = center - motion.rotation * center;
  return motion;
}

/// Runs a short registration from each start. Returns the motion with the least cost
/// (Overlap::cost).
RigidMotion best_start(const Mesh& mesh, const RegistrationSurface& surface,
                       const Progress& progress) {
  RigidMotion best;
  double least = std::numeric_limits<double>::infinity();
  const Box box = bounding_box(mesh);
  const Vec3 center = box.min() + (box.max() - box.min()) / 2;
  for (int start = 0; start < starts; ++start) {
    Registration registration(surface, oriented_samples(mesh, samples_of_start),
                              start_motion(start, center));
    try {
      registration.run(iterations_of_start, [&](int iteration) {
        progress("start", (start + (iteration - 1.0) / iterations_of_start) / starts);
      });
      const double cost = registration.overlap().cost;
      if (cost >= least) continue;
      least = cost;
      best = registration.motion();
    } catch (const GoalError&) {
      continue;  // If all starts fail, the final registration throws the error again.
    }
  }
  return best;
}

void refuse_empty(const Mesh& mesh, const std::string& name) {
  if (mesh.positions.empty()) throw InputError(name + " has no vertices");
}

/// Throws InputError if the area of the mesh or of the reference is zero or infinite. Both are in
/// the frame of the reference.
void check_areas(const Mesh& mesh, const Mesh& reference) {
  if (!reference.faces.empty() && !(surface_area(reference) > 0))
    throw InputError("the reference has no area");
  if (mesh.faces.empty()) return;
  const double area = surface_area(mesh);
  if (!(area > 0))
    throw InputError("the mesh is too small compared with the reference, or has no area");
  if (!std::isfinite(area)) throw InputError("the mesh is too large compared with the reference");
}

void check(const RegistrationOptions& options) {
  if (options.samples < least_samples)
    throw UsageError("at least " + std::to_string(least_samples) + " samples are needed");
  if (options.iterations < 1) throw UsageError("at least one iteration is needed");
}

Frame frame_of(const Mesh& reference) {
  const Box box = bounding_box(reference);
  const double size = diagonal_of(box);
  if (!(size > 0) || !std::isfinite(size) || !std::isfinite(1 / size))
    throw InputError("the reference has no size that can be measured");
  return {box.min() + (box.max() - box.min()) / 2, size};
}

/// Returns the matrix of a motion in input units.
Matrix4 matrix_of(const RigidMotion& motion, const Frame& frame) {
  Matrix4 matrix = Matrix4::Identity();
  matrix.topLeftCorner<3, 3>() = motion.rotation;
  matrix.topRightCorner<3, 1>() =
      frame.center - motion.rotation * frame.center + frame.size * motion.translation;
  return matrix;
}

void describe(const Registration& registration, const Frame& frame, std::size_t samples,
              RegistrationResult& result) {
  const Overlap overlap = registration.overlap();
  result.has_converged = registration.has_converged();
  result.rms = frame.size * std::sqrt(overlap.mean_square);
  result.overlap = static_cast<double>(overlap.count) / static_cast<double>(samples);
  result.stability = registration.stability();
  result.rotation_deg = angle_deg_of(registration.motion().rotation);
  result.motion = matrix_of(registration.motion(), frame);
}

}  // namespace

RegistrationResult align(Mesh& mesh, const Mesh& reference, const RegistrationOptions& options,
                         const Progress& progress) {
  check(options);
  refuse_empty(mesh, "the mesh");
  refuse_empty(reference, "the reference");
  progress("search tree");
  const Frame frame = frame_of(reference);
  Mesh target = in_frame(reference, frame);
  if (count_touching_borders(target) > 0) stitch(target);
  const Mesh unit = in_frame(mesh, frame);
  check_areas(unit, target);
  const RegistrationSurface surface(target);
  const std::vector<OrientedPoint> samples = oriented_samples(unit, options.samples);
  Registration registration(surface, samples, best_start(unit, surface, progress));

  RegistrationResult result;
  result.iterations = registration.run(options.iterations, [&](int iteration) {
    progress("align", static_cast<double>(iteration - 1) / options.iterations);
  });
  describe(registration, frame, samples.size(), result);
  transform(mesh, result.motion);
  return result;
}

}  // namespace transformesh
