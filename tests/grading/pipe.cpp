// The grader's end of the pipe: starts the program that holds the submission, asks, and waits no longer than allowed.

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>

#include "grading/sandbox.hpp"
#include "grading/seam.hpp"

namespace carom::grading {

namespace {

// An answer larger than this is an attack on the grader's memory, not an answer.
constexpr std::uint32_t kLargestAnswer = 64u << 20;

// How much of the conversation is asked a second time at the end.
constexpr std::size_t kAskedAgain = 32;
constexpr std::size_t kKeptBytes = 1u << 20;

int fromEnvironment(const char* name, int otherwise) {
  const char* text = std::getenv(name);
  return text ? std::atoi(text) : otherwise;
}

class Child : public Channel {
 public:
  Child() {
    const char* program = std::getenv("CAROM_CHILD");
    if (!program)
      throw std::runtime_error("CAROM_CHILD does not name the program that holds the submission");
    int question[2];
    int answer[2];
    if (pipe2(question, O_CLOEXEC) != 0 || pipe2(answer, O_CLOEXEC) != 0)
      throw std::runtime_error("no pipe");
    // Confined, if whoever called us has decided how; otherwise with limits and the lock alone.
    const char* text = std::getenv("CAROM_CONFINED");
    Command command;
    if (text) {
      command = fromText(text);
    } else {
      command.words = {program};
      command.shutIn = true;
    }
    enclosed_ = command.enclosure.any;
    std::vector<char*> words;
    for (const auto& word : command.words) words.push_back(const_cast<char*>(word.c_str()));
    words.push_back(nullptr);
    char* const environment[] = {nullptr};
    Limits limits = command.limits;
    limits.cpuSeconds = fromEnvironment("CAROM_CPU_S", 5);
    limits.memoryMegabytes = fromEnvironment("CAROM_MEM_MB", 1024);
    limits.fileKilobytes = 1;
    wallSeconds_ = fromEnvironment("CAROM_WALL_S", 3);
    signal(SIGPIPE, SIG_IGN);
    // What the grader expects stands in its memory: nobody else of this user may look there.
#if !defined(__SANITIZE_ADDRESS__)  // whose leak check looks at itself in the same way
    prctl(PR_SET_DUMPABLE, 0, 0, 0, 0);
#endif
    const int filter = command.filtered ? filterFile() : -1;
    const pid_t self = getpid();
    pid_ = fork();
    if (filter >= 0 && pid_ != 0) close(filter);
    if (pid_ < 0) throw std::runtime_error("no process");
    if (pid_ == 0) {
      setsid();
      // The question pipe may itself sit on 3 or 4: move both ends out of the way first.
      const int in = fcntl(question[0], F_DUPFD, 10);
      const int out = fcntl(answer[1], F_DUPFD, 10);
      const int rules = filter >= 0 ? fcntl(filter, F_DUPFD, 10) : -1;
      const int nothing = open("/dev/null", O_RDWR);
      dup2(nothing, 0);
      dup2(nothing, 1);
      dup2(nothing, 2);
      dup2(in, 3);
      dup2(out, 4);
      if (filter >= 0) dup2(rules, 5);
      closeFrom(filter >= 0 ? 6 : 5);
      applyLimits(limits);
      // No child outlives a grader that was killed.
      prctl(PR_SET_PDEATHSIG, SIGKILL, 0, 0, 0);
      if (getppid() != self || !enter(command.enclosure)) _exit(127);
      if (command.shutIn) {
        // Opened before the rights go: root without them cannot enter the folders of other users.
        const int file = open(words[0], O_RDONLY | O_CLOEXEC);
        enterSandbox();
        syscall(SYS_execveat, file, "", words.data(), environment, AT_EMPTY_PATH);
      } else {
        execve(words[0], words.data(), environment);
      }
      _exit(127);
    }
    close(question[0]);
    close(answer[1]);
    to_ = question[1];
    from_ = answer[0];
  }

  ~Child() override {
    if (pid_ > 0) stop(0);
  }

  void send(const std::string& bytes) override {
    if (!stopped_.empty()) throw SubmissionStopped(stopped_);
    const bool call = !bytes.empty() && bytes[0] == static_cast<char>(Message::call);
    question_ = call ? bytes : std::string();
    const auto size = static_cast<std::uint32_t>(bytes.size());
    std::string all(reinterpret_cast<const char*>(&size), sizeof size);
    all += bytes;
    deadline_ = Clock::now() + std::chrono::seconds(wallSeconds_);
    // Both pipes are served together, or two large messages could wait for each other for ever.
    fcntl(to_, F_SETFL, O_NONBLOCK);
    for (std::size_t done = 0; done < all.size();) {
      waitFor(to_, POLLOUT);
      const ssize_t put = write(to_, all.data() + done, all.size() - done);
      if (put < 0) {
        if (errno == EAGAIN) continue;
        fail();
      }
      done += static_cast<std::size_t>(put);
    }
  }

  std::string receive() override {
    std::uint32_t size = 0;
    readAll(reinterpret_cast<char*>(&size), sizeof size);
    if (size > kLargestAnswer) fail("answered with more than 64 MB");
    std::string bytes;
    // Grow with what really arrives: an announced size costs nothing.
    char buffer[1 << 16];
    while (bytes.size() < size) {
      const std::size_t want = std::min<std::size_t>(size - bytes.size(), sizeof buffer);
      readAll(buffer, want);
      bytes.append(buffer, want);
    }
    const bool result = !bytes.empty() && bytes[0] == static_cast<char>(Message::result);
    if (result && !question_.empty() && !askingAgain_) {
      kept_ += question_.size() + bytes.size();
      conversation_.emplace_back(std::move(question_), bytes);
      while (conversation_.size() > kAskedAgain || (kept_ > kKeptBytes && !conversation_.empty())) {
        kept_ -= conversation_.front().first.size() + conversation_.front().second.size();
        conversation_.erase(conversation_.begin());
      }
    }
    return bytes;
  }

  /// Asks the last questions again, in the opposite order. An answer that was counted out, remembered by its number
  /// or read from memory that was never set differs the second time.
  bool answersAlike() {
    askingAgain_ = true;
    const auto begin = Clock::now();
    for (auto pair = conversation_.rbegin(); pair != conversation_.rend(); ++pair) {
      send(pair->first);
      if (receive() != pair->second) return false;
      if (Clock::now() - begin > std::chrono::seconds(1)) break;
    }
    return true;
  }

 private:
  using Clock = std::chrono::steady_clock;

  void waitFor(int fd, short what) {
    for (;;) {
      const auto left =
          std::chrono::duration_cast<std::chrono::milliseconds>(deadline_ - Clock::now()).count();
      if (left <= 0) fail("did not answer within " + std::to_string(wallSeconds_) + " s");
      pollfd watched{fd, what, 0};
      const int ready = poll(&watched, 1, static_cast<int>(left));
      if (ready > 0) return;
      if (ready < 0 && errno != EINTR) fail();
    }
  }

  void readAll(char* data, std::size_t size) {
    while (size > 0) {
      waitFor(from_, POLLIN);
      const ssize_t got = read(from_, data, size);
      if (got <= 0) fail();
      data += got;
      size -= static_cast<std::size_t>(got);
    }
  }

  /// \param patience milliseconds for a child that is about to end by itself to leave its own exit status
  int stop(int patience) {
    close(to_);
    int status = 0;
    bool ended = false;
    for (int i = 0; i < patience && !ended; ++i) {
      ended = waitpid(pid_, &status, WNOHANG) == pid_;
      if (!ended) usleep(1000);
    }
    killGroup(pid_);
    if (!ended) waitpid(pid_, &status, 0);
    pid_ = -1;
    // As long as somebody holds the other end of the pipe, somebody of the group is left.
    char rest[1 << 12];
    fcntl(from_, F_SETFL, O_NONBLOCK);
    for (int i = 0; i < 1000; ++i) {
      const ssize_t got = read(from_, rest, sizeof rest);
      if (got == 0) break;
      if (got < 0) usleep(1000);
    }
    close(from_);
    return enclosed_ ? endInside(status) : status;
  }

  [[noreturn]] void fail(std::string reason = "") {
    const int status = stop(50);
    stopped_ = !reason.empty() ? reason : describeEnd(status) + " instead of answering";
    throw SubmissionStopped(stopped_);
  }

  pid_t pid_ = -1;
  bool enclosed_ = false;
  int to_ = -1;
  int from_ = -1;
  int wallSeconds_ = 3;
  Clock::time_point deadline_{};
  std::string stopped_;
  std::string question_;  // the call that is under way, while it has not called back
  std::vector<std::pair<std::string, std::string>> conversation_;
  std::size_t kept_ = 0;
  bool askingAgain_ = false;
};

Child* started = nullptr;

}  // namespace

Channel& submission() {
  static Child child;
  started = &child;
  return child;
}

std::optional<Lazy> lazyMode() {
  static const char* const mode = std::getenv("CAROM_LAZY");
  if (!mode) return std::nullopt;
  const std::string_view text = mode;
  return text == "one" ? Lazy::one : text == "echo" ? Lazy::echo : Lazy::zero;
}

bool answersAlike() {
  return !started || started->answersAlike();
}

}  // namespace carom::grading
