#pragma once
// Which questions of which scenes are engines compared by?
//
// A problem is a scene whose answer is known, and the moments at which it is asked for. Between two
// moments an engine may go as it likes: in one step, in a thousand, or in steps of its own choice.
// So the moments belong to the problem and not to the engine, and every engine pays for being read
// at each of them. Where a scene is shown as a film (30 moments a second) that is a problem of its
// own beside the one that asks for a few moments only.
//
// Not handled: scenes that are chaotic, beyond the time at which their answer means something. Of
// the gas that is the third second: an error of 1e-16 has become 1e-9 after the fourth.

#include <functional>
#include <string>
#include <vector>

#include "scenes/scene.hpp"

namespace carom::scenes {

/// A figure of a scene that is an error.
struct Question {
  std::string figure;     ///< its name, as the judge says it
  std::string axis;       ///< its name for people, with the unit
  Real rounding = 1e-13;  ///< what rounding makes of the answer: smaller errors count as this
  Real wanted = 1;        ///< times that others should be dearer at equal error
  bool length = false;    ///< whether a tolerance of positions and orientations speaks of it
};

/// A scene with an answer, and what is asked.
struct Problem {
  std::string name;                 ///< one word: the scene's, and how it is looked at
  std::string title;                ///< for people
  std::function<Scene()> make;      ///< the scene; its lookEvery says at which moments
  std::vector<Question> questions;  ///< one diagram for each
  std::string condition = {};  ///< a figure that must be 1, or the run has failed; may be empty
};

/// All problems, in the order of the letters of their scenes.
std::vector<Problem> allProblems();

}  // namespace carom::scenes
