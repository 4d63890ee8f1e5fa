#include "frame/run.h"

#include <doctest/doctest.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <nlohmann/json.hpp>

#include "helpers/temporary_folder.h"
#include "transformesh/errors.h"
#include "transformesh/mesh_io.h"

using namespace transformesh;
using namespace transformesh::test;
using namespace transformesh::tool;

namespace {

constexpr const char* triangle =
    "ply\nformat ascii 1.0\ncomment by hand\nelement vertex 3\nproperty float x\n"
    "property float y\nproperty float z\nelement face 1\n"
    "property list uchar int vertex_indices\nend_header\n0 0 0\n3 0 0\n0 4 0\n3 0 1 2\n";

// A folder with t.ply, in which programs run. Each has its own process, because it ends the
// process.
class Place {
 public:
  Place() { make_file(folder_ / "t.ply", triangle); }

  int run(Reads reads, Writes writes, std::vector<std::string> arguments,
          const std::function<void(Run&)>& body,
          const std::function<void(Program&)>& declare = {}) {
    // without a flush, the child would also write the buffered output of the tests
    std::fflush(nullptr);
    const pid_t child = fork();
    if (child == 0) {
      if (chdir((folder_ / ".").c_str()) != 0) _exit(99);
      dup2(open("stdout", O_WRONLY | O_CREAT | O_TRUNC, 0600), STDOUT_FILENO);
      dup2(open("stderr", O_WRONLY | O_CREAT | O_TRUNC, 0600), STDERR_FILENO);
      Program program{"tm-x", "[INPUT]", "Tests", {reads}, {writes}};
      if (declare) declare(program);
      std::string name = "tm-x";
      std::vector<char*> words{name.data()};
      for (std::string& argument : arguments) words.push_back(argument.data());
      _exit(program.run(static_cast<int>(words.size()), words.data(), body));
    }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  int evolve(const std::vector<std::string>& arguments, const std::function<void(Run&)>& body) {
    return run(Reads::file, Writes::evolved_mesh, arguments, body, [](Program& program) {
      program.reference_edge();
      program.options.output_file("csv", &csv_, "lines");
    });
  }

  std::string text(const std::string& name) const { return content_of(folder_ / name); }
  bool has(const std::string& name) const { return std::filesystem::exists(folder_ / name); }
  Document mesh(const std::string& name) const { return read_mesh(text(name), name).document; }
  std::string errors() const { return text("stderr"); }

 private:
  static inline std::string csv_;
  TemporaryFolder folder_;
};

void move_up(Document& document) {
  for (Vec3& position : document.mesh.positions) position.z() += 1;
}

}  // namespace

TEST_CASE("a filter changes the mesh read and keeps the rest") {
  Place place;
  CHECK(place.run(Reads::mesh, Writes::mesh, {"t.ply", "-o", "out.ply", "--no-provenance"},
                  [](Run& run) { move_up(run.document()); }) == 0);
  const std::string out = place.text("out.ply");
  CHECK(out == std::string(triangle).replace(std::string(triangle).find("0 0 0\n3"), 30,
                                             "0 0 1\n3 0 1\n0 4 1\n3 0 1 2\n"));
}

TEST_CASE("a negative answer is exit code 1, and suppresses the output if requested") {
  Place place;
  CHECK(place.run(Reads::mesh, Writes::answer, {"t.ply"}, [](Run& run) {
    run.report("vertices", run.document().mesh.positions.size());
    run.answer(false);
  }) == 1);
  CHECK(place.text("stdout") == "vertices: 3\n");
  CHECK(place.run(Reads::mesh, Writes::mesh, {"t.ply", "-o", "out.ply"},
                  [](Run& run) { run.out().write_nothing(); }) == 0);
  CHECK_FALSE(place.has("out.ply"));
}

TEST_CASE("a missing input is reported with its purpose") {
  Place place;
  static std::string target;
  const auto run = [&place](const std::vector<std::string>& arguments) {
    return place.run(
        Reads::nothing, Writes::text, arguments, [](Run&) {},
        [](Program& program) {
          program.options.text("target", &target, "FILE", "mesh to move towards").is_needed = true;
        });
  };
  CHECK(run({}) == 2);
  CHECK(place.errors() == "tm-x: --target FILE is needed: mesh to move towards\n");
  CHECK(run({"--target", "t.ply"}) == 0);
}

TEST_CASE("an evolution's meshes all have the comments that the output has, once") {
  Place place;
  const auto body = [](Run& run) {
    Document& document = run.read_input();
    run.out().stamp(document);
    write_file("frame.ply", write_mesh(document).bytes);
    move_up(document);
    run.report("converged", true);
    run.out().when_written(
        [] { make_file("after", std::filesystem::exists("out.ply") ? "yes" : "no"); });
  };
  CHECK(place.evolve({"t.ply", "-o", "out.ply", "--report", "r.json", "--reference-edge", "auto"},
                     body) == 0);
  const std::vector<std::string> comments = place.mesh("out.ply").style.comments;
  CHECK(comments == std::vector<std::string>{"by hand", "tm:reference-edge 4", comments.back()});
  CHECK(comments.back().starts_with("tm-x "));
  CHECK(place.mesh("frame.ply").style.comments == comments);
  CHECK(place.mesh("out.ply").style.format == Format::ply_little);
  CHECK(place.mesh("out.ply").style.coordinate == Scalar::float32);
  CHECK(place.text("after") == "yes");
  const auto report = nlohmann::json::parse(place.text("r.json"));
  CHECK(report["input"]["vertices"] == 3);
  CHECK(report["options"]["reference_edge"] == "auto");
  CHECK(report["result"]["converged"] == true);
  CHECK(report.contains("peak_memory_bytes"));
}

TEST_CASE("a continued run keeps its comments and its reference edge") {
  Place place;
  const auto body = [](Run& run) {
    std::string text = triangle;
    text.replace(text.find("by hand"), 7, "tm:reference-edge 2");
    run.continue_from(read_mesh(text, "state").document);
    run.report("half", run.length({0.5, Length::Unit::reference_edge}));
  };
  CHECK(place.evolve({"t.ply", "-o", "out.ply", "--report", "r.json"}, body) == 0);
  CHECK(place.mesh("out.ply").style.comments == std::vector<std::string>{"tm:reference-edge 2"});
  CHECK(nlohmann::json::parse(place.text("r.json"))["result"]["half"] == 1);
}

TEST_CASE("a failure that leaves a state names it") {
  Place place;
  const auto body = [](Run& run) {
    move_up(run.read_input());
    run.out().keep("stopped in iteration 2", "the mesh of iteration 1");
    throw GoalError("no edge is left");
  };
  CHECK(place.evolve({"t.ply", "-o", "out.ply", "-q"}, body) == 4);
  CHECK(place.errors() ==
        "tm-x: stopped in iteration 2; 'out.ply' holds the mesh of iteration 1\n"
        "tm-x: no edge is left\n");
  CHECK(place.mesh("out.ply").mesh.positions[0].z() == 1);
  CHECK(place.evolve({"t.ply"}, body) == 4);
  CHECK(place.text("stdout").empty());
  CHECK(place.errors().find("tm-x: stopped in iteration 2; '-' is not written\n") !=
        std::string::npos);
}

TEST_CASE("outputs of one place and outputs that cannot be written are refused early") {
  Place place;
  const auto body = [](Run& run) {
    run.out().check_files();
    make_file("late", "");
  };
  CHECK(place.evolve({"t.ply", "-o", "out.ply", "--csv", "./out.ply"}, body) == 2);
  CHECK(place.errors() == "tm-x: --csv and --output have the same file: give each its own\n");
  CHECK(place.evolve({"t.ply", "-o", "out.ply", "--csv", "-"}, body) == 2);
  CHECK(place.evolve({"t.ply", "-o", "out.ply", "--csv", "./t.ply"}, body) == 2);
  CHECK(place.errors() ==
        "tm-x: './t.ply' is an input, which would be lost: name another output\n");
  CHECK(place.evolve({"t.ply", "-o", "none/out.ply"}, body) == 5);
  CHECK(place.errors() == "tm-x: cannot write 'none/out.ply': No such file or directory\n");
  CHECK_FALSE(place.has("late"));
  CHECK(place.evolve({"t.ply", "-o", "/dev/null", "--csv", "/dev/null"}, [](Run& run) {
    run.out().check_files();
    run.out().write_nothing();
  }) == 0);
}

TEST_CASE("a signal is reported with the advice to continue") {
  Place place;
  const auto body = [](Run& run) {
    report_interruption(run.program().name, run.out().name() == "-" ? "" : "; --resume continues");
    raise(SIGTERM);
  };
  CHECK(place.evolve({"t.ply", "-o", "out.ply"}, body) == 143);
  CHECK(place.errors() == "tm-x: interrupted by SIGTERM; --resume continues\n");
  CHECK(place.evolve({"t.ply"}, body) == 143);
  CHECK(place.errors() == "tm-x: interrupted by SIGTERM\n");
}
