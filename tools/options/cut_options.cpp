#include "options/cut_options.h"

#include "frame/column_notes.h"
#include "geometry/section_svg.h"
#include "io/segments.h"
#include "mesh/surface_columns.h"
#include "transformesh/errors.h"
#include "transformesh/select.h"

namespace transformesh::tool {
namespace {

std::vector<std::string> corner_lists(const Mesh& mesh) {
  std::vector<std::string> names;
  for (const Column& column : mesh.face_columns.columns)
    if (is_corner_list(column)) names.push_back(column.name);
  return names;
}

std::string section_file(const CutChoices& c, const Mesh& mesh, const CutPlane& plane) {
  const std::vector<Segment> segments = plane_section(mesh, plane);
  return c.section.ends_with(".svg") ? section_svg(segments, plane.normal) : segment_file(segments);
}

}  // namespace

void check_cut(const CutChoices& c, bool is_inverted) {
  if (c.plane.empty() && (c.cap || !c.section.empty()))
    throw UsageError("--cap and --section need a cut: give its plane with --plane A,B,C,D");
  if (!c.plane.empty() && is_inverted)
    throw UsageError(
        "--invert cannot be combined with --plane: to keep the other side, negate the numbers of "
        "the plane");
}

void cut_document(Document& document, const CutChoices& c, Run& run) {
  if (c.plane.empty()) return;
  const CutPlane plane{Vec3(c.plane.data()), c.plane[3]};
  if (!c.section.empty()) run.out().write(c.section, section_file(c, document.mesh, plane));
  const std::vector<std::string> lists = corner_lists(document.mesh);
  if (c.cap) {
    cut_closed(document.mesh, plane, document.style.coordinate, run.progress());
  } else if (cut_open(document.mesh, plane)) {
    run.note("the cut leaves a border; close it with --cap");
  }
  if (corner_lists(document.mesh).empty()) note_dropped_lists(lists, run);
}

void declare_cut(Program& program, CutChoices& choices) {
  program.options.numbers(
      "plane", &choices.plane, "A,B,C,D",
      "keep the part where a x + b y + c z >= d, and cut faces across the plane");
  program.options.flag("cap", &choices.cap, "with --plane: close the cut; the mesh must be closed");
  program.options
      .output_file("section", &choices.section,
                   "write the curves in which the plane intersects the faces: an .svg drawing, "
                   "else a PLY with edges")
      .endings = {".svg", ".ply"};
}

}  // namespace transformesh::tool
