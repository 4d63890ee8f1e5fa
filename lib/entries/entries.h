/// Entries of reports: names and values, in order, that a program prints and that the Python module
/// returns. Names are lower case with underscores. Points are three numbers, lengths are in input
/// units.
#pragma once

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "transformesh/length.h"
#include "transformesh/mesh.h"

namespace transformesh {

struct AlignResult;
struct CarryResult;
struct Certificate;
struct CleanResult;
struct Comparison;
struct DecimateResult;
struct DisplaceResult;
struct EvolveResult;
struct TimeResult;
struct FillResult;
struct FlowCounts;
struct FlowSpeeds;
struct HandleResult;
struct MeshCheck;
struct MorphResult;
struct MorphStepResult;
struct OffsetResult;
struct RemeshResult;
struct RegistrationResult;
struct RepairResult;
struct SelectionResult;
struct StitchResult;
struct TransformResult;

using Value =
    std::variant<bool, long, std::size_t, double, std::string, std::vector<double>, Length>;
using Entries = std::vector<std::pair<std::string, Value>>;

/// Describes a mesh: counts, topology, sizes, and the quality of its triangles. Areas, volumes and
/// lengths that no double can hold are infinite.
Entries describe(const Mesh& mesh);

Entries entries_of(const CleanResult& result);
Entries entries_of(const StitchResult& result);
Entries entries_of(const FillResult& result);
Entries entries_of(const HandleResult& result);
Entries entries_of(const RepairResult& result);
Entries entries_of(const RemeshResult& result);
Entries entries_of(const DecimateResult& result);
Entries entries_of(const AlignResult& result);
Entries entries_of(const DisplaceResult& result);
Entries entries_of(const MorphStepResult& result);
Entries entries_of(const OffsetResult& result);
Entries entries_of(const EvolveResult& result);
Entries entries_of(const TimeResult& result);
Entries entries_of(const FlowCounts& counts);
Entries entries_of(const FlowSpeeds& speeds);
Entries entries_of(const MorphResult& result);
Entries entries_of(const TransformResult& result);
Entries entries_of(const RegistrationResult& result);
Entries entries_of(const SelectionResult& result);
Entries entries_of(const CarryResult& result);
Entries entries_of(const Comparison& result);
Entries entries_of(const Certificate& result);
/// Returns the report of a check: manifoldness, orientation and closedness, counts of defects and
/// components, genus, and then the number of intersections and the certificate if present.
Entries entries_of(const MeshCheck& result);

/// Appends the entries of `more` (names and values of a report) to `entries`.
void append(Entries& entries, const Entries& more);

}  // namespace transformesh
