/// The comments that go with a mesh through an evolution. They hold which programs made it, the
/// mean edge length when it began, and how far merging of flat faces moved its surface.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace transformesh {

/// Appends a line such as `tm-remesh 0.1.0 --min-edge 0.7x` and keeps only the last 20, so that a
/// loop's header does not grow.
void add_provenance(std::vector<std::string>& comments, const std::string& line);

/// The length in the last `tm:reference-edge` comment. Throws InputError where it is no length.
std::optional<double> reference_edge_of(const std::vector<std::string>& comments);

/// Drops those that are no length, and returns their number.
std::size_t drop_bad_reference_edges(std::vector<std::string>& comments);

/// Replaces all `tm:reference-edge` comments by one.
void set_reference_edge(std::vector<std::string>& comments, double length);

/// The largest length in a `tm:planarity` comment: a bound of how far flat faces moved; else 0.
double planarity_of(const std::vector<std::string>& comments);

/// Replaces all `tm:planarity` comments by one of their largest length and a further movement.
void add_planarity(std::vector<std::string>& comments, double movement);

/// Scales the lengths of both.
void scale_lengths(std::vector<std::string>& comments, double factor);

}  // namespace transformesh
