/// Comments in mesh files that describe the mesh: the programs that made it, the reference edge,
/// and a bound on how far merging of flat faces moved its surface.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace transformesh {

/// Appends a comment with a command line, such as `tm-remesh 0.1.0 --min-edge 0.7x`. Keeps only the
/// last 20 such lines, so that headers do not grow in a loop of programs.
void add_provenance(std::vector<std::string>& comments, const std::string& line);

/// Returns the length in the last `tm:reference-edge` comment, or nothing if there is no such
/// comment. Throws InputError if the comment does not contain a length.
std::optional<double> reference_edge_of(const std::vector<std::string>& comments);

/// Drops `tm:reference-edge` comments that do not hold a length, and returns their number.
std::size_t drop_bad_reference_edges(std::vector<std::string>& comments);

/// Replaces all `tm:reference-edge` comments by one comment with this length.
void set_reference_edge(std::vector<std::string>& comments, double length);

/// Returns the largest length in a `tm:planarity` comment, 0 if there is none: a bound on how far
/// merging of flat faces moved the surface, in input units.
double planarity_of(const std::vector<std::string>& comments);

/// Replaces all `tm:planarity` comments by one comment: their largest length plus `movement`.
void add_planarity(std::vector<std::string>& comments, double movement);

/// Multiplies the lengths in `tm:reference-edge` and `tm:planarity` comments by `factor`.
void scale_lengths(std::vector<std::string>& comments, double factor);

}  // namespace transformesh
