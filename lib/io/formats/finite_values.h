/// Handles non-finite values in files, which occur in scans: drops them and counts them, or rejects
/// the file if reading is strict. Also counts integers that doubles may not hold.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "io/streams/source.h"
#include "transformesh/mesh.h"

namespace transformesh {

/// Drops vertices with a non-finite coordinate, and faces that use such vertices. `dropped_faces`
/// is the number of faces that were dropped earlier for this reason; the note states the sum. Does
/// nothing if all coordinates are finite.
void drop_points_not_finite(Mesh& mesh, std::size_t dropped_faces, const std::string& format,
                            std::vector<std::string>& notes);

/// Sets a normal (nx ny nz) or color (red green blue, with alpha if present) to zero if one of its
/// values is not finite. Throws InputError instead if reading is strict. `element` is the word for
/// a row in messages, such as "vertex".
void zero_values_not_finite(Columns& columns, const Source& source, const std::string& element,
                            const std::string& format, std::vector<std::string>& notes);

/// Adds a note such as "ply: 1 normal of a vertex is not a finite number and becomes 0".
void note_zeroed(std::size_t count, const std::string& what, const std::string& format,
                 std::vector<std::string>& notes);

/// Adds a note if integers of 64 bits, which were converted to doubles, are so large that they may
/// have been rounded. `what` names the property.
void note_rounded_integers(const std::vector<double>& values, const std::string& what,
                           const std::string& format, std::vector<std::string>& notes);

}  // namespace transformesh
