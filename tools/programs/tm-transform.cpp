/// tm-transform: translates, rotates, scales and mirrors a mesh.
#include "frame/run.h"
#include "io/comments.h"
#include "io/document/unit.h"
#include "options/transform_options.h"
#include "transformesh/transform.h"

namespace {

using namespace transformesh;

void transform_document(Document& document, tool::TransformChoices& choices, tool::Program& program,
                        tool::Run& run) {
  Matrix4 product = Matrix4::Identity();
  for (const auto& step : choices.steps) product = step(run, product) * product;
  const TransformResult result = transform(document.mesh, product);
  scale_lengths(document.style.comments, result.scale);
  if (!choices.to.empty()) set_unit(document, *find_unit(choices.to));

  // In the output file, the comment on the program and its options states a single --matrix: the
  // product of all transformations.
  const Matrix4 rows = product.transpose();
  choices.matrix.assign(rows.data(), rows.data() + rows.size());
  tool::Option& matrix = *program.options.find("matrix");
  matrix.affects_result = matrix.is_given = true;
  matrix.placeholder = "A11,...,A44";
  run.report("matrix", choices.matrix);
  run.report(entries_of(result));
}

}  // namespace

int main(int argc, char** argv) {
  tool::TransformChoices choices;
  tool::Program program{"tm-transform", "[OPTION]... [INPUT]",
                        "Moves, turns, scales and mirrors a mesh, in the order of the options"};
  program.input.may_keep_polygons = true;
  tool::declare_transforms(program, choices);
  program.example = "tm-transform --rotate 0,0,1,90 mesh.ply > turned.ply";
  return program.run(argc, argv, [&](tool::Run& run) {
    transform_document(run.document(), choices, program, run);
  });
}
