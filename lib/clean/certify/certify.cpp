#include "clean/certify/certify.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "clean/certify/certify_faces.h"
#include "clean/certify/certify_samples.h"
#include "geometry/numbers/predicates.h"
#include "geometry/search/closest_point.h"
#include "geometry/solid_angle_winding.h"
#include "mesh/location_text.h"
#include "support/number.h"
#include "support/parallel.h"
#include "transformesh/errors.h"
#include "transformesh/length.h"
#include "transformesh/measure.h"

namespace transformesh {
namespace {

/// Number of sampled faces per uncut patch (connected faces without intersections). `other_samples`
/// is the number of sampled unchanged faces of the output, and also that of removed faces of the
/// input. Choices: more samples detect smaller errors and take more time.
constexpr std::size_t samples_per_patch = 4;
constexpr std::size_t other_samples = 2000;
/// Limit on the number of solid angles summed per mesh. The sums take 0.2 s on one core.
constexpr std::size_t most_solid_angles = 20'000'000;

/// A face, and the side on which a sample is taken: 1 is the front, -1 the back.
struct FaceSide {
  bool is_of_input = false;
  Index face = no_index;
  int side = 1;
};

/// Input and output, scaled such that products of coordinates neither overflow nor underflow.
struct Meshes {
  Mesh input, output;
  /// Length 1 of the scaled meshes, in units of the original coordinates; a power of two.
  double unit = 1;
};

struct Judgement {
  FaceSide face_side;
  std::optional<WindingSample> sample;
  bool is_wrong = false;
};

void add_sides(bool is_of_input, const std::vector<Index>& faces, std::vector<FaceSide>& sides) {
  for (const Index face : faces)
    for (const int side : {1, -1}) sides.push_back({is_of_input, face, side});
}

/// Returns at most `count` faces, up to `samples_per_patch` of each patch. The first faces of all
/// patches are taken before second faces of patches.
std::vector<Index> faces_of_patches(const UncutPatches& patches, std::size_t count) {
  std::vector<Index> firsts;
  std::vector<Index> others;
  for (const std::vector<Index>& patch : patches.faces) {
    const std::vector<Index> chosen = spread(patch, samples_per_patch);
    firsts.push_back(chosen.front());
    others.insert(others.end(), chosen.begin() + 1, chosen.end());
  }
  std::vector<Index> result = spread(firsts, count);
  const std::vector<Index> rest = spread(others, count - result.size());
  result.insert(result.end(), rest.begin(), rest.end());
  return result;
}

std::vector<FaceSide> choose_sides(const Mesh& input, const FaceMatch& match,
                                   const CertifyOptions& options, const Progress& progress) {
  const UncutPatches patches = find_uncut_patches(input, progress);
  const std::size_t count = options.most_faces;
  std::vector<FaceSide> sides;
  add_sides(false, spread(marked_faces(match.output_is_new, 1), count), sides);
  add_sides(true, faces_of_patches(patches, count), sides);
  add_sides(true, spread(marked_faces(patches.is_cut, 1), count), sides);
  add_sides(false, spread(marked_faces(match.output_is_new, 0), other_samples), sides);
  add_sides(true, spread(marked_faces(match.input_vanished, 1), other_samples), sides);

  // A face without area has no sides to sample.
  std::vector<char> has_no_area(input.faces.size(), 0);
  for (const Index face : degenerate_faces(input)) has_no_area[face] = 1;
  std::erase_if(sides,
                [&](const FaceSide& s) { return s.is_of_input && has_no_area[s.face] != 0; });
  return sides;
}

std::string describe(const Judgement& judgement, int winding_level, double unit) {
  const WindingSample& sample = *judgement.sample;
  const bool is_inside = sample.input_winding >= winding_level;
  return std::string(judgement.face_side.side > 0 ? "in front of" : "behind") + " face " +
         std::to_string(judgement.face_side.face) +
         (judgement.face_side.is_of_input ? " of the input" : "") + ", at " +
         point_text(unit * sample.point) + ", the winding number is " +
         std::to_string(sample.output_winding) + " and should be " + (is_inside ? "1" : "0") +
         ": that of the input is " + std::to_string(sample.input_winding);
}

std::string percent(double share) { return shortest_text(std::round(1000 * share) / 10) + " %"; }

/// Reports as a problem that too many samples are undecided, if no other problem was found.
/// Undecided samples certify nothing.
void finish(Certificate& certificate) {
  if (!certificate.problem.empty() || certificate.undecided_share() <= most_undecided) return;
  certificate.problem = std::to_string(certificate.undecided) + " of " +
                        std::to_string(certificate.samples + certificate.undecided) + " samples (" +
                        percent(certificate.undecided_share()) + ") are undecided, more than " +
                        percent(most_undecided) +
                        ": the faces are too small or too close for their coordinates";
}

std::vector<Judgement> judge(const Meshes& meshes, const FaceMatch& match,
                             const CertifyOptions& options, const Progress& progress,
                             Certificate& certificate) {
  const Mesh& input = meshes.input;
  const Mesh& output = meshes.output;
  const std::vector<FaceSide> sides = choose_sides(input, match, options, progress);
  progress("sample");
  const SampleFinder finder(input, output, match, options.coordinate);
  certificate.margin = meshes.unit * finder.zone().largest_margin();
  std::vector<Judgement> judgements(sides.size());
  parallel_for(sides.size(), 16, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const FaceSide& face_side = sides[i];
      const Mesh& mesh = face_side.is_of_input ? input : output;
      const auto sample = finder.find(mesh, face_side.face, face_side.side);
      const auto is_wrong = [&] {
        return sample->output_winding != (sample->input_winding >= options.winding_level ? 1 : 0);
      };
      judgements[i] = {face_side, sample, sample && is_wrong()};
    }
  });
  return judgements;
}

/// Compares the winding numbers at some samples with sums of solid angles. If a sum differs, and
/// its rounding error is small enough to decide, the sample counts as wrong.
void compare_with_solid_angles(const Mesh& mesh, int WindingSample::*number,
                               std::vector<Judgement>& judgements) {
  const std::size_t faces = std::max<std::size_t>(1, mesh.faces.size());
  const std::size_t affordable = std::max<std::size_t>(1, most_solid_angles / faces);
  std::vector<std::size_t> chosen;
  std::vector<Vec3> points;
  const std::size_t stride = judgements.size() / affordable + 1;
  for (std::size_t i = 0; i < judgements.size(); i += stride) {
    if (!judgements[i].sample) continue;
    chosen.push_back(i);
    points.push_back(judgements[i].sample->point);
  }
  const std::vector<BoundedWindingNumber> windings = SolidAngleWinding(mesh)(points);
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    Judgement& judgement = judgements[chosen[i]];
    if (!windings[i].is_decided() || windings[i].rounded() == (*judgement.sample).*number) continue;
    (*judgement.sample).*number = windings[i].rounded();
    judgement.is_wrong = true;
  }
}

void certify_winding(const Meshes& meshes, const FaceMatch& match, const CertifyOptions& options,
                     const Progress& progress, Certificate& certificate) {
  std::vector<Judgement> judgements = judge(meshes, match, options, progress, certificate);
  compare_with_solid_angles(meshes.input, &WindingSample::input_winding, judgements);
  compare_with_solid_angles(meshes.output, &WindingSample::output_winding, judgements);
  for (const Judgement& judgement : judgements) {
    ++(judgement.sample ? certificate.samples : certificate.undecided);
    if (!judgement.is_wrong) continue;
    if (certificate.wrong++ == 0)
      certificate.problem = describe(judgement, options.winding_level, meshes.unit);
  }
}

/// True if the piece has the orientation of the face, or is so thin that moving its corners by the
/// margins can reverse it. To first order, moving a corner by a vector m changes the dot product of
/// both normals by m . (opposite edge x face normal).
bool has_orientation(const Triangle& piece, const Triangle& face, const Vec3& margins) {
  if (normals_dot(piece, face) > 0) return true;
  const Vec3 normal = (face[1] - face[0]).cross(face[2] - face[0]);
  const double product = normal.dot((piece[1] - piece[0]).cross(piece[2] - piece[0]));
  double change = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 opposite = piece[(i + 2) % 3] - piece[(i + 1) % 3];
    change += opposite.cross(normal).cwiseAbs().dot(margins);
  }
  return -product < change;
}

/// True if there is a face of the input with the orientation of `piece` that contains all corners
/// of `piece`, up to the margins.
bool is_piece(const Triangle& piece, const Mesh& input, const Bvh& bvh, const Vec3& margins) {
  bool is_found = false;
  bvh.visit_overlaps(float_box(piece[0] - margins, piece[0] + margins), [&](Index face) {
    const Triangle t = triangle_of(input, face);
    const auto is_on = [&](const Vec3& corner) { return is_within(margins, corner, t); };
    is_found = std::all_of(piece.begin(), piece.end(), is_on) && has_orientation(piece, t, margins);
    return !is_found;
  });
  return is_found;
}

void certify_pieces(const Meshes& meshes, const FaceMatch& match, const CertifyOptions& options,
                    Certificate& certificate) {
  const Mesh& input = meshes.input;
  const Mesh& output = meshes.output;
  const std::vector<Index> faces = spread(marked_faces(match.output_is_new, 1), options.most_faces);
  const std::vector<Vec3> margins = rounding_margins(input, output, faces, options.coordinate);
  const Bvh bvh(input);
  std::vector<char> is_right(faces.size());
  parallel_for(faces.size(), 64, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
      is_right[i] = is_piece(triangle_of(output, faces[i]), input, bvh, margins[i]) ? 1 : 0;
  });
  certificate.samples = faces.size();
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (is_right[i] || certificate.wrong++ > 0) continue;
    certificate.problem = "face " + std::to_string(faces[i]) + ", at " +
                          point_text(meshes.unit * triangle_of(output, faces[i])[0]) +
                          ", is not part of an input face of the same orientation";
  }
}

Mesh scaled(Mesh mesh, double scale) {
  for (Vec3& position : mesh.positions) position *= scale;
  return mesh;
}

Meshes scale_near_1(const Mesh& input, const Mesh& output) {
  const Box box = bounding_box(input);
  const double largest = box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).maxCoeff();
  const int exponent = largest > 0 ? std::clamp(std::ilogb(largest), -1000, 1000) : 0;
  const double scale = std::ldexp(1.0, -exponent);
  return {scaled(input, scale), scaled(output, scale), std::ldexp(1.0, exponent)};
}

}  // namespace

double Certificate::undecided_share() const {
  const std::size_t all = samples + undecided;
  return all == 0 ? 0 : static_cast<double>(undecided) / static_cast<double>(all);
}

Certificate certify(const Mesh& input, const Mesh& output, const CertifyOptions& options,
                    const Progress& progress) {
  if (input.faces.empty()) throw InputError("the input to certify against has no faces");
  progress("match");
  const Meshes meshes = scale_near_1(input, output);
  const FaceMatch match = match_faces(meshes.input, meshes.output);
  Certificate certificate;
  certificate.input_is_closed = match.input_is_closed;
  if (match.input_is_closed) {
    certify_winding(meshes, match, options, progress, certificate);
  } else {
    certify_pieces(meshes, match, options, certificate);
  }
  finish(certificate);
  return certificate;
}

}  // namespace transformesh
