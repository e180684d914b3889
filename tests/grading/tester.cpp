// The program that holds a student's own test cases (exercises of the kind `test`).
//
// The function that the cases call is not in this program: calls go out on file descriptor 4 and answers come back
// on 3, from a process that holds one version of it. So the very same program meets every version, right and wrong,
// and nothing in its memory, arguments or environment says which one it is talking to: it can only ask. What became
// of each case is printed, marked so that it can be told from what the cases print themselves.

#include <unistd.h>

#include <csignal>
#include <iostream>
#include <nlohmann/json.hpp>

#if CAROM_CATCH_MAJOR < 3
#define CATCH_CONFIG_EXTERNAL_INTERFACES
#endif
#include "carom/core/errors.hpp"
#include "grading/pipe_end.hpp"
#include "support/catch.hpp"
#include "support/catch_main.hpp"
#if CAROM_CATCH_MAJOR >= 3
#include <catch2/reporters/catch_reporter_event_listener.hpp>
#include <catch2/reporters/catch_reporter_registrars.hpp>
#endif

namespace carom::grading {

namespace {

using nlohmann::json;

// More failures than a reader wants to see; a loop of assertions must not fill the disk.
constexpr int kReportedFailures = 20;

// Begins a line of the report; the runner knows it too.
constexpr const char* kReportMark =
    "\x1f"
    "case ";

long calls = 0;
bool notAttempted = false;
bool functionMissing = false;

void report(const json& event) {
  const std::string text = "\n" + std::string(kReportMark) +
                           event.dump(-1, ' ', false, json::error_handler_t::replace) + "\n";
  std::cout << std::flush;
  if (write(1, text.data(), text.size()) < 0) return;  // nobody reads: nothing is lost
}

// The client's end. A version that does not answer is ended by its own limits, and the pipe with it.
class Function : public PipeEnd {
 public:
  void send(const std::string& bytes) override {
    ++calls;
    PipeEnd::send(bytes);
  }
  std::string receive() override {
    const std::string bytes = PipeEnd::receive();
    // Nothing that a case can help.
    functionMissing |= !bytes.empty() && bytes[0] == static_cast<char>(Message::notAttempted);
    return bytes;
  }

 private:
  [[noreturn]] void gone(bool sending) override {
    throw SubmissionStopped(sending ? "the function has stopped"
                                    : "the function crashed or never ended");
  }
};

#if CAROM_CATCH_MAJOR >= 3
using ListenerBase = Catch::EventListenerBase;
using Noted = void;
#else
using ListenerBase = Catch::TestEventListenerBase;
using Noted = bool;
#endif

class Listener : public ListenerBase {
 public:
  using ListenerBase::ListenerBase;

  void testCaseStarting(const Catch::TestCaseInfo& info) override {
    ListenerBase::testCaseStarting(info);
    name_ = std::string(info.name).substr(0, 200);
    callsBefore_ = calls;
  }

  Noted assertionEnded(const Catch::AssertionStats& stats) override {
    const auto& result = stats.assertionResult;
    if (!result.isOk() && ++failures_ <= kReportedFailures) {
      const auto place = result.getSourceInfo();
      report({{"event", "failed"},
              {"case", name_},
              {"asserted", cut(std::string(result.getExpressionInMacro()))},
              {"was", cut(std::string(result.getExpandedExpression()))},
              {"message", cut(std::string(result.getMessage()))},
              {"file", place.file},
              {"line", place.line}});
    }
    return Noted();
  }

  void testCaseEnded(const Catch::TestCaseStats& stats) override {
    report({{"event", "case"},
            {"name", name_},
            {"assertions", stats.totals.assertions.total()},
            {"failed", stats.totals.assertions.failed},
            {"calls", calls - callsBefore_}});
    ListenerBase::testCaseEnded(stats);
  }

 private:
  static std::string cut(const std::string& text) {
    return text.substr(0, 1000);
  }

  std::string name_;
  long callsBefore_ = 0;
  int failures_ = 0;
};

CATCH_REGISTER_LISTENER(Listener)

const bool hooked = [] {
  // A function that has crashed is told in words; the write that finds out must not end the program.
  std::signal(SIGPIPE, SIG_IGN);
  carom_test::afterTests = [](int exitCode) {
    report({{"event", "end"},
            {"exit", exitCode},
            {"not attempted", notAttempted},
            {"function missing", functionMissing}});
  };
  return true;
}();

}  // namespace

std::optional<Lazy> lazyMode() {
  return std::nullopt;
}

Channel& submission() {
  static Function function;
  return function;
}

}  // namespace carom::grading

CATCH_TRANSLATE_EXCEPTION(const carom::NotAttempted& e) {
  carom::grading::notAttempted = true;
  return e.what();
}
