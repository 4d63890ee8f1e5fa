/// The folder of a run (run_folder.h) as a page shows it. It may be that of a run that goes on:
/// what is there is shown.
#pragma once

#include <string>

#include "evolution/loop/run_folder.h"
#include "page/page.h"
#include "support/progress.h"

namespace transformesh {

struct RunPageOptions {
  std::size_t every = 1;  ///< of the frames take the first, every so many, and the last
};

/// With the result as the last mesh, unless that is the last frame. Where there is a target,
/// vertices get the column `distance`, from its faces, or from its points where it has none; a
/// column of that name gives way. Of a movie, the targets and views of the meshes shown. Throws
/// InputError where the folder is no run, or where it has neither frames nor a result.
PageRun read_run_page(const std::string& folder, const RunPageOptions& options = {},
                      const Progress& progress = {});

/// Several runs, whose names are the title.
Page read_runs_page(const std::vector<std::string>& folders, const RunPageOptions& options = {},
                    const Progress& progress = {});

/// Whether some mesh of a run has the column, so that it can be `color_by`.
bool has_column(const Page& page, const std::string& name);

/// All of it but meshes and views, and the files of the former: the frames, then the result unless
/// that is the last frame, with their numbers.
PageRun read_run_texts(const std::string& folder);
RunPaths run_mesh_files(const std::string& folder, const std::string& log);

/// One frame of it as such a page has it; the target may be empty.
PageMesh read_frame(std::size_t number, const std::string& path, const Mesh& target);

/// Of targets or views that one with which the mesh of this number is shown; null where none is.
const RunPaths::value_type* shown_with(std::size_t number, const RunPaths& paths);

Mesh read_run_target(const std::string& path);

}  // namespace transformesh
