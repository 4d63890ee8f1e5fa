/// tm-select: keeps components or faces of a mesh.
#include "frame/run.h"
#include "options/cut_options.h"
#include "support/counted.h"
#include "support/number.h"
#include "transformesh/components.h"
#include "transformesh/errors.h"
#include "transformesh/select.h"

namespace {

using namespace transformesh;

struct Choices {
  std::string split;
  tool::CutChoices cut;
  SelectionOptions all;
};

constexpr std::size_t most_files = 9999;

void report(const SelectionResult& result, tool::Run& run) {
  run.report(entries_of(result));
  if (result.contains_point && !*result.contains_point)
    run.note("no component contains the point: the closest is taken, " +
             shortest_text(result.distance) + " away");
}

/// Returns a name such as `part-007.ply`. Numbers have leading zeros, so that the order of the
/// names is the order of the numbers.
std::string part_name(const Choices& c, std::size_t number, std::size_t count,
                      const std::string& format) {
  const std::size_t digits = std::max<std::size_t>(3, std::to_string(count).size());
  std::string text = std::to_string(number);
  text.insert(0, digits - text.size(), '0');
  return c.split + '-' + text + '.' + (format.empty() ? "ply" : format.substr(0, 3));
}

void write_parts(const Document& document, const Choices& c, tool::Run& run) {
  const std::size_t count = connected_components(document.mesh).components.size();
  if (count > most_files)
    throw GoalError(
        "--split would write " + counted(count, "file") + ", and " + std::to_string(most_files) +
        " are the most: join a soup with tm-stitch, or keep fewer components with --largest");
  std::vector<Mesh> parts = split_components(document.mesh, c.all.by);
  for (std::size_t i = 0; i < count; ++i)
    run.out().write_mesh_file(
        part_name(c, i + 1, count, run.program().common.format),
        Document{std::move(parts[i]), document.style, document.other_elements});
  run.report("files", count);
}

void select_document(Document& document, const Choices& choices, tool::Run& run) {
  tool::check_cut(choices.cut, choices.all.invert);
  report(select(document.mesh, choices.all), run);
  tool::cut_document(document, choices.cut, run);
  if (!choices.split.empty()) write_parts(document, choices, run);
  if (!run.program().writes_mesh()) run.out().write_nothing();
}

}  // namespace

int main(int argc, char** argv) {
  Choices choices;
  tool::Program program{"tm-select", "[OPTION]... [INPUT]",
                        "Keeps the components or faces of a mesh that meet all conditions"};
  program.input.soups = tool::Soups::reported;
  program.input.may_keep_polygons = true;
  program.options.integer("largest", &choices.all.largest, 1, 1000000000,
                          "keep the N largest components");
  program.options.number("at-least", &choices.all.at_least, 0, 1e300,
                         "keep components of at least this size");
  program.options.named("by", &choices.all.by,
                        {{"faces", ComponentSize::faces},
                         {"area", ComponentSize::area},
                         {"volume", ComponentSize::volume}},
                        "measure of the size of a component");
  program.options.text("where", &choices.all.where, "CONDITION",
                       "keep faces by a property, such as 'intersections>0'; a vertex property "
                       "must hold at all corners");
  program.options.box("box", &choices.all.box, "X0,Y0,Z0,X1,Y1,Z1",
                      "keep faces with all corners in this box");
  program.options.point("around", &choices.all.around,
                        "keep the component that contains this point, the innermost if several "
                        "do, the closest if none does");
  tool::declare_cut(program, choices.cut);
  program.options.flag("invert", &choices.all.invert,
                       "keep the faces that do not meet the conditions");
  program.options
      .text("split", &choices.split, "PREFIX",
            "write each component of the result to PREFIX-001.ply and so on, the largest first; "
            "write the whole result only if -o is given")
      .affects_result = false;
  program.output.is_mesh = [&] {
    return choices.split.empty() || program.options.find("output")->is_given;
  };
  program.example = "tm-select --largest 1 mesh.ply > largest.ply";
  return program.run(argc, argv,
                     [&](tool::Run& run) { select_document(run.document(), choices, run); });
}
