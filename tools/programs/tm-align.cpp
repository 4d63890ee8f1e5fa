/// tm-align: moves a mesh onto a reference, by rigid registration.
#include "frame/run.h"
#include "io/matrix_file.h"
#include "support/percent.h"
#include "transformesh/align.h"

namespace {

using namespace transformesh;

/// If RegistrationResult::stability is below this limit, a note states that part of the motion is
/// arbitrary. Spheres of 1280 and 10000 faces have stabilities of 0.039 and 0.015; a cylinder of
/// 3000 faces has 0.038. An ellipsoid with axes 1, 0.95 and 0.9, whose motion is determined, has
/// 0.052.
constexpr double low_stability = 0.05;
/// If less than this share of the mesh lies on the reference, a note states that the alignment may
/// be wrong. The registration itself assumes an overlap of at least 0.2.
constexpr double low_overlap = 0.3;

struct Choices {
  std::string reference, matrix;
  RegistrationOptions registration;
};

void note_doubts(const RegistrationResult& result, tool::Run& run) {
  if (!result.has_converged)
    run.note("the mesh still moved after " + std::to_string(result.iterations) +
             " iterations; allow more with --iterations");
  if (result.overlap < low_overlap)
    run.note("only " + percent_text(result.overlap) +
             " % of the mesh lies on the reference: the alignment may be wrong; turn the mesh "
             "closer to the reference with tm-transform, then align it again");
  if (result.stability < low_stability)
    run.note(
        "the surfaces can slide along each other, as spheres and planes do: this part of the "
        "motion is arbitrary");
}

void align_document(Document& document, const Choices& choices, tool::Run& run) {
  const Mesh reference = run.in().read(choices.reference).mesh;
  const RegistrationResult result =
      align(document.mesh, reference, choices.registration, run.progress());
  if (!choices.matrix.empty()) run.out().write(choices.matrix, matrix_text(result.motion));
  run.report(entries_of(result));
  note_doubts(result, run);
}

}  // namespace

int main(int argc, char** argv) {
  Choices choices;
  tool::Program program{"tm-align", "--reference FILE [OPTION]... [INPUT]",
                        "Aligns a mesh with a reference by a rigid motion, for example two scans"};
  program.options.text("reference", &choices.reference, "FILE", "mesh or points to align with")
      .is_needed = true;
  program.options
      .output_file("write-matrix", &choices.matrix,
                   "write the motion as a 4x4 matrix, for tm-transform --matrix")
      .affects_result = false;
  program.options.integer("samples", &choices.registration.samples, 100, 10000000,
                          "number of compared points on the mesh, uniform by area");
  program.options.integer("iterations", &choices.registration.iterations, 1, 1000000,
                          "maximum number of iterations");
  program.example = "tm-align --reference scan.ply part.ply | tm-cat scan.ply - > both.ply";
  return program.run(argc, argv,
                     [&](tool::Run& run) { align_document(run.document(), choices, run); });
}
