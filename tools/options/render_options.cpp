#include "options/render_options.h"

#include <algorithm>
#include <tuple>

#include "frame/movie.h"
#include "picture/colormap.h"
#include "picture/parse_picture_options.h"
#include "transformesh/errors.h"

namespace transformesh::tool {

void declare_picture(Program& program, RenderOptions& options) {
  PictureOptions& picture = options.picture;
  program.options.text("size", &options.size, "WxH", "width and height of the picture in pixels");
  program.options.text(
      "orbit", &options.orbit, "AZIMUTH,ELEVATION",
      "direction of the camera as seen from the mesh, in degrees; 0,0 is the front, larger angles "
      "move the camera to its right and upwards");
  program.options.named("up", &picture.orbit.up, {{"x", Axis::x}, {"y", Axis::y}, {"z", Axis::z}},
                        "axis that points up");
  program.options.number("zoom", &picture.orbit.zoom, 0.001, 1000,
                         "magnification; 2 shows everything twice as large");
  program.options.named(
      "frame", &picture.framing,
      {{"each", Framing::each}, {"scale", Framing::scale}, {"place", Framing::place}},
      "each: a mesh fills its panel; scale: all meshes have one scale; place: "
      "all panels show the box of all meshes");
  program.options.text("around", &options.around, "FILE",
                       "use the view in which the mesh in FILE fills the panel");
  program.options.integer("views", &picture.views, 1, 1000,
                          "draw each mesh from N directions around it");
  program.options.integer(
      "frames", &options.frames, 0, 10000,
      "write a movie of N pictures, in which the camera moves around the mesh once; 0: none");
  program.options.number("film", &options.film, 0, 86400,
                         "write a movie of this many seconds that shows the meshes one after the "
                         "other, as with --frame place; 0: none");
  program.options.integer(
      "columns", &picture.columns, 0, 10000,
      "number of panels in a row; 0: all, or the best number with --views of one mesh");
  program.options.text(
      "color", &options.color, "COLOR",
      "color of the surface, as #rrggbb (default: the properties red, green and blue)");
  program.options.text("color-by", &picture.shade.color.by, "PROPERTY",
                       "color by the values of this face or vertex property, with a legend");
  program.options.numbers("range", &options.range, "LOW,HIGH",
                          "values at both ends of the colors of --color-by (default: smallest and "
                          "largest finite value)");
  program.options.text("highlight", &picture.shade.color.highlight, "PROPERTY",
                       "draw faces orange if this face or vertex property is not zero");
  program.options.text(
      "segments", &options.segments, "FILE",
      "draw the edges of this PLY file, as tm-intersect --segments writes it, over the meshes");
  program.options.text(
      "background", &options.background, "COLOR",
      "color of the background: #rrggbb, two colors as TOP,BOTTOM, or transparent");
  program.options.number(
      "crease-angle", &picture.shade.crease_angle_deg, 0, 180,
      "angle in degrees above which edges are drawn as sharp creases; 0: draw all faces flat");
  program.options.flag("ambient-occlusion", &options.occlusion,
                       "darken hollows, where less light arrives from all directions");
  program.options.flag("soft-shadow", &picture.shade.soft_shadow,
                       "let the mesh cast a soft shadow on itself and on a floor");
  program.options.flag("edges", &picture.shade.draw_edges, "draw the edges of the faces");
}

PictureOptions picture_of(const RenderOptions& options) {
  PictureOptions picture = options.picture;
  std::tie(picture.width, picture.height) = parse_size(options.size);
  std::tie(picture.orbit.azimuth_deg, picture.orbit.elevation_deg) = parse_orbit(options.orbit);
  picture.frames = std::max(options.frames, 1);
  if (!options.color.empty()) picture.shade.color.front = parse_color(options.color);
  if (!options.range.empty()) picture.range = {options.range[0], options.range[1]};
  picture.shade.background = parse_background(options.background);
  return picture;
}

void check_film(const RenderOptions& options, const Program& program) {
  if (options.frames > 0)
    throw UsageError(
        "--film shows meshes one after the other, and --frames moves around a mesh: give one of "
        "them");
  const Option& frame = *program.options.find("frame");
  if (options.picture.framing != Framing::place && frame.is_given)
    throw UsageError(
        "--film shows the bounding box of all meshes in every picture, as --frame "
        "place does: leave out --frame " +
        frame.text());
}

void hold_still(const std::vector<const Mesh*>& meshes, const Mesh& corners,
                PictureOptions& picture) {
  if (picture.around == nullptr) picture.around = &corners;
  const std::string& property = picture.shade.color.by;
  if (property.empty() || picture.range) return;
  const ColorScale scale = scale_of_column(meshes, property);
  if (scale.low < scale.high) picture.range = {scale.low, scale.high};
}

bool draws_lines(const Run& run) {
  if (ending_of(run.out().name()) != ".svg") return false;
  for (const Option& option : run.program().options)
    for (const char* name : {"color", "color-by", "range", "highlight", "background",
                             "ambient-occlusion", "soft-shadow"})
      if (option.is_given && option.name() == name)
        throw UsageError("--" + option.name() +
                         ": an SVG file can hold only lines: write a .png file instead");
  return true;
}

}  // namespace transformesh::tool
