/// Reads the folder of a recorded evolution (run_folder.h) for an HTML page. If the evolution is
/// still running, the page shows its present state.
#pragma once

#include <string>

#include "evolution/loop/run_folder.h"
#include "page/page.h"
#include "transformesh/control.h"

namespace transformesh {

struct RunPageOptions {
  std::size_t every = 1;  ///< n: reads every n-th frame, besides the first and the last frame
};

/// Reads the record of an evolution. Its meshes are the frames, followed by the result, unless the
/// last frame is of the last iteration. If there is a target, vertices get the column `distance`,
/// which replaces an existing column. This is the distance from the faces of the target, or from
/// its points if it has no faces. For a movie, reads the targets and views of the shown meshes.
/// Throws InputError if the folder does not hold a run, or holds neither frames nor a result.
PageRun read_run_page(const std::string& folder, const RunPageOptions& options = {},
                      const Progress& progress = {});

/// Reads several runs; their names form the title.
Page read_runs_page(const std::vector<std::string>& folders, const RunPageOptions& options = {},
                    const Progress& progress = {});

/// True if a mesh of a run has the column, so that it can be `color_by`.
bool has_column(const Page& page, const std::string& name);

/// Read the text files of a recorded evolution, and list its mesh files with their numbers. Mesh
/// files are the frames, and the result unless the last frame is of the last iteration.
PageRun read_run_texts(const std::string& folder);
RunPaths run_mesh_files(const std::string& folder, const std::string& log);

/// Reads one frame as read_run_page() does. The target may be empty.
PageMesh read_frame(std::size_t number, const std::string& path, const Mesh& target);

/// Returns the path of the target (or of the views) to show together with the mesh of this number;
/// null if there is none.
const RunPaths::value_type* shown_with(std::size_t number, const RunPaths& paths);

Mesh read_run_target(const std::string& path);

}  // namespace transformesh
