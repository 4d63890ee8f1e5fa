// What the kinds of programs read, call and write.
#include <unistd.h>

#include "exit_code.h"
#include "implementation.h"
#include "tm/support/error.h"

namespace transformesh::tool {

int Program::filter(int argc, char** argv, const std::function<void(Document&, Run&)>& body) {
  const auto work = [&](Session& session, const std::vector<std::string>& inputs) {
    Document document = session.read_input(inputs[0], true);
    session.begin(&document);
    body(document, session);
    session.write_mesh(document, {});
    session.finish();
    return exit_done;
  };
  return implementation_->run(argc, argv, Kind{}, work);
}

int Program::source(int argc, char** argv, const std::function<Document(Run&)>& body) {
  const auto work = [&](Session& session, const std::vector<std::string>&) {
    session.begin(nullptr);
    Document document = body(session);
    const std::vector<std::string>* words = implementation_->words;
    session.write_mesh(document, words == nullptr ? std::vector<std::string>() : *words);
    session.finish();
    return exit_done;
  };
  return implementation_->run(argc, argv, Kind{.reads_mesh = false}, work);
}

int Program::combine(int argc, char** argv,
                     const std::function<Document(std::vector<Document>, Run&)>& body) {
  const auto work = [&](Session& session, const std::vector<std::string>& inputs) {
    std::vector<Document> documents = session.read_inputs(inputs, true);
    session.begin(documents.data());
    Document document = body(std::move(documents), session);
    session.write_mesh(document, {});
    session.finish();
    return exit_done;
  };
  return implementation_->run(argc, argv, Kind{.many_inputs = true}, work);
}

int Program::predicate(int argc, char** argv, const std::function<bool(Document&, Run&)>& body) {
  const Kind kind{.writes_mesh = false, .prints_report = true, .is_predicate = true};
  return implementation_->run_report(argc, argv, kind, body);
}

int Program::description(int argc, char** argv, const std::function<void(Document&, Run&)>& body) {
  const auto describe = [&](Document& document, Run& run) {
    body(document, run);
    return true;
  };
  const Kind kind{.writes_mesh = false, .prints_report = true};
  return implementation_->run_report(argc, argv, kind, describe);
}

int Program::Implementation::run_report(int argc, char** argv, const Kind& kind,
                                        const std::function<bool(Document&, Run&)>& body) {
  const auto work = [&](Session& session, const std::vector<std::string>& inputs) {
    Document document = session.read_input(inputs[0], false);
    session.begin(&document);
    const bool answer = body(document, session);
    session.write_report(common.json, only_key == nullptr ? "" : *only_key);
    session.finish();
    return answer ? exit_done : exit_no;
  };
  return run(argc, argv, kind, work);
}

int Program::Implementation::run_either(int argc, char** argv,
                                        const std::function<bool()>& is_predicate,
                                        const std::function<bool(Document&, Run&)>& body) {
  const auto work = [&](Session& session, const std::vector<std::string>& named) {
    if (common.json && !is_predicate()) {
      throw UsageError("--json needs a report on standard output");
    }
    Document document = session.read_input(named[0], !is_predicate());
    session.begin(&document);
    const bool answer = body(document, session);
    if (is_predicate()) session.write_report(common.json, "");
    if (!is_predicate() && answer) session.write_mesh(document, {});
    session.finish();
    return answer ? exit_done : exit_no;
  };
  return run(argc, argv, Kind{.prints_report = true, .is_predicate = true}, work);
}

int Program::filter_or_predicate(int argc, char** argv, const bool* is_predicate,
                                 const std::function<bool(Document&, Run&)>& body) {
  return implementation_->run_either(
      argc, argv, [=] { return *is_predicate; }, body);
}

int Program::predicate_or_filter(int argc, char** argv, const bool* is_filter,
                                 const std::function<bool(Document&, Run&)>& body) {
  return implementation_->run_either(
      argc, argv, [=] { return !*is_filter; }, body);
}

int Program::picture(int argc, char** argv,
                     const std::function<std::string(std::vector<Document>, Run&)>& body) {
  const auto work = [&](Session& session, const std::vector<std::string>& inputs) {
    if (implementation_->common.output == "-" && is_terminal(STDOUT_FILENO)) {
      throw UsageError("not writing a picture to a terminal: redirect it or name a file with -o");
    }
    std::vector<Document> documents = session.read_inputs(inputs, false);
    session.begin(documents.data());
    session.write_bytes(body(std::move(documents), session));
    session.finish();
    return exit_done;
  };
  return implementation_->run(argc, argv, Kind{.many_inputs = true, .writes_mesh = false}, work);
}

int Program::maker(int argc, char** argv,
                   const std::function<Document(const std::string&, Run&)>& body) {
  const auto work = [&](Session& session, const std::vector<std::string>& inputs) {
    session.begin(nullptr);
    Document document = body(inputs[0], session);
    session.write_mesh(document, {});
    session.finish();
    return exit_done;
  };
  return implementation_->run(argc, argv, Kind{.makes_mesh = true}, work);
}

int Program::converter(int argc, char** argv,
                       const std::function<std::string(const std::string&, Run&)>& body) {
  const auto work = [&](Session& session, const std::vector<std::string>& inputs) {
    session.begin(nullptr);
    session.write_bytes(body(inputs[0], session));
    session.finish();
    return exit_done;
  };
  return implementation_->run(argc, argv, Kind{.writes_mesh = false}, work);
}

}  // namespace transformesh::tool
