// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/imagery/measures.h"

#include <algorithm>
#include <array>
#include <optional>

#include "kernel/imagery/convex.h"

namespace soarbox::kernel::imagery {
namespace {

/// Hulls with a smaller distance touch.
constexpr double kTouching = 1e-15;

Solid SolidOf(const Node& node) {
  Solid solid;
  if (node.shape() == Shape::kHull) {
    solid.points = node.WorldPoints();
    return solid;
  }
  const double radius = std::abs(node.radius());
  const double factor = node.World().UniformScale();
  if (factor >= 0) {
    solid.points = std::span(&node.World().shift(), 1);
    solid.margin = radius * factor;
  } else {
    solid.ellipsoid = &node.World();
    solid.radius = radius;
  }
  return solid;
}

void AppendShapes(const Node& node, std::vector<const Node*>& shapes) {
  if (!node.is_group()) shapes.push_back(&node);
  for (const auto& child : node.children()) AppendShapes(*child, shapes);
}

std::vector<const Node*> ShapesOf(const Node& node) {
  std::vector<const Node*> shapes;
  AppendShapes(node, shapes);
  return shapes;
}

bool InOneTree(const Node& a, const Node& b) {
  return &a == &b || a.IsAbove(b) || b.IsAbove(a);
}

/// The distance from a point or line to the shapes of a node.
double DistanceTo(const Solid& solid, std::span<const Node* const> shapes) {
  double least = -1;
  for (const Node* const shape : shapes) {
    const double distance = DistanceBetween(solid, SolidOf(*shape));
    if (least < 0 || distance < least) least = distance;
    if (least == 0) break;
  }
  return least;
}

double DistanceOfShapes(const Node& a, const Node& b) {
  if (!a.is_group() && !b.is_group()) return DistanceBetween(SolidOf(a), SolidOf(b));
  const std::vector<const Node*> of_a = ShapesOf(a), of_b = ShapesOf(b);
  if (of_a.empty() && of_b.empty()) return Distance(a.Centroid(), b.Centroid());
  if (of_a.empty() || of_b.empty()) {
    const Vec3 centroid = (of_a.empty() ? a : b).Centroid();
    Solid point;
    point.points = std::span(&centroid, 1);
    return DistanceTo(point, of_a.empty() ? of_b : of_a);
  }
  double least = -1;
  for (const Node* const one : of_a) {
    for (const Node* const other : of_b) {
      // A ball's box contains the ball, so if the boxes are farther apart, the shapes need no comparison.
      if (least >= 0 && one->Bounds().Gap(other->Bounds()) >= least) continue;
      const double distance = DistanceBetween(SolidOf(*one), SolidOf(*other));
      if (least < 0 || distance < least) least = distance;
      if (least == 0) return 0;
    }
  }
  return least;
}

bool AnyHasPoint(std::span<const Node* const> shapes, const Vec3& point) {
  return std::any_of(shapes.begin(), shapes.end(), [&](const Node* shape) { return HasPoint(SolidOf(*shape), point); });
}

double GapOf(std::pair<double, double> a, std::pair<double, double> b) {
  if (b.first > a.second) return b.first - a.second;
  if (b.second < a.first) return b.second - a.first;
  return 0;
}

}  // namespace

// Random points -------------------------------------------------------------------------------------------------------

PlainRandom::PlainRandom() : last_(31) {
  std::int64_t number = 1;
  for (std::size_t n = 0; n < last_.size(); ++n) {
    last_[n] = static_cast<std::uint32_t>(number);
    number = number * 16807 % 2147483647;
  }
  // The generator discards its first ten rounds.
  for (int n = 0; n < 310; ++n) Next();
}

double PlainRandom::Next() {
  // x[n] = x[n - 31] + x[n - 3]
  last_[at_] += last_[(at_ + 28) % 31];
  const std::uint32_t drawn = last_[at_] >> 1;
  at_ = (at_ + 1) % 31;
  return drawn / 2147483647.0;
}

// Distances -----------------------------------------------------------------------------------------------------------

double HullDistance(const Node& a, const Node& b) {
  return InOneTree(a, b) ? 0 : DistanceOfShapes(a, b);
}

SightLine ShortestLine(const Node& a, const Node& b) {
  const auto solids = [](const Node& node, const Vec3& centroid) {
    std::vector<Solid> found;
    for (const Node* const shape : ShapesOf(node)) found.push_back(SolidOf(*shape));
    if (found.empty()) found.emplace_back().points = std::span(&centroid, 1);
    return found;
  };
  const Vec3 of_a = a.Centroid(), of_b = b.Centroid();
  SightLine best{of_a, of_b};
  double least = -1;
  for (const Solid& one : solids(a, of_a)) {
    for (const Solid& other : solids(b, of_b)) {
      SightLine line;
      if (!ShortestBetween(one, other, line.from, line.to)) continue;
      const double length = Distance(line.from, line.to);
      if (least >= 0 && length >= least) continue;
      least = length;
      best = line;
    }
  }
  return best;
}

double PositionDistance(const Node& a, const Node& b) {
  return Distance(a.pose().position, b.pose().position);
}

double AxisDistance(const Node& a, const Node& b, int axis) {
  const Box &of_a = a.Bounds(), &of_b = b.Bounds();
  return GapOf({of_a.low[axis], of_a.high[axis]}, {of_b.low[axis], of_b.high[axis]});
}

double AxisDistance(const Node& a, const Node& b, const Vec3& direction) {
  const double length = Length(direction);
  if (length == 0) return 0;
  const Vec3 unit = direction * (1 / length);
  return GapOf(a.Extent(unit), b.Extent(unit));
}

bool HullsTouch(const Node& a, const Node& b) {
  return a.Bounds().Touches(b.Bounds()) && HullDistance(a, b) < kTouching;
}

// Sizes ---------------------------------------------------------------------------------------------------------------

double BoxVolume(const Node& node) {
  return node.Bounds().Volume();
}

double ScaleVolume(const Node& node) {
  const Vec3& scale = node.pose().scale;
  return scale.x * scale.y * scale.z;
}

double Overlap(const Node& a, const Node& b, PlainRandom& random) {
  constexpr int kSamples = 200, kMostDraws = 100000;
  if (InOneTree(a, b)) return 0;
  const std::vector<const Node*> of_a = ShapesOf(a), of_b = ShapesOf(b);
  if (of_b.empty()) return 0;
  if (of_a.empty()) return AnyHasPoint(of_b, a.Centroid()) ? 1 : 0;
  if (DistanceOfShapes(a, b) > 0) return 0;
  const Box box = a.Bounds();
  int samples = 0, inside = 0;
  for (int draw = 0; samples < kSamples && draw < kMostDraws; ++draw) {
    Vec3 point;
    for (int axis = 0; axis < 3; ++axis) point[axis] = box.low[axis] + random.Next() * (box.high[axis] - box.low[axis]);
    if (!AnyHasPoint(of_a, point)) continue;
    ++samples;
    if (AnyHasPoint(of_b, point)) ++inside;
  }
  return samples == 0 ? 0 : inside / static_cast<double>(samples);
}

// Places --------------------------------------------------------------------------------------------------------------

Vec3 Placement(const Node& a, const Node& b, const Node* reference, const Vec3& separation) {
  Pose turned;
  if (reference != nullptr) turned.rotation = reference->pose().rotation;
  const Transform rotation(turned);
  const Vec3 centroid_a = a.Centroid(), centroid_b = b.Centroid();
  Vec3 place = centroid_b;
  for (int axis = 0; axis < 3; ++axis) {
    const double gap = separation[axis];
    if (gap == 0) continue;
    Vec3 unit;
    unit[axis] = 1;
    const Vec3 along = rotation.Turn(unit);
    const auto [low_a, high_a] = a.Extent(along);
    const auto [low_b, high_b] = b.Extent(along);
    const double at_a = Dot(along, centroid_a), at_b = Dot(along, centroid_b);
    if (gap > 0) {
      place = place + along * ((high_b - at_b) + gap - (low_a - at_a));
    } else {
      place = place - along * (-(low_b - at_b) - gap + (high_a - at_a));
    }
  }
  return place;
}

// Sight ---------------------------------------------------------------------------------------------------------------

void AppendSightLines(const Node& target, const Node& eye, std::vector<SightLine>& lines) {
  const Vec3 from = eye.Centroid();
  for (const Node* const shape : ShapesOf(target)) {
    if (shape->shape() != Shape::kHull) continue;
    for (const Vec3& point : shape->WorldPoints()) lines.push_back({from, point});
  }
}

double Occlusion(std::span<const SightLine> lines, std::span<const Node* const> occluders) {
  if (lines.empty()) return 0;
  std::vector<std::vector<const Node*>> shapes;
  for (const Node* const occluder : occluders) {
    shapes.push_back(ShapesOf(*occluder));
  }
  std::size_t hidden = 0;
  for (const SightLine& line : lines) {
    const Vec3 ends[2] = {line.from, line.to};
    Solid solid;
    solid.points = ends;
    Box box{line.from, line.from};
    box.Include(line.to);
    for (std::size_t n = 0; n < occluders.size(); ++n) {
      const Vec3 centroid = occluders[n]->Centroid();
      Solid point;
      point.points = std::span(&centroid, 1);
      // A group without shapes counts as the point at its centroid.
      const bool crossed = shapes[n].empty() ? DistanceBetween(solid, point) <= 0
                                             : box.Touches(occluders[n]->Bounds()) && DistanceTo(solid, shapes[n]) <= 0;
      if (!crossed) continue;
      ++hidden;
      break;
    }
  }
  return static_cast<double>(hidden) / static_cast<double>(lines.size());
}

// Fitting -------------------------------------------------------------------------------------------------------------

namespace {

/// Tries smaller scales of a node until it does not touch certain others.
class Fitting {
 public:
  Fitting(Scene& scene, Node& node) : scene_(scene), node_(node), full_(node.pose()) {
    scene.ForEach([&](const Node& other) {
      const std::string* const source = other.Tag("object-source");
      if (&other != &node && source != nullptr && *source == "belief" && HullsTouch(node, other)) {
        others_.push_back(&other);
      }
    });
  }

  void Run() {
    if (others_.empty() || CentroidIsInside()) return;
    const auto one = [](int axis) { return std::array{axis == 0, axis == 1, axis == 2}; };
    const auto two = [](int axis) { return std::array{axis != 0, axis != 1, axis != 2}; };
    std::optional<std::array<bool, 3>> axes = OnlyThatFrees(one);
    if (!axes) axes = OnlyThatFrees(two);
    const std::array<bool, 3> chosen = axes.value_or(std::array{true, true, true});
    double low = 0.001, high = 1;
    for (int step = 0; step < 8; ++step) {
      const double middle = (high + low) / 2;
      Scale(chosen, middle);
      (Touches() ? high : low) = middle;
    }
    Scale(chosen, low * 0.98);
  }

 private:
  bool Touches() const {
    return std::any_of(others_.begin(), others_.end(), [&](const Node* other) { return HullsTouch(node_, *other); });
  }
  void Scale(const std::array<bool, 3>& axes, double factor) {
    Pose pose = full_;
    for (int axis = 0; axis < 3; ++axis) {
      if (axes[static_cast<std::size_t>(axis)]) pose.scale[axis] *= factor;
    }
    scene_.Move(node_, pose);
  }
  bool CentroidIsInside() const {
    const Vec3 centroid = node_.Centroid();
    return std::any_of(others_.begin(), others_.end(),
                       [&](const Node* other) { return AnyHasPoint(ShapesOf(*other), centroid); });
  }
  /// Shrinks the node along each choice of axes in turn. Returns the choice after which the node touches nothing, if
  /// there is exactly one.
  template <typename Choice>
  std::optional<std::array<bool, 3>> OnlyThatFrees(Choice choice) {
    std::optional<std::array<bool, 3>> found;
    for (int axis = 0; axis < 3; ++axis) {
      Scale(choice(axis), 0.001);
      if (Touches()) continue;
      if (found) {
        found.reset();
        break;
      }
      found = choice(axis);
    }
    Scale({true, true, true}, 1);
    return found;
  }

  Scene& scene_;
  Node& node_;
  Pose full_;
  std::vector<const Node*> others_;
};

}  // namespace

void ShrinkToFit(Scene& scene, Node& node) {
  Fitting(scene, node).Run();
}

}  // namespace soarbox::kernel::imagery
