// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "kernel/imagery/imagery_scene.h"

namespace soarbox::kernel::imagery {

/// The random numbers of the C library that Soar uses, without a seed: 31 bits each.
class PlainRandom {
 public:
  PlainRandom();
  /// A number from 0 to 1, both included.
  double Next();

 private:
  std::vector<std::uint32_t> last_;  ///< A ring of the last 31 numbers, before their lowest bit is dropped.
  std::size_t at_ = 3;
};

/// The smallest distance between the shapes of two nodes; 0 if one is a descendant of the other. A group without shapes
/// counts as the point at its centroid.
double HullDistance(const Node& a, const Node& b);
/// A line from one point to another.
struct SightLine {
  Vec3 from, to;
};
/// The line from a to b between their closest points.
SightLine ShortestLine(const Node& a, const Node& b);
/// The distance between the local positions of two nodes.
double PositionDistance(const Node& a, const Node& b);
/// How far b's box is beyond a's box along an axis (0, 1, 2); negative if it is below; 0 if they overlap on the axis.
double AxisDistance(const Node& a, const Node& b, int axis);
/// The same along any direction, computed from projections.
double AxisDistance(const Node& a, const Node& b, const Vec3& direction);
double BoxVolume(const Node& node);
/// The product of the components of the node's own scale.
double ScaleVolume(const Node& node);
bool HullsTouch(const Node& a, const Node& b);
/// The fraction of a's volume inside b, estimated with 200 points.
double Overlap(const Node& a, const Node& b, PlainRandom& random);
/// The position of a's centroid that leaves a gap of `separation` to b on each axis. Where `separation` is 0, it equals
/// that of b's centroid on this axis. The axes are those of `reference`'s own rotation, or of the world.
Vec3 Placement(const Node& a, const Node& b, const Node* reference, const Vec3& separation);

/// Appends lines from the eye's centroid to the points of all hulls of a target.
void AppendSightLines(const Node& target, const Node& eye, std::vector<SightLine>& lines);
/// The fraction of the lines that cross a shape of an occluder.
double Occlusion(std::span<const SightLine> lines, std::span<const Node* const> occluders);

/// Finds the nodes that this node touches now and that have the tag `object-source` with the value `belief`. Shrinks
/// the node until it touches none of them. Does nothing if its centroid is inside one of them.
void ShrinkToFit(Scene& scene, Node& node);

}  // namespace soarbox::kernel::imagery
