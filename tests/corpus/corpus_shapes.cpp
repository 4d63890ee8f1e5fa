// A test program, not installed: lists and writes the generated inputs of tests/corpus/run.
//   corpus_shapes
//     lists the inputs, a line each: NAME KIND OUTCOME, and the options of tm-clean
//   corpus_shapes NAME
//     writes that input as PLY
//   corpus_shapes --volume NAME
//     prints the volume of the result, if it is known
// The end of NAME is the scalar type: double, float or to-float (doubles that tm-clean must convert
// to floats). Files are binary, or text if NAME has -ascii.
#include <iostream>

#include "corpus/cases.h"
#include "transformesh/mesh_io.h"

using namespace transformesh;
using namespace transformesh::corpus;

namespace {

struct Input {
  std::string name;
  const Case* shape;
  std::string form;
};

Cases all_cases() {
  Cases cases;
  for (const auto add :
       {add_coplanar_cases, add_contact_cases, add_degenerate_cases, add_nesting_cases,
        add_coordinate_cases, add_random_cases, add_open_cases, add_wall_cases, add_workload_cases})
    add(cases);
  return cases;
}

/// Lists each case as doubles and, if it fits, as floats. Encodings alternate.
std::vector<Input> all_inputs(const Cases& cases) {
  std::vector<Input> inputs;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    std::vector<std::string> forms = {i % 2 == 0 ? "double" : "double-ascii"};
    if (cases[i].fits_float)
      forms.push_back(i % 3 == 2 ? "to-float" : i % 2 == 0 ? "float-ascii" : "float");
    for (const std::string& form : forms)
      inputs.push_back({cases[i].kind + "/" + cases[i].name + "/" + form, &cases[i], form});
  }
  return inputs;
}

std::string outcome_text(Outcome outcome, bool is_at_limit) {
  switch (outcome) {
    case Outcome::clean:
      return is_at_limit ? "clean-at-limit" : "clean";
    case Outcome::by_winding:
      return "by-winding";
    case Outcome::inside_out:
      return "inside-out";
    case Outcome::not_oriented:
      return "not-oriented";
  }
  return {};
}

/// Fewer than 256 numbers fit into the smallest feature.
bool is_at_limit(const Input& input) {
  const bool is_float = input.form.find("float") != std::string::npos;
  return input.shape->feature < 256 * (is_float ? 0x1p-23 : 0x1p-52);
}

std::string options_text(const Input& input) {
  std::string options;
  if (input.shape->winding_level != 1)
    options += " --level " + std::to_string(input.shape->winding_level);
  if (input.form == "to-float") options += " --float";
  return options;
}

void write(const Input& input) {
  Document document;
  document.mesh = input.shape->make();
  document.style.coordinate = input.form.starts_with("float") ? Scalar::float32 : Scalar::float64;
  document.style.format = input.form.ends_with("ascii") ? Format::ply_ascii : Format::ply_little;
  std::cout << write_mesh(document).bytes;
}

void print_volume(const Input& input) {
  if (input.shape->volume) std::cout << *input.shape->volume << '\n';
}

}  // namespace

int main(int argc, char** argv) {
  const Cases cases = all_cases();
  const bool wants_volume = argc == 3 && std::string(argv[1]) == "--volume";
  const std::string name = argc > 1 ? argv[argc - 1] : "";
  for (const Input& input : all_inputs(cases)) {
    if (argc == 1) {
      std::cout << input.name << ' ' << input.shape->kind << ' '
                << outcome_text(input.shape->outcome, is_at_limit(input)) << options_text(input)
                << '\n';
    } else if (input.name == name) {
      wants_volume ? print_volume(input) : write(input);
      return 0;
    }
  }
  if (argc > 1) std::cerr << "corpus_shapes: no input is named '" << name << "'\n";
  return argc > 1 ? 2 : 0;
}
