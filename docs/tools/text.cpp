#include "text.hpp"

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>

namespace site {

std::string readFile(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) {
    std::cerr << path.string() << ": cannot be read\n";
    std::exit(1);
  }
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

void writeFile(const std::filesystem::path& path, const std::string& text) {
  if (std::filesystem::exists(path) && readFile(path) == text) {
    return;
  }
  std::filesystem::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << text;
}

std::vector<std::string> splitLines(const std::string& text) {
  std::vector<std::string> lines = split(text, '\n');
  if (!lines.empty() && lines.back().empty()) {
    lines.pop_back();
  }
  return lines;
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::size_t start = 0;
  for (std::size_t end = text.find(separator); end != std::string::npos;
       end = text.find(separator, start)) {
    parts.push_back(text.substr(start, end - start));
    start = end + 1;
  }
  parts.push_back(text.substr(start));
  return parts;
}

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string::npos) {
    return "";
  }
  return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

std::vector<std::vector<std::string>> readTable(const std::filesystem::path& path,
                                                std::size_t columns) {
  std::vector<std::vector<std::string>> rows;
  for (const std::string& line : splitLines(readFile(path))) {
    if (line.empty() || line.front() == '#') {
      continue;
    }
    rows.push_back(split(line, '\t'));
    if (rows.back().size() != columns) {
      std::cerr << path.string() << ": " << rows.back().size() << " columns instead of " << columns
                << ": " << line << '\n';
      std::exit(1);
    }
  }
  return rows;
}

Settings readSettings(const std::filesystem::path& path) {
  Settings settings;
  std::string section;
  for (const std::string& raw : splitLines(readFile(path))) {
    const std::string line = trimmed(raw);
    if (line.empty() || line.front() == '#') {
      continue;
    }
    if (line.front() == '[' && line.back() == ']') {
      section = line.substr(1, line.size() - 2);
      continue;
    }
    const std::size_t equals = line.find('=');
    if (equals != std::string::npos) {
      settings[section][trimmed(line.substr(0, equals))] = trimmed(line.substr(equals + 1));
    }
  }
  return settings;
}

std::string cellText(const std::string& text) {
  std::string out;
  bool formula = false;
  for (char c : text) {
    if (c == '$') {
      out += "\\f$";
      formula = !formula;
    } else if (formula) {
      out += c;
    } else if (c == '<') {
      out += "&lt;";
    } else if (c == '>') {
      out += "&gt;";
    } else if (c == '&') {
      out += "&amp;";
    } else if (c == '@' || c == '\\' || c == '#' || c == '%' || c == '*' || c == '_') {
      out += '\\';
      out += c;
    } else {
      out += c;
    }
  }
  return out;
}

std::string htmlText(const std::string& text) {
  std::string out;
  for (char c : text) {
    switch (c) {
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '&':
        out += "&amp;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

}  // namespace site
