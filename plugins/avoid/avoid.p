% SPDX-License-Identifier: BSD-3-Clause
%
% Layer 0, obstacle avoidance: sonar echoes become objects, objects a force, the force a turn or a
% step forward. Source: Amir and Maynard-Reid, LSA (IJCAI-99), section 4.
%
% Angles are radians relative to the robot's heading, counter-clockwise, in (-pi, pi]; distances are
% metres from the robot's centre; gaps are metres from its hull.
%
% Latches     sonar_reading(N, Gap)  no_echo(N)  sonar_direction(N, A)  robot_radius(R)
%             object(O)  distance(O, D)  direction(O, A)            from above
% Parameters  stand here as facts: sense_range(G), halt_gap(G), halt_half_angle(A), ...
% Minimized   halt_robot, object, distance, direction: what is not forced to hold is assumed not to.
% Attached    get_force(Strength, Direction): the sum over every provable object
%             get_clearance(Way): how far it is free ahead, over every provable object

% --- Echoes become objects -----------------------------------------------------------------------
% An echo is a witness: there is something at its distance. sonar_obj is the Skolem function of
% "every echo has an object". A sonar looks along the ray through the robot's centre.

cnf(echo, axiom,
    ( ~ sonar_reading(N, G) | ~ sense_range(S) | ~ $lesseq(G, S) | echo(N, G) )).

cnf(echo_is_an_object, axiom,
    ( ~ echo(N, G) | object(sonar_obj(N)) )).

cnf(echo_has_a_distance, axiom,
    ( ~ echo(N, G) | ~ robot_radius(R) | distance(sonar_obj(N), $sum(R, G)) )).

cnf(echo_has_a_direction, axiom,
    ( ~ echo(N, G) | ~ sonar_direction(N, A) | direction(sonar_obj(N), A) )).

% --- The reflex: an object ahead halts the robot -------------------------------------------------
% Nothing above can say otherwise: whatever enters through the latch `objects` can only add objects,
% and no axiom takes one away.

fof(object_ahead_halts, axiom,
    ! [O] : ( ( object(O) & object_ahead(O) ) => halt_robot )).

fof(object_ahead, axiom,
    ! [O, A, H, D, R, G] :
      ( ( direction(O, A) & halt_half_angle(H) & $lesseq($abs(A), H)
        & distance(O, D) & robot_radius(R) & halt_gap(G) & $lesseq(D, $sum(R, G)) )
     => object_ahead(O) )).

fof(halted_robots_halt, axiom, ( halt_robot => halt )).

% --- Where to, and how fast ----------------------------------------------------------------------
% Force proportional to speed: the robot slows down as it gets away from what repels it. A weak
% force is no reason to move.

fof(heading, axiom,
    ! [S, A, L] :
      ( ( get_force(S, A) & least_force(L) & $greatereq(S, L) )
     => ( heading_angle(A) & heading_strength(S) ) )).

fof(turn_towards_the_heading, axiom,
    ! [A, T] :
      ( ( heading_angle(A) & turn_tolerance(T) & $greater($abs(A), T) ) => turn(A) )).

% The default at work: "not halt_robot" is assumed unless halt_robot is proved.
fof(go_forward, axiom,
    ! [V] : ( ( ~ halt_robot & speed(V) & $greater(V, 0) ) => fwd(V) )).

% As fast as the force asks for and the way ahead allows, and slower in a bend.
fof(speed, axiom,
    ! [A, W, S, K, C, T, M] :
      ( ( heading_angle(A) & aligned_within(W) & $less($abs(A), W)
        & heading_strength(S) & speed_gain(K) & get_clearance(C) & headway(T) & max_speed(M) )
     => speed($product($min(M, $min($product(K, S), $quotient(C, T))),
                       $difference(1.0, $quotient($abs(A), W)))) )).

% --- Hard axioms: what no layer above may claim --------------------------------------------------
% They conclude nothing; a fact that contradicts them never enters the latch.

cnf(no_negative_distance, axiom, ( ~ distance(O, D) | ~ $less(D, 0) )).
cnf(direction_at_most_pi, axiom, ( ~ direction(O, A) | ~ $greater(A, 3.141592653589794) )).
cnf(direction_above_minus_pi, axiom, ( ~ direction(O, A) | ~ $lesseq(A, -3.141592653589793) )).

fof(one_distance, axiom,
    ! [O, D1, D2] : ~ ( distance(O, D1) & distance(O, D2) & $less(D1, D2) )).
fof(one_direction, axiom,
    ! [O, A1, A2] : ~ ( direction(O, A1) & direction(O, A2) & $less(A1, A2) )).

% A sonar without an echo has no object, whatever is said about it.
fof(silence_is_no_object, axiom, ! [N] : ~ ( no_echo(N) & object(sonar_obj(N)) )).
fof(silence_has_no_distance, axiom, ! [N, D] : ~ ( no_echo(N) & distance(sonar_obj(N), D) )).
fof(silence_has_no_direction, axiom, ! [N, A] : ~ ( no_echo(N) & direction(sonar_obj(N), A) )).
