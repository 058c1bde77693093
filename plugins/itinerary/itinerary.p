% SPDX-License-Identifier: BSD-3-Clause
%
% Layer 3, high-level planning: which landmark comes next on the way to the goal. Situation calculus
% with the robot's place as the one fluent, so that plans may be deep. An elevator trip is one macro
% action; how it is done is layer 2's business. The first proof found is the shallowest one, so its
% situation is a shortest plan.
% Source: Amir and Maynard-Reid, LSA (IJCAI-99), section 4.
%
% Latches     curr_landmark(L)   adjacent(L1, L2)  elevator_front(E, L, K)
%             cab(E, C)   door_shut(L)   goal(L)
%             elevator_at(E, K)  elevator_out_of_order(E)
% Minimized   goal, door_shut, elevator_out_of_order

fof(robot_now, axiom, ! [P] : ( curr_landmark(P) => robot_at(P, s0) )).

% No way leads through a shut door; who stands in one may leave.
fof(go, axiom,
    ! [P, L, S] :
      ( ( ~ door_shut(L) & adjacent(P, L) & robot_at(P, S) ) => robot_at(L, do(go(L), S)) )).

fof(take_elevator, axiom,
    ! [E, P, K1, L, K2, S] :
      ( ( elevator_front(E, L, K2) & ~ elevator_out_of_order(E) & elevator_front(E, P, K1)
        & robot_at(P, S) )
     => robot_at(L, do(take_elevator(E, L), S)) )).

% In a cab, only now: the plan starts there and never comes back.
fof(ride_on, axiom,
    ! [E, C, L, K] :
      ( ( elevator_front(E, L, K) & ~ elevator_out_of_order(E) & cab(E, C) & curr_landmark(C) )
     => robot_at(L, do(take_elevator(E, L), s0)) )).
fof(get_out, axiom,
    ! [E, C, L, K] :
      ( ( elevator_front(E, L, K) & elevator_at(E, K) & cab(E, C) & curr_landmark(C) )
     => robot_at(L, do(go(L), s0)) )).

% --- The first step of a plan --------------------------------------------------------------------

fof(first_go, axiom, ! [L] : first_step(do(go(L), s0), L)).
fof(first_trip, axiom, ! [E, L] : first_step(do(take_elevator(E, L), s0), L)).
fof(first_step_below, axiom,
    ! [A, B, S, L] : ( first_step(do(B, S), L) => first_step(do(A, do(B, S)), L) )).

fof(arrived, axiom, ! [L] : ( ( goal(L) & curr_landmark(L) ) => target_landmark(L) )).
fof(next_landmark, axiom,
    ! [G, S, L] :
      ( ( goal(G) & robot_at(G, S) & first_step(S, L) ) => target_landmark(L) )).
