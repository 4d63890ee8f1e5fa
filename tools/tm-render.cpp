/// tm-render: a picture of meshes without a display.
#include <algorithm>
#include <tuple>

#include "film.h"
#include "frame/run.h"
#include "tm/io/segments.h"
#include "tm/picture/picture.h"
#include "tm/picture/png.h"
#include "tm/picture/spelling.h"

namespace {

using namespace transformesh;

/// Options as they are written; the rest are in `picture`.
struct Options {
  std::string size = "800x600";
  std::string orbit = "30,20";
  std::string up = "y";
  std::string frame = "each";
  std::string around;
  std::string color;
  std::string background = "#f7f7f7,#d6d9de";
  std::string segments;
  std::vector<double> range;
  long columns = 0;
  int frames = 0;
  PictureOptions picture;
};

void declare(tool::Program& program, Options& options) {
  PictureOptions& picture = options.picture;
  program.text("size", &options.size, "WxH", "pixels of the picture");
  program.text("orbit", &options.orbit, "AZIMUTH,ELEVATION",
               "where the eye is, in degrees: moved to its right and upwards from the front");
  program.choice("up", &options.up, {"x", "y", "z"}, "the axis that points up");
  program.number("zoom", &picture.orbit.zoom, 0.001, 1000, "2 shows everything twice as large");
  program.choice("frame", &options.frame, {"each", "scale", "place"},
                 "what fills a panel: its mesh, the scale of the largest, the box of all meshes");
  program.text("around", &options.around, "FILE", "frame FILE's mesh in every panel instead");
  program.integer("views", &picture.views, 1, 1000,
                  "draw each mesh so many times, seen from all around in equal steps");
  program.integer("frames", &options.frames, 0, 10000,
                  "write a film of so many pictures, in which the eye goes around once; 0: none");
  program.integer("columns", &options.columns, 0, 10000,
                  "panels in a row; 0 is all, with --views what fits best");
  program.text("color", &options.color, "COLOR",
               "of the surface, as #rrggbb; without it the properties red, green and blue");
  program.text("color-by", &picture.shade.color.by, "PROPERTY",
               "color by the numbers of this property of faces or vertices, with a legend");
  program.numbers("range", &options.range, "LOW,HIGH",
                  "of --color-by: the numbers at the ends of the colors (default: the ends of the "
                  "finite values)");
  program.text("highlight", &picture.shade.color.highlight, "PROPERTY",
               "orange where this property of faces or vertices is not zero");
  program.text("segments", &options.segments, "FILE",
               "draw the edges of a PLY over the meshes, as tm-intersect --segments writes");
  program.text("background", &options.background, "COLOR",
               "#rrggbb, two as TOP,BOTTOM, or transparent");
  program.number("crease-angle", &picture.shade.crease_angle_deg, 0, 180,
                 "degrees beyond which a bend is drawn as a sharp edge; 0 draws flat faces");
  program.flag("edges", &picture.shade.draw_edges, "draw the edges of the faces");
}

void render(const Options& options, tool::Run& run) {
  PictureOptions picture = options.picture;
  std::tie(picture.width, picture.height) = parse_size(options.size);
  std::tie(picture.orbit.azimuth_deg, picture.orbit.elevation_deg) = parse_orbit(options.orbit);
  picture.orbit.up = options.up == "x" ? Axis::x : options.up == "y" ? Axis::y : Axis::z;
  if (options.frame == "scale") picture.framing = Framing::scale;
  if (options.frame == "place") picture.framing = Framing::place;
  picture.columns = static_cast<int>(options.columns);
  if (!options.color.empty()) picture.shade.color.front = parse_color(options.color);
  if (!options.range.empty()) picture.range = {options.range[0], options.range[1]};
  picture.shade.background = parse_background(options.background);
  picture.frames = std::max(options.frames, 1);
  tool::check_film(options.frames, picture.width, picture.height,
                   picture.shade.background.is_transparent, run);

  const Mesh around = options.around.empty() ? Mesh{} : run.read(options.around).mesh;
  if (!options.around.empty()) picture.around = &around;
  if (!options.segments.empty())
    picture.shade.segments = segments_of(run.read(options.segments), options.segments);
  std::vector<const Mesh*> meshes;
  for (const Document& document : run.documents()) meshes.push_back(&document.mesh);
  run.report("meshes", meshes.size());
  const auto draw = [&](int frame, const Progress& progress) {
    picture.frame = frame;
    return write_png(draw_picture(meshes, picture, progress));
  };
  if (options.frames == 0) return run.write_output(draw(0, run.progress()));
  tool::write_frames(
      options.frames, [&](int frame) { return draw(frame, {}); }, run);
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  tool::Program program{"tm-render", "[OPTION]... [INPUT]...", "Draws meshes as a PNG picture",
                        tool::Reads::meshes, tool::Writes::picture};
  declare(program, options);
  program.picture_endings = {".png", ".mp4", ".gif"};
  program.epilog = "Before and after: tm-clean a.ply | tm-render --frame place a.ply - > both.png";
  return program.run(argc, argv, [&](tool::Run& run) { render(options, run); });
}
