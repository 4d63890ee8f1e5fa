/// Notes about columns that were dropped because they no longer describe the surface.
#pragma once

#include <string>
#include <vector>

#include "frame/run.h"

namespace transformesh::tool {

inline void note_new_normals(bool are_new, Run& run) {
  if (are_new) run.note("the normals nx ny nz are computed anew");
}

inline void note_dropped_lists(const std::vector<std::string>& names, Run& run) {
  for (const std::string& name : names)
    run.note("face property '" + name +
             "' dropped: the corners whose texture coordinates it holds are no longer the same");
}

inline constexpr const char* source_of_step = "; --source writes those of this step";
inline constexpr const char* closest_places = "; tm-carry --closest finds the closest places";

/// Notes, if `are_dropped`, that the source columns were removed. `remedy` ends the sentence.
inline void note_dropped_sources(bool are_dropped, const std::string& remedy, Run& run) {
  if (are_dropped)
    run.note(
        "properties source_face, source_u and source_v dropped: vertices and faces are no longer "
        "the "
        "same" +
        remedy);
}

}  // namespace transformesh::tool
