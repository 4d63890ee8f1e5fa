#include "options/transform_options.h"

#include "io/document/unit.h"
#include "io/matrix_file.h"
#include "support/number.h"
#include "transformesh/errors.h"

namespace transformesh::tool {
namespace {

using namespace std::string_literals;

Vec3 vector_of(const std::vector<double>& n) { return {n[0], n[1], n[2]}; }

Matrix4 matrix_of(const std::vector<double>& numbers) {
  return Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(numbers.data());
}

/// Makes an option append a transformation to `choices.steps` each time it occurs on the command
/// line. `make` is called after the option's value is assigned, and returns the matrix of the
/// transformation.
void in_order(Option& option, TransformChoices& choices, const std::function<Matrix4()>& make) {
  option.affects_result = false;
  option.assign = [&choices, make, assign = option.assign](const std::string& text) {
    assign(text);
    const Matrix4 matrix = make();
    choices.steps.emplace_back([matrix](Run&, const Matrix4&) { return matrix; });
  };
}

void in_order_of_box(Option& option, TransformChoices& choices, Matrix4 (*make)(const Box&)) {
  option.affects_result = false;
  option.assign = [&choices, make](const std::string&) {
    choices.steps.emplace_back([make](Run& run, const Matrix4& before) {
      return make(mapped_box(run.document().mesh, before));
    });
  };
}

/// Lets --mirror accept x, y or z for the plane through the origin perpendicular to that axis.
void take_axes(Option& mirror) {
  mirror.placeholder = "x|y|z|A,B,C,D";
  mirror.assign = [numbers = mirror.assign](const std::string& text) {
    if (text.find(',') != std::string::npos) return numbers(text);
    if (text.size() != 1 || text < "x" || text > "z")
      throw UsageError("'" + text + "' is neither x, y, z nor four numbers separated by commas");
    const auto axis = static_cast<std::size_t>(text[0] - 'x');
    numbers("0,0,0,0"s.replace(2 * axis, 1, "1"));
  };
}

/// Lets --matrix accept a file name if the value is not a list of numbers. The file is read when
/// the mesh is transformed.
void take_files(Option& matrix, TransformChoices& choices) {
  matrix.placeholder = "A11,...,A44|FILE";
  matrix.assign = [&choices, numbers = matrix.assign](const std::string& text) {
    const std::size_t comma = text.find(',');
    if (comma != std::string::npos && number_in<double>(text.substr(0, comma)))
      return numbers(text);
    choices.steps.emplace_back([text](Run& run, const Matrix4&) {
      return parse_matrix(run.in().read_bytes(text), input_name(text));
    });
  };
}

/// Returns the scaling from the mesh's unit, or from the unit of --from, to the unit of --to.
/// Throws InputError if the mesh states no unit and --from is not given.
Matrix4 change_of_unit(const TransformChoices& c, const Document& document) {
  const Unit* from = c.from.empty() ? unit_of(document) : find_unit(c.from);
  if (from == nullptr) throw InputError("the mesh does not state its unit: give it with --from");
  return scaling_by(Vec3::Constant(from->millimeters / find_unit(c.to)->millimeters));
}

void declare_units(Program& program, TransformChoices& c) {
  std::vector<std::string> names;
  for (const Unit& unit : all_units()) names.emplace_back(unit.short_name);
  Option& to = program.options.choice("to", &c.to, names,
                                      "scale from the unit of the mesh, or of --from, to this "
                                      "unit, and write the unit to the output");
  to.affects_result = false;
  to.assign = [&c, assign = to.assign](const std::string& text) {
    assign(text);
    c.steps.emplace_back(
        [&c](Run& run, const Matrix4&) { return change_of_unit(c, run.document()); });
  };
  program.options.choice("from", &c.from, names, "unit of the mesh, for --to").affects_result =
      false;
}

}  // namespace

void declare_transforms(Program& program, TransformChoices& c) {
  in_order(program.options.numbers("translate", &c.translate, "X,Y,Z", "move by this vector"), c,
           [&c] { return translation_by(vector_of(c.translate)); });
  in_order(program.options.numbers("rotate", &c.rotate, "X,Y,Z,DEGREES",
                                   "rotate about this axis through the origin, counterclockwise as "
                                   "seen from the tip of the axis"),
           c, [&c] { return rotation_about(vector_of(c.rotate), c.rotate[3]); });
  in_order(program.options.numbers("scale", &c.scale, "FACTOR", "scale about the origin"), c,
           [&c] { return scaling_by(Vec3::Constant(c.scale[0])); });
  in_order(
      program.options.numbers("scale-axes", &c.scales, "X,Y,Z", "scale by a factor for each axis"),
      c, [&c] { return scaling_by(vector_of(c.scales)); });
  Option& mirror = program.options.numbers("mirror", &c.mirror, "A,B,C,D",
                                           "change the sign of a coordinate, or mirror in the "
                                           "plane a x + b y + c z = d; a solid stays a solid");
  take_axes(mirror);
  in_order(mirror, c, [&c] { return mirroring_in(vector_of(c.mirror), c.mirror[3]); });
  in_order_of_box(program.options.flag("center", &c.center,
                                       "move the center of the bounding box to the origin"),
                  c, centering);
  in_order_of_box(
      program.options.flag("unit-box", &c.unit_box,
                           "scale uniformly so that the longest side of the bounding box "
                           "is 1, and center it in the cube from 0,0,0 to 1,1,1"),
      c, fitting_unit_box);
  declare_units(program, c);
  Option& matrix = program.options.numbers("matrix", &c.matrix, ",,,,,,,,,,,,,,,",
                                           "apply a matrix of 16 numbers, row by row, that acts on "
                                           "columns x y z 1; or a text file of them");
  in_order(matrix, c, [&c] { return matrix_of(c.matrix); });
  take_files(matrix, c);
}

}  // namespace transformesh::tool
