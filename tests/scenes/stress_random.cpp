// Scenes at random.

#include <algorithm>
#include <cmath>
#include <memory>
#include <sstream>

#include "carom/core/random.hpp"
#include "carom/rotation/renormalize.hpp"
#include "carom/solver/soft_steps.hpp"
#include "carom/world/world.hpp"
#include "scenes/stress.hpp"
#include "support/random_shapes.hpp"

namespace carom::stress {

void Tally::add(const Tally& other) {
  scenes += other.scenes;
  bodies += other.bodies;
  steps += other.steps;
  contacts += other.contacts;
  impacts += other.impacts;
  searches += other.searches;
  refused += other.refused;
  gain = std::max(gain, other.gain);
  gainOfStep = std::max(gainOfStep, other.gainOfStep);
  depth = std::max(depth, other.depth);
}

namespace {

using namespace carom::world;

// Of the energy that a scene has, what its steps may add to it in all, and what one step may add to
// what those before have left.
constexpr Real kGain = 1e-6, kGainOfStep = 1e-3;

enum class Walls { planes, boxes, moving, sheet };
enum class Start { apart, overlapping, tower };

// Whether no idea is left out that keeps numbers right.
bool isExact(const WorldSettings& s) {
  return s.continuous && s.locateEvents && s.trapezoidal && s.exactRotation && s.gyroscopic &&
         s.projectPositions;
}

struct RandomScene {
  WorldSettings settings;
  Walls walls = Walls::planes;
  Start start = Start::apart;
  Real size = 1;                           // of its bodies [m]
  Real room = 3;                           // half of its edge [m]
  Real speed = 1;                          // of the fastest [m/s]
  Vector3 roomVelocity = Vector3::Zero();  // of walls that move [m/s]
  Real dt = 1.0 / 60;
  int steps = 10;
  std::vector<BodyDescription> bounds;  // walls
  std::vector<BodyDescription> bodies;
};

bool chance(Random& random, Real share) {
  return random.between(0, 1) < share;
}

// Zero, one or something between: the ends are what goes wrong.
Real coefficient(Random& random, Real most) {
  const int kind = random.integer(0, 3);
  const Real any = random.between(0, most);
  return kind == 0 ? 0 : kind == 1 ? most : any;
}

void flip(Random& random, bool& flag) {
  if (chance(random, 0.1)) flag = !flag;
}

WorldSettings anySettings(Random& random) {
  WorldSettings settings;
  const Real weight = random.between(0, 30);
  const int kind = random.integer(0, 5);
  if (kind == 0) settings.gravity = Vector3::Zero();
  if (kind == 1) settings.gravity = weight * random.direction();
  if (chance(random, 0.4)) return settings;
  if (chance(random, 0.1)) settings.pairFinding = PairFinding::allPairs;
  for (bool* flag : {&settings.warmStarting, &settings.sleeping, &settings.keepStill,
                     &settings.continuous, &settings.locateEvents, &settings.exactRotation,
                     &settings.gyroscopic, &settings.trapezoidal, &settings.projectPositions,
                     &settings.friction, &settings.restitution, &settings.directIslands}) {
    flip(random, *flag);
  }
  if (chance(random, 0.2)) settings.iterations = random.integer(1, 30);
  if (chance(random, 0.2)) settings.rowBudget = random.integer(0, 1000);
  if (chance(random, 0.2)) settings.eventContacts = random.integer(0, 16);
  if (chance(random, 0.1)) settings.pileContacts = random.integer(0, 12);
  if (chance(random, 0.1)) settings.pileBodies = random.integer(0, 6);
  if (chance(random, 0.2)) settings.directWork = random.integer(0, 1000);
  if (chance(random, 0.2)) settings.eventsPerBody = random.integer(1, 20);
  if (chance(random, 0.2)) settings.shortSteps = random.integer(1, 12);
  if (chance(random, 0.2)) settings.sleepTime = 0.05;
  if (chance(random, 0.1)) settings.contactMargin = 1e-4;
  return settings;
}

Quaternion anyOrientation(Random& random) {
  const Real w = random.between(-1, 1);
  const Vector3 v = random.vector(1);
  // Lying along the axes is what faces meet in.
  if (w > 0.3) return {};
  return renormalize(Quaternion{w, v.x() + 0.1, v.y(), v.z()});
}

ShapeDescription anyPart(Random& random, const Shape& shape) {
  ShapeDescription part;
  part.shape = shape;
  part.material.friction = coefficient(random, 2);
  part.material.restitution = coefficient(random, 1);
  part.density = std::pow(10, random.between(2, 4));
  return part;
}

BodyDescription wall(Random& random, const Shape& shape, const Vector3& position) {
  BodyDescription body;
  body.kind = BodyKind::immovable;
  body.position = position;
  body.shapes = {anyPart(random, shape)};
  return body;
}

void addWalls(Random& random, RandomScene& scene) {
  const bool boxes = scene.walls == Walls::boxes || scene.walls == Walls::moving;
  for (int axis = 0; axis < 3; ++axis) {
    for (const Real side : {-1.0, 1.0}) {
      Vector3 out = Vector3::Zero();
      out[axis] = side;
      if (scene.walls == Walls::sheet && axis == 2 && side < 0) {
        BodyDescription ground = wall(random, Ball{}, -scene.room * Vector3::UnitZ());
        ground.shapes[0].ground = std::make_shared<TriangleMesh>(
            carom_test::randomSheet(random, 2 * scene.room, 0.1 * scene.room));
        scene.bounds.push_back(ground);
        continue;
      }
      if (!boxes) {
        scene.bounds.push_back(
            wall(random, makeHalfSpace(-out, scene.room * out), Vector3::Zero()));
        continue;
      }
      // They overlap at the corners of the room, and leave no gap.
      Vector3 half = Vector3::Constant(2 * scene.room);
      half[axis] = scene.room / 2;
      BodyDescription body = wall(random, Box{half}, 1.5 * scene.room * out);
      if (scene.walls == Walls::moving) {
        body.kind = BodyKind::kinematic;
        body.velocity = scene.roomVelocity;
      }
      scene.bounds.push_back(body);
    }
  }
}

void addBodies(Random& random, RandomScene& scene) {
  const int count = random.integer(2, 12);
  constexpr int kCells = 3;
  const Real cell = 2 * scene.room / kCells;
  int places[kCells * kCells * kCells];
  for (int i = 0; i < kCells * kCells * kCells; ++i) places[i] = i;
  for (int i = kCells * kCells * kCells - 1; i > 0; --i) {
    std::swap(places[i], places[random.integer(0, i)]);
  }
  // Nobody else is put where the tower stands.
  if (scene.start == Start::tower) {
    std::stable_partition(places, places + kCells * kCells * kCells,
                          [](int at) { return at % 9 != 4; });
  }
  for (int i = 0; i < count; ++i) {
    BodyDescription body;
    const bool stands = scene.start == Start::tower && i < 6;
    Shape shape = carom_test::randomShape(random, scene.size);
    if (stands) shape = Box{Vector3::Constant(0.25 * scene.size)};
    body.shapes = {anyPart(random, shape)};
    if (!stands && chance(random, 0.1)) {
      body.shapes.push_back(anyPart(random, Ball{0.3 * scene.size}));
      body.shapes.back().pose.p_WB = random.vector(0.5 * scene.size);
    }
    const int at = places[i];
    body.position = cell * Vector3(at % kCells - 1, at / kCells % kCells - 1, at / 9 - 1);
    const Vector3 anywhere = random.vector(0.8 * (scene.room - 1.6 * scene.size));
    if (scene.start == Start::overlapping) body.position = anywhere;
    body.orientation = anyOrientation(random);
    const Real share = random.between(0, 1);
    body.velocity = share * scene.speed * random.direction();
    body.angularVelocity = random.vector(scene.speed / scene.size * random.between(0, 1));
    if (stands) {
      const Real floor = -scene.room + (scene.walls == Walls::sheet ? 0.1 * scene.room : 0);
      body.position = {0, 0, floor + (0.25 + 0.5 * i) * scene.size};
      body.orientation = {};
      body.velocity = body.angularVelocity = Vector3::Zero();
    }
    body.velocity += scene.roomVelocity;
    body.maySleep = !chance(random, 0.1);
    scene.bodies.push_back(body);
  }
}

RandomScene makeScene(std::uint64_t seed) {
  // Seeds in a row must not make streams that share their numbers.
  Random scramble(seed);
  Random random(scramble.bits());
  RandomScene scene;
  scene.settings = anySettings(random);
  const int walls = random.integer(0, 3);
  scene.walls = static_cast<Walls>(walls);
  // Who does not look inside the step passes through what has an end.
  if (!scene.settings.continuous) scene.walls = Walls::planes;
  const Real start = random.between(0, 1);
  scene.start = start < 0.65 ? Start::apart : start < 0.8 ? Start::overlapping : Start::tower;
  const Real scale = random.between(0, 1);
  scene.size = scale < 0.7 ? 0.5 : scale < 0.85 ? 0.01 : 20;
  // A body in its cell touches nothing: no point of it is farther than 1.6 sizes from its origin.
  scene.room = 3 * 1.6 * scene.size * random.between(1, 1.3);
  scene.speed = scene.size * std::pow(10, random.between(-1, 2));
  if (scene.walls == Walls::moving) scene.roomVelocity = random.vector(3);
  scene.dt = 1 / std::exp(random.between(std::log(30.0), std::log(1000.0)));
  // Nobody falls by more than an eighth of his size in a step from rest: coarser steps are like
  // those of a quarter of a second for what is as large as a man.
  const Real weight = scene.settings.gravity.norm();
  if (weight > 0) scene.dt = std::min(scene.dt, std::sqrt(scene.size / weight) / 2);
  scene.steps = random.integer(10, 60);
  addWalls(random, scene);
  addBodies(random, scene);
  return scene;
}

// Who lies in a hill at the start: those of a sheet reach into the lowest cells. Asked of a world in
// which nothing moves.
std::vector<bool> whoIsInHill(const RandomScene& scene) {
  std::vector<bool> inHill(scene.bodies.size(), false);
  if (scene.walls != Walls::sheet) return inHill;
  WorldSettings settings;
  settings.gravity = Vector3::Zero();
  settings.projectPositions = false;
  World world(settings);
  for (const BodyDescription& wall : scene.bounds) world.add(wall);
  std::vector<BodyId> ids;
  for (BodyDescription body : scene.bodies) {
    body.velocity = body.angularVelocity = Vector3::Zero();
    ids.push_back(world.add(body));
  }
  world.step(scene.dt);
  for (const TouchingPair& pair : world.touching()) {
    for (std::size_t i = 0; i < ids.size(); ++i) {
      const bool isOfBody = pair.bodyA == ids[i] || pair.bodyB == ids[i];
      if (isOfBody && pair.separation < -settings.touchTolerance) inHill[i] = true;
    }
  }
  return inHill;
}

// What is watched while a scene runs.
class Watch {
 public:
  Watch(const RandomScene& scene, World& world, const std::vector<BodyId>& bodies)
      : scene_(scene),
        world_(world),
        bodies_(bodies),
        late_(bodies.size()),
        heights_(bodies.size()),
        rises_(bodies.size()),
        before_(energy()) {
    const std::vector<bool> inHill = whoIsInHill(scene_);
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const Real height = world.mass(bodies_[i]) * weight() * 2 * scene_.room;
      scale_ += height;
      if (scene_.start == Start::overlapping) {
        lifted_ += height;
      } else if (inHill[i]) {
        lifted_ += world.mass(bodies_[i]) * weight() * hill();
      }
    }
    // Where nothing moves and nothing weighs, what rounding makes is beside a slow way of its own.
    for (const BodyId body : bodies_) {
      scale_ += world.mass(body) * std::pow(1e-3 * scene_.size / scene_.dt, 2);
    }
    scale_ += std::abs(before_.moving);
    last_ = before_.moving + before_.high;
  }

  // After a step. Returns what is wrong.
  std::string look(Tally& tally) {
    ++tally.steps;
    tally.contacts += world_.counters().contactPoints;
    tally.impacts += world_.counters().impacts;
    tally.searches += world_.counters().firstContacts;
    time_ += scene_.dt;
    std::ostringstream wrong;
    wrong.precision(6);
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const BodyId body = bodies_[i];
      const Vector3 centre = world_.centre(body), v = world_.velocity(body);
      const Quaternion q = world_.orientation(body);
      if (!centre.allFinite() || !v.allFinite() || !world_.angularVelocity(body).allFinite() ||
          !std::isfinite(q.w + q.x + q.y + q.z)) {
        wrong << "body " << i << " has a number that is none";
        return wrong.str();
      }
      const Vector3 place = centre - time_ * scene_.roomVelocity;
      const Real outside = place.cwiseAbs().maxCoeff() - scene_.room;
      const Real slow = (v - scene_.roomVelocity).norm() + fastest_;
      // Who looks at the ends of steps only finds a wall when he is in it, and is lifted out of it
      // at the rate of soft steps at least, though he may long have lost the speed of then. Who lifts
      // nobody out of anything leaves him there.
      const bool lifts = scene_.settings.projectPositions;
      const Real stays = std::max(Real(0), 1 - (lifts ? SoftSettings().rise * scene_.dt : 0));
      late_[i] = std::max(stays * late_[i], slow * scene_.dt);
      if (outside > (scene_.settings.continuous ? 0 : late_[i]) + hill()) {
        wrong << "body " << i << " is " << outside << " m outside of the walls";
        return wrong.str();
      }
    }
    for (const TouchingPair& pair : world_.touching()) {
      tally.depth = std::max(tally.depth, -pair.separation / scene_.size);
    }
    return lookAtEnergy(tally);
  }

 private:
  struct Energy {
    Real moving = 0, high = 0;
  };

  Real weight() const {
    return scene_.settings.gravity.norm();
  }

  // Ground of triangles has its own height.
  Real hill() const {
    return scene_.walls == Walls::sheet ? 0.1 * scene_.room : 0;
  }

  // What this step has lifted bodies by, none faster than soft steps take overlap away [J].
  Real liftOfPiles() const {
    const Real most = SoftSettings().slowestPull * scene_.dt * weight();
    Real sum = 0;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      sum += world_.mass(bodies_[i]) * std::clamp(rises_[i], Real(0), most);
    }
    return sum;
  }

  // As somebody sees it who moves with the walls: for him they do no work.
  Energy energy() {
    Energy sum;
    fastest_ = 0;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const BodyId body = bodies_[i];
      const Vector3 v = world_.velocity(body) - scene_.roomVelocity;
      const Vector3 w = world_.angularVelocity(body);
      const Vector3 place = world_.centre(body) - time_ * scene_.roomVelocity;
      const Real mass = world_.mass(body);
      sum.moving += (mass * v.squaredNorm() + w.dot(world_.inertia(body) * w)) / 2;
      const Real high = -scene_.settings.gravity.dot(place);
      rises_[i] = high - heights_[i];
      heights_[i] = high;
      sum.high += mass * high;
      fastest_ = std::max(fastest_, v.norm());
    }
    return sum;
  }

  // What this step has added.
  std::string lookAtEnergy(Tally& tally) {
    const WorldSettings& s = scene_.settings;
    const Real fastBefore = fastest_;
    const Energy now = energy();
    const Real sum = now.moving + now.high;
    const Real ofStep = sum - last_, inAll = sum - before_.moving - before_.high;
    last_ = sum;
    // Bodies that turn as balls do have no energy that is kept.
    if (!s.gyroscopic) return {};
    const bool exact = isExact(s);
    Real allowed = lifted_;
    if (!exact) {
      const Real way = (std::max(fastest_, fastBefore) + weight() * scene_.dt) * scene_.dt;
      for (const BodyId body : bodies_) allowed += world_.mass(body) * weight() * way;
      allowed_ += allowed - lifted_;
    }
    // What was lost when they sank comes back.
    if (world_.counters().pileBodies > 0) allowed += liftOfPiles();
    const Real all = (inAll - allowed_ - lifted_) / scale_, step = (ofStep - allowed) / scale_;
    tally.gain = std::max(tally.gain, all);
    tally.gainOfStep = std::max(tally.gainOfStep, step);
    if (all <= kGain && step <= kGainOfStep) return {};
    std::ostringstream wrong;
    wrong << "energy of " << scale_ << " J grew by a share of " << step << ", in all of " << all;
    return wrong.str();
  }

  const RandomScene& scene_;
  World& world_;
  const std::vector<BodyId>& bodies_;
  std::vector<Real> late_;             // how deep each may be in a wall that he found too late [m]
  std::vector<Real> heights_, rises_;  // of each beside gravity, and by the last step [m^2/s^2]
  Real time_ = 0;
  Real fastest_ = 0;
  Energy before_;
  Real scale_ = 0;    // of energies in the scene [J]
  Real last_ = 0;     // energy after the last step [J]
  Real lifted_ = 0;   // by what bodies may be lifted out of each other [J]
  Real allowed_ = 0;  // what steps without some ideas may have added so far [J]
};

}  // namespace

Outcome runRandomScene(std::uint64_t seed) {
  Outcome outcome;
  outcome.tally.scenes = 1;
  int step = 0;
  try {
    const RandomScene scene = makeScene(seed);
    outcome.isPlain = scene.walls != Walls::sheet && isExact(scene.settings);
    World world(scene.settings);
    for (const BodyDescription& body : scene.bounds) world.add(body);
    std::vector<BodyId> bodies;
    for (const BodyDescription& body : scene.bodies) bodies.push_back(world.add(body));
    outcome.tally.bodies = static_cast<long>(bodies.size());
    Watch watch(scene, world, bodies);
    for (; step < scene.steps && outcome.failure.empty(); ++step) {
      world.step(scene.dt);
      outcome.failure = watch.look(outcome.tally);
    }
  } catch (const std::exception& problem) {
    outcome.failure = problem.what();
  }
  if (!outcome.failure.empty()) outcome.failure += ", step " + std::to_string(step);
  return outcome;
}

std::string describeRandomScene(std::uint64_t seed) {
  const RandomScene scene = makeScene(seed);
  const WorldSettings& s = scene.settings;
  static const char* const kWalls[] = {"planes", "boxes", "moving boxes", "sheet"};
  static const char* const kStarts[] = {"apart", "overlapping", "tower"};
  std::ostringstream text;
  text << scene.bodies.size() << " bodies of " << scene.size << " m, "
       << kWalls[static_cast<int>(scene.walls)] << ", " << kStarts[static_cast<int>(scene.start)]
       << ", up to " << scene.speed << " m/s, " << scene.steps << " steps of " << scene.dt
       << " s, gravity " << s.gravity.norm();
  const WorldSettings usual;
  const auto tell = [&](const char* name, auto now, auto before) {
    if (now != before) text << ", " << name << ' ' << now;
  };
  tell("allPairs", s.pairFinding == PairFinding::allPairs, false);
  tell("warmStarting", s.warmStarting, usual.warmStarting);
  tell("sleeping", s.sleeping, usual.sleeping);
  tell("keepStill", s.keepStill, usual.keepStill);
  tell("continuous", s.continuous, usual.continuous);
  tell("locateEvents", s.locateEvents, usual.locateEvents);
  tell("exactRotation", s.exactRotation, usual.exactRotation);
  tell("gyroscopic", s.gyroscopic, usual.gyroscopic);
  tell("trapezoidal", s.trapezoidal, usual.trapezoidal);
  tell("projectPositions", s.projectPositions, usual.projectPositions);
  tell("friction", s.friction, usual.friction);
  tell("restitution", s.restitution, usual.restitution);
  tell("directIslands", s.directIslands, usual.directIslands);
  tell("iterations", s.iterations, usual.iterations);
  tell("rowBudget", s.rowBudget, usual.rowBudget);
  tell("eventContacts", s.eventContacts, usual.eventContacts);
  tell("pileContacts", s.pileContacts, usual.pileContacts);
  tell("pileBodies", s.pileBodies, usual.pileBodies);
  tell("directWork", s.directWork, usual.directWork);
  tell("eventsPerBody", s.eventsPerBody, usual.eventsPerBody);
  tell("shortSteps", s.shortSteps, usual.shortSteps);
  return text.str();
}

}  // namespace carom::stress
