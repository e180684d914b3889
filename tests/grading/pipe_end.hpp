#pragma once
// The end of the pipe of a program that was started with one: messages come in on file descriptor 3
// and go out on 4, each as a length and so many bytes.

#include <unistd.h>

#include <cerrno>

#include "grading/seam.hpp"

namespace carom::grading {

/// Sends and receives; what to do when nobody is there any more is for those who have such an end.
class PipeEnd : public Channel {
 public:
  void send(const std::string& bytes) override {
    const auto size = static_cast<std::uint32_t>(bytes.size());
    std::string all(reinterpret_cast<const char*>(&size), sizeof size);
    all += bytes;
    for (std::size_t done = 0; done < all.size();) {
      const ssize_t put = write(4, all.data() + done, all.size() - done);
      if (put <= 0) gone(true);
      done += static_cast<std::size_t>(put);
    }
  }
  std::string receive() override {
    std::uint32_t size = 0;
    readAll(reinterpret_cast<char*>(&size), sizeof size);
    std::string bytes(size, '\0');
    readAll(bytes.data(), size);
    return bytes;
  }

 protected:
  /// The other end has closed the pipe. Does not return. \param sending or receiving
  [[noreturn]] virtual void gone(bool sending) = 0;

 private:
  void readAll(char* data, std::size_t size) {
    while (size > 0) {
      const ssize_t got = read(3, data, size);
      if (got < 0 && errno == EINTR) continue;
      if (got <= 0) gone(false);
      data += got;
      size -= static_cast<std::size_t>(got);
    }
  }
};

}  // namespace carom::grading
