% SPDX-License-Identifier: BSD-3-Clause
%
% Layer 2, mid-level planning: how to get to the next landmark, on foot or by elevator, and where
% that is in metres. Situation calculus with three fluents (robot_at, and elevator_at for each of
% two elevators) and four actions (go, call, board, ride); every cycle plans anew from the
% present state, so re-planning is the execution monitor.
% Source: Amir and Maynard-Reid, LSA (IJCAI-99), section 4; the names of the actions are ours.
%
% Latches     curr_landmark(L)
%             elevator_at(E, K)  elevator_open(E)  elevator_out_of_order(E)  inside(E)
%             landmark(L, K, X, Y)  adjacent(L1, L2)  elevator(E)  elevator_front(E, L, K)
%             cab(E, C)
%             target_landmark(L)                                         from above
% Minimized   target_landmark, elevator_open, elevator_out_of_order, inside, same_elevator
% Attached    shortest_plan(N): the length of the shortest plan

% --- The present situation, s0 -------------------------------------------------------------------

fof(robot_now, axiom, ! [P] : ( curr_landmark(P) => robot_at(P, s0) )).
fof(elevator_now, axiom, ! [E, K] : ( elevator_at(E, K) => elevator_is_at(E, K, s0) )).

fof(usable, axiom,
    ! [E] : ( ( elevator(E) & ~ elevator_out_of_order(E) ) => usable(E) )).

% --- What actions bring about --------------------------------------------------------------------

fof(go, axiom,
    ! [P, L, S] : ( ( robot_at(P, S) & adjacent(P, L) ) => robot_at(L, do(go(L), S)) )).

% Leaving a cab is going, too: to the landmark before its door, on the floor where it stands. An
% elevator that is out of order lets people out.
fof(go_out, axiom,
    ! [E, C, K, L, S] :
      ( ( cab(E, C) & robot_at(C, S) & elevator_is_at(E, K, S) & elevator_front(E, L, K) )
     => robot_at(L, do(go(L), S)) )).

fof(board, axiom,
    ! [E, C, K, L, S] :
      ( ( cab(E, C) & usable(E) & elevator_is_at(E, K, S) & elevator_front(E, L, K)
        & robot_at(L, S) )
     => robot_at(C, do(board(E), S)) )).

fof(call, axiom,
    ! [E, K, L, S] :
      ( ( elevator_front(E, L, K) & usable(E) & robot_at(L, S) )
     => elevator_is_at(E, K, do(call(E), S)) )).

fof(ride, axiom,
    ! [E, C, K, L, S] :
      ( ( cab(E, C) & usable(E) & robot_at(C, S) & elevator_front(E, L, K) )
     => elevator_is_at(E, K, do(ride(E, K), S)) )).

% --- Frame axioms: what actions leave alone, one for each fluent and action ----------------------

fof(robot_stays_while_calling, axiom,
    ! [P, E, S] : ( robot_at(P, S) => robot_at(P, do(call(E), S)) )).
fof(robot_stays_in_the_cab, axiom,
    ! [P, E, K, S] : ( robot_at(P, S) => robot_at(P, do(ride(E, K), S)) )).

fof(elevator_waits_for_walkers, axiom,
    ! [E, K, L, S] : ( elevator_is_at(E, K, S) => elevator_is_at(E, K, do(go(L), S)) )).
fof(elevator_waits_for_boarders, axiom,
    ! [E, K, E2, S] : ( elevator_is_at(E, K, S) => elevator_is_at(E, K, do(board(E2), S)) )).
fof(elevator_ignores_calls_of_others, axiom,
    ! [E, K, E2, S] :
      ( ( elevator(E2) & ~ same_elevator(E, E2) & elevator_is_at(E, K, S) )
     => elevator_is_at(E, K, do(call(E2), S)) )).
fof(elevator_ignores_rides_of_others, axiom,
    ! [E, K, E2, K2, S] :
      ( ( elevator(E2) & ~ same_elevator(E, E2) & elevator_is_at(E, K, S) )
     => elevator_is_at(E, K, do(ride(E2, K2), S)) )).

% Unique names by circumscription: what need not be the same elevator is another one.
fof(same_elevator, axiom, ! [E] : same_elevator(E, E)).

% --- Plans, the shortest first -------------------------------------------------------------------
% plan(N, A, S): the shape of a situation that N actions lead to, the first of which is A. From any
% landmark next to the target, or before an elevator that goes there, four actions are enough; where
% no plan is that short, the layer is silent. That no shorter plan exists is a statement about
% proofs; the attachment shortest_plan asks for reach_in(0), reach_in(1), ... in turn.

cnf(plan_1, axiom, plan(1, A, do(A, s0))).
cnf(plan_2, axiom, plan(2, A, do(B, do(A, s0)))).
cnf(plan_3, axiom, plan(3, A, do(C, do(B, do(A, s0))))).
cnf(plan_4, axiom, plan(4, A, do(D, do(C, do(B, do(A, s0)))))).

fof(there_already, axiom,
    ! [T] : ( ( target_landmark(T) & curr_landmark(T) ) => reach_in(0) )).
fof(reach_in, axiom,
    ! [T, N, A, S] :
      ( ( target_landmark(T) & plan(N, A, S) & robot_at(T, S) ) => reach_in(N) )).

fof(first_step, axiom,
    ! [T, N, A, S] :
      ( ( target_landmark(T) & shortest_plan(N) & plan(N, A, S) & robot_at(T, S) )
     => first_step(A) )).

% --- What to do now ------------------------------------------------------------------------------

% At the target the robot moves on to its very place, until the next target comes.
fof(be_there, axiom,
    ! [T] : ( ( target_landmark(T) & curr_landmark(T) ) => move_to(T) )).

fof(walk, axiom,
    ! [L, P] : ( ( curr_landmark(P) & first_step(go(L)) & adjacent(P, L) ) => move_to(L) )).

% Out of a cab: when the door is open; till then the robot waits in the middle of the cab. Once out,
% it goes on to the target even if the elevator leaves behind its back.
fof(in_cab, axiom,
    ! [E, C] : ( ( cab(E, C) & curr_landmark(C) & inside(E) ) => in_cab(E, C) )).
fof(walk_out, axiom,
    ! [E, C, L] :
      ( ( in_cab(E, C) & elevator_open(E) & first_step(go(L)) ) => move_to(L) )).
fof(wait_to_walk_out, axiom,
    ! [E, C, L] :
      ( ( in_cab(E, C) & ~ elevator_open(E) & first_step(go(L)) ) => move_to(C) )).
fof(walk_on, axiom,
    ! [E, C, T] :
      ( ( cab(E, C) & curr_landmark(C) & ~ inside(E) & target_landmark(T) ) => move_to(T) )).

fof(step_in, axiom,
    ! [E, C] : ( ( first_step(board(E)) & elevator_open(E) & cab(E, C) ) => move_to(C) )).

% Here, but shut: the button opens it. Anywhere else: the button brings it.
fof(wait_to_step_in, axiom,
    ! [E, L] :
      ( ( first_step(board(E)) & ~ elevator_open(E) & curr_landmark(L) )
     => ( wait_at(L) & press_call(E) ) )).
fof(wait_for_the_elevator, axiom,
    ! [E, L] :
      ( ( first_step(call(E)) & curr_landmark(L) ) => ( wait_at(L) & press_call(E) ) )).
fof(ride_along, axiom,
    ! [E, K, C] :
      ( ( in_cab(E, C) & first_step(ride(E, K)) ) => ( wait_at(C) & ride(E, K) ) )).

fof(waiting_keeps_the_place, axiom, ! [L] : ( wait_at(L) => move_to(L) )).

fof(press_the_button_of_this_floor, axiom,
    ! [E, L, K] :
      ( ( press_call(E) & curr_landmark(L) & elevator_front(E, L, K) ) => call(E, K) )).

fof(coordinates, axiom,
    ! [L, K, X, Y] : ( ( move_to(L) & landmark(L, K, X, Y) ) => move_cmd(X, Y) )).
