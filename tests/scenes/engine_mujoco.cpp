// MuJoCo: the scene is written as its own XML.

#include <mujoco/mujoco.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "scenes/engines.hpp"

namespace carom::scenes {
namespace {

std::string ofNumbers(std::initializer_list<Real> numbers) {
  std::string all;
  char text[40];
  for (const Real number : numbers) {
    std::snprintf(text, sizeof text, "%.17g ", number);
    all += text;
  }
  return all;
}

std::string ofVector(const Vector3& v) {
  return ofNumbers({v.x(), v.y(), v.z()});
}

// MuJoCo takes the larger coefficient of a pair. With the fixed bodies at zero the one that moves
// decides against them; bodies that move and meet must be alike, which can() asks for.
Real frictionOf(const Scene& scene, const Body& body) {
  if (!body.moves) return 0;
  for (const Body& other : scene.bodies) {
    if (!other.moves) return body.friction * other.friction;
  }
  return body.friction;
}

class Mujoco : public Engine {
 public:
  ~Mujoco() override {
    if (data_ != nullptr) mj_deleteData(data_);
    if (model_ != nullptr) mj_deleteModel(model_);
  }

  void build(const Scene& scene) override {
    const bool free = scene.bodies.size() == 1;
    std::string xml = "<mujoco><compiler angle=\"radian\"/><option gravity=\"" +
                      ofVector(scene.gravity) + "\" integrator=\"" + (free ? "RK4" : "Euler") +
                      "\" solver=\"Newton\"/><size njmax=\"" +
                      std::to_string(200 + 60 * movingCount(scene)) + "\" nconmax=\"" +
                      std::to_string(100 + 20 * movingCount(scene)) + "\"/><worldbody>";
    for (const Body& body : scene.bodies) xml += textOf(scene, body);
    xml += "</worldbody></mujoco>";
    auto files = std::make_unique<mjVFS>();
    mj_defaultVFS(files.get());
    mj_makeEmptyFileVFS(files.get(), "scene.xml", static_cast<int>(xml.size()));
    std::copy(xml.begin(), xml.end(), static_cast<char*>(files->filedata[0]));
    std::array<char, 1000> problem{};
    model_ = mj_loadXML("scene.xml", files.get(), problem.data(), static_cast<int>(problem.size()));
    if (model_ == nullptr) throw std::runtime_error(problem.data());
    data_ = mj_makeData(model_);
    int joint = 0;
    for (const Body& body : scene.bodies) {
      fixed_.push_back(body.start);
      joints_.push_back(body.moves ? joint++ : -1);
      if (!body.moves) continue;
      mjtNum* v = data_->qvel + 6 * joints_.back();
      // The velocity of a free joint: in the world; its spin: in the body.
      const Vector3 spin =
          poseMatrix(body.start.orientation).transpose() * body.start.angularVelocity;
      for (int k = 0; k < 3; ++k) v[k] = body.start.velocity[k], v[3 + k] = spin[k];
    }
  }

  void step(Real dt) override {
    model_->opt.timestep = dt;
    mj_step(model_, data_);
  }

  State state(int body) const override {
    const int joint = joints_[static_cast<std::size_t>(body)];
    if (joint < 0) return fixed_[static_cast<std::size_t>(body)];
    const mjtNum *x = data_->qpos + 7 * joint, *v = data_->qvel + 6 * joint;
    const Quaternion q{x[3], x[4], x[5], x[6]};
    const Vector3 spin = poseMatrix(q) * Vector3(v[3], v[4], v[5]);
    return {{x[0], x[1], x[2]}, q, {v[0], v[1], v[2]}, spin};
  }

  std::vector<Figure> counters() const override {
    return {{"contact points", data_->ncon * 1.0}};
  }

 private:
  static Matrix3 poseMatrix(const Quaternion& q) {
    const mjtNum turn[4] = {q.w, q.x, q.y, q.z};
    mjtNum rows[9];
    mju_quat2Mat(rows, turn);
    Matrix3 matrix;
    for (int i = 0; i < 9; ++i) matrix(i / 3, i % 3) = rows[i];
    return matrix;
  }

  static std::string textOf(const Scene& scene, const Body& body) {
    const std::string friction =
        " friction=\"" + ofNumbers({frictionOf(scene, body), 0, 0}) + "\" condim=\"3\"/>";
    std::string geom;
    if (const Ball* ball = std::get_if<Ball>(&body.shape)) {
      geom = "<geom type=\"sphere\" size=\"" + ofNumbers({ball->radius}) + "\"" + friction;
    } else if (const Box* box = std::get_if<Box>(&body.shape)) {
      geom = "<geom type=\"box\" size=\"" + ofVector(box->halfExtents) + "\"" + friction;
    } else {
      const HalfSpace& half = std::get<HalfSpace>(body.shape);
      geom = "<geom type=\"plane\" size=\"0 0 1\" pos=\"" + ofVector(half.offset * half.normal) +
             "\" zaxis=\"" + ofVector(half.normal) + "\"" + friction;
    }
    const Quaternion& q = body.start.orientation;
    const std::string pose = "<body pos=\"" + ofVector(body.start.position) + "\" quat=\"" +
                             ofNumbers({q.w, q.x, q.y, q.z}) + "\">";
    if (!body.moves) {
      return std::holds_alternative<HalfSpace>(body.shape) ? geom : pose + geom + "</body>";
    }
    return pose + "<freejoint/><inertial pos=\"0 0 0\" mass=\"" + ofNumbers({body.mass}) +
           "\" diaginertia=\"" + ofVector(body.moments) + "\"/>" + geom + "</body>";
  }

  mjModel* model_ = nullptr;
  mjData* data_ = nullptr;
  std::vector<int> joints_;
  std::vector<State> fixed_;
};

bool can(const Scene& scene) {
  if (scene.bounces || scene.fast || scene.sleeps || movingCount(scene) > 50) return false;
  for (const Body& body : scene.bodies) {
    const bool hull = std::holds_alternative<ConvexHull>(body.shape);
    if (hull || body.force != Vector3::Zero()) return false;
    if (body.moves && body.friction != scene.bodies.back().friction) return false;
  }
  return true;
}

}  // namespace

std::vector<EngineKind> mujocoEngines() {
  return {{"mujoco", mj_versionString(),
           "Newton solver, pyramidal cone, Euler (RK4 where nothing can touch), dense arrays: up "
           "to 50 bodies, no coefficient of restitution",
           can, [](const Scene&) { return true; }, [] { return std::make_unique<Mujoco>(); }}};
}

}  // namespace carom::scenes
