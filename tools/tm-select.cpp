/// tm-select: keeps components or faces of a mesh.
#include "frame/run.h"
#include "tm/geometry/component_around.h"
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
  std::vector<double> box, around;
  bool invert = false;
  std::string split;
  ComponentSize size() const {
    return by == "faces"  ? ComponentSize::faces
           : by == "area" ? ComponentSize::area
                          : ComponentSize::volume;
  }
};

constexpr std::size_t most_files = 9999;

Vec3 vector_of(const double* numbers) { return {numbers[0], numbers[1], numbers[2]}; }

void meet(std::vector<bool>& keep, const std::vector<bool>& more) {
  for (std::size_t f = 0; f < keep.size(); ++f) keep[f] = keep[f] && more[f];
}

std::vector<bool> faces_around(const Mesh& mesh, const Vec3& point, tool::Run& run) {
  ComponentAround found = component_around(mesh, point);
  run.report("contains_point", found.contains_point);
  run.report("distance", found.distance);
  if (!found.contains_point)
    run.note("no component contains the point: the closest is taken, " +
             shortest_text(found.distance) + " away");
  return std::move(found.faces);
}

std::vector<bool> chosen_faces(const Mesh& mesh, const Choices& c, tool::Run& run) {
  std::vector<bool> keep(mesh.faces.size(), true);
  if (c.largest) meet(keep, faces_of_largest(mesh, static_cast<std::size_t>(*c.largest), c.size()));
  if (c.at_least > 0) meet(keep, faces_of_at_least(mesh, c.at_least, c.size()));
  if (!c.around.empty()) meet(keep, faces_around(mesh, vector_of(c.around.data()), run));
  if (!c.where.empty()) meet(keep, faces_where(mesh, c.where));
  if (!c.box.empty())
    meet(keep, faces_in_box(mesh, {vector_of(c.box.data()), vector_of(c.box.data() + 3)}));
  if (c.invert) keep.flip();
  return keep;
}

/// `part-007.ply`: names sort by number.
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
    throw GoalError("--split would write " + counted(count, "file") + ", and " +
                    std::to_string(most_files) +
                    " are the most: join a soup by tm-stitch, or say how many with --largest");
  std::vector<Mesh> parts = split_components(document.mesh, c.size());
  for (std::size_t i = 0; i < count; ++i)
    run.write_mesh_file(part_name(c, i + 1, count, run.program().common.format),
                        Document{std::move(parts[i]), document.style, document.other_elements});
  run.report("files", count);
}

void select_document(Document& document, const Choices& choices, tool::Run& run) {
  Mesh& mesh = document.mesh;
  const std::size_t faces = mesh.faces.size();
  mesh = select_faces(mesh, chosen_faces(mesh, choices, run));
  if (mesh.faces.empty())
    throw GoalError("none of " + counted(faces, "face") +
                    " is selected; --invert takes the others");
  run.report("selected_faces", mesh.faces.size());
  run.report("dropped_faces", faces - mesh.faces.size());
  if (!choices.split.empty()) write_parts(document, choices, run);
  if (!run.program().writes_mesh()) run.write_nothing();
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
  program.numbers("around", &choices.around, "X,Y,Z",
                  "the component that contains this point, of nested ones the innermost; where "
                  "none does, the closest");
  program.flag("invert", &choices.invert, "keep all other faces instead");
  program
      .text("split", &choices.split, "PREFIX",
            "write each component of what is kept to PREFIX-001.ply and so on, the largest first, "
            "and the whole to -o only where that is given")
      .affects_result = false;
  program.writes_mesh_if = [&] {
    return choices.split.empty() || program.find("output")->is_given;
  };
  return program.run(argc, argv,
                     [&](tool::Run& run) { select_document(run.document(), choices, run); });
}
