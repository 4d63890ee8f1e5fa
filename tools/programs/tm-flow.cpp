/// tm-flow: velocities of classic flows at the vertices of a mesh.
#include "flow/flow_columns.h"
#include "frame/run.h"
#include "options/flow_options.h"

namespace {

using namespace transformesh;

struct Choices {
  tool::FlowChoices flow;
  double time = 0, span = 0;
  bool list = false;
};

void add_velocities(const Choices& choices, tool::Run& run) {
  if (choices.list) return run.out().set_bytes(tool::flow_list());
  const Flow flow = tool::flow_of(run.program().word, choices.flow);
  const FlowSpeeds speeds = add_flow_columns(run.document().mesh, flow.motion,
                                             {choices.time, choices.span}, run.progress());
  run.report(entries_of(speeds));
  if (choices.span > 0 && !flow.motion.displacement)
    run.note("the flow is not computed in steps: --span has no effect");
  tool::note_flow(flow, run);
}

}  // namespace

int main(int argc, char** argv) {
  Choices choices;
  tool::Program program{"tm-flow", "[OPTION]... NAME [INPUT] | --list",
                        "Writes the velocities of a flow as the vertex properties vx vy vz"};
  program.words = {"NAME", "name of a flow; --list prints all names"};
  program.words.choices = tool::flow_names();
  program.input.is_absent = [&] { return choices.list; };
  program.output.is_mesh = [&] { return !choices.list; };
  program.options.flag("list", &choices.list, "print the flows, with the options of each")
      .affects_result = false;
  program.options.number("time", &choices.time, -1e300, 1e300,
                         "time at which velocities are evaluated");
  program.options.number("span", &choices.span, 0, 1e300,
                         "for flows by curvature: write the mean velocity of an implicit step over "
                         "this time; 0: the velocity at --time");
  tool::declare_flow(program.options, choices.flow);
  program.example =
      "tm-flow deformation --time 0.1 mesh.ply | tm-displace --time-step 0.02 > next.ply";
  return program.run(argc, argv, [&](tool::Run& run) { add_velocities(choices, run); });
}
