/// The two kinds of comment lines that the programs write into a mesh's header.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "option_table.h"

namespace transformesh::tool {

/// `tm-remesh 0.1.0 --min-edge 0.7x`: the words and options given that affect the result.
std::string provenance(const std::string& program, const std::string& version,
                       const std::vector<std::string>& words, const OptionTable& table);

/// Appends a provenance line and keeps only the last 20, so that a loop's header does not grow.
void add_provenance(std::vector<std::string>& comments, const std::string& line);

/// The length in the last `tm:reference-edge` comment. Throws InputError where it is no length.
std::optional<double> reference_edge_of(const std::vector<std::string>& comments);

/// Replaces all `tm:reference-edge` comments by one.
void set_reference_edge(std::vector<std::string>& comments, double length);

}  // namespace transformesh::tool
