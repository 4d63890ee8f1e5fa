/// Documents as one, one after the other: vertices, faces, columns and further elements in their
/// order. Types of columns become as wide as both need, missing values are zero. Comments are
/// joined without repetition; a reference edge belongs to one mesh: the first keeps its own.
/// Coordinates are doubles where they are in either. Linear.
#pragma once

#include <string>
#include <vector>

#include "io/document/document.h"

namespace transformesh {

/// Returns what cannot be joined, one line each: columns that are lists in one of them and numbers
/// in the other.
std::vector<std::string> append(Document& all, const Document& other);

}  // namespace transformesh
