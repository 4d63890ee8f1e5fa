/// tm-photograph: renders synthetic photographs of a mesh from given cameras, or from a ring of
/// cameras.
#include <tuple>

#include "frame/run.h"
#include "options/photograph_files.h"
#include "picture/parse_picture_options.h"
#include "support/number.h"
#include "transformesh/errors.h"
#include "transformesh/measure.h"

namespace {

using namespace transformesh;

struct Options {
  tool::PhotographFiles files;
  std::string size = "320x240";
  const tool::Option* size_option = nullptr;
  CameraRing ring;
  double focal = 3.4;
  std::optional<Length> distance;
  Length finest = parse_length("2%");
  Length coarsest = parse_length("20%");
};

void declare(tool::Program& program, Options& options) {
  tool::PhotographFiles& files = options.files;
  program.options.text("cameras", &files.cameras, "WHERE",
                       "file, folder or pattern of the cameras (default: a ring of cameras)");
  options.size_option = &program.options.text(
      "size", &options.size, "WxH",
      "width and height of an image in pixels, if the camera file does not state them");
  program.options.integer("ring", &options.ring.count, 1, 100000,
                          "number of cameras in the ring around the mesh");
  program.options.numbers("elevations", &options.ring.elevations_deg, "DEGREES,DEGREES",
                          "elevations of the ring's cameras above the horizon, which alternate");
  program.options.length("distance", &options.distance,
                         "distance of the ring's cameras from the center of the mesh (default: the "
                         "mesh nearly fills the images)");
  program.options.number("focal", &options.focal, 0.1, 1000,
                         "focal length of the ring's cameras, divided by the width of the image");
  program.options.text("write-images", &files.images, "FOLDER",
                       "write the photographs to this folder, as NAME.png");
  program.options.text("write-silhouettes", &files.silhouettes, "FOLDER",
                       "write masks to this folder, as NAME.png");
  program.options.named("look", &files.is_shaded, {{"texture", false}, {"shade", true}},
                        "show a gray texture without shading, or shade the mesh as tm-render does");
  program.options.length("finest", &options.finest, "shortest wavelength of the texture");
  program.options.length("coarsest", &options.coarsest, "longest wavelength of the texture");
  program.options.integer("waves", &files.texture.waves, 1, 10000,
                          "number of waves that make the texture");
  PhotographOptions& sensor = files.sensor;
  program.options.number("noise", &sensor.noise, 0, 255,
                         "standard deviation of the noise, in intensities from 0 to 255");
  program.options.number(
      "gain", &sensor.gain_spread, 0, 0.99,
      "multiply each photograph by a random gain between 1 - NUMBER and 1 + NUMBER");
  program.options.number("offset", &sensor.offset_spread, 0, 255,
                         "add a random offset between -NUMBER and NUMBER to each photograph");
  program.options.text("compare-silhouettes", &files.masks, "WHERE",
                       "report how well the silhouettes of the mesh agree with these masks");
  program.options.seed(&sensor.seed);
}

// Throws InputError if the mesh is so large or so small that products of lengths in camera matrices
// would overflow or underflow.
void check_size(double diagonal) {
  if (!(diagonal > 0)) throw InputError("the mesh is empty or a single point");
  if (diagonal < 1e-100 || diagonal > 1e100)
    throw InputError("the mesh is " + shortest_text(diagonal) +
                     " across: scale it to a size from 1e-100 to 1e100");
}

void photograph(Options& options, tool::Run& run) {
  const Mesh mesh = run.in().read(run.in().name()).mesh;
  const Box box = bounding_box(mesh);
  check_size(diagonal_of(box));
  run.in().set_basis(diagonal_of(box));
  CameraRing& ring = options.ring;
  std::tie(ring.width, ring.height) = parse_size(options.size);
  ring.focal_length = options.focal * ring.width;
  ring.center = box.min() + (box.max() - box.min()) / 2;
  ring.distance =
      options.distance ? run.length(*options.distance) : distance_for(mesh.positions, ring);
  options.files.texture = {options.files.texture.waves, run.length(options.finest),
                           run.length(options.coarsest), options.files.sensor.seed};
  options.files.size_is_given = options.size_option->is_given;
  run.out().set_bytes(tool::write_photographs(mesh, ring, options.files, run));
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  tool::Program program{"tm-photograph",
                        "[OPTION]... [INPUT]",
                        "Takes photographs of a mesh, and writes their cameras",
                        {tool::Reads::file},
                        {tool::Writes::text}};
  declare(program, options);
  program.example = "tm-photograph --write-images shots mesh.ply > shots.txt";
  return program.run(argc, argv, [&](tool::Run& run) { photograph(options, run); });
}
