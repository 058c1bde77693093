% SPDX-License-Identifier: BSD-3-Clause
% Turn away from a wall that is nearer than the clearance.
cnf(left, axiom, turn(-0.5) | ~ wall(left, D) | ~ clearance(C) | ~ $less(D, C)).
cnf(right, axiom, turn(0.5) | ~ wall(right, D) | ~ clearance(C) | ~ $less(D, C)).
