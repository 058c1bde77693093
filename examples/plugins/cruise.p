% SPDX-License-Identifier: BSD-3-Clause
% Drive on for as long as the gap ahead is wider than the stop distance.
cnf(drive_on, axiom, fwd(V) | ~ speed(V) | ~ gap(D) | ~ stop_distance(S) | ~ $less(S, D)).
