#pragma once
// Scenes of contacts for the graders of chapter 8: who can be reached from whom, by trying every
// body as a stop on the way.

#include <cstdint>
#include <vector>

#include "carom/broadphase/index_pair.hpp"
#include "grading/fields_broadphase.hpp"
#include "grading/grade.hpp"

namespace carom::grading {

using Contacts = std::vector<IndexPair>;
using Flags = std::vector<std::uint8_t>;
using Numbers = std::vector<std::int32_t>;

/// reached[a][b]: a way of contacts leads from a to b over bodies that can be moved.
inline std::vector<Flags> reachable(const Contacts& contacts, const Flags& movable) {
  const std::size_t count = movable.size();
  std::vector<Flags> reached(count, Flags(count, 0));
  for (std::size_t i = 0; i < count; ++i) reached[i][i] = movable[i];
  for (const IndexPair& contact : contacts) {
    if (movable[contact.first] == 0 || movable[contact.second] == 0) continue;
    reached[contact.first][contact.second] = reached[contact.second][contact.first] = 1;
  }
  for (std::size_t stop = 0; stop < count; ++stop) {
    for (std::size_t a = 0; a < count; ++a) {
      for (std::size_t b = 0; b < count; ++b) {
        if (reached[a][stop] != 0 && reached[stop][b] != 0) reached[a][b] = 1;
      }
    }
  }
  return reached;
}

/// Bodies with about as many contacts as bodies; one in `immovable` is moved by nothing.
struct ContactScene {
  Contacts contacts;
  Flags movable;
};

inline ContactScene anyContacts(Random& random, int count, int contacts, int immovable) {
  ContactScene scene;
  for (int i = 0; i < count; ++i) {
    scene.movable.push_back(random.integer(1, immovable) == 1 ? 0 : 1);
  }
  while (static_cast<int>(scene.contacts.size()) < contacts) {
    const int a = random.integer(0, count - 1);
    const int b = random.integer(0, count - 1);
    if (a != b) scene.contacts.push_back(pairOf(a, b));
  }
  return scene;
}

}  // namespace carom::grading
