#include "advice.h"

#include <pybind11/pybind11.h>

namespace transformesh::python {

namespace py = pybind11;

std::string advice_for(ErrorKind kind) {
  const py::dict table = py::module_::import("transformesh._advice").attr("advice");
  return py::cast<std::string>(table.attr("get")(name_of(kind), ""));
}

std::string with_advice(const Problem& problem) {
  const std::string advice = advice_for(problem.kind);
  return advice.empty() ? problem.sentence : problem.sentence + "; " + advice;
}

std::vector<std::string> with_advice(const std::vector<Problem>& problems) {
  std::vector<std::string> lines;
  for (const Problem& problem : problems) lines.push_back(with_advice(problem));
  return lines;
}

}  // namespace transformesh::python
