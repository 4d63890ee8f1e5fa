/// tm-select: keeps components or faces of a mesh.
#include "frame/run.h"
#include "tm/mesh/components.h"
#include "tm/mesh/select.h"
#include "tm/support/counted.h"
#include "tm/support/error.h"

namespace {

using namespace transformesh;

struct Choices {
  std::optional<long> largest;
  std::string by = "faces", where;
  double at_least = 0;
  std::vector<double> box;
  bool invert = false;
};

void meet(std::vector<bool>& keep, const std::vector<bool>& more) {
  for (std::size_t f = 0; f < keep.size(); ++f) keep[f] = keep[f] && more[f];
}

std::vector<bool> chosen_faces(const Mesh& mesh, const Choices& c) {
  const auto by = c.by == "faces"  ? ComponentSize::faces
                  : c.by == "area" ? ComponentSize::area
                                   : ComponentSize::volume;
  std::vector<bool> keep(mesh.faces.size(), true);
  if (c.largest) meet(keep, faces_of_largest(mesh, static_cast<std::size_t>(*c.largest), by));
  if (c.at_least > 0) meet(keep, faces_of_at_least(mesh, c.at_least, by));
  if (!c.where.empty()) meet(keep, faces_where(mesh, c.where));
  if (!c.box.empty())
    meet(keep, faces_in_box(
                   mesh, {Vec3(c.box[0], c.box[1], c.box[2]), Vec3(c.box[3], c.box[4], c.box[5])}));
  if (c.invert) keep.flip();
  return keep;
}

void report(std::size_t selected, std::size_t dropped, tool::Run& run) {
  run.report("selected_faces", selected);
  run.report("dropped_faces", dropped);
}

void select_document(Document& document, const Choices& choices, tool::Run& run) {
  Mesh& mesh = document.mesh;
  const std::size_t faces = mesh.faces.size();
  mesh = select_faces(mesh, chosen_faces(mesh, choices));
  if (mesh.faces.empty())
    throw GoalError("none of " + counted(faces, "face") +
                    " is selected; --invert takes the others");
  report(mesh.faces.size(), faces - mesh.faces.size(), run);
}

}  // namespace

int main(int argc, char** argv) {
  Choices choices;
  tool::Program program{"tm-select", "[OPTION]... [INPUT]",
                        "Keeps the components or faces of a mesh that meet all conditions"};
  program.integer("largest", &choices.largest, 1, 1000000000, "the N largest components");
  program.number("at-least", &choices.at_least, 0, 1e300, "components at least so large");
  program.choice("by", &choices.by, {"faces", "area", "volume"}, "what makes a component large");
  program.text("where", &choices.where, "CONDITION",
               "faces by a property, such as 'intersections>0'; one of vertices at all corners");
  program.numbers("box", &choices.box, "X0,Y0,Z0,X1,Y1,Z1", "faces with all corners in this box");
  program.flag("invert", &choices.invert, "keep all other faces instead");
  return program.run(argc, argv,
                     [&](tool::Run& run) { select_document(run.document(), choices, run); });
}
