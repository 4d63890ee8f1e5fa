/// Boolean operations on solids: the boundary of their union, intersection, difference or symmetric
/// difference, in one arrangement of all operands. An operand is the solid { p : w(p) >= 1 }, w
/// being its own winding number, so it may overlap itself, be nested, touch or equal others.
///
/// Guarantees: the result is closed, oriented outwards and manifold. It is the boundary of exactly
/// that region, without walls of no thickness. Rounded to `coordinate`, it has no self-intersection
/// and no face without area. Faces that meet no other operand keep coordinates, columns and order,
/// unless `merge_flat` covers their flat region anew. Faces of subtracted operands are reversed.
/// Pieces have the columns of their faces; missing ones are as columns.h says. An empty region is
/// an empty mesh. Reference: Zhou, Grinspun, Zorin & Jacobson, "Mesh arrangements for solid
/// geometry", ACM TOG 35(4), 2016. Throws InputError, naming the operand, if one is not closed and
/// oriented, and GoalError if rounding cannot be repaired. Deterministic for any number of threads.
/// Cost: that of clean() for all operands together; where an operand intersects itself beside
/// others, and for the symmetric difference, hidden pieces are cut as well.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "transformesh/clean_result.h"
#include "transformesh/control.h"
#include "transformesh/error_kind.h"

namespace transformesh {

enum class BooleanOperation {
  unite,      ///< inside any operand
  intersect,  ///< inside all operands
  subtract,   ///< inside the first operand, and inside no other
  exclude     ///< inside an odd number of operands
};
struct Operand {
  const Mesh* mesh = nullptr;
  std::string name{};  ///< for messages
};

struct BooleanOptions {
  bool merge_flat = true;               ///< merge what lies in one plane at cuts (clean.h)
  bool source_operand = false;          ///< write the operand of each face as source_operand
  Scalar coordinate = Scalar::float64;  ///< the type in which positions will be written
};

struct BooleanResult : CleanResult {
  std::optional<ErrorKind> reason{};      ///< why it is empty, by clean() of all operands
  std::vector<std::size_t> inside_out{};  ///< operands that enclose nothing: w < 0
  std::vector<std::size_t> canceling{};   ///< operands that enclose nothing: w = 0, with faces
};

/// The counts are of all operands together. `operands` is not empty.
BooleanResult boolean(BooleanOperation operation, const std::vector<Operand>& operands,
                      const BooleanOptions& options = {}, const Progress& progress = Progress());

enum class SheetSide { outside, inside };
/// The part of a sheet outside or inside of a solid, cut along the surface of the solid. Throws as
/// boolean() does, for the solid.
BooleanResult cut_sheet(const Operand& sheet, const Operand& solid, SheetSide side,
                        const BooleanOptions& options = {}, const Progress& progress = Progress());

}  // namespace transformesh
