/// Boolean operations on solids: the boundary of their union, intersection, difference or symmetric
/// difference, in one arrangement of all operands. An operand is the solid { p : w(p) >= 1 }, w
/// being its own winding number, so it may overlap itself, be nested, touch or equal others.
///
/// Guarantees: the result is closed, oriented outwards and manifold. It is the boundary of exactly
/// that region, without walls of no thickness. Rounded to `coordinate`, it has no self-intersection
/// and no face without area. Where operands do not meet, faces keep
/// coordinates, columns and order. Faces of subtracted operands are reversed. Every face has the
/// columns of the operand face that it is a piece of; missing ones are as columns.h says. An empty
/// region is an empty mesh.
///
/// Reference: Zhou, Grinspun, Zorin & Jacobson, "Mesh arrangements for solid geometry", ACM TOG
/// 35(4), 2016. Throws InputError, naming the operand, if one is not closed and oriented, and
/// GoalError if rounding cannot be repaired. Deterministic for any number of threads.
/// Cost: O(n log n + k log k) for n faces and k intersecting pairs, as clean() of all operands
/// together. Where an operand intersects itself, and for the symmetric difference, hidden pieces
/// are cut as well, at about twice the cost.
#pragma once

#include <string>
#include <vector>

#include "transformesh/clean_result.h"
#include "transformesh/control.h"

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
  std::vector<std::size_t> empty_operands{};  ///< inside out: they enclose nothing
};

/// The counts are of all operands together. `operands` is not empty.
BooleanResult boolean(BooleanOperation operation, const std::vector<Operand>& operands,
                      const BooleanOptions& options = {}, const Progress& progress = Progress());

enum class SheetSide { outside, inside };
/// The part of a sheet outside or inside of a solid, cut along the surface of the solid. Throws as
/// boolean() does, for the solid.
CleanResult cut_sheet(const Operand& sheet, const Operand& solid, SheetSide side,
                      const BooleanOptions& options = {}, const Progress& progress = Progress());

}  // namespace transformesh
