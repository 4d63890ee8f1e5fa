/// Notes on stderr about properties of vertices and faces that were recomputed or dropped, because
/// they no longer describe the surface.
#pragma once

#include <string>
#include <vector>

#include "frame/run.h"

namespace transformesh::tool {

inline void note_new_normals(bool are_new, Run& run) {
  if (are_new) run.note("the normals nx ny nz are recomputed");
}

inline void note_dropped_lists(const std::vector<std::string>& names, Run& run) {
  for (const std::string& name : names)
    run.note("face property '" + name +
             "' dropped: the face corners that its texture coordinates belong to have changed");
}

inline constexpr const char* source_of_step = "; write those of this step with --source";
inline constexpr const char* closest_places = "; use the closest points with tm-carry --closest";

/// Prints a note if `are_dropped` is true: the properties source_face, source_u and source_v were
/// removed. `remedy` ends the sentence.
inline void note_dropped_sources(bool are_dropped, const std::string& remedy, Run& run) {
  if (are_dropped)
    run.note(
        "properties source_face, source_u and source_v dropped: vertices and faces have changed" +
        remedy);
}

}  // namespace transformesh::tool
