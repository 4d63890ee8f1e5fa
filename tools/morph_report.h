/// What tm-morph reports, and the line that it ends with.
#pragma once

#include <string>

#include "tm/evolution/tracking.h"
#include "tool.h"

namespace transformesh::tool {

std::string summary(const MorphingResult& result, const Mesh& mesh);
std::string summary(const TrackingResult& result, const Mesh& mesh);
void report_morph(const MorphingResult& result, Run& run);
void report_tracking(const TrackingResult& result, const Mesh& mesh, Run& run);

}  // namespace transformesh::tool
