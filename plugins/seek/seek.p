% SPDX-License-Identifier: BSD-3-Clause
%
% Layer 1, destination seeking: a place to go becomes a virtual object behind the robot that pushes
% it there. Source: Amir and Maynard-Reid, LSA (IJCAI-99), section 4; eight sectors are the paper's.
%
% Latches     curr_location(X, Y)  curr_heading(H)     move_cmd(X, Y)   from above
% Parameters  sector_width(W), arrive_tolerance(T), push_distance(D)
% Minimized   move_cmd: without a command there is no push, and layer 0 alone avoids what is near.
% Attached    bearing(X0, Y0, H, X, Y, Distance, Bearing): a place as the robot sees it

fof(destination, axiom,
    ! [X, Y, X0, Y0, H, D, B] :
      ( ( move_cmd(X, Y) & curr_location(X0, Y0) & curr_heading(H)
        & bearing(X0, Y0, H, X, Y, D, B) )
     => destination(D, B) )).

% Sector 0 is centred ahead, sectors count counter-clockwise and negative ones clockwise.
fof(goal_sector, axiom,
    ! [D, B, T, W] :
      ( ( destination(D, B) & arrive_tolerance(T) & $greater(D, T) & sector_width(W) )
     => goal_sector($round($quotient(B, W))) )).

fof(push, axiom, ! [Q] : ( goal_sector(Q) => object(push_object) )).

fof(push_distance, axiom,
    ! [Q, D] : ( ( goal_sector(Q) & push_distance(D) ) => distance(push_object, D) )).

% The object that pushes stands opposite the goal's sector; both clauses keep within (-pi, pi].
fof(push_from_the_left, axiom,
    ! [Q, W] :
      ( ( goal_sector(Q) & $lesseq(Q, 0) & sector_width(W) )
     => direction(push_object, $sum($product(Q, W), 3.141592653589793)) )).

fof(push_from_the_right, axiom,
    ! [Q, W] :
      ( ( goal_sector(Q) & $greater(Q, 0) & sector_width(W) )
     => direction(push_object, $difference($product(Q, W), 3.141592653589793)) )).

% Hard: nobody goes to two places at once; of two commands in one batch the second is refused.
fof(one_destination_x, axiom,
    ! [X1, Y1, X2, Y2] : ~ ( move_cmd(X1, Y1) & move_cmd(X2, Y2) & $less(X1, X2) )).
fof(one_destination_y, axiom,
    ! [X1, Y1, X2, Y2] : ~ ( move_cmd(X1, Y1) & move_cmd(X2, Y2) & $less(Y1, Y2) )).
