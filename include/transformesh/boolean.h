/// Boolean operations on solids: the boundary of their union, intersection, difference or symmetric
/// difference, in one arrangement of all operands. An operand is the solid { p : w(p) >= 1 }, where
/// w is its own winding number. Operands may overlap themselves, touch, and be nested or equal.
///
/// Guarantees: the result is exactly the boundary of that region: closed, oriented outwards and
/// manifold. Rounded to `coordinate`, it has no self-intersection and no face without area. Faces
/// that meet no other operand keep coordinates, columns and order, unless `merge_flat`
/// retriangulates their flat region. Faces of subtracted operands are reversed. Of coincident
/// faces, at most one stays. Parts of a cut face keep its columns; columns.h defines missing
/// values. An empty region gives an empty mesh. Reference: Zhou, Grinspun, Zorin & Jacobson, "Mesh
/// arrangements for solid geometry", ACM TOG 35(4), 2016. Throws InputError, naming the operand, if
/// one is not closed and oriented, and GoalError if rounding cannot be repaired. Deterministic.
/// Cost: that of clean(); more for `exclude` and if one of several operands intersects itself.
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
  std::string name{};  ///< name of the operand in messages
};
struct BooleanOptions {
  bool merge_flat = true;       ///< merge coplanar faces around cuts (clean.h)
  bool source_operand = false;  ///< add a face column source_operand: index of the face's operand
  Scalar coordinate = Scalar::float64;  ///< type to which positions of input and output are rounded
  bool cap = false;                     ///< cut_sheet(): close the result by faces of the solid
};

struct BooleanResult : CleanResult {
  std::optional<ErrorKind> reason{};      ///< why the result is empty, as an error kind of clean()
  std::vector<std::size_t> inside_out{};  ///< operands with winding numbers < 0, but none > 0
  std::vector<std::size_t> canceling{};   ///< operands with faces, but winding number 0 everywhere
};

/// All counts in the result are sums over the operands. `operands` must not be empty.
BooleanResult boolean(BooleanOperation operation, const std::vector<Operand>& operands,
                      const BooleanOptions& options = {}, const Progress& progress = Progress());

enum class SheetSide { outside, inside };
/// Returns the part of a sheet, an open surface, outside or inside of a solid. If
/// BooleanOptions::cap is set, faces of the solid are added that close this part. Throws like
/// boolean() for the solid, and InputError if no faces close the part.
BooleanResult cut_sheet(const Operand& sheet, const Operand& solid, SheetSide side,
                        const BooleanOptions& options = {}, const Progress& progress = Progress());

}  // namespace transformesh
