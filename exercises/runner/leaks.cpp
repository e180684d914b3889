#include "runner/leaks.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <regex>

#include "runner/skeleton.hpp"

namespace carom::runner {

namespace {

constexpr std::size_t kShortest = 12;
constexpr std::size_t kCommon = 3;

bool isBlank(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

// Lines from which nothing of an answer can be learnt; blanks are gone.
bool saysNothing(const std::string& line) {
  static const std::regex nothing(
      R"(#include.*|using\w+=?.*|namespace.*|template<[\w,]*>|)"
      R"(for\((int|std::size_t|std::int32_t)\w+=[01];\w+<=?[\w.()]+;\+\+\w+\)\{?|)"
      R"(for\((const)?(auto|\w+)&?\w+:[\w.]+\)\{?|)"
      R"(while\((true|!\w+\.empty\(\))\)\{|switch\(\w+\)\{|case[\w:]+:|return\w+;|\+\+[\w.]+;|)"
      R"((const|constexpr)?[A-Za-z][\w:<>,]*(=(-?[\d.e+-]+|[\w:<>]+::Zero\(\)))?;|)"
      R"(struct\w+\{|(const)?[A-Za-z][\w:<>,&]*=|if\(\w+[<>=]=?\d+\)(continue;|break;|\{)?)");
  return std::regex_match(line, nothing);
}

// The exercise whose facts these are, and the facts without its last hint.
std::pair<std::string, std::string> withoutLastHint(std::string_view ini) {
  const std::string text(ini);
  static const std::regex given(R"((?:^|\n)id = (\S+))");
  std::smatch id;
  std::regex_search(text, id, given);
  const auto last = text.rfind("\n[hint.");
  return {id.empty() ? "" : id[1].str(), text.substr(0, last)};
}

}  // namespace

std::string withoutBlanks(std::string_view text, bool code) {
  std::string out;
  out.reserve(text.size());
  bool comment = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '\n') comment = false;
    if (code && c == '/' && i + 1 < text.size() && text[i + 1] == '/') comment = true;
    if (!comment && !isBlank(c)) out += c;
  }
  return out;
}

std::string textOfHtml(std::string_view html) {
  static const std::map<std::string_view, char> names = {
      {"lt", '<'},    {"gt", '>'},   {"amp", '&'},  {"quot", '"'},
      {"apos", '\''}, {"#39", '\''}, {"nbsp", ' '}, {"#160", ' '}};
  std::string out;
  out.reserve(html.size());
  for (std::size_t i = 0; i < html.size(); ++i) {
    if (html[i] == '<') {
      const auto end = html.find('>', i);
      if (end == std::string_view::npos) break;
      i = end;
    } else if (html[i] == '&') {
      const auto end = html.find(';', i);
      const auto name = end == std::string_view::npos || end - i > 8
                            ? names.end()
                            : names.find(html.substr(i + 1, end - i - 1));
      if (name == names.end()) {
        out += '&';
      } else {
        out += name->second;
        i = end;
      }
    } else {
      out += html[i];
    }
  }
  return out;
}

SecretLines::SecretLines(const fs::path& source, const std::vector<const Exercise*>& secret,
                         const std::vector<SourceText>& texts)
    : heads_(1 << 16) {
  for (const auto* e : secret) {
    const fs::path folder = source / "solutions" / e->chapter / e->name;
    const std::string answer = readFile(folder / e->fileName());
    const std::string skeleton = withoutBlanks(cutSkeleton(answer, e->fileName()), false);
    for (const auto& line : splitLines(answerOnly(answer, e->fileName()))) add(*e, line, skeleton);
    std::error_code none;
    for (const auto& file : fs::directory_iterator(folder / "right", none)) {
      for (const auto& line : splitLines(readFile(file.path()))) add(*e, line, skeleton);
    }
    if (!e->home.empty()) {
      const auto library = readIfThere(source / e->home / e->fileName());
      for (const auto& line : splitLines(library.value_or(""))) add(*e, line, skeleton);
    }
  }
  // What library and programs write again and again is no answer.
  std::vector<std::size_t> files(lines_.size());
  for (const auto& text : texts) {
    std::set<std::size_t> here;
    search(withoutBlanks(text.content, true), [&](std::size_t i, std::size_t) { here.insert(i); });
    for (const auto i : here) ++files[i];
  }
  for (auto& [head, secrets] : byHead_) {
    std::erase_if(secrets, [&](std::size_t i) { return files[i] >= kCommon; });
  }
  readAllowed(source / "solutions/ordinary_lines.tsv");
}

void SecretLines::add(const Exercise& exercise, std::string_view line,
                      const std::string& skeleton) {
  // An answer file of a prediction has its comments behind #, and its values are the answer.
  const std::string text = withoutBlanks(line, exercise.extension == ".cpp");
  if (text.size() < kShortest || skeleton.find(text) != std::string::npos || saysNothing(text))
    return;
  if (!known_.insert(exercise.id + " " + text).second) return;
  byHead_[text.substr(0, kShortest)].push_back(lines_.size());
  heads_[static_cast<unsigned char>(text[0]) << 8 | static_cast<unsigned char>(text[1])] = true;
  lines_.push_back({exercise.id, text});
}

void SecretLines::readAllowed(const fs::path& file) {
  int number = 0;
  for (const auto& line : splitLines(readIfThere(file).value_or(""))) {
    ++number;
    if (line.empty() || line.starts_with("#")) continue;
    const auto first = line.find('\t');
    const auto second = first == std::string::npos ? first : line.find('\t', first + 1);
    if (second == std::string::npos || trimmed(line.substr(second)).empty()) {
      problems_.push_back(file.filename().string() + ":" + std::to_string(number) +
                          ": a line is file, tab, line of code, tab, reason");
      continue;
    }
    const std::string text = withoutBlanks(line.substr(first + 1, second - first - 1), true);
    allowed_.insert({line.substr(0, first), text});
    allowedSomewhere_.insert(text);
  }
}

template <class Found>
void SecretLines::search(std::string_view text, Found found) const {
  std::string head;
  for (std::size_t i = 0; i + kShortest <= text.size(); ++i) {
    if (!heads_[static_cast<unsigned char>(text[i]) << 8 | static_cast<unsigned char>(text[i + 1])])
      continue;
    head.assign(text.substr(i, kShortest));
    const auto secrets = byHead_.find(head);
    if (secrets == byHead_.end()) continue;
    for (const auto s : secrets->second) {
      if (text.compare(i, lines_[s].text.size(), lines_[s].text) == 0) found(s, i);
    }
  }
}

std::vector<Leak> SecretLines::leaksIn(const std::string& path, std::string_view content) const {
  const bool facts = path.ends_with("/exercise.ini");
  const auto [own, hinted] =
      facts ? withoutLastHint(content) : std::pair<std::string, std::string>();
  std::vector<Leak> leaks;
  std::string text;
  std::vector<int> lineOf;  // of each character
  text.reserve(content.size());
  lineOf.reserve(content.size());
  int number = 1;
  std::size_t beforeHint = content.size();
  for (std::size_t i = 0; i < content.size(); ++i) {
    if (facts && i == hinted.size()) beforeHint = text.size();
    if (content[i] == '\n') ++number;
    if (isBlank(content[i])) continue;
    text += content[i];
    lineOf.push_back(number);
  }
  std::set<std::size_t> seen;
  search(text, [&, &own = own](std::size_t s, std::size_t at) {
    const auto& secret = lines_[s];
    if (at >= beforeHint && secret.exercise == own) return;
    if (allowed_.count({path, secret.text}) || !seen.insert(s).second) return;
    leaks.push_back({secret.exercise, path, lineOf[at], secret.text});
  });
  return leaks;
}

std::vector<Leak> SecretLines::leaksInSite(const std::string& path,
                                           std::string_view content) const {
  std::vector<Leak> leaks;
  std::set<std::size_t> seen;
  const bool html = path.ends_with(".html");
  search(withoutBlanks(html ? textOfHtml(content) : std::string(content), false),
         [&](std::size_t s, std::size_t) {
           if (allowedSomewhere_.count(lines_[s].text) || !seen.insert(s).second) return;
           leaks.push_back({lines_[s].exercise, path, 0, lines_[s].text});
         });
  return leaks;
}

}  // namespace carom::runner
