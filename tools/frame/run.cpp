#include "frame/run.h"

#include "frame/observer.h"
#include "transformesh/errors.h"

namespace transformesh::tool {

Run::Run(Program& program, Terminal& terminal)
    : program_(program),
      messages_(program, terminal),
      in_(program, messages_, phases_),
      out_(program, in_, messages_),
      report_(program, in_, messages_),
      progress_([this, &terminal](std::string_view phase, double fraction) {
        report_.show_settings();
        phases_.begin(phase);
        if (!program_.is_evolution()) terminal.progress(phase, fraction);
        return may_continue(phase, fraction);
      }) {}

std::string Run::version() { return TM_VERSION; }

void Run::start() {
  const CommonValues& values = program_.common;
  out_.check_name();
  if (values.json && program_.writes_mesh())
    throw UsageError(
        "--json needs standard output, where the mesh is written: give --report FILE instead");
  if (program_.is_evolution()) {
    if (program_.writes_mesh()) out_.set_style(document());
    return;
  }
  out_.check_files();
  if (program_.reads_mesh()) read_input();
  if (program_.input.soups == Soups::joined) report("joined_vertices", in_.joined_vertices());
}

Document& Run::read_input() {
  in_.read_all();
  for (Document& document : in_.documents()) {
    if (program_.is_evolution()) {
      document.style.format = Format::ply_little;
    } else if (program_.writes_mesh()) {
      out_.set_style(document);
    }
  }
  in_.refer_to_mesh();
  return document();
}

Document& Run::continue_from(Document document) {
  in_.continue_from(std::move(document));
  out_.set_stamped();
  return in_.document();
}

int Run::finish() {
  in_.end_reading();
  const bool prints_report = program_.may_print_report() && !program_.writes_mesh();
  if (prints_report) out_.set_bytes(report_.text());
  phases_.begin(out_.has_main() ? "write" : "");
  out_.stage_all();
  phases_.begin("");
  report_.show_settings();
  if (!prints_report) report_.show_entries();
  if (const std::string& path = program_.common.report; !path.empty())
    out_.stage(path, report_.full(out_.counts(), phases_));
  out_.commit();
  return answer_ ? exit_done : exit_no;
}

}  // namespace transformesh::tool
