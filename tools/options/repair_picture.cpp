#include "options/repair_picture.h"

#ifdef TM_SHOW
#include "picture/change_picture.h"
#include "repair/losses.h"
#endif

namespace transformesh::tool {

#ifdef TM_SHOW

void declare_repair_picture(Program& program, std::string& file) {
  Option& picture = program.options.output_file(
      "picture", &file,
      "draw input and result as a PNG picture: removed faces red, new faces green");
  picture.affects_result = false;
  picture.endings = {".png"};
}

void write_repair_picture(const Mesh& input, const RepairResult& result, const std::string& file,
                          Run& run) {
  ChangePictureOptions options;
  options.is_lost = faces_off(input, result.mesh);
  options.is_new = faces_off(result.mesh, input);
  run.out().write(file, write_png(draw_change(input, result.mesh, options)));
}

#else

void declare_repair_picture(Program& /*program*/, std::string& /*file*/) {}
void write_repair_picture(const Mesh& /*input*/, const RepairResult& /*result*/,
                          const std::string& /*file*/, Run& /*run*/) {}

#endif

}  // namespace transformesh::tool
