#include "clean/arrange/refine.h"
#include "clean/intersect/any_intersection.h"
#include "frame/column_notes.h"
#include "frame/run.h"
#include "geometry/source_points.h"
#include "io/segments.h"
#include "transformesh/errors.h"
#include "transformesh/intersect.h"

using namespace transformesh;

namespace {

struct Options {
  bool check = false;
  bool any = false;
  bool refine = false;
  std::string pairs;
  std::string segments;
};

std::string pair_lines(const std::vector<FacePair>& pairs) {
  std::string lines;
  for (const auto& [f, g] : pairs) lines += std::to_string(f) + ' ' + std::to_string(g) + '\n';
  return lines;
}

void count_per_face(Mesh& mesh, const std::vector<FacePair>& pairs) {
  Column& column = mesh.face_columns.get("intersections", Scalar::int32, mesh.faces.size());
  for (const auto& [f, g] : pairs) {
    ++column.values[f];
    ++column.values[g];
  }
}

void check_together(const Options& options) {
  if (options.any && (options.refine || !options.pairs.empty() || !options.segments.empty()))
    throw UsageError("--any stops at the first pair: leave out --refine, --pairs and --segments");
}

void intersect(Document& document, const Options& options, tool::Run& run) {
  check_together(options);
  if (options.any) {
    const bool is_crossing = has_intersections(document.mesh, run.progress());
    run.report("intersects", is_crossing);
    return run.answer(!is_crossing);
  }
  const std::vector<FacePair> pairs = find_intersections(document.mesh, run.progress());
  run.report("pairs", pairs.size());
  if (!options.pairs.empty()) run.out().write(options.pairs, pair_lines(pairs));
  if (!options.segments.empty()) {
    run.out().write(options.segments, segment_file(intersection_segments(document.mesh, pairs)));
  }
  if (!options.check) count_per_face(document.mesh, pairs);
  if (options.refine) {
    tool::note_dropped_sources(has_source_points(document.mesh), tool::closest_places, run);
    document.mesh = refine(document.mesh, run.progress());
  }
  run.answer(pairs.empty() || !options.check);
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  tool::Program program{"tm-intersect",
                        "[OPTION]... [INPUT]",
                        "Finds the pairs of faces that intersect",
                        {tool::Reads::mesh},
                        {tool::Writes::answer}};
  program.options.flag(
      "check", &options.check,
      "print the number of pairs instead of the mesh; exit with 1 if there are any");
  program.options.flag("any", &options.any,
                       "report only whether there are any pairs; stop at the first pair, and exit "
                       "with 1 if there is one");
  program.options.output_file("pairs", &options.pairs, "write the pairs of face indices as text");
  program.options
      .output_file("segments", &options.segments,
                   "write the segments in which faces intersect, as edges of a PLY file")
      .endings = {".ply"};
  program.options.flag(
      "refine", &options.refine,
      "split faces along the intersections; source_face is the index of the input face");
  program.output.is_mesh = [&] { return !options.check && !options.any; };
  program.example = "tm-intersect --check mesh.ply";
  return program.run(argc, argv, [&](tool::Run& run) { intersect(run.document(), options, run); });
}
