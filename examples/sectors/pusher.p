% SPDX-License-Identifier: BSD-3-Clause
% Layer 1: a command pushes the robot out of a sector; to leave the corner, out of one of two.
fof(leave_left, axiom, move_cmd(left) => pushed(s3)).
fof(leave_right, axiom, move_cmd(right) => pushed(s5)).
fof(leave_corner, axiom, move_cmd(corner) => ( pushed(s3) | pushed(s5) )).
