/// tm-offset: computes the surface at a given distance from a solid, or thickens a sheet.
#include "frame/column_notes.h"
#include "frame/run.h"
#include "mesh/location_text.h"
#include "mesh/surface_columns.h"
#include "support/number.h"
#include "transformesh/errors.h"
#include "transformesh/offset.h"

namespace {

using namespace transformesh;

struct Choices {
  std::optional<Length> distance, edge, thicken;
  bool miter = false;
  OffsetOptions offset;
};

void note_missed(const OffsetResult& result, tool::Run& run) {
  run.note("the surface did not converge: it is " + significant(result.deviation.missed, 3) +
           " from the offset at " + point_text(result.deviation.missed_at) +
           ", because parts or gaps thinner than an edge are lost; shorter edges come nearer: "
           "--edge " +
           significant(result.edge / 2, 3));
}

void report_miter(const MiterDeviation& deviation, tool::Run& run) {
  run.report({{"deviation_max", deviation.most}});
  if (deviation.is_large)
    run.note("planes of faces move by up to " + significant(deviation.most, 3) +
             " too much or too little, most of all at " + point_text(deviation.at) +
             ", where more than three planes meet at a vertex, or a spike is cut off");
  if (deviation.remains)
    run.note("the result is wrong at " + point_text(*deviation.remains) +
             ", where a part or a gap too narrow for this distance remains, turned inside out");
}

void offset_document(Document& document, Choices& choices, tool::Run& run) {
  if (choices.thicken.has_value() == choices.distance.has_value())
    throw UsageError(
        "give either --distance, by which the surface moves, or --thicken, the thickness of a "
        "sheet");
  const Scalar coordinate = document.style.coordinate;
  if (choices.thicken) tool::note_dropped_lists(drop_corner_lists(document.mesh.face_columns), run);
  if (choices.thicken || choices.miter) {
    const double length = run.length(choices.thicken ? *choices.thicken : *choices.distance);
    const auto move = choices.thicken ? thicken : offset_mitered;
    return report_miter(move(document.mesh, length, coordinate, run.progress()), run);
  }
  choices.offset.distance = run.length(*choices.distance);
  if (choices.edge) choices.offset.edge = run.length(*choices.edge);
  const OffsetResult result = offset(document, choices.offset, run.progress());
  run.report(entries_of(result));
  if (result.has_missed) note_missed(result, run);
  if (!result.has_arrived)
    run.note("the surface has not converged after the last iteration: it is " +
             significant(result.deviation.rms, 3) +
             " from the offset on average; allow more with --iterations");
}

}  // namespace

int main(int argc, char** argv) {
  Choices choices;
  tool::Program program{"tm-offset", "[OPTION]... --distance LENGTH|--thicken LENGTH [INPUT]",
                        "Moves a surface outwards or inwards by a distance"};
  program.input.soups = tool::Soups::joined;
  program.options.length("distance", &choices.distance,
                         "distance of the offset surface: outwards, or inwards if negative", true);
  program.options.flag(
      "miter", &choices.miter,
      "move the planes of all faces, so that corners stay sharp (default: round them)");
  program.options.length(
      "thicken", &choices.thicken,
      "make a solid of this thickness from an open sheet, instead of --distance");
  program.options.length("edge", &choices.edge,
                         "make edges 0.7 to 1.5 times as long as this (default: the mean edge, but "
                         "at most half the distance and a 60th of the diagonal)");
  program.options.integer("iterations", &choices.offset.iterations, 1, 1000000,
                          "maximum number of steps");
  program.epilog =
      "Make a shell of thickness 2:\n"
      "  tm-offset --distance -2 a.ply | tm-stitch --flip | tm-cat a.ply -";
  program.example = "tm-offset --distance 2% mesh.ply > larger.ply";
  return program.run(argc, argv,
                     [&](tool::Run& run) { offset_document(run.document(), choices, run); });
}
