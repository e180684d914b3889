// A confined command as text: the runner decides how the child is confined, the grader starts it.

#include <nlohmann/json.hpp>

#include "grading/sandbox.hpp"

namespace carom::grading {

using nlohmann::json;

std::string toText(const Command& command) {
  const Enclosure& e = command.enclosure;
  json places = json::array();
  for (const auto& p : e.places)
    places.push_back({static_cast<int>(p.kind), p.from, p.to, p.folder});
  return json{{"words", command.words},
              {"environment", command.environment},
              {"shut_in", command.shutIn},
              {"filtered", command.filtered},
              {"any", e.any},
              {"processes", command.limits.processes},
              {"nobody", e.nobody},
              {"namespaces", e.namespaces},
              {"user_namespace", e.userNamespace},
              {"base", e.base},
              {"directory", e.directory},
              {"places", places}}
      .dump();
}

Command fromText(const std::string& text) {
  const json from = json::parse(text);
  Command command;
  command.words = from.at("words").get<std::vector<std::string>>();
  command.environment = from.at("environment").get<std::vector<std::string>>();
  command.shutIn = from.at("shut_in");
  command.filtered = from.at("filtered");
  command.limits.processes = from.at("processes");
  Enclosure& e = command.enclosure;
  e.any = from.at("any");
  e.nobody = from.at("nobody");
  e.namespaces = from.at("namespaces");
  e.userNamespace = from.at("user_namespace");
  e.base = from.at("base");
  e.directory = from.at("directory");
  for (const auto& p : from.at("places"))
    e.places.push_back({.kind = static_cast<Place::Kind>(p.at(0).get<int>()),
                        .from = p.at(1),
                        .to = p.at(2),
                        .folder = p.at(3)});
  return command;
}

}  // namespace carom::grading
