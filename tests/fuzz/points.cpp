// Files of points as text, and damaged ones.
#include "fuzz/round_trip.h"

void transformesh::fuzz::run_target(std::string_view bytes) { check_mesh_file(bytes, "input.xyz"); }
