#pragma once
// What a grader writes: one line per question, with everything that a good failure message needs.
//
//   TEST_CASE("order") {
//     GRADE(hamiltonProduct(i, j), k, within(0, "products of 0 and 1 are exact"), given("q", i), given("r", j));
//   }
//
// The same compiled test runs in three settings: linked with the student's function (self-check), linked with a
// proxy that asks a submission through a pipe (grading), linked with the library's own function. It never holds
// or calls a reference solution: expected values come from closed forms, invariants and other roads.

#include <functional>
#include <string>
#include <vector>

#include "carom/core/errors.hpp"
#include "grading/random.hpp"
#include "grading/wire.hpp"
#include "support/catch.hpp"

namespace carom::grading {

/// How far an answer may be from what is expected, and why just so far.
struct Within {
  double absolute = 0;
  double relative = 0;  ///< of the largest number expected
  const char* why = "";
};

/// An absolute tolerance, in the unit of the answer.
inline Within within(double absolute, const char* why) {
  return {absolute, 0, why};
}
/// A tolerance relative to the largest number in what is expected.
inline Within withinRelative(double relative, const char* why) {
  return {0, relative, why};
}

/// A named input, shown when the answer is wrong.
struct Given {
  std::string name;
  std::string value;
};
template <class T>
Given given(const char* name, const T& value, const char* unit = "") {
  return {name, show(value) + (*unit ? std::string(" ") + unit : "")};
}

/// The unit of the answer.
struct Unit {
  const char* text;
};
inline Unit unit(const char* text) {
  return {text};
}

/// The answer may have the other sign as a whole: q and -q are one rotation, a principal axis has no direction.
struct UpToSign {};
inline UpToSign upToSign() {
  return {};
}

/// A sentence that says what the question is about, for answers whose call alone does not.
struct About {
  const char* text;
};
inline About about(const char* text) {
  return {text};
}

struct Question {
  std::string call;
  std::string file;
  int line = 0;
  std::vector<Given> given;
  std::string unit;
  std::string about;
  bool upToSign = false;

  void add(const Given& g) {
    given.push_back(g);
  }
  void add(const Unit& u) {
    unit = u.text;
  }
  void add(const UpToSign&) {
    upToSign = true;
  }
  void add(const About& a) {
    about = a.text;
  }
};

/// Notes the question in the report before it is asked, so that a crash can be told with its input.
void ask(const Question& question);
void passed();
void failed(const Question& question, const std::string& got, const std::string& expected,
            const std::string& tolerance, const std::string& why);
/// Reports a call that ended in an exception. Rethrows what is the grader's own fault.
void failedWith(const Question& question, const std::string& expected);

bool agree(const std::vector<double>& got, const std::vector<double>& expected,
           const Within& within, bool upToSign);
std::string showTolerance(const Within& within);

template <class F, class E, class... Extra>
void grade(const char* call, const char* file, int line, F&& function, const E& expected,
           const Within& within, const Extra&... extra) {
  using Answer = std::invoke_result_t<F>;
  Question question{.call = call, .file = file, .line = line, .given = {}, .unit = {}, .about = {}};
  (question.add(extra), ...);
  ask(question);
  try {
    const Answer got = function();
    std::vector<double> gotNumbers;
    std::vector<double> expectedNumbers;
    flatten(got, gotNumbers);
    const Answer wanted(expected);
    flatten(wanted, expectedNumbers);
    if (agree(gotNumbers, expectedNumbers, within, question.upToSign)) {
      passed();
    } else {
      failed(question, show(got), show(wanted), showTolerance(within), within.why);
    }
  } catch (...) {
    failedWith(question, show(Answer(expected)));
  }
}

template <class F, class... Extra>
void gradeRefusal(const char* call, const char* file, int line, F&& function,
                  const Extra&... extra) {
  Question question{.call = call, .file = file, .line = line, .given = {}, .unit = {}, .about = {}};
  (question.add(extra), ...);
  ask(question);
  try {
    failed(question, show(function()), "an InvalidInput exception", "", "");
  } catch (const InvalidInput&) {
    passed();
  } catch (...) {
    failedWith(question, "an InvalidInput exception");
  }
}

/// Writes an answer to the report, to be compared with what known-wrong versions answer.
void probeNumbers(const std::vector<double>& numbers);

template <class F>
void probe(F&& function) {
  std::vector<double> numbers;
  try {
    flatten(function(), numbers);
  } catch (const InvalidInput&) {
    numbers = {std::nan("")};
  }
  probeNumbers(numbers);
}

/// The seed of this run's random inputs: fixed for self-checks, the student's own when graded.
std::uint64_t seed();

/// A number that a student wrote into an answer file: `name = value unit`. Blank answers are "not attempted".
/// \throws NotAttempted, InvalidInput (no number, or another unit)
Real predicted(const char* name, const char* unit);

}  // namespace carom::grading

// The call is evaluated inside, so that an exception is reported like any other wrong answer.
#define GRADE(call, ...)   \
  ::carom::grading::grade( \
      #call, __FILE__, __LINE__, [&] { return call; }, __VA_ARGS__)
// The call must throw InvalidInput.
#define GRADE_REFUSES(call, ...)                            \
  ::carom::grading::gradeRefusal(#call, __FILE__, __LINE__, \
                                 [&] { return call; } __VA_OPT__(, ) __VA_ARGS__)
// Inputs on which known-wrong versions answer differently; run by the runner, not scored.
#define PROBES() TEST_CASE("probes", "[.][probes]")
#define PROBE(call) ::carom::grading::probe([&] { return call; })
