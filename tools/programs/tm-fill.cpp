/// tm-fill: closes the holes of a mesh.
#include "frame/column_notes.h"
#include "frame/run.h"
#include "mesh/location_text.h"
#include "support/counted.h"
#include "support/number.h"
#include "transformesh/fill.h"

namespace {

using namespace transformesh;

struct Choices {
  std::optional<Length> max_diameter;
  std::optional<std::size_t> max_edges;
  bool no_refine = false;
  bool no_fair = false;
  bool allow_self_intersections = false;
};

std::string described(const std::vector<OpenHole>& holes, const Mesh& mesh, const char* why) {
  const OpenHole& first = holes.front();
  return counted(holes.size(), "hole") + (holes.size() == 1 ? " stays open, " : " stay open, ") +
         why + (holes.size() == 1 ? ": " : ", the first: ") + counted(first.edges, "edge") + ", " +
         significant(first.length, 3) + " long, at " + vertex_text(mesh, first.vertex);
}

void note_open(const FillResult& result, const Mesh& mesh, tool::Run& run) {
  if (!result.crossing.empty())
    run.note(described(result.crossing, mesh, "because every patch would intersect the mesh") +
             "; close these holes with --allow-crossings, then run tm-clean");
  if (!result.flat.empty())
    run.note(
        described(result.flat, mesh,
                  "because every patch would have a face without area, or an edge that has two "
                  "faces already") +
        "; close slits with tm-clean");
  if (!result.too_large.empty()) run.note(described(result.too_large, mesh, "beyond the limits"));
}

void fill_document(Document& document, const Choices& choices, tool::Run& run) {
  FillOptions options;
  if (choices.max_edges) options.max_edges = *choices.max_edges;
  if (choices.max_diameter) options.max_diameter = run.length(*choices.max_diameter);
  options.refine = !choices.no_refine;
  options.fair = !choices.no_fair;
  options.allow_self_intersections = choices.allow_self_intersections;
  options.coordinate = document.style.coordinate;
  const FillResult result = fill_holes(document.mesh, options, run.progress());
  tool::note_dropped_sources(result.dropped_source_points, tool::closest_places, run);
  run.report(entries_of(result));
  if (result.cut_edges > 0)
    run.note(counted(result.cut_edges, "edge") +
             " cut where bodies touch, so that each gets a patch");
  note_open(result, document.mesh, run);
}

}  // namespace

int main(int argc, char** argv) {
  Choices choices;
  tool::Program program{"tm-fill", "[OPTION]... [INPUT]",
                        "Closes holes with smooth patches that do not intersect the mesh"};
  program.input.soups = tool::Soups::joined;
  program.options.integer("max-edges", &choices.max_edges, 3, 1000000000,
                          "leave holes with more than N edges open (default: no limit)");
  program.options.length(
      "max-diameter", &choices.max_diameter,
      "leave holes open if the diagonal of their bounding box is longer (default: no limit)");
  program.options.flag("no-fair", &choices.no_fair, "do not fair patches: leave them almost flat");
  program.options.flag("no-refine", &choices.no_refine,
                       "add no vertices: patches have few large triangles, and are not faired");
  program.options.flag(
      "allow-crossings", &choices.allow_self_intersections,
      "also close holes for which every patch intersects the mesh; run tm-clean afterwards");
  program.example = "tm-fill part.ply > closed.ply";
  return program.run(argc, argv,
                     [&](tool::Run& run) { fill_document(run.document(), choices, run); });
}
