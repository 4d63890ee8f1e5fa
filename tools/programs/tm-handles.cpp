/// tm-handles: removes thin handles and narrow tunnels.
#include "frame/column_notes.h"
#include "frame/run.h"
#include "support/counted.h"
#include "transformesh/components.h"
#include "transformesh/handles.h"

namespace {

using namespace transformesh;

// Default of --max-length. Handles from the noise of scans, and from thin bridges in
// reconstructions, have few triangles around them. A larger value also removes thin handles of the
// object.
constexpr Length short_loop{5, Length::Unit::reference_edge};

struct Choices {
  std::optional<Length> max_length;
};

void handle_document(Document& document, const Choices& choices, tool::Run& run) {
  HandleOptions options;
  options.max_length = run.length(choices.max_length.value_or(short_loop));
  options.coordinate = document.style.coordinate;
  const HandleResult result = remove_handles(document.mesh, options, run.progress());

  tool::note_dropped_sources(result.dropped_source_points, tool::closest_places, run);
  run.report("max_length", options.max_length);
  run.report(entries_of(result));
  run.report("genus", connected_components(document.mesh).genus());
  if (result.refused > 0)
    run.note("no patches fit along " + counted(result.refused, "loop") +
             ", where handles stay: run tm-remesh, then tm-handles again, which may remove them");
  if (result.blocked > 0)
    run.note("handles stay along " + counted(result.blocked, "loop") +
             ", because cutting there would open a cavity or join separate parts");
}

}  // namespace

int main(int argc, char** argv) {
  Choices choices;
  tool::Program program{"tm-handles", "[OPTION]... [INPUT]",
                        "Removes thin handles and closes narrow tunnels, before tm-clean"};
  program.input.soups = tool::Soups::joined;
  program.options.length("max-length", &choices.max_length,
                         "remove handles and tunnels that have a loop of at most this length "
                         "around or through them (default 5x)");
  program.example = "tm-handles scan.ply | tm-clean > untied.ply";
  return program.run(argc, argv,
                     [&](tool::Run& run) { handle_document(run.document(), choices, run); });
}
