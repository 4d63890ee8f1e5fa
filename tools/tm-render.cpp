/// tm-render: a picture of meshes without a display.
#include "tm/picture/picture.h"
#include "tm/picture/png.h"
#include "tm/picture/spelling.h"
#include "tool.h"

namespace {

using namespace transformesh;

struct Options {
  std::string size = "800x600";
  std::string orbit = "30,20";
  std::string up = "y";
  double zoom = 1;
  std::string frame = "each";
  std::string around;
  long columns = 0;
  std::string color;
  std::string highlight;
  std::string background = "default";
  double crease_angle = 40;
  bool edges = false;
};

PictureOptions resolve(const Options& options) {
  PictureOptions resolved;
  std::tie(resolved.width, resolved.height) = parse_size(options.size);
  std::tie(resolved.orbit.azimuth_deg, resolved.orbit.elevation_deg) = parse_orbit(options.orbit);
  resolved.orbit.up = options.up == "x" ? Axis::x : options.up == "y" ? Axis::y : Axis::z;
  resolved.orbit.zoom = options.zoom;
  resolved.framing = options.frame == "each"    ? Framing::each
                     : options.frame == "scale" ? Framing::scale
                                                : Framing::place;
  resolved.columns = static_cast<int>(options.columns);
  if (!options.color.empty()) resolved.shade.color.front = parse_color(options.color);
  resolved.shade.color.highlight = options.highlight;
  resolved.shade.background = parse_background(options.background);
  resolved.shade.crease_angle_deg = options.crease_angle;
  resolved.shade.draw_edges = options.edges;
  return resolved;
}

std::string render(const std::vector<Document>& documents, const Options& options, tool::Run& run) {
  PictureOptions resolved = resolve(options);
  Mesh around;
  if (!options.around.empty()) {
    around = run.read(options.around).mesh;
    resolved.around = &around;
  }
  std::vector<const Mesh*> meshes;
  for (const Document& document : documents) meshes.push_back(&document.mesh);
  return write_png(picture(meshes, resolved, run.progress()));
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  tool::Program program("tm-render", "[OPTION]... [INPUT]...", "Draws meshes as a PNG picture");
  program.text("size", &options.size, "WxH", "pixels of the picture");
  program.text("orbit", &options.orbit, "AZIMUTH,ELEVATION",
               "where the eye is, in degrees: moved to its right and upwards from the front");
  program.choice("up", &options.up, {"x", "y", "z"}, "the axis that points up");
  program.number("zoom", &options.zoom, 0.001, 1000, "2 shows everything twice as large");
  program.choice("frame", &options.frame, {"each", "scale", "place"},
                 "what fills a panel: its mesh, the scale of the largest, the box of all meshes");
  program.text("around", &options.around, "FILE", "frame FILE's mesh in every panel instead");
  program.integer("columns", &options.columns, 0, 10000, "panels in a row; 0 is all");
  program.text("color", &options.color, "COLOR",
               "of the surface, as #rrggbb; without it the properties red, green and blue");
  program.text("highlight", &options.highlight, "PROPERTY",
               "orange where this property of faces or vertices is not zero");
  program.text("background", &options.background, "COLOR",
               "#rrggbb, two as TOP,BOTTOM, default or transparent");
  program.number("crease-angle", &options.crease_angle, 0, 180,
                 "degrees beyond which a bend is drawn as a sharp edge; 0 draws flat faces");
  program.flag("edges", &options.edges, "draw the edges of the faces");
  return program.picture(argc, argv, [&](std::vector<Document> documents, tool::Run& run) {
    return render(documents, options, run);
  });
}
