#include "runner/skeleton.hpp"

#include "runner/text.hpp"

namespace carom::runner {

namespace {

struct Cut {
  std::string skeleton;
  std::string answer;
  std::string only;
  int lines = 0;
};

Cut cut(std::string_view source, std::string_view fileName) {
  const std::string marker = fileName.ends_with(".txt") ? "##" : "//#";
  enum { outside, solution, stub } where = outside;
  Cut result;
  int number = 0;
  int stubLines = 0;
  auto wrongLine = [&](const std::string& what) -> Failure {
    return {ourFault, std::string(fileName) + ":" + std::to_string(number) + ": " + what};
  };
  for (const auto& line : splitLines(source)) {
    ++number;
    const std::string text = trimmed(line);
    if (!text.starts_with(marker)) {
      if (text.find(marker) != std::string::npos)
        throw wrongLine("a marker must stand alone on its line");
      if (where != stub) result.answer += line + "\n";
      if (where != solution) result.skeleton += line + "\n";
      if (where == solution) {
        result.only += text + "\n";
        if (!text.empty() && !text.starts_with("//")) ++result.lines;
      }
      if (where == stub) {
        ++stubLines;
        if (!text.empty() && !text.starts_with("//") && !text.starts_with("#")) {
          throw wrongLine("a stub line is a comment, or code behind " + marker + "|");
        }
      }
      continue;
    }
    const std::string keyword = trimmed(text.substr(marker.size()));
    if (keyword.starts_with("|")) {
      if (where != stub) throw wrongLine("stub code outside a stub");
      const auto bar = line.find(marker + "|") + marker.size() + 1;
      const std::string indent = line.substr(0, line.find(marker));
      std::string code = line.substr(bar);
      if (code.starts_with(" ")) code.erase(0, 1);
      result.skeleton += (code.empty() ? "" : indent + code) + "\n";
      ++stubLines;
    } else if (keyword == "solution") {
      if (where != outside) throw wrongLine("markers cannot be nested");
      where = solution;
    } else if (keyword == "stub") {
      if (where != solution) throw wrongLine("'stub' follows 'solution'");
      where = stub;
      stubLines = 0;
    } else if (keyword == "end") {
      if (where != stub) throw wrongLine("'end' follows 'stub'");
      if (stubLines == 0) throw wrongLine("the stub is empty");
      where = outside;
    } else {
      throw wrongLine("unknown marker '" + keyword + "'");
    }
  }
  if (where != outside) throw wrongLine("a region is not closed");
  if (result.lines == 0 && result.only.empty()) throw wrongLine("there is no region 'solution'");
  return result;
}

}  // namespace

std::string cutSkeleton(std::string_view source, std::string_view fileName) {
  return cut(source, fileName).skeleton;
}
std::string cutAnswer(std::string_view source, std::string_view fileName) {
  return cut(source, fileName).answer;
}
int answerLines(std::string_view source, std::string_view fileName) {
  return cut(source, fileName).lines;
}
std::string answerOnly(std::string_view source, std::string_view fileName) {
  return cut(source, fileName).only;
}

}  // namespace carom::runner
