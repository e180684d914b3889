#pragma once
// All scenes, by name.
//
// The letters A to M are those of the survey of engines that the project measures itself against
// (E2: E without walls); S, I and T are cases of its book of reference answers. Where the survey
// leaves a number open (seeds, grids, friction of the piles), it is fixed here.

#include <functional>
#include <string>
#include <vector>

#include "scenes/scene.hpp"

namespace carom::scenes {

/// A scene that can be made.
struct SceneEntry {
  std::string name;             ///< also the scene's
  std::function<Scene()> make;  ///< makes it: large ones are not kept
};

// --- One body with a closed form (one_body.cpp)

/// A: a ball falls from 5 m and bounces, e = 0.8, until it lies still.
Scene bounceScene();
/// B and M: a cube slides to rest, far from the origin if asked. \param x0 where it starts [m]
Scene slideScene(const std::string& name, Real x0);
/// C: a ball slides and begins to roll.
Scene rollScene();
/// F: a 1 x 2 x 3 box tumbles about its middle axis for 100 s.
Scene rotorScene();
/// I8: a block on a slope near the critical angle. \param beyond the critical angle by this [rad]
Scene inclineScene(const std::string& name, Real beyond);
/// I15: a ball with side spin runs along a parabola.
Scene masseScene();

// --- Bodies that turn about an edge (edges.cpp)

/// S7: a domino tips over its lower edge.
Scene dominoScene();
/// S10: a block rocks from one edge to the other.
Scene rockingScene();
/// I19: a square hits the floor with a corner and sticks.
Scene cornerScene();

/// N10: a spinning top precesses on its tip (top.cpp).
Scene topScene();

// --- Balls (balls.cpp)

/// I5: touching balls in a row, the first `moving` of which come in.
Scene cradleScene(const std::string& name, int moving);
/// S9: a small ball on a big one, dropped together. \param ratio of the masses
Scene twoBallsScene(const std::string& name, Real ratio);
/// T13: a heavy ball pushes a light one against a wall. \param power mass ratio 100^power
Scene breakScene(const std::string& name, int power);
/// S8: eight hard balls in a unit box.
Scene gasScene();
/// S2: 49 balls bounce without loss.
Scene bouncing49Scene();
/// S3: 216 balls fall on a floor. \param elastic e = 1 (energy) or e = 0 (penetration)
Scene balls216Scene(const std::string& name, bool elastic);
/// I13: a ball hits another off the line of their centres.
Scene obliqueScene();
/// D: 666 balls fall on a floor.
Scene drop666Scene();
/// E and E2: 666 elastic balls, in a room or free.
Scene elastic666Scene(const std::string& name, bool walls);
/// I14: balls on a pushed box.
Scene pushedBoxScene();

// --- Boxes and hulls in numbers (piles.cpp)

/// G and M: boxes on each other. \param count of boxes \param x0 where they stand [m]
Scene stackScene(const std::string& name, int count, Real x0);
/// H: a wall of boxes in the shape of a triangle. \param base boxes in its lowest row
Scene pyramidScene(const std::string& name, int base);
/// I: boxes of unlike masses on each other, the lowest first [kg].
Scene massRatioScene(const std::string& name, const std::vector<Real>& masses);
/// J: balls are shot at a thin wall. \param speed [m/s]
Scene bulletScene(const std::string& name, Real speed);
/// K: 5000 boxes lie on a floor. \param asleep may be put to sleep, and only then is timed
Scene fieldScene(const std::string& name, bool asleep);
/// L: 1000 polyhedra fall into a bin.
Scene hullPileScene();
/// P: three of the scenes that Box3D measures itself with (its shared/benchmarks.c), rebuilt from
/// their numbers: one wall of cubes with a base of 100.
Scene largePyramidScene();
/// P: 196 walls of cubes with a base of 10.
Scene manyPyramidsScene();
/// P: 5120 alike polyhedra fall into a heap; the corners are drawn by our own generator.
Scene convexPileScene();

// --- What stands, or just does not (stacks.cpp)

/// S1: ten cubes of a kilogram on each other for a thousand seconds.
Scene restingStackScene();
/// S4: a cube on one of a kilogram. \param ratio of the masses
Scene heavyOnLightScene(const std::string& name, Real ratio);
/// S5: two cards lean against each other. \param above the least friction on the floor by this
Scene cardHouseScene(const std::string& name, Real above);
/// S6: half a circle of stones. \param stones even \param part of the least thickness that stands
/// \param friction of two stones, and of a stone and the ground
Scene archScene(const std::string& name, int stones, Real part, Real friction);
/// S11: fifteen cubes in five rows that touch each other.
Scene smallPyramidScene();

// --- For growth and skipping (fields.cpp)

/// Bodies spread over a floor, all of which fall and come to rest. \param count of bodies
Scene spreadScene(int count);
/// Bodies in a heap. \param count of bodies
Scene pileScene(int count);
/// What a body of a quiet crowd does.
enum class Quiet { immovable, resting, flying, unturned, frictionless };
/// Ten bodies that collide in a room, beside a quiet crowd. \param kind what the others do
/// \param count of the others
Scene quietScene(Quiet kind, int count);
/// What it is called.
const char* nameOf(Quiet kind);

/// All scenes of the suite `scenes`, in the order of their letters.
std::vector<SceneEntry> allScenes();

}  // namespace carom::scenes
