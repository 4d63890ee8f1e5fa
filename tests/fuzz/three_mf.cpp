// Archives of 3MF, or only their models. Changed models in an archive would not be read, because of
// its checksums.
#include "fuzz/round_trip.h"
#include "lib/io/stored_zip.h"

void transformesh::fuzz::run_target(std::string_view bytes) {
  const std::string text(bytes);
  check_mesh_file(bytes.starts_with("PK") ? text : testing::three_mf_of(text), "input.3mf");
}
