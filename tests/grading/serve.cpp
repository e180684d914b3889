// The program that holds a submission and answers the grader's questions.
//
// It knows no expected values and no Catch2: calls come in on file descriptor 3, answers go out on 4, each as
// a length and so many bytes. It ends when the pipe closes.

#include <unistd.h>
#include <cfenv>
#include <cstdio>
#include <cstdlib>

#ifdef __SSE2__
#include <immintrin.h>
#endif

#include "grading/pipe_end.hpp"

namespace carom::grading {

std::map<std::string, Handler>& handlers() {
  static std::map<std::string, Handler> all;
  return all;
}

namespace {

// A grader that has gone has no more questions.
class Grader : public PipeEnd {
  [[noreturn]] void gone(bool) override {
    _exit(0);
  }
};

std::string exceptionMessage(Message kind, const char* text) {
  Writer w;
  w.put(kind);
  w.put(std::string(text).substr(0, 2000));
  return w.bytes;
}

// Flags down, rounding to nearest, denormal numbers kept: the arithmetic that a program starts with.
void sameArithmetic() {
  std::fesetenv(FE_DFL_ENV);
#ifdef __SSE2__
  _mm_setcsr(0x1f80);
#endif
}

std::string answer(const std::string& question, Channel& channel) {
  Reader r{question};
  r.take<Message>();
  const auto handler = handlers().find(r.take<std::string>());
  if (handler == handlers().end()) return exceptionMessage(Message::threw, "no such function");
  // Whatever the last call left behind.
  sameArithmetic();
  try {
    return handler->second(r, channel);
  } catch (const NotAttempted& e) {
    return exceptionMessage(Message::notAttempted, e.what());
  } catch (const InvalidInput& e) {
    return exceptionMessage(Message::invalidInput, e.what());
  } catch (const std::exception& e) {
    return exceptionMessage(Message::threw, e.what());
  } catch (...) {
    return exceptionMessage(Message::threw, "an object that is not a std::exception");
  }
}

}  // namespace
}  // namespace carom::grading

int main() {
  carom::grading::Grader channel;
  for (;;) channel.send(carom::grading::answer(channel.receive(), channel));
}
