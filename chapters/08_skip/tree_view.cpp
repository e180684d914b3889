// What does a tree of boxes look like, and which nodes does a question touch?
//
// Thirty discs in the plane, in a tree. A box wanders through them and asks, at each place, whom it
// meets. A frame stands around each node; those that the question looked at are red.

#include <cmath>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "carom/broadphase/tree.hpp"
#include "carom/core/elementary.hpp"
#include "carom/core/random.hpp"
#include "carom_io/plot.hpp"
#include "carom_io/recorder.hpp"
#include "carom_io/table.hpp"

using carom::Real;
using carom::Vector2;
using carom::Vector3;
using Box = carom::Aabb<2>;
using Node = carom::TreeNode<2>;

constexpr int kDiscs = 30;
constexpr Real kRadius = 0.3;  // [m]

// The corners of a box, closed.
carom::io::Polyline frameAround(const Box& box) {
  const Vector2 &a = box.low, &b = box.high;
  return {{{a.x(), a.y(), 0},
           {b.x(), a.y(), 0},
           {b.x(), b.y(), 0},
           {a.x(), b.y(), 0},
           {a.x(), a.y(), 0}}};
}

// How many nodes are above one.
int levelOf(const std::vector<Node>& nodes, std::int32_t node) {
  int level = 0;
  for (; nodes[node].parent != carom::kNone; node = nodes[node].parent) ++level;
  return level;
}

void drawLevels(const std::vector<Node>& nodes, const std::filesystem::path& folder) {
  carom::io::Plot plot("The tree, down to its fourth level");
  plot.describe("Thirty squares; around halves, quarters and eighths of them boxes.");
  plot.xRange(-5.5, 5.5).yRange(-4, 4).equalAspect().size(760, 560);
  const std::vector<carom::io::Color> colors = {
      {30, 30, 30}, carom::io::kBlue, carom::io::kGreen, carom::io::kVermilion};
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(nodes.size()); ++i) {
    const int level = levelOf(nodes, i);
    if (level > 3 && !nodes[i].isLeaf()) continue;
    std::vector<Vector2> corners;
    for (const Vector3& corner : frameAround(nodes[i].box).points)
      corners.push_back(corner.head<2>());
    corners.pop_back();
    const bool leaf = nodes[i].isLeaf();
    plot.polygon("", corners,
                 {.opacity = leaf ? 0.4 : 0.03,
                  .width = leaf ? 1.0 : 3.5 - 0.6 * level,
                  .color = leaf ? carom::io::Color{120, 120, 120} : colors[level]});
  }
  plot.writeSvg(folder / "tree_view.svg");
}

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? argv[1] : ".";
  carom::Random random(808);
  carom::Tree<2> tree;
  std::vector<Vector2> centers;
  for (int i = 0; i < kDiscs; ++i) {
    const Real x = random.between(-4.8, 4.8);
    const Real y = random.between(-3.2, 3.2);
    centers.emplace_back(x, y);
    const Vector2 reach = Vector2::Constant(kRadius);
    tree.insert(i, {centers[i] - reach, centers[i] + reach});
  }
  tree.rebuild();
  const std::vector<Node>& nodes = tree.nodes().nodes;
  drawLevels(nodes, folder);

  carom::io::Recording recording("A tree of boxes is asked",
                                 "Discs with nested frames around them. A box wanders across, and "
                                 "the frames that it had to be compared with turn red.");
  for (int i = 0; i < kDiscs; ++i) {
    recording.addFixed("disc " + std::to_string(i), carom::io::Disc{kRadius},
                       {.position = {centers[i].x(), centers[i].y(), 0}},
                       {.color = carom::io::Color{150, 150, 150}});
  }
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    recording.addFixed("frame " + std::to_string(i), frameAround(nodes[i].box), {},
                       {.color = carom::io::Color{190, 190, 190}});
    recording.addBody("asked " + std::to_string(i), frameAround(nodes[i].box),
                      {.color = carom::io::kVermilion});
  }
  const Vector2 half(0.5, 0.4);
  recording.addBody("question", frameAround({-half, half}), {.color = carom::io::kBlue});
  recording.addChannel("nodes looked at", "");
  recording.addChannel("discs found", "");
  recording.setView({.flat = true, .target = Vector3::Zero(), .distance = 4});

  carom::io::Table table;
  table.column("x [m]", carom::io::fixed(2)).column("y [m]", carom::io::fixed(2));
  table.column("nodes", carom::io::fixed(0)).column("found", carom::io::fixed(0));
  const int frames = 240;
  for (int n = 0; n <= frames; ++n) {
    const Real angle = 2 * M_PI * n / frames;
    const Vector2 at(4.5 * carom::sine(angle), 2.8 * carom::sine(2 * angle));
    const Box box{at - half, at + half};
    int found = 0;
    const std::int64_t looked = tree.overlap(box, [&](std::int32_t) { ++found; });
    carom::io::Frame frame{.time = n / 30.0};
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      // Looked at are the root and the children of all that the box meets.
      const std::int32_t above = nodes[i].parent;
      const bool asked = above == carom::kNone || carom::meets(nodes[above].box, box);
      // Who is not asked waits outside of the picture.
      frame.poses.push_back({.position = Vector3(asked ? 0 : 30, 0, 0.01)});
    }
    frame.poses.push_back({.position = {at.x(), at.y(), 0.02}});
    frame.channels = {Real(looked), Real(found)};
    recording.addFrame(frame);
    if (n % 30 == 0) table.row({at.x(), at.y(), Real(looked), Real(found)});
  }
  recording.writeHtml(folder / "tree_view.html");
  std::cout << "A tree of " << kDiscs << " discs has " << nodes.size() << " nodes; a box asks\n\n"
            << table;
}
