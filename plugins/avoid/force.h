// SPDX-License-Identifier: BSD-3-Clause
#ifndef LATCHWORK_PLUGINS_AVOID_FORCE_H_
#define LATCHWORK_PLUGINS_AVOID_FORCE_H_

#include <span>

namespace latchwork::avoid {

/// An object relative to the robot: sensed, or sent by a higher layer to push or to keep away from.
struct RelativeObject {
  double distance = 0.0;   ///< From the robot's centre, m.
  double direction = 0.0;  ///< rad, counter-clockwise, 0 = straight ahead.
  bool is_virtual = false;
};

/// How objects act on the robot.
struct ForceLaw {
  double robot_radius = 0.25;  ///< m
  double influence = 0.8;      ///< Gap between hull and object from which a sensed object acts, m.
  double repulsion = 0.12;     ///< Strength of a sensed object at half the influence.
  double circulation = 1.0;    ///< Share of a sensed object's force that leads round it.
  double push = 1.0;           ///< Strength of a virtual object at 1 m.
};

/// A force by strength and direction: 0 = straight ahead, counter-clockwise, in (-pi, pi].
struct Force {
  double strength = 0.0;
  double direction = 0.0;
};

/// The sum of the forces of all objects. A virtual object repels with push/distance. A sensed
/// object at a gap g repels with repulsion * (influence/g - 1), nothing beyond the influence; and
/// where it stands ahead of the virtual objects' push, a share of that acts across the line of
/// sight, to the side on which the push passes it (to the right of an object dead ahead). Two door
/// posts thus add up to a pull through the door, and a box is rounded instead of stopping the
/// robot. Zero strength has direction 0. The order of the objects has no part but in the last bits.
Force SumForces(const ForceLaw& law, std::span<const RelativeObject> objects);

/// How far the robot can roll straight ahead until its hull is `margin` from the nearest sensed
/// object, m; at most `horizon`. An object may stand anywhere within `half_cone` of its direction;
/// the worst place counts.
double FreeAhead(double robot_radius, double margin, double half_cone, double horizon,
                 std::span<const RelativeObject> objects);

}  // namespace latchwork::avoid

#endif  // LATCHWORK_PLUGINS_AVOID_FORCE_H_
