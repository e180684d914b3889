// Carom.

#include "scenes/engine_carom.hpp"

#include <memory>
#include <vector>

namespace carom::scenes {
namespace {

world::BodyDescription described(const Scene& scene, const Body& body) {
  world::BodyDescription description;
  description.kind = body.moves ? world::BodyKind::dynamic : world::BodyKind::immovable;
  description.position = body.start.position;
  description.orientation = body.start.orientation;
  description.velocity = body.start.velocity;
  description.angularVelocity = body.start.angularVelocity;
  world::ShapeDescription shape;
  shape.shape = body.shape;
  // The geometric mean of the squares is the product of what the scene says.
  shape.material = {body.friction * body.friction, body.restitution};
  if (scene.strangers && body.moves) shape.filter.family = 1;
  description.shapes = {shape};
  if (body.moves) {
    MassProperties mass;
    mass.mass = body.mass;
    mass.volume = 1;
    mass.inertia = body.moments.asDiagonal();
    description.mass = mass;
  }
  return description;
}

class CaromEngine : public Engine {
 public:
  CaromEngine(const world::WorldSettings& settings, Real tolerance)
      : settings_(settings), tolerance_(tolerance) {}

  void build(const Scene& scene) override {
    duration_ = scene.duration;
    world_ = std::make_unique<world::World>(settingsFor(scene, settings_));
    ids_ = addScene(scene, *world_);
  }

  void step(Real dt) override {
    if (tolerance_ > 0) {
      // Of what may go wrong over the whole scene each part gets its share.
      world_->advance(dt, tolerance_ * dt / duration_);
    } else {
      world_->step(dt);
    }
  }

  State state(int body) const override {
    const world::BodyId id = ids_[static_cast<std::size_t>(body)];
    return {world_->centre(id), world_->orientation(id), world_->velocity(id),
            world_->angularVelocity(id)};
  }

  std::vector<Figure> counters() const override {
    const world::Counters& c = world_->counters();
    const auto figure = [](const char* name, std::int64_t value) {
      return Figure{name, static_cast<Real>(value)};
    };
    return {figure("parts", c.parts),
            figure("bodies awake", c.bodiesAwake),
            figure("bodies asleep", c.bodiesAsleep),
            figure("bodies free", c.bodiesFree),
            figure("islands awake", c.islandsAwake),
            figure("islands still", c.islandsStill),
            figure("pairs kept", c.pairsKept),
            figure("pairs tested", c.pairsTested),
            figure("pairs awake", c.pairsAwake),
            figure("manifolds made", c.manifoldsMade),
            figure("axes searches", c.axesSearches),
            figure("contact points", c.contactPoints),
            figure("normal rows", c.normalRows),
            figure("friction rows", c.frictionRows),
            figure("rows solved", c.rowsSolved),
            figure("first contacts", c.firstContacts),
            figure("impacts", c.impacts),
            figure("slip changes", c.slipChanges),
            figure("exact rotations", c.exactRotations),
            figure("projections", c.projections),
            figure("long steps", c.macroSteps),
            figure("sub-steps", c.subSteps),
            figure("tries refused", c.triesRefused),
            figure("tries forced", c.triesForced),
            figure("long steps cut", c.macroStepsCut),
            figure("islands direct", c.islandsDirect),
            figure("factorisations", c.factorisations),
            figure("manifolds carried", c.manifoldsCarried),
            figure("bodies in piles", c.pileBodies),
            figure("islands too dear", c.islandsTooDear)};
  }

 private:
  world::WorldSettings settings_;
  Real tolerance_;  // 0: steps as long as asked [m]
  Real duration_ = 1;
  std::unique_ptr<world::World> world_;
  std::vector<world::BodyId> ids_;
};

}  // namespace

world::WorldSettings settingsFor(const Scene& scene, const world::WorldSettings& settings) {
  world::WorldSettings all = settings;
  all.gravity = scene.gravity;
  all.sleeping = settings.sleeping && scene.sleeps;
  all.restitutionRule = RestitutionRule::product;
  return all;
}

std::vector<world::BodyId> addScene(const Scene& scene, world::World& world) {
  std::vector<world::BodyId> ids;
  for (const Body& body : scene.bodies) ids.push_back(world.add(described(scene, body)));
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const Vector3& force = scene.bodies[i].force;
    if (force != Vector3::Zero()) world.setForce(ids[i], force);
  }
  return ids;
}

EngineKind caromWith(const std::string& name, const std::string& words,
                     const world::WorldSettings& settings, bool best, Real tolerance) {
  return {name,
          "this build",
          words,
          [](const Scene&) { return true; },
          [best](const Scene&) { return best; },
          [settings, tolerance] { return std::make_unique<CaromEngine>(settings, tolerance); },
          settings.threads};
}

std::vector<EngineKind> caromEngines() {
  world::WorldSettings noEvents;
  noEvents.locateEvents = false;
  world::WorldSettings skipsNothing;
  skipsNothing.sleeping = skipsNothing.keepStill = false;
  skipsNothing.pairFinding = world::PairFinding::allPairs;
  world::WorldSettings soft;
  soft.pileContacts = soft.pileBodies = 0;
  world::WorldSettings oneSoftStep = soft;
  oneSoftStep.shortSteps = 1;
  world::WorldSettings onePhase;
  onePhase.phaseTurn = 1e3;
  world::WorldSettings twoThreads;
  twoThreads.threads = 2;
  return {
      caromWith("carom", "as it comes; sleeping only where the scene lets bodies sleep", {}, true),
      caromWith("carom no events", "impacts and ends of slipping are not located inside the step",
                noEvents, false),
      caromWith("carom soft", "islands go by soft steps as soon as they touch, however small", soft,
                false),
      caromWith("carom soft 1", "the same, a single one for each step", oneSoftStep, false),
      caromWith("carom one phase", "bodies that turn while they touch take a step at once",
                onePhase, false),
      caromWith("carom 2 threads", "piles and manifolds are shared by two threads", twoThreads,
                false),
      caromWith("carom skips nothing", "all pairs, nothing sleeps", skipsNothing),
      caromWith("carom advance 1e-1", "steps chosen for an error of 0.1 m over the scene", {},
                false, 1e-1),
      caromWith("carom advance 1e-3", "steps chosen for an error of 1e-3 m over the scene", {},
                false, 1e-3),
      caromWith("carom advance 1e-6", "steps chosen for an error of 1e-6 m over the scene", {},
                false, 1e-6),
      caromWith("carom advance 1e-9", "steps chosen for an error of 1e-9 m over the scene", {},
                false, 1e-9)};
}

}  // namespace carom::scenes
