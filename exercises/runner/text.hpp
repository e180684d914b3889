#pragma once
// Small things about text and files that several parts of the runner need.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace carom::runner {

namespace fs = std::filesystem;

/// The end of the runner with a message for the user and one of the exit codes below.
struct Failure {
  int exitCode;
  std::string message;
};

/// Exit codes of `course`.
enum Exit { pass = 0, checkFailed = 1, doesNotCompile = 2, stopped = 3, usage = 4, ourFault = 70 };

/// Whole content of a file. \throws Failure (ourFault) naming the file
std::string readFile(const fs::path& path);
/// The same, or nothing where there is no such file.
std::optional<std::string> readIfThere(const fs::path& path);
/// Writes beside the target first and renames, so that nobody ever sees half a file.
void writeFile(const fs::path& path, std::string_view content);

std::vector<std::string> splitLines(std::string_view text);
std::string trimmed(std::string_view text);
std::vector<std::string> words(std::string_view text);
/// Breaks a paragraph into lines of at most `width` characters, each beginning with `indent`.
std::string wrapped(std::string_view text, std::size_t width, std::string_view indent);
/// The same in ASCII, in words that a screen reader reads as they are meant: m^2 for m², omega for its letter.
std::string spoken(std::string_view text);
/// The first character of a text in UTF-8, and of how many bytes it is made; 0 and one byte where it is none.
/// \param text not empty
/// \param length becomes the number of its bytes
char32_t nextCharacter(std::string_view text, std::size_t& length);
/// Characters that nobody sees, or that turn the direction of what follows.
bool unseen(char32_t c);
/// The text of somebody else, for a terminal or a report: bytes that are no UTF-8, and characters that nobody sees or
/// that steer a terminal, become question marks; ends of lines and tabs stay.
std::string printable(std::string_view text);
/// FNV-1a, as hexadecimal text: tells whether a file has changed since.
std::string hashOf(std::string_view text);

}  // namespace carom::runner
