% SPDX-License-Identifier: BSD-3-Clause
% Layer 0: a sector is blocked by an object in it, seen or virtual; into the others the robot may go.
fof(sectors, axiom, sector(s3) & sector(s5)).
fof(seen, axiom, ! [S] : ( object(S) => blocked(S) )).
fof(virtual, axiom, ! [S] : ( pushed(S) => blocked(S) )).
fof(free, axiom, ! [S] : ( ( sector(S) & ~ blocked(S) ) => go(S) )).
fof(closed, axiom, ! [S] : ( blocked(S) => ~ go(S) )).
